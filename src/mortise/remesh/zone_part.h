// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Remeshing a zone takes time for the zone: the part of a model it may change, cut out and put back.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/brep/face_normals.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A piece of the path of a model edge.
struct PathPiece {
  ModelEdgeId edge;
  std::size_t first = 0, last = 0;  ///< places in its path
};

/// The triangles of a zone and all that touch these, which stay. Open where it was cut.
struct ZonePart {
  SurfaceMesh mesh;                ///< with its labels and data
  FaceNormals normals;             ///< per triangle
  std::vector<std::uint8_t> zone;  ///< per triangle
  std::vector<FaceId> triangles;   ///< per triangle: of the whole mesh, ascending
  std::vector<VertexId> vertices;  ///< per vertex: of the whole mesh, ascending
  ClassifiedBrep model;            ///< model faces by their numbers; edges are the pieces; model vertices are theirs and the ends of pieces
  IdVector<ModelEdgeId, PathPiece> pieces;  ///< of the model edges of the whole
};

/// @param zone  per triangle: 1 when it may change
/// O(n), and O(k log k) in the triangles of the part.
[[nodiscard]] ZonePart cut_out(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals,
                               const std::vector<std::uint8_t>& zone);

/// A part that was changed, but for the vertices of what was cut off.
struct ChangedPart {
  SurfaceMesh mesh;
  Classification classification;     ///< on the model of the part
  std::vector<FaceId> sources;       ///< per triangle: of the part
  std::vector<VertexId> new_vertex;  ///< per vertex of the part: where it is now; of those that stayed
};

/// The whole with the changed part in it.
struct PutBack {
  SurfaceMesh mesh;  ///< points and triangles: first those that are not of the part, in their order, then those of the part
  Classification classification;
  std::vector<FaceId> outside;  ///< the triangles that are not of the part, ascending
};

/// O(n).
[[nodiscard]] PutBack put_back(const ZonePart& part, const ChangedPart& changed, const SurfaceMesh& mesh, const ClassifiedBrep& model);

}  // namespace mortise
