// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A stable sort of the triangles.
#include "mortise/mesh/group_by_label.h"

#include <algorithm>

#include "mortise/mesh/validate.h"

namespace mortise {

GroupedMesh group_by_label(const SurfaceMesh& mesh) {
  validate(mesh);
  const auto label_of = [&](FaceId f) { return mesh.face_labels.empty() ? 0U : mesh.face_labels[f.index()]; };
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) faces.push_back(FaceId(f));
  std::stable_sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) { return label_of(a) < label_of(b); });
  GroupedMesh result{select_faces(mesh, faces), {}};
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (i == 0 || label_of(faces[i]) != result.groups.back().label) result.groups.push_back({i, 0, label_of(faces[i])});
    ++result.groups.back().count;
  }
  return result;
}

}  // namespace mortise
