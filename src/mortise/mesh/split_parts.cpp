// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers the parts and selects the faces of each.
#include "mortise/mesh/split_parts.h"

#include <utility>

#include "mortise/base/error.h"
#include "mortise/mesh/find_regions.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/require_closed.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

constexpr const char* stage = "split_parts";

/// The faces as lists, one for each number, in order.
std::vector<std::vector<FaceId>> group_faces(const std::vector<FaceId>& faces, const std::vector<std::uint32_t>& number) {
  std::vector<std::vector<FaceId>> groups;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (number[i] >= groups.size()) groups.resize(number[i] + 1);
    groups[number[i]].push_back(faces[i]);
  }
  return groups;
}

std::vector<std::vector<FaceId>> group_by_components(const SurfaceMesh& mesh) {
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) faces.push_back(FaceId(f));
  return group_faces(faces, connect_by_edges(mesh, build_topology(mesh)).component_of);
}

[[noreturn]] void refuse_inside_out(const std::vector<FaceId>& faces) {
  std::vector<std::uint32_t> ids;
  for (const FaceId f : faces) ids.push_back(f.value);
  throw Error(ErrorCode::InsideOut, stage,
              "a part of the mesh is inside out and no cavity of another: its faces run clockwise seen from outside")
      .with_ids(IdKind::Faces, std::move(ids));
}

std::vector<std::vector<FaceId>> group_by_regions(const WeldedMesh& welded) {
  require_closed(welded, build_topology(welded.mesh), stage);
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < welded.mesh.triangles.size(); ++f) {
    if (!repeats_vertex(welded.mesh.triangles[f])) faces.push_back(FaceId(f));
  }
  const MeshRegions found = find_regions(select_faces(welded.mesh, faces).mesh);
  const std::vector<std::vector<FaceId>> groups = group_faces(faces, found.region_of_face);
  for (std::size_t r = 0; r < groups.size(); ++r) {
    if (found.regions[r].volume < 0) refuse_inside_out(groups[r]);
  }
  return groups;
}

}  // namespace

std::vector<MeshPart> split_parts(const SurfaceMesh& mesh, SplitBy by) {
  validate(mesh);
  const WeldedMesh welded = weld(mesh);
  std::vector<MeshPart> parts;
  for (const auto& faces : by == SplitBy::Components ? group_by_components(welded.mesh) : group_by_regions(welded)) {
    parts.push_back(select_faces(welded.mesh, faces));
    for (VertexId& v : parts.back().source_vertex) v = welded.old_vertex[v.index()];
  }
  return parts;
}

}  // namespace mortise
