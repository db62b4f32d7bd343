// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Mesh edges that lie on model edges (paper 2.1: deviation of normals and analysis attributes).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "mortise/base/lists.h"
#include "mortise/brep/face_normals.h"

namespace mortise {

/// What parts faces of a model.
struct FeatureRules {
  double face_angle_deg = 40;                       ///< triangles at a larger angle are of different faces; 180: angles do not matter
  std::optional<double> weak_angle_deg;             ///< smaller: edges above it are features too where they continue one
  std::uint32_t least_dangling = 0;                 ///< creases that end inside a face after fewer edges are dropped
  std::vector<std::uint32_t> groups;                ///< empty, or per triangle: triangles of different groups are of different faces
  bool splits_at_labels = true;                     ///< between triangles of different labels
  std::vector<std::array<VertexId, 2>> user_edges;  ///< features whatever the angle
};

/// Marks the edges that part faces: those without exactly two triangles, between triangles that run the same way along them,
/// between walls and other triangles, between labels, between groups, chosen by the user, and creases.
///
/// @return per edge of the topology: 1 for a feature
/// @throws Error{InvalidArgument} for angles outside 0 .. 180 or a weak angle above the face angle, and naming a user edge that is
///         not in the mesh; when there is not one group per triangle
/// O(n).
[[nodiscard]] std::vector<std::uint8_t> find_feature_edges(const SurfaceMesh& mesh, const MeshTopology& topology,
                                                           const FaceNormals& normals, const FeatureRules& rules);

/// @throws Error{InvalidArgument} naming an edge that is not in the mesh
[[noreturn]] void refuse_user_edge(const std::array<VertexId, 2>& ends, std::string_view stage);

/// The marked edges at every vertex, ascending.
[[nodiscard]] Lists<VertexId, MeshEdgeId> edges_round_vertices(const MeshTopology& topology, const std::vector<std::uint8_t>& is_marked,
                                                               std::size_t vertex_count);

}  // namespace mortise
