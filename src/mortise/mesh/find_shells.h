// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The connected sides of a surface, and the pieces of space they bound.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/topology.h"

namespace mortise {

/// A surface in pieces that have one back and one front each: faces joined through edges of two that run opposite ways.
struct SurfacePieces {
  FaceComponents of_face;         ///< the pieces, by number
  std::vector<MeshEdgeId> edges;  ///< where sides of pieces join: every edge between faces of different pieces, or one for each
                                  ///< run of such edges round which the same faces' pieces follow one another
};

/// Sides that join round edges are a shell; shells that bound one piece of space are of one cell.
struct SurfaceShells {
  static constexpr std::uint32_t unbounded = 0;

  std::vector<std::uint32_t> behind;         ///< per piece: the shell at its back
  std::vector<std::uint32_t> in_front;       ///< per piece
  std::vector<std::uint32_t> cell_of_shell;  ///< 0 reaches to infinity; the others in the order of their lowest faces
  std::uint32_t cell_count = 1;
};

/// The shells and cells of a surface that does not cross itself and has no face without area; its faces may run either way and
/// meet any number at an edge. Sides join round edges by exact radial order; a surface inside another is located by an exact ray.
/// O(n log n) in edges between pieces, O(n) in faces, plus a ray for each surface connected through edges.
[[nodiscard]] SurfaceShells find_shells(const SurfaceMesh& mesh, const MeshTopology& topology, const SurfacePieces& pieces);

}  // namespace mortise
