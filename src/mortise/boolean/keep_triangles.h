// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Some triangles of a result leave it, with all that is known of them.
#pragma once

#include <cstdint>
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

/// Leaves the marked triangles and the vertices they use, in their order.
/// @return per vertex there was: 1 when it stays
std::vector<std::uint8_t> keep_triangles(const std::vector<std::uint8_t>& is_kept, SurfaceMesh& mesh, Provenance& provenance);
void keep_triangles(const std::vector<std::uint8_t>& is_kept, MergedMesh& merged);

}  // namespace mortise
