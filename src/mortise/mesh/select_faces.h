// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Some of the faces of a mesh as a mesh of their own.
#pragma once

#include <span>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Faces taken out of a mesh, and where they were.
struct MeshPart {
  SurfaceMesh mesh;                     ///< all label names are kept, so that label numbers mean the same
  std::vector<FaceId> source_face;      ///< per face
  std::vector<VertexId> source_vertex;  ///< per vertex, ascending
};

/// These faces in this order, with the vertices they use in the order they have in `mesh`, and the data of both.
/// O(n log n) in the faces taken.
[[nodiscard]] MeshPart select_faces(const SurfaceMesh& mesh, std::span<const FaceId> faces);

}  // namespace mortise
