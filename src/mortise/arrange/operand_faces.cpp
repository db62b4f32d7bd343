// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Gathers the operands of a call: weld, face shapes, closedness, parts.
#include "mortise/arrange/operand_faces.h"

#include <algorithm>
#include <functional>

#include "mortise/base/bits.h"
#include "mortise/base/error.h"
#include "mortise/base/union_find.h"

#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

// 128 bits of a directed edge; the sum over all edges less that of their reverses is zero for a closed surface.
struct EdgeSum {
  std::uint64_t low = 0, high = 0;

  void add(PointId from, PointId to) {
    const std::uint64_t key = (std::uint64_t{from.value} << 32U) | to.value;
    low += mixed_bits(key);
    high += mixed_bits(key ^ 0x9e3779b97f4a7c15U);
  }
  void subtract(PointId from, PointId to) {
    const std::uint64_t key = (std::uint64_t{from.value} << 32U) | to.value;
    low -= mixed_bits(key);
    high -= mixed_bits(key ^ 0x9e3779b97f4a7c15U);
  }
};

bool is_closed(const OperandFaces& faces, OperandId k) {
  EdgeSum sum;
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) {
    const PlanePoints& c = faces.corners[SourceId(f)];
    for (std::size_t i = 0; i < 3; ++i) {
      sum.add(c[i], c[(i + 1) % 3]);
      sum.subtract(c[(i + 1) % 3], c[i]);
    }
  }
  return sum.low == 0 && sum.high == 0;
}

PlanePoints sorted_corners(PlanePoints c) {
  std::sort(c.begin(), c.end());
  return c;
}

// Do two faces of the operand have the same three corners? Only faces with the same lowest corner are compared.
bool has_coincident_faces(const OperandFaces& faces, OperandId k) {
  const std::uint32_t count = faces.end(k) - faces.first[k];
  std::vector<std::uint32_t> begin(faces.points.size() + 1, 0);
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) ++begin[sorted_corners(faces.corners[SourceId(f)])[0].index() + 1];
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) begin[p + 1] += begin[p];
  std::vector<std::array<PointId, 2>> others(count);  // the two higher corners, grouped by the lowest
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) {
    const PlanePoints c = sorted_corners(faces.corners[SourceId(f)]);
    others[next[c[0].index()]++] = {c[1], c[2]};
  }
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
    if (begin[p + 1] - begin[p] < 2) continue;
    const auto first = others.begin() + begin[p];
    const auto last = others.begin() + begin[p + 1];
    std::sort(first, last);
    if (std::adjacent_find(first, last) != last) return true;
  }
  return false;
}

FaceShape shape_of(const PointSet& points, const PlanePoints& c) {
  if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return FaceShape::Repeated;
  return are_collinear(points.nearest(c[0]), points.nearest(c[1]), points.nearest(c[2])) ? FaceShape::Collinear : FaceShape::Proper;
}

// Parts of one operand, numbered by one of their vertices.
void number_parts(const SurfaceMesh& mesh, OperandId k, OperandFaces& faces) {
  UnionFind joined(mesh.points.size());
  std::vector<std::uint32_t> vertex_of(faces.points.size(), 0xffffffffU);  // the first vertex of the operand at each point
  const std::vector<PointId>& point_of = faces.point_of_vertex[k];
  const auto vertex = [&](VertexId v) {
    std::uint32_t& first = vertex_of[point_of[v.index()].index()];
    if (first == 0xffffffffU) first = v.value;
    return first;
  };
  for (const Triangle& t : mesh.triangles) {
    joined.join(vertex(t[0]), vertex(t[1]));
    joined.join(vertex(t[1]), vertex(t[2]));
  }
  for (const Triangle& t : mesh.triangles) faces.part.push_back(joined.find(vertex(t[0])));
}

bool has_meeting_parts(const OperandFaces& faces, OperandId k) {
  if (faces.end(k) == faces.first[k]) return false;
  const auto parts = std::span(faces.part.values()).subspan(faces.first[k], faces.end(k) - faces.first[k]);
  if (std::adjacent_find(parts.begin(), parts.end(), std::not_equal_to<>()) == parts.end()) return false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_part;
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) by_part.emplace_back(faces.part[SourceId(f)], f);
  std::sort(by_part.begin(), by_part.end());
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < by_part.size(); ++i) {
    if (i == 0 || by_part[i].first != by_part[i - 1].first) boxes.emplace_back();
    boxes.back().extend(faces.box(SourceId(by_part[i].second)));
  }
  bool meet = false;
  for_each_meeting_pair_within(BoxTree(boxes), [&](std::uint32_t, std::uint32_t) { meet = true; });
  return meet;
}

SelfContacts self_contacts_of(const OperandFaces& faces, OperandId k, bool has_collinear) {
  if (!is_closed(faces, k) || has_coincident_faces(faces, k)) return SelfContacts::All;
  if (has_meeting_parts(faces, k)) return SelfContacts::Parts;
  return has_collinear ? SelfContacts::Collinear : SelfContacts::None;
}

void append_operand(const SurfaceMesh& mesh, OperandFaces& faces) {
  const OperandId k(faces.operand_count());
  std::vector<PointId>& point_of = faces.point_of_vertex[faces.point_of_vertex.push_back({})];
  point_of.reserve(mesh.points.size());
  for (const Vec3d& p : mesh.points) point_of.push_back(faces.points.add_input(p));
  bool has_collinear = false;
  for (const Triangle& t : mesh.triangles) {
    const PlanePoints c{point_of[t[0].index()], point_of[t[1].index()], point_of[t[2].index()]};
    faces.corners.push_back(c);
    faces.operand.push_back(k);
    faces.shape.push_back(shape_of(faces.points, c));
    has_collinear |= faces.shape.values().back() == FaceShape::Collinear;
  }
  faces.first.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  number_parts(mesh, k, faces);
  faces.self_contacts.push_back(self_contacts_of(faces, k, has_collinear));
  faces.bounds.push_back({});
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) faces.bounds[k].extend(faces.box(SourceId(f)));
}

}  // namespace

Box3 OperandFaces::box(SourceId f) const {
  Box3 result;
  for (std::size_t i = 0; i < 3; ++i) result.extend(corner_position(f, i));
  return result;
}

OperandFaces gather_operands(std::span<const SurfaceMesh* const> operands) {
  OperandFaces faces;
  std::size_t point_count = 0;
  std::size_t face_count = 0;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    try {
      validate(*operands[k]);
    } catch (Error& error) {
      throw std::move(error).in_operand(k);
    }
    point_count += operands[k]->points.size();
    face_count += operands[k]->triangles.size();
  }
  faces.points.reserve(point_count);
  faces.corners.reserve(face_count);
  faces.shape.reserve(face_count);
  faces.operand.reserve(face_count);
  faces.first.push_back(0);
  for (const SurfaceMesh* mesh : operands) append_operand(*mesh, faces);
  if (operands.size() == 1) faces.self_contacts[OperandId(0)] = SelfContacts::All;
  return faces;
}

}  // namespace mortise
