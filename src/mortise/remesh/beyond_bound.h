// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where a mesh leaves the surface of another by more than a bound: proven everywhere, not only where somebody looked.
#pragma once

#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A mesh and the model faces of its triangles.
struct FacedMesh {
  const SurfaceMesh& mesh;
  const std::vector<ModelFaceId>& face_of_triangle;
};

struct PlaceBeyond {
  FaceId triangle;
  Vec3d at;             ///< on it
  FaceId closest;       ///< triangle of the other mesh; invalid where there is none
  double distance = 0;  ///< to it; infinite where there is none
};

/// Triangles with points farther than `bound` from the triangles of the same model face of the other mesh; each with one such place. All
/// others are within it: the distance from a triangle is a convex function of the point, so a convex piece is within a bound of it when
/// its corners are. Pieces that are not within it of any one triangle are cut along the prisms over these, or halved; those still undecided
/// when they are a sixteenth of the bound across count as beyond it.
///
/// @param bound  positive
/// O(n log n) in the triangles and what they have in common.
[[nodiscard]] std::vector<PlaceBeyond> find_beyond(const FacedMesh& mesh, const FacedMesh& other, double bound);

}  // namespace mortise
