// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangles that a repair put on the same corners, and the spaces outside all of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mortise/mesh/provenance.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

struct StackedTriangle {
  std::array<VertexId, 3> corners;  ///< ascending
  std::uint32_t triangle;
  bool is_even;  ///< runs along them
};

/// The triangles by their corners, those on the same ascending; without those that have a corner twice.
[[nodiscard]] std::vector<StackedTriangle> sorted_by_corners(const std::vector<Triangle>& triangles);

/// Covering sets on the two sides of triangles on the same corners.
struct OuterSpaces {
  std::uint32_t in_front, behind;  ///< of a triangle that runs along the ascending corners
};

/// What is left when spaces between the triangles cancel in pairs; when all do, the space round the sheet among them, or nothing.
[[nodiscard]] std::optional<OuterSpaces> outer_spaces(std::span<const StackedTriangle> stack, const Provenance& provenance);

}  // namespace mortise
