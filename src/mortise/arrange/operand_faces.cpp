// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Gathers the operands of a call: weld, face shapes, closedness, parts.
#include "mortise/arrange/operand_faces.h"

#include <algorithm>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

// Finds the lowest vertex at each point, one operand after the other; its memory grows with the points, its time does not.
class Welder {
 public:
  std::vector<std::uint32_t> lowest_vertices(const std::vector<PointId>& point_of, std::size_t point_count) {
    constexpr std::uint32_t none = 0xffffffffU;
    lowest_vertex_.resize(point_count, none);
    std::vector<std::uint32_t> lowest(point_of.size());
    for (std::uint32_t v = 0; v < point_of.size(); ++v) {
      std::uint32_t& first = lowest_vertex_[point_of[v].index()];
      if (first == none) first = v;
      lowest[v] = first;
    }
    for (const PointId p : point_of) lowest_vertex_[p.index()] = none;
    return lowest;
  }

 private:
  std::vector<std::uint32_t> lowest_vertex_;
};

FaceShape shape_of(const PointSet& points, const PlanePoints& c) {
  if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return FaceShape::Repeated;
  return are_collinear(points.nearest(c[0]), points.nearest(c[1]), points.nearest(c[2])) ? FaceShape::Collinear : FaceShape::Proper;
}

bool has_meeting_parts(const OperandFaces& faces, OperandId k, const Connectivity& connectivity) {
  if (connectivity.part_count < 2) return false;
  std::vector<Box3> boxes(connectivity.part_count);
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) boxes[faces.part[SourceId(f)]].extend(faces.box(SourceId(f)));
  bool meet = false;
  for_each_meeting_pair_within(BoxTree(boxes), [&](std::uint32_t, std::uint32_t) { meet = true; });
  return meet;
}

SelfContacts self_contacts_of(const OperandFaces& faces, OperandId k, const Connectivity& connectivity) {
  if (connectivity.has_coincident_faces || !connectivity.is_closed) return SelfContacts::All;
  if (has_meeting_parts(faces, k, connectivity)) return SelfContacts::Parts;
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) {
    if (faces.shape[SourceId(f)] == FaceShape::Collinear) return SelfContacts::Collinear;
  }
  return SelfContacts::None;
}

void append_walls(const SurfaceMesh& mesh, OperandFaces& faces) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) faces.is_wall.push_back(mesh.walls.empty() ? 0 : mesh.walls[t]);
  const bool has_walls = std::find(mesh.walls.begin(), mesh.walls.end(), 1) != mesh.walls.end();
  const bool has_others = mesh.walls.empty() || std::find(mesh.walls.begin(), mesh.walls.end(), 0) != mesh.walls.end();
  faces.kind.push_back(!has_walls ? OperandKind::Solid : has_others ? OperandKind::SolidWithWalls : OperandKind::Sheet);
}

// Adds the points of a prepared operand, each position once.
std::vector<PointId> add_positions(const SurfaceMesh& mesh, const PreparedOperand& prepared, PointSet& points) {
  std::vector<PointId> point_at;
  point_at.reserve(prepared.first_vertex().size());
  for (const std::uint32_t v : prepared.first_vertex()) point_at.push_back(points.add_input(mesh.points[v]));
  return point_at;
}

// Are all positions of an operand still different points? Those from `first_own` on are its own, in ascending order where it added them.
bool are_all_different(const std::vector<PointId>& point_at, std::size_t first_own) {
  std::vector<PointId> of_others;
  std::size_t next_own = first_own;
  for (const PointId p : point_at) {
    if (p.index() < first_own) {
      of_others.push_back(p);
    } else if (p.index() != next_own++) {
      return false;
    }
  }
  std::sort(of_others.begin(), of_others.end());
  return std::adjacent_find(of_others.begin(), of_others.end()) == of_others.end();
}

