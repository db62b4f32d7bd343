// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A tree of the triangles that changed, asked by all.
#include "mortise/boolean/folded_faces.h"

#include <algorithm>

#include "mortise/base/sort_unique.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/find_self_crossings.h"

namespace mortise {
namespace {

Box3 box_of(const SurfaceMesh& mesh, const Triangle& t) {
  Box3 box;
  for (const VertexId v : t) box.extend(mesh.points[v.index()]);
  return box;
}

bool is_where_it_was(const SurfaceMesh& given, const ImprintedOperand& changed, std::size_t t) {
  const Triangle &now = changed.mesh.triangles[t], &before = given.triangles[changed.source_face[t]];
  for (std::size_t i = 0; i < 3; ++i) {
    if (changed.mesh.points[now[i].index()] != given.points[before[i].index()]) return false;
  }
  return true;
}

// Without those of no area, which no arrangement keeps.
std::vector<std::uint32_t> find_changed(const SurfaceMesh& given, const ImprintedOperand& changed) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < changed.mesh.triangles.size(); ++t) {
    if (!is_where_it_was(given, changed, t) && !is_degenerate(changed.mesh, FaceId(t))) triangles.push_back(t);
  }
  return triangles;
}

bool have_same_corners(Triangle s, Triangle t) {
  std::sort(s.begin(), s.end());
  std::sort(t.begin(), t.end());
  return s == t;
}

bool cross_or_overlap(const SurfaceMesh& mesh, FaceId s, FaceId t) {
  if (have_same_corners(mesh.triangles[s.index()], mesh.triangles[t.index()]) || is_degenerate(mesh, s)) return false;
  return classify_meeting(mesh, s, t) != PairMeeting::Apart;
}

}  // namespace

std::vector<std::uint32_t> find_folded_faces(const SurfaceMesh& given, const ImprintedOperand& changed) {
  const SurfaceMesh& mesh = changed.mesh;
  const std::vector<std::uint32_t> moved = find_changed(given, changed);
  std::vector<Box3> boxes;
  for (const std::uint32_t t : moved) boxes.push_back(box_of(mesh, mesh.triangles[t]));
  const BoxTree tree(boxes);
  std::vector<std::uint32_t> folded;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    tree.for_each_meeting(box_of(mesh, mesh.triangles[t]), [&](std::uint32_t item) {
      const std::uint32_t other = moved[item];
      if (other == t || !cross_or_overlap(mesh, FaceId(t), FaceId(other))) return;
      folded.push_back(changed.source_face[t]);
      folded.push_back(changed.source_face[other]);
    });
  }
  sort_unique(folded);
  return folded;
}

}  // namespace mortise
