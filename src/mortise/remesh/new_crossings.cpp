// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/new_crossings.h"

#include <algorithm>
#include <array>

#include "mortise/base/sort_unique.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/select_faces.h"

namespace mortise {
namespace {

using FacePair = std::array<ModelFaceId, 2>;

FacePair faces_of(const SelfCrossing& crossing, const std::vector<ModelFaceId>& face_of_triangle) {
  const ModelFaceId a = face_of_triangle[crossing.a.index()], b = face_of_triangle[crossing.b.index()];
  return a < b ? FacePair{a, b} : FacePair{b, a};
}

Box3 box_of(const SurfaceMesh& mesh, std::size_t t) {
  Box3 box;
  for (const VertexId v : mesh.triangles[t]) box.extend(mesh.points[v.index()]);
  return box;
}

// The first so many triangles whose boxes meet that of one of the others, and these others.
std::vector<FaceId> triangles_near_others(const SurfaceMesh& mesh, std::size_t outside) {
  std::vector<Box3> boxes;
  for (std::size_t t = outside; t < mesh.triangles.size(); ++t) boxes.push_back(box_of(mesh, t));
  std::vector<FaceId> near;
  if (boxes.empty()) return near;
  const BoxTree tree(boxes);
  for (std::size_t t = 0; t < outside; ++t) {
    bool meets = false;
    tree.for_each_meeting(box_of(mesh, t), [&](std::uint32_t) { meets = true; });
    if (meets) near.emplace_back(t);
  }
  for (std::size_t t = outside; t < mesh.triangles.size(); ++t) near.emplace_back(t);
  return near;
}

std::vector<SelfCrossing> crossings_of_others(const SurfaceMesh& mesh, std::size_t outside) {
  if (outside == 0) return find_self_crossings(mesh);
  const std::vector<FaceId> near = triangles_near_others(mesh, outside);
  std::vector<SelfCrossing> crossings = find_self_crossings(select_faces(mesh, near).mesh);
  for (SelfCrossing& crossing : crossings) {
    crossing.a = near[crossing.a.index()];
    crossing.b = near[crossing.b.index()];
  }
  std::erase_if(crossings, [&](const SelfCrossing& crossing) { return crossing.b.index() < outside; });
  return crossings;
}

}  // namespace

std::vector<SelfCrossing> find_new_crossings(const SurfaceMesh& mesh, const std::vector<ModelFaceId>& face_of_triangle, std::size_t outside,
                                             const SurfaceMesh& given, const ClassifiedBrep& given_model) {
  std::vector<SelfCrossing> crossings = crossings_of_others(mesh, outside);
  if (crossings.empty()) return crossings;
  std::vector<FacePair> crossed;
  for (const SelfCrossing& crossing : find_self_crossings(given))
    crossed.push_back(faces_of(crossing, given_model.classification.face_of_triangle));
  sort_unique(crossed);
  std::erase_if(crossings, [&](const SelfCrossing& crossing) {
    return std::binary_search(crossed.begin(), crossed.end(), faces_of(crossing, face_of_triangle));
  });
  return crossings;
}

}  // namespace mortise