// Adds the points of operand k. Does what was known of it still hold?
bool append_points(const OperandList& operands, OperandId k, OperandFaces& faces) {
  const SurfaceMesh& mesh = operands.mesh(k.index());
  const PreparedOperand* prepared = operands.prepared(k.index());
  std::vector<PointId>& point_of = faces.point_of_vertex[faces.point_of_vertex.push_back({})];
  point_of.reserve(mesh.points.size());
  if (prepared == nullptr) {
    for (const Vec3d& p : mesh.points) point_of.push_back(faces.points.add_input(p));
    return false;
  }
  const std::size_t first_own = faces.points.size();
  const std::vector<PointId> point_at = add_positions(mesh, *prepared, faces.points);
  for (const std::uint32_t position : prepared->position_of_vertex()) point_of.push_back(point_at[position]);
  return are_all_different(point_at, first_own);
}

// What a prepared operand knows of its faces where it is now; of a plain mesh nothing.
KnownOperand known_operand(const OperandList& operands, OperandId k) {
  const PreparedOperand& prepared = *operands.prepared(k.index());
  const bool is_in_place = operands.is_in_place(k.index());
  const AffineMap& place = operands.place(k.index());
  const Box3& bounds = prepared.tree().bounds();
  return {&prepared, is_in_place, is_in_place ? 0 : rounding_seen_in_mesh(place, bounds), PlacedBoxes(place, bounds)};
}

void append_faces(const SurfaceMesh& mesh, OperandId k, OperandFaces& faces) {
  const KnownOperand& known = faces.known[k];
  const bool keeps_area = known.prepared != nullptr && known.prepared->least_height() > 4 * known.rounding;
  const std::vector<PointId>& point_of = faces.point_of_vertex[k];
  Box3 bounds;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const PlanePoints c{point_of[t[0].index()], point_of[t[1].index()], point_of[t[2].index()]};
    faces.corners.push_back(c);
    faces.operand.push_back(k);
    faces.shape.push_back(keeps_area && known.prepared->has_area(FaceId(f)) ? FaceShape::Proper : shape_of(faces.points, c));
    for (const VertexId v : t) bounds.extend(mesh.points[v.index()]);
  }
  append_walls(mesh, faces);
  faces.first.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  faces.bounds.push_back(bounds);
}

void append_connectivity(const Connectivity& connectivity, OperandId k, OperandFaces& faces) {
  for (const std::uint32_t part : connectivity.part_of_face) faces.part.push_back(part);
  faces.self_contacts.push_back(self_contacts_of(faces, k, connectivity));
}

void validate_operand(const SurfaceMesh& mesh, std::size_t k) {
  try {
    validate(mesh);
  } catch (Error& error) {
    throw std::move(error).in_operand(k);
  }
}

void append_operand(const OperandList& operands, OperandId k, Welder& welder, OperandFaces& faces) {
  const SurfaceMesh& mesh = operands.mesh(k.index());
  const bool is_known = append_points(operands, k, faces);
  faces.known.push_back(is_known ? known_operand(operands, k) : KnownOperand{});
  append_faces(mesh, k, faces);
  if (is_known) {
    append_connectivity(operands.prepared(k.index())->connectivity(), k, faces);
  } else {
    append_connectivity(find_connectivity(mesh, welder.lowest_vertices(faces.point_of_vertex[k], faces.points.size())), k, faces);
  }
}

}  // namespace

Box3 OperandFaces::box(SourceId f) const {
  Box3 result;
  for (std::size_t i = 0; i < 3; ++i) result.extend(corner_position(f, i));
  return result;
}

void make_sheet(OperandId k, OperandFaces& faces) {
  faces.kind[k] = OperandKind::Sheet;
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) faces.is_wall[SourceId(f)] = 1;
}

OperandFaces gather_operands(const OperandList& operands) {
  OperandFaces faces;
  std::size_t point_count = 0;
  std::size_t face_count = 0;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (operands.prepared(k) == nullptr) validate_operand(operands.mesh(k), k);
    point_count += operands.mesh(k).points.size();
    face_count += operands.mesh(k).triangles.size();
  }
  faces.points.reserve(point_count);
  faces.corners.reserve(face_count);
  faces.shape.reserve(face_count);
  faces.operand.reserve(face_count);
  faces.is_wall.reserve(face_count);
  faces.first.push_back(0);
  Welder welder;
  for (std::size_t k = 0; k < operands.size(); ++k) append_operand(operands, OperandId(k), welder, faces);
  if (operands.size() == 1) faces.self_contacts[OperandId(0)] = SelfContacts::All;
  return faces;
}

}  // namespace mortise
