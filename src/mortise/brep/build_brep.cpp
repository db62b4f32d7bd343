// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh divided, then the tables of what bounds what.
#include "mortise/brep/build_brep.h"

#include <algorithm>
#include <string>

#include "mortise/base/error.h"
#include "mortise/brep/assemble_brep.h"
#include "mortise/brep/divide_mesh.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "build_brep";

void refuse_bad_input(const SurfaceMesh& mesh) {
  validate(mesh);
  std::vector<std::uint32_t> bad;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (repeats_vertex(mesh.triangles[f])) bad.push_back(f);
  }
  if (!bad.empty())
    throw Error(ErrorCode::InvalidArgument, stage_name, "triangles repeat a vertex: repair the mesh first").with_ids(IdKind::Faces, bad);
}

// The ends of a mesh edge in the order in which a path comes to them.
std::array<VertexId, 2> along(std::span<const VertexId> path, const std::array<VertexId, 2>& ends) {
  std::size_t i = 0;
  while (sorted_ends(path[i], path[i + 1]) != ends) ++i;
  return {path[i], path[i + 1]};
}

BrepParts parts_of(const SurfaceMesh& mesh, const MeshTopology& topology, DividedMesh&& divided) {
  BrepParts parts;
  parts.faces = std::move(divided.pieces);
  parts.genus = std::move(divided.boundaries.genus);
  parts.is_corner = std::move(divided.is_corner);
  parts.path = std::move(divided.edges.path);
  parts.is_seam.assign(parts.path.size(), 0);
  std::vector<std::uint8_t> is_known(parts.path.size(), 0);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const ModelEdgeId edge = divided.edges.edge_of[e];
    if (!edge.is_valid() || is_known[edge.index()] != 0) continue;
    is_known[edge.index()] = 1;
    parts.is_seam[edge.index()] = divided.features.is_seam[e];
    const auto uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() <= 2) continue;
    const std::array<VertexId, 2> ends = along(parts.path.of(edge), topology.edges[e]);
    parts.crowded.push_back({edge, faces_round(mesh, parts.faces, ends, {uses.begin(), uses.end()})});
  }
  for (std::size_t b = 0; b < divided.boundaries.piece.size(); ++b) {
    for (const HalfEdge h : divided.boundaries.half_edges.of(BoundaryId(b))) parts.loops.items.push_back(origin_of(mesh, h));
    parts.loops.close();
    parts.face_of_loop.emplace_back(divided.boundaries.piece[b]);
  }
  for (const TouchedVertex& t : divided.boundaries.touched) {
    parts.loops.items.push_back(t.vertex);
    parts.loops.close();
    parts.face_of_loop.emplace_back(t.piece);
  }
  return parts;
}

ClassifiedBrep build_from(const SurfaceMesh& mesh, const MeshTopology& topology, const BrepRules& rules, const FaceNormals& normals) {
  return assemble_brep(mesh, parts_of(mesh, topology, divide_mesh(mesh, topology, rules, normals)));
}

}  // namespace

ClassifiedBrep build_brep(const SurfaceMesh& mesh, const BrepRules& rules, const FaceNormals& normals) {
  refuse_bad_input(mesh);
  if (normals.normals.size() != mesh.triangles.size() || (!normals.planes.empty() && normals.planes.size() != mesh.triangles.size()))
    throw Error(
        ErrorCode::InvalidArgument, stage_name,
        "there are " + std::to_string(normals.normals.size()) + " normals for " + std::to_string(mesh.triangles.size()) + " triangles");
  return build_from(mesh, build_topology(mesh), rules, normals);
}

ClassifiedBrep build_brep(const SurfaceMesh& mesh, const BrepRules& rules) {
  refuse_bad_input(mesh);
  const MeshTopology topology = build_topology(mesh);
  return build_from(mesh, topology, rules, measure_normals(mesh, topology));
}

}  // namespace mortise
