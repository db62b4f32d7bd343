// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Model vertices, and the paths of mesh edges between them.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/brep/face_boundaries.h"

namespace mortise {

/// Feature edges of a mesh, and which of them were made to open faces.
struct FeatureEdges {
  std::vector<std::uint8_t> is_feature;  ///< per mesh edge
  std::vector<std::uint8_t> is_seam;     ///< per mesh edge: these are features too
};

/// The features at every vertex, ascending.
using FeaturesRound = Lists<VertexId, MeshEdgeId>;

/// Marks the mesh vertices that are model vertices: where other than two features meet, where features turn by more than an
/// angle, where the pieces along them change, those a piece touches, and of boundaries without any the lexicographically lowest.
/// @param edge_angle_deg  seams may turn
/// @return per mesh vertex
[[nodiscard]] std::vector<std::uint8_t> find_corners(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features,
                                                     const FeaturesRound& round, const FaceComponents& pieces,
                                                     const FaceBoundaries& boundaries, double edge_angle_deg);

/// Marks those that seams make, once these are features too.
void add_corners_on_seams(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features, const FeaturesRound& round,
                          const FaceComponents& pieces, const std::vector<MeshEdgeId>& seams, std::vector<std::uint8_t>& is_corner);

/// Paths along features from corner to corner.
struct TracedEdges {
  Lists<ModelEdgeId, VertexId> path;  ///< by lowest mesh edge; from the lower end on, round a closed one to the lower neighbour
  std::vector<ModelEdgeId> edge_of;   ///< per mesh edge; invalid where it is no feature
};

/// @param is_corner  per mesh vertex; one at least on every closed path
[[nodiscard]] TracedEdges trace_edges(const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature, const FeaturesRound& round,
                                      const std::vector<std::uint8_t>& is_corner);

}  // namespace mortise
