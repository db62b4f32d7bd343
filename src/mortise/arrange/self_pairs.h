// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which faces of one mesh may meet one another, wherever the mesh is put.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mortise/geom/vec.h"
#include "mortise/mesh/surface_mesh.h"
#include "mortise/mesh/transform.h"

namespace mortise {

/// All other pairs meet in the corners they share or not at all, in every image of the mesh under an affine map and a movement
/// of each vertex that, seen in the mesh, is at most `slack` long.
struct SelfPairs {
  double slack = 0;
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< first < second, sorted
  bool is_known = false;                            ///< false when there would be more than a few per face
};

/// @param lowest  per vertex: the lowest one at its position
/// O(n log n), plus time in proportion to the pairs whose boxes meet.
[[nodiscard]] SelfPairs find_self_pairs(const SurfaceMesh& mesh, std::span<const std::uint32_t> lowest);

/// A bound of how far, seen in the mesh, apply() puts a point of the box beside its exact image; infinite when there is none.
[[nodiscard]] double rounding_seen_in_mesh(const AffineMap& map, const Box3& box);

/// Of each face, a margin wider on every side.
[[nodiscard]] std::vector<Box3> boxes_of_faces(const SurfaceMesh& mesh, double margin);

}  // namespace mortise
