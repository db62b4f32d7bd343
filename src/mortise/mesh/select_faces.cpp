// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertices of the selection found by sorting, so that the cost does not grow with the mesh they come from.
#include "mortise/mesh/select_faces.h"

#include <algorithm>

#include "mortise/mesh/face_marks.h"

namespace mortise {

MeshPart select_faces(const SurfaceMesh& mesh, std::span<const FaceId> faces) {
  MeshPart part;
  part.source_face.assign(faces.begin(), faces.end());
  for (const FaceId f : faces) {
    const Triangle& t = mesh.triangles[f.index()];
    part.source_vertex.insert(part.source_vertex.end(), t.begin(), t.end());
  }
  part.mesh.corner_data = without_values(mesh.corner_data);
  std::vector<VertexId>& used = part.source_vertex;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  for (const VertexId v : used) part.mesh.points.push_back(mesh.points[v.index()]);
  for (const FaceId f : faces) {
    Triangle t = mesh.triangles[f.index()];
    for (VertexId& v : t) v = VertexId(static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin()));
    part.mesh.triangles.push_back(t);
    append_face_marks(mesh, f, part.mesh);
  }
  part.mesh.label_names = mesh.label_names;
  part.mesh.vertex_data = select_vertex_data(mesh.vertex_data, used);
  return part;
}

}  // namespace mortise
