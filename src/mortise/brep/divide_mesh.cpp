// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Features part pieces; corners part paths; seams, last, are features too.
#include "mortise/brep/divide_mesh.h"

#include <map>

#include "mortise/base/error.h"

namespace mortise {
namespace {

FaceComponents connect_smoothly(const HalfEdgesAcross& across, const KnownFaces& known) {
  UnionFind faces(across.size() / 3);
  for (HalfEdge h = 0; h < across.size(); ++h) {
    if (across[h] != no_half_edge && h < across[h]) faces.join(face_of(h).value, face_of(across[h]).value);
  }
  std::map<std::uint32_t, std::uint32_t> first;  // triangle of each known face
  for (std::uint32_t t = 0; t < known.face_of_triangle.size(); ++t) {
    if (known.face_of_triangle[t] != KnownFaces::none) faces.join(first.emplace(known.face_of_triangle[t], t).first->second, t);
  }
  return number_components(faces);
}

std::vector<std::uint8_t> pieces_to_open(const FaceComponents& pieces, const KnownFaces& known) {
  std::vector<std::uint8_t> may_open(pieces.count, 1);
  for (std::size_t t = 0; t < known.face_of_triangle.size(); ++t) {
    if (known.face_of_triangle[t] != KnownFaces::none) may_open[pieces.component_of[t]] = 0;
  }
  return may_open;
}

// Makes features of seams.
void open_along(const std::vector<MeshEdgeId>& seams, const SurfaceMesh& mesh, const MeshTopology& topology, HalfEdgesAcross& across,
                FeaturesRound& round, DividedMesh& d) {
  std::vector<std::uint8_t> opened(d.pieces.count, 0);
  for (const MeshEdgeId e : seams) {
    d.features.is_feature[e.index()] = d.features.is_seam[e.index()] = 1;
    for (const HalfEdge h : topology.uses_of(e)) {
      across[h] = no_half_edge;
      opened[d.pieces.component_of[face_of(h).index()]] = 1;
    }
  }
  round = edges_round_vertices(topology, d.features.is_feature, mesh.points.size());
  walk_again(across, d.pieces, opened, d.boundaries);
  add_corners_on_seams(mesh, topology, d.features, round, d.pieces, seams, d.is_corner);
}

}  // namespace

DividedMesh divide_mesh(const SurfaceMesh& mesh, const MeshTopology& topology, const BrepRules& rules, const FaceNormals& normals,
                        const KnownFaces& known) {
  if (!(rules.edge_angle_deg >= 0 && rules.edge_angle_deg <= 180))
    throw Error(ErrorCode::InvalidArgument, "build_brep", "angles lie between 0 and 180 degrees");
  DividedMesh d;
  d.features.is_feature = find_feature_edges(mesh, topology, normals, rules.features);
  d.features.is_seam.assign(topology.edges.size(), 0);
  HalfEdgesAcross across = half_edges_across(topology, d.features.is_feature);
  d.pieces = connect_smoothly(across, known);
  d.boundaries = find_face_boundaries(mesh, across, d.pieces);
  FeaturesRound round = edges_round_vertices(topology, d.features.is_feature, mesh.points.size());
  d.is_corner = find_corners(mesh, topology, d.features, round, d.pieces, d.boundaries, rules.edge_angle_deg);
  std::vector<MeshEdgeId> seams =
      find_seams(rules.seams, mesh, topology, d.pieces, d.boundaries, d.is_corner, pieces_to_open(d.pieces, known));
  seams.insert(seams.end(), known.seams.begin(), known.seams.end());
  if (!seams.empty()) open_along(seams, mesh, topology, across, round, d);
  d.edges = trace_edges(topology, d.features.is_feature, round, d.is_corner);
  return d;
}

}  // namespace mortise
