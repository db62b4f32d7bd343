// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The tables of what bounds what, from faces, edges and vertices on their mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/topology.h"

namespace mortise {

/// An edge that faces use more than twice.
struct CrowdedEdge {
  ModelEdgeId edge;
  std::vector<FaceUse> round;  ///< as in Brep::faces_of_edge
};

/// The faces round an edge, counterclockwise looking against it, from the lowest on.
/// @param ends  of one of its mesh edges, the one its path comes to first in front
/// @param half_edges  all of that mesh edge
[[nodiscard]] std::vector<FaceUse> faces_round(const SurfaceMesh& mesh, const FaceComponents& faces, const std::array<VertexId, 2>& ends,
                                               std::vector<HalfEdge> half_edges);

/// The faces, edges and vertices of a model, numbered, on their mesh.
struct BrepParts {
  FaceComponents faces;                 ///< of triangles
  std::vector<std::uint32_t> genus;     ///< per face
  std::vector<std::uint8_t> is_corner;  ///< per mesh vertex: a model vertex
  Lists<ModelEdgeId, VertexId> path;    ///< from corner to corner
  std::vector<std::uint8_t> is_seam;    ///< per edge
  Lists<LoopId, VertexId> loops;        ///< mesh vertices in turn, the face on the left; only one where a face touches it from within
  std::vector<ModelFaceId> face_of_loop;
  std::vector<CrowdedEdge> crowded;
};

/// Vertices are numbered by their mesh vertices, loops by their faces, shells and regions by their faces.
/// O(n + m log m) for m entities, and find_shells.
[[nodiscard]] ClassifiedBrep assemble_brep(const SurfaceMesh& mesh, BrepParts&& parts);

}  // namespace mortise
