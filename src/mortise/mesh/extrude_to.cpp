// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The sheet, its shadow in the plane, and a wall under every boundary edge.
#include "mortise/mesh/extrude_to.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/exact/predicates.h"
#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/select_faces.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

constexpr const char* stage = "extrude_to";

void turn_over_all(SurfaceMesh& mesh) {
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) turn_over(FaceId(f), mesh);
}

/// The used vertices of a mesh, with the faces as they are.
MeshPart compact(const SurfaceMesh& mesh, const std::vector<VertexId>& old_vertex) {
  std::vector<FaceId> all;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) all.push_back(FaceId(f));
  MeshPart part = select_faces(mesh, all);
  for (VertexId& v : part.source_vertex) v = old_vertex[v.index()];
  return part;
}

[[noreturn]] void refuse_faces(const std::string& why, std::vector<std::uint32_t> faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  throw Error(ErrorCode::InvalidArgument, stage, std::to_string(faces.size()) + " faces of the sheet " + why)
      .with_ids(IdKind::Faces, std::move(faces));
}

/// Makes all faces look up; they may all look down.
void turn_up(SurfaceMesh& sheet) {
  std::vector<std::uint32_t> not_up, not_down;
  for (std::uint32_t f = 0; f < sheet.triangles.size(); ++f) {
    const Triangle& t = sheet.triangles[f];
    const Sign turn = repeats_vertex(t)
                          ? Sign::Zero
                          : orient2d(sheet.points[t[0].index()], sheet.points[t[1].index()], sheet.points[t[2].index()], Axis::Z);
    if (turn != Sign::Positive) not_up.push_back(f);
    if (turn != Sign::Negative) not_down.push_back(f);
  }
  if (not_up.empty()) return;
  if (!not_down.empty()) {
    refuse_faces("stand upright or fold over: it is no heightfield", not_up.size() <= not_down.size() ? not_up : not_down);
  }
  turn_over_all(sheet);
}

/// Is the plane below the sheet, or else above it?
bool is_below(const MeshPart& sheet, double z) {
  std::vector<std::uint32_t> not_above, not_below;
  for (std::size_t v = 0; v < sheet.mesh.points.size(); ++v) {
    if (!(sheet.mesh.points[v].z > z)) not_above.push_back(sheet.source_vertex[v].value);
    if (!(sheet.mesh.points[v].z < z)) not_below.push_back(sheet.source_vertex[v].value);
  }
  if (!not_above.empty() && !not_below.empty()) {
    throw Error(ErrorCode::InvalidArgument, stage, "the plane must lie below or above the whole sheet and not touch it")
        .with_ids(IdKind::Vertices, not_above.size() <= not_below.size() ? std::move(not_above) : std::move(not_below));
  }
  return not_above.empty();
}

SurfaceMesh shadow_of(const SurfaceMesh& sheet, double z) {
  SurfaceMesh shadow;
  shadow.points = sheet.points;
  shadow.triangles = sheet.triangles;
  for (Vec3d& p : shadow.points) p.z = z;
  return shadow;
}

void require_apart(const SurfaceMesh& shadow) {
  std::vector<std::uint32_t> faces;
  for (const SelfCrossing& pair : find_self_crossings(shadow)) {
    faces.push_back(pair.a.value);
    faces.push_back(pair.b.value);
  }
  if (!faces.empty()) refuse_faces("meet others when seen along z: it is no heightfield", std::move(faces));
}

/// Appends the shadow, facing down, and the walls. The sheet faces up and lies above.
void close_below(SurfaceMesh& solid, const SurfaceMesh& shadow) {
  const std::size_t n = solid.points.size();
  const MeshTopology topology = build_topology(shadow);
  solid.points.insert(solid.points.end(), shadow.points.begin(), shadow.points.end());
  for (const Triangle& t : shadow.triangles) {
    solid.triangles.push_back({VertexId(n + t[0].index()), VertexId(n + t[2].index()), VertexId(n + t[1].index())});
  }
  for (const MeshEdgeId e : find_boundary_edges(topology)) {
    const HalfEdge h = topology.uses_of(e)[0];
    const VertexId a = origin_of(shadow, h), b = origin_of(shadow, next_in_face(h));
    const VertexId below_a(n + a.index()), below_b(n + b.index());
    solid.triangles.push_back({b, a, below_a});
    solid.triangles.push_back({b, below_a, below_b});
  }
}

void label_new_faces(SurfaceMesh& solid, std::size_t sheet_faces) {
  if (solid.face_labels.empty()) return;
  const auto base = static_cast<std::uint32_t>(solid.label_names.size());
  solid.label_names.insert(solid.label_names.end(), {"base", "side"});
  solid.face_labels.resize(2 * sheet_faces, base);
  solid.face_labels.resize(solid.triangles.size(), base + 1);
}

}  // namespace

SurfaceMesh extrude_to(const SurfaceMesh& sheet, double z) {
  validate(sheet);
  if (!(std::fabs(z) <= std::numeric_limits<double>::max())) throw Error(ErrorCode::InvalidArgument, stage, "z is not a finite number");
  const WeldedMesh welded = weld(sheet);
  MeshPart part = compact(welded.mesh, welded.old_vertex);
  turn_up(part.mesh);
  const bool below = is_below(part, z);
  const SurfaceMesh shadow = shadow_of(part.mesh, z);
  require_apart(shadow);
  SurfaceMesh solid = std::move(part.mesh);
  const std::size_t sheet_faces = solid.triangles.size();
  close_below(solid, shadow);
  label_new_faces(solid, sheet_faces);
  solid.walls.clear();
  resize_face_marks(solid);
  if (!below) turn_over_all(solid);
  return solid;
}

}  // namespace mortise
