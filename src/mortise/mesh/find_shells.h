// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The connected sides of a surface, and the pieces of space they bound.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/base/lists.h"
#include "mortise/mesh/topology.h"

namespace mortise {

/// A piece of a surface as one comes to it on the way round an edge.
struct PieceAtEdge {
  std::uint32_t piece = 0;
  bool runs_along = false;  ///< its half-edge there runs along the edge, not against it
};

using JointId = Id<struct JointTag>;

/// A surface in pieces that have one back and one front each: faces joined through edges of two that run opposite ways.
struct SurfacePieces {
  FaceComponents of_face;              ///< the pieces, by number
  Lists<JointId, PieceAtEdge> joints;  ///< where sides of pieces join: every edge between faces of different pieces, or one for each run of
                                       ///< edges round which the same pieces follow one another; what meets there, counterclockwise
};

/// Adds the edge that some half-edges are on.
void add_joint(const SurfaceMesh& mesh, std::span<const HalfEdge> half_edges, SurfacePieces& pieces);

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
[[nodiscard]] SurfaceShells find_shells(const SurfaceMesh& mesh, const SurfacePieces& pieces);

}  // namespace mortise
