// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paths that open faces: a cylinder along its side, a torus to a square, a sphere from pole to pole.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/brep/face_boundaries.h"

namespace mortise {

enum class Seams : std::uint8_t {
  None,
  Annulus,  ///< one in every face without handles between two loops: a cylinder has a seam, a plate with a hole too
  Disc,     ///< as many as make every face a disc: one more loop or handle each; a sphere has one
};

/// Short paths inside pieces, from loop to loop and round handles. They leave a loop at a corner where there is one to leave at.
/// Pieces whose loops touch themselves or one another get none.
///
/// @param is_corner  per mesh vertex
/// @param may_open  per piece: whether to look for any
/// @return mesh edges, ascending
/// O(n log n) in the pieces that get seams.
[[nodiscard]] std::vector<MeshEdgeId> find_seams(Seams seams, const SurfaceMesh& mesh, const MeshTopology& topology,
                                                 const FaceComponents& pieces, const FaceBoundaries& boundaries,
                                                 const std::vector<std::uint8_t>& is_corner, const std::vector<std::uint8_t>& may_open);

}  // namespace mortise
