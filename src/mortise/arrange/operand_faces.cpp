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
    if (faces.is_wall[SourceId(f)] != 0) continue;
    const PlanePoints& c = faces.corners[SourceId(f)];
    for (std::size_t i = 0; i < 3; ++i) {
      sum.add(c[i], c[(i + 1) % 3]);
      sum.subtract(c[(i + 1) % 3], c[i]);
    }
  }
  return sum.low == 0 && sum.high == 0;
}

// Corners of the faces of one operand, equal positions being one vertex: the lowest.
using WeldedCorners = std::array<std::uint32_t, 3>;

// Finds the lowest vertex at each point, one operand after the other; its memory grows with the points, its time does not.
class Welder {
 public:
  std::vector<WeldedCorners> weld(const SurfaceMesh& mesh, const std::vector<PointId>& point_of, std::size_t point_count) {
    constexpr std::uint32_t none = 0xffffffffU;
    lowest_vertex_.resize(point_count, none);
    std::vector<std::uint32_t> lowest(point_of.size());
    for (std::uint32_t v = 0; v < point_of.size(); ++v) {
      std::uint32_t& first = lowest_vertex_[point_of[v].index()];
      if (first == none) first = v;
      lowest[v] = first;
    }
    for (const PointId p : point_of) lowest_vertex_[p.index()] = none;
    std::vector<WeldedCorners> corners;
    corners.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) corners.push_back({lowest[t[0].index()], lowest[t[1].index()], lowest[t[2].index()]});
    return corners;
  }

 private:
  std::vector<std::uint32_t> lowest_vertex_;
};

// Do two faces have the same three corners? Only faces with the same lowest corner are compared.
bool has_coincident_faces(std::vector<WeldedCorners> corners, std::size_t vertex_count) {
  std::vector<std::uint32_t> begin(vertex_count + 1, 0);
  for (WeldedCorners& c : corners) {
    std::sort(c.begin(), c.end());
    ++begin[c[0] + 1];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
  std::vector<std::array<std::uint32_t, 2>> others(corners.size());  // the two higher corners, grouped by the lowest
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const WeldedCorners& c : corners) others[next[c[0]]++] = {c[1], c[2]};
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (begin[v + 1] - begin[v] < 2) continue;
    const auto first = others.begin() + begin[v];
    const auto last = others.begin() + begin[v + 1];
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
void number_parts(const std::vector<WeldedCorners>& corners, std::size_t vertex_count, OperandFaces& faces) {
  UnionFind joined(vertex_count);
  for (const WeldedCorners& c : corners) {
    joined.join(c[0], c[1]);
    joined.join(c[1], c[2]);
  }
  for (const WeldedCorners& c : corners) faces.part.push_back(joined.find(c[0]));
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

SelfContacts self_contacts_of(const OperandFaces& faces, OperandId k, bool has_coincident) {
  if (has_coincident || !is_closed(faces, k)) return SelfContacts::All;
  if (has_meeting_parts(faces, k)) return SelfContacts::Parts;
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

void append_operand(const SurfaceMesh& mesh, Welder& welder, OperandFaces& faces) {
  const OperandId k(faces.operand_count());
  std::vector<PointId>& point_of = faces.point_of_vertex[faces.point_of_vertex.push_back({})];
  point_of.reserve(mesh.points.size());
  for (const Vec3d& p : mesh.points) point_of.push_back(faces.points.add_input(p));
  for (const Triangle& t : mesh.triangles) {
    const PlanePoints c{point_of[t[0].index()], point_of[t[1].index()], point_of[t[2].index()]};
    faces.corners.push_back(c);
    faces.operand.push_back(k);
    faces.shape.push_back(shape_of(faces.points, c));
  }
  append_walls(mesh, faces);
  faces.first.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  const std::vector<WeldedCorners> corners = welder.weld(mesh, point_of, faces.points.size());
  number_parts(corners, mesh.points.size(), faces);
  faces.self_contacts.push_back(self_contacts_of(faces, k, has_coincident_faces(corners, mesh.points.size())));
  faces.bounds.push_back({});
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) faces.bounds[k].extend(faces.box(SourceId(f)));
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
  faces.is_wall.reserve(face_count);
  faces.first.push_back(0);
  Welder welder;
  for (const SurfaceMesh* mesh : operands) append_operand(*mesh, welder, faces);
  if (operands.size() == 1) faces.self_contacts[OperandId(0)] = SelfContacts::All;
  return faces;
}

}  // namespace mortise
