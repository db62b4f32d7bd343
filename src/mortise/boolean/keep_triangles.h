// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Some triangles of a result leave it, with all that is known of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/boolean/merge.h"

namespace mortise {

/// Only the marked values, in their order; an empty array stays empty.
template <class T>
void keep_marked(std::vector<T>& values, const std::vector<std::uint8_t>& is_kept) {
  if (values.empty()) return;
  std::size_t next = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_kept[i] != 0) values[next++] = values[i];
  }
  values.resize(next);
}

/// The numbers the marked ones get, Provenance::none for the others.
[[nodiscard]] std::vector<std::uint32_t> numbers_of_kept(std::span<const std::uint8_t> is_kept);

/// Those of some ids that stay, by their new numbers.
[[nodiscard]] std::vector<std::uint32_t> renumbered(std::span<const std::uint32_t> ids, std::span<const std::uint8_t> is_kept);

/// Leaves the marked triangles and the vertices they use, in their order.
/// @return per vertex there was: 1 when it stays
std::vector<std::uint8_t> keep_triangles(const std::vector<std::uint8_t>& is_kept, SurfaceMesh& mesh, Provenance& provenance);
void keep_triangles(const std::vector<std::uint8_t>& is_kept, MergedMesh& merged);

}  // namespace mortise
