// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/new_crossings.h"

#include <algorithm>
#include <array>

#include "mortise/base/sort_unique.h"

namespace mortise {
namespace {

using FacePair = std::array<ModelFaceId, 2>;

FacePair faces_of(const SelfCrossing& crossing, const std::vector<ModelFaceId>& face_of_triangle) {
  const ModelFaceId a = face_of_triangle[crossing.a.index()], b = face_of_triangle[crossing.b.index()];
  return a < b ? FacePair{a, b} : FacePair{b, a};
}

}  // namespace

std::vector<SelfCrossing> find_new_crossings(const SurfaceMesh& mesh, const std::vector<ModelFaceId>& face_of_triangle,
                                             const SurfaceMesh& given, const ClassifiedBrep& given_model) {
  std::vector<SelfCrossing> crossings = find_self_crossings(mesh);
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
