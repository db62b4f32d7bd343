// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers the parts and selects the faces of each.
#include "mortise/mesh/split_parts.h"

#include <utility>

#include "mortise/base/error.h"
#include "mortise/base/union_find.h"
#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/find_cells.h"
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

std::vector<FaceId> faces_with_three_corners(const SurfaceMesh& mesh) {
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (!repeats_vertex(mesh.triangles[f])) faces.push_back(FaceId(f));
  }
  return faces;
}

// Which cells belong to the solid: those behind faces that are no walls, and those a wall parts from such a cell.
std::vector<std::uint8_t> find_inside(const SurfaceMesh& mesh, const MeshCells& cells) {
  UnionFind same(cells.cells.size());
  for (std::size_t f = 0; f < mesh.walls.size(); ++f) {
    if (mesh.walls[f] != 0) same.join(cells.behind[f], cells.in_front[f]);
  }
  std::vector<std::uint8_t> is_inside(cells.cells.size(), 0);
  for (std::size_t f = 0; f < mesh.walls.size(); ++f) {
    if (mesh.walls[f] == 0) is_inside[same.find(cells.behind[f])] = 1;
  }
  for (std::uint32_t c = 0; c < is_inside.size(); ++c) is_inside[c] = is_inside[same.find(c)];
  return is_inside;
}

// With walls a face may bound two regions: each region gets its own copy, with the region behind it.
std::vector<MeshPart> parts_between_walls(const SurfaceMesh& welded) {
  const MeshPart clean = select_faces(welded, faces_with_three_corners(welded));
  const MeshCells cells = find_cells(clean.mesh);
  const std::vector<std::uint8_t> is_inside = find_inside(clean.mesh, cells);
  if (is_inside[MeshCells::unbounded] != 0)
    throw Error(ErrorCode::NotClosed, stage, "the faces that are no walls do not enclose the regions");
  std::vector<std::vector<FaceId>> faces(cells.cells.size());
  for (std::size_t f = 0; f < cells.behind.size(); ++f) {
    if (cells.behind[f] == cells.in_front[f]) continue;
    for (const std::uint32_t c : {cells.behind[f], cells.in_front[f]}) faces[c].push_back(FaceId(f));
  }
  std::vector<MeshPart> parts;
  for (std::uint32_t c = 0; c < faces.size(); ++c) {
    if (is_inside[c] == 0) continue;
    MeshPart part = select_faces(clean.mesh, faces[c]);
    part.mesh.walls.clear();
    for (std::size_t i = 0; i < faces[c].size(); ++i) {
      if (cells.in_front[faces[c][i].index()] == c) turn_over(FaceId(i), part.mesh);
      part.source_face[i] = clean.source_face[faces[c][i].index()];
    }
    for (VertexId& v : part.source_vertex) v = clean.source_vertex[v.index()];
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<std::vector<FaceId>> group_by_regions(const WeldedMesh& welded) {
  require_closed(welded, build_topology(welded.mesh), stage);
  const std::vector<FaceId> faces = faces_with_three_corners(welded.mesh);
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
  if (by == SplitBy::Regions && !mesh.walls.empty()) {
    parts = parts_between_walls(welded.mesh);
  } else {
    const auto groups = by == SplitBy::Components ? group_by_components(welded.mesh) : group_by_regions(welded);
    for (const auto& faces : groups) parts.push_back(select_faces(welded.mesh, faces));
  }
  for (MeshPart& part : parts) {
    for (VertexId& v : part.source_vertex) v = welded.old_vertex[v.index()];
  }
  return parts;
}

}  // namespace mortise
