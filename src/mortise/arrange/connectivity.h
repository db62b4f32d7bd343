// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the faces of a mesh are to one another, wherever its points are: the part of an operand that outlives a move.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Holds as long as the same vertices share a position; turning all faces over changes nothing.
struct Connectivity {
  std::vector<std::uint32_t> part_of_face;  ///< 0, 1, ... by first face: faces of one part are connected through points
  std::uint32_t part_count = 0;
  bool is_closed = false;             ///< along every edge as many faces run one way as the other; walls do not count
  bool has_coincident_faces = false;  ///< two faces have the same three corners
};

/// @param lowest  per vertex: the lowest one at its position
/// O(n).
[[nodiscard]] Connectivity find_connectivity(const SurfaceMesh& mesh, std::span<const std::uint32_t> lowest);

}  // namespace mortise
