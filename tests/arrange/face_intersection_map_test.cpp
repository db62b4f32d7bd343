// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The face intersection map: the paper's example, every kind of contact, shared lines, and independence of the order of faces.
#include "mortise/arrange/face_intersection_map.h"

#include <algorithm>
#include <map>
#include <set>

#include "support/arrangement.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// The stages up to the map, without the crossings of segments that the next stage adds.
struct Mapped {
  explicit Mapped(const std::vector<SurfaceMesh>& operands)
      : faces(gather(operands)),
        contacts(find_contacts(faces, std::uint64_t{1} << 31, {})),
        overlays(overlay_coplanar(faces, contacts)),
        map(build_face_intersection_map(faces, contacts, overlays)) {}

  OperandFaces faces;
  Contacts contacts;
  Overlays overlays;
  FaceIntersectionMap map;

  [[nodiscard]] OverlayId overlay(std::size_t k, std::size_t f) const { return overlays.of_face(SourceId(faces.first[OperandId(k)] + f)); }
  [[nodiscard]] std::array<double, 3> position(PointId p) const {
    const Vec3d& x = faces.points.nearest(p);
    return {x.x, x.y, x.z};
  }
};

using Position = std::array<double, 3>;
using Positions = std::set<Position>;
using EndPair = std::array<Position, 2>;
using Ends = std::set<EndPair>;

template <class Points>
Positions positions(const Mapped& scene, const Points& points) {
  Positions result;
  for (const PointId p : points) result.insert(scene.position(p));
  return result;
}

/// The segments of a face by the positions of their ends.
Ends segments(const Mapped& scene, std::size_t k, std::size_t f) {
  Ends result;
  for (const Segment& s : scene.map.segments_of(scene.overlay(k, f))) {
    Position p = scene.position(s.p), q = scene.position(s.q);
    if (q < p) std::swap(p, q);
    result.insert({p, q});
  }
  return result;
}

Positions isolated(const Mapped& scene, std::size_t k, std::size_t f) {
  return positions(scene, scene.map.isolated_of(scene.overlay(k, f)));
}

/// Points put on edge i of a face, its ends included.
Positions on_edge(const Mapped& scene, std::size_t k, std::size_t f, std::size_t i) {
  const SlotId slot = scene.overlays.slot_of_face[SourceId(scene.faces.first[OperandId(k)] + f)];
  const LineId line = scene.map.edge_line[slot][i];
  Positions result;
  for (const PointOnLine& p : scene.map.points_on_lines) {
    if (p.line == line) result.insert(scene.position(p.point));
  }
  return result;
}

SurfaceMesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return make_mesh({a, b, c}, {{0, 1, 2}}); }

// In z = 0, corner 0 at the origin.
const SurfaceMesh table = triangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0});

}  // namespace

TEST_CASE("the example of the paper: two faces with a common edge pass through a third (Figs. 10 and 11)") {
  // F1 and F2 share edge E67; F3 reaches into both with edges E52 and E50.
  const SurfaceMesh first = make_mesh({{4, 0, 0}, {4, 0, 8}, {0, 4, 4}, {8, 4, 4}}, {{0, 1, 2}, {1, 0, 3}});
  const SurfaceMesh second = triangle({1, 1, 4}, {4, -9, 4}, {7, 1, 4});
  const Mapped scene({second, first});
  // F3 in z = 4 crosses F1 where x + y = 4 and F2 where x - y = 4: in E67 at (4, 0, 4); its edges cut them at y = 1.
  const Position p1{3, 1, 4}, p2{5, 1, 4}, p3{4, 0, 4};
  CHECK(segments(scene, 1, 0) == Ends{EndPair{p1, p3}});
  CHECK(segments(scene, 1, 1) == Ends{EndPair{p3, p2}});
  CHECK(segments(scene, 0, 0) == Ends{EndPair{p1, p3}, EndPair{p3, p2}});
  CHECK(positions(scene, scene.map.contact_points) == Positions{p1, p2, p3});
  CHECK(scene.map.contact_points.size() == 3);
  CHECK(on_edge(scene, 1, 0, 0) == Positions{{4, 0, 0}, {4, 0, 8}, p3});
  CHECK(on_edge(scene, 1, 1, 0) == on_edge(scene, 1, 0, 0));
  CHECK(on_edge(scene, 0, 0, 2) == Positions{{7, 1, 4}, {1, 1, 4}, p1, p2});
}

TEST_CASE("two triangles through each other share one segment on one line") {
  const Mapped scene({table, triangle({2, 2, 4}, {1, 2, -4}, {3, 2, -4})});
  CHECK(segments(scene, 0, 0) == Ends{EndPair{Position{1.5, 2, 0}, Position{2.5, 2, 0}}});
  CHECK(segments(scene, 1, 0) == segments(scene, 0, 0));
  const auto of_a = scene.map.segments_of(scene.overlay(0, 0)), of_b = scene.map.segments_of(scene.overlay(1, 0));
  REQUIRE((of_a.size() == 1 && of_b.size() == 1));
  CHECK(of_a[0] == of_b[0]);
  const Line& line = scene.map.lines[of_a[0].line];
  CHECK_FALSE(line.is_edge());
  CHECK((line.overlay_a == scene.overlay(0, 0) && line.overlay_b == scene.overlay(1, 0)));
  CHECK(scene.map.isolated.empty());
}

TEST_CASE("a corner on the inside is an isolated point of the face it touches") {
  const Mapped scene({table, triangle({2, 2, 0}, {1, 2, 4}, {3, 2, 4})});
  CHECK(isolated(scene, 0, 0) == Positions{{2, 2, 0}});
  CHECK(isolated(scene, 1, 0).empty());
  CHECK(scene.map.segments.empty());
  CHECK(positions(scene, scene.map.contact_points) == Positions{{2, 2, 0}});
  CHECK(scene.faces.points.size() == 6);  // the corner is the point
}

TEST_CASE("a corner on an edge is a point of that edge") {
  const Mapped scene({table, triangle({2, 0, 0}, {1, -2, 4}, {3, -2, 4})});
  CHECK(scene.map.isolated.empty());
  CHECK(scene.map.segments.empty());
  CHECK(on_edge(scene, 0, 0, 0) == Positions{{0, 0, 0}, {8, 0, 0}, {2, 0, 0}});
  CHECK(positions(scene, scene.map.contact_points) == Positions{{2, 0, 0}});
}

TEST_CASE("a corner on a corner is a contact point and nothing else") {
  const Mapped scene({table, triangle({8, 0, 0}, {9, 1, 4}, {9, -1, 4})});
  CHECK(positions(scene, scene.map.contact_points) == Positions{{8, 0, 0}});
  CHECK((scene.map.isolated.empty() && scene.map.segments.empty()));
  CHECK(scene.faces.points.size() == 5);
}

TEST_CASE("edges that cross in one point share it") {
  const Mapped scene({table, triangle({2, -1, -1}, {2, 1, 1}, {2, -9, 9})});
  CHECK(on_edge(scene, 0, 0, 0) == Positions{{0, 0, 0}, {8, 0, 0}, {2, 0, 0}});
  CHECK(on_edge(scene, 1, 0, 0) == Positions{{2, -1, -1}, {2, 1, 1}, {2, 0, 0}});
  CHECK((scene.map.isolated.empty() && scene.map.segments.empty()));
  CHECK(scene.faces.points.size() == 7);
}

TEST_CASE("a segment along an edge lies on the line of that edge, in the other face only") {
  const Mapped scene({table, triangle({1, 1, 0}, {3, 1, 0}, {2, 1, 4})});
  const auto of_table = scene.map.segments_of(scene.overlay(0, 0));
  REQUIRE(of_table.size() == 1);
  const SlotId slot = scene.overlays.slot_of_face[SourceId(std::size_t{1})];
  CHECK(of_table[0].line == scene.map.edge_line[slot][0]);
  CHECK(scene.map.lines[of_table[0].line].is_edge());
  CHECK(scene.map.segments_of(scene.overlay(1, 0)).empty());
  CHECK(scene.map.isolated.empty());
}

TEST_CASE("a part of an edge in the face and the rest beyond: the line of the edge is split where the face ends") {
  const Mapped scene({table, triangle({1, 1, 0}, {9, 1, 0}, {5, 1, 4})});
  CHECK(segments(scene, 0, 0) == Ends{EndPair{Position{1, 1, 0}, Position{7, 1, 0}}});
  CHECK(on_edge(scene, 1, 0, 0) == Positions{{1, 1, 0}, {9, 1, 0}, {7, 1, 0}});
  CHECK(on_edge(scene, 0, 0, 1) == Positions{{8, 0, 0}, {0, 8, 0}, {7, 1, 0}});
}

TEST_CASE("an edge along an edge makes the two lines one and no segment") {
  const Mapped scene({table, triangle({2, 0, 0}, {9, 0, 0}, {4, 0, 4})});
  CHECK(scene.map.segments.empty());
  CHECK(scene.map.isolated.empty());
  REQUIRE(scene.map.same_line.size() == 1);
  const auto& [a, b] = scene.map.same_line[0];
  const auto line_of = [&](std::size_t face) { return scene.map.edge_line[scene.overlays.slot_of_face[SourceId(face)]][0]; };
  CHECK((a == line_of(0) && b == line_of(1)));
  CHECK(on_edge(scene, 0, 0, 0) == Positions{{0, 0, 0}, {8, 0, 0}, {2, 0, 0}});
  CHECK(on_edge(scene, 1, 0, 0) == Positions{{2, 0, 0}, {9, 0, 0}, {8, 0, 0}});
}

TEST_CASE("a whole common edge is one line, and nothing is made") {
  const Mapped scene({table, triangle({8, 0, 0}, {0, 0, 0}, {4, 0, 4})});
  CHECK((scene.map.segments.empty() && scene.map.isolated.empty()));
  CHECK(scene.faces.points.size() == 4);
  CHECK(scene.map.lines.size() == 5);
}

TEST_CASE("an isolated point that ends a segment of the same face is isolated no more") {
  // The roof touches the table with its corner; its other face stands on the table from that corner on.
  const SurfaceMesh roof = make_mesh({{2, 2, 0}, {1, 2, 4}, {3, 2, 4}, {2, 3, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Mapped scene({table, roof});
  CHECK(segments(scene, 0, 0) == Ends{EndPair{Position{2, 2, 0}, Position{2, 3, 0}}});
  CHECK(isolated(scene, 0, 0).empty());
}

TEST_CASE("isolated points keep company with segments elsewhere in the face") {
  const SurfaceMesh two = joined({triangle({2, 2, 0}, {1, 2, 4}, {3, 2, 4}), triangle({1, 1, 4}, {0.5, 1, -4}, {1.5, 1, -4})});
  const Mapped scene({table, two});
  CHECK(isolated(scene, 0, 0) == Positions{{2, 2, 0}});
  CHECK(segments(scene, 0, 0) == Ends{EndPair{Position{0.75, 1, 0}, Position{1.25, 1, 0}}});
}

TEST_CASE("faces round an edge give one point where it passes through, faces round a corner one where it touches") {
  const SurfaceMesh spike = tetrahedron({1, 1, -1}, {2, 1, 3}, {1, 2, 3}, {1, 1, 3});
  const Mapped through({table, spike});
  CHECK(through.map.contact_points.size() == 3);  // three edges go down to the tip
  CHECK(through.map.segments_of(through.overlay(0, 0)).size() == 3);
  const Mapped touching({table, moved(spike, {0, 0, 1})});
  CHECK(touching.map.contact_points.size() == 1);
}

TEST_CASE("an edge through faces that coincide makes one point in all of them") {
  const Mapped scene({table, triangle({1, 1, 0}, {1, 6, 0}, {6, 1, 0}), triangle({2, 2, 4}, {2, 2, -4}, {9, 9, 5})});
  CHECK(scene.overlay(0, 0) == scene.overlay(1, 0));
  CHECK(scene.overlays.size() == 2);
  // (2, 2, 0) on the upright edge, and (5.2..., ...) or so on the edges of the two faces where the third leaves them.
  const auto count = std::count_if(scene.map.contact_points.begin(), scene.map.contact_points.end(), [&](PointId p) {
    return scene.position(p) == Position{2, 2, 0};
  });
  CHECK(count == 1);
  const auto rows = scene.map.segments_of(scene.overlay(0, 0));
  for (const Segment& s : rows) CHECK(scene.map.lines[s.line].overlay_b == scene.overlay(2, 0));
}

TEST_CASE("no contact: no lines, no points, an empty row for nobody") {
  const Mapped scene({table, moved(table, {0, 0, 1})});
  CHECK((scene.map.lines.empty() && scene.map.contact_points.empty() && scene.map.segments.empty()));
  CHECK(scene.map.first_segment.values() == std::vector<std::uint32_t>{0});
}

// ---- any order of faces --------------------------------------------------------------------------------------------------

namespace {

/// The same operand with its faces in reverse order and their corners turned.
SurfaceMesh renumbered(SurfaceMesh mesh) {
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    Triangle& t = mesh.triangles[f];
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(f % 3), t.end());
  }
  return mesh;
}

using FaceKey = std::set<Position>;

/// Rows by the corners of their faces; segments by their ends.
std::map<FaceKey, std::pair<Ends, Positions>> rows_of(const Mapped& scene) {
  std::map<FaceKey, std::pair<Ends, Positions>> rows;
  for (std::size_t f = 0; f < scene.faces.corners.size(); ++f) {
    if (!scene.overlays.slot_of_face[SourceId(f)].is_valid()) continue;
    FaceKey key;
    for (const PointId p : scene.faces.corners[SourceId(f)]) key.insert(scene.position(p));
    rows[key] = {segments(scene, 0, f), isolated(scene, 0, f)};
  }
  return rows;
}

}  // namespace

TEST_CASE("the map does not depend on the order of operands, faces and corners") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    std::vector<SurfaceMesh> backward;
    for (auto k = scene.operands.rbegin(); k != scene.operands.rend(); ++k) backward.push_back(renumbered(*k));
    const Mapped first(scene.operands), second(backward);
    CHECK(rows_of(first) == rows_of(second));
    CHECK(positions(first, first.map.contact_points) == positions(second, second.map.contact_points));
    CHECK(first.map.contact_points.size() == second.map.contact_points.size());
  }
}

TEST_CASE("rows are sorted, without duplicates, and their ends are contact points on their lines") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const Mapped m(scene.operands);
    const auto& points = m.map.contact_points;
    CHECK(std::is_sorted(points.begin(), points.end()));
    CHECK(std::adjacent_find(points.begin(), points.end()) == points.end());
    std::set<std::pair<LineId, PointId>> on_lines;
    for (const PointOnLine& p : m.map.points_on_lines) on_lines.emplace(p.line, p.point);
    for (std::size_t i = 0; i < m.overlays.size(); ++i) {
      const auto row = m.map.segments_of(OverlayId(i));
      CHECK(std::is_sorted(row.begin(), row.end()));
      CHECK(std::adjacent_find(row.begin(), row.end()) == row.end());
      for (const Segment& s : row) {
        CHECK(s.p < s.q);
        CHECK((on_lines.count({s.line, s.p}) == 1 && on_lines.count({s.line, s.q}) == 1));
        CHECK((std::binary_search(points.begin(), points.end(), s.p) && std::binary_search(points.begin(), points.end(), s.q)));
        for (const PointId p : m.map.isolated_of(OverlayId(i))) CHECK((p != s.p && p != s.q));
      }
    }
  }
}

namespace {

Positions corners_of(const Scene& scene) {
  Positions corners;
  for (const SurfaceMesh& operand : scene.operands) {
    for (const Vec3d& p : operand.points) corners.insert({p.x, p.y, p.z});
  }
  return corners;
}

/// Does the corner of an operand lie on another operand?
bool is_on_another(const Scene& scene, const Position& corner) {
  const Vec3d p{corner[0], corner[1], corner[2]};
  std::size_t touched = 0;
  for (const SurfaceMesh& operand : scene.operands) touched += oracle::winding_number(operand, oracle::exact(p)) ? 0 : 1;
  return touched > 1;
}

}  // namespace

TEST_CASE("contact points of the small scenes are the oracle's, rounded once") {
  for (const Scene& scene : scenes_for_rationals()) {
    INFO(scene.name);
    const Arrangement whole(scene.operands);  // with the crossings of segments, which the oracle has too
    const Positions corners = corners_of(scene);
    Positions found, expected;
    for (const PointId p : whole.map.contact_points) {
      const Vec3d& x = whole.faces.points.nearest(p);
      found.insert({x.x, x.y, x.z});
    }
    for (const oracle::MadePoint& p : oracle::made_points(pointers_to(scene.operands)))
      expected.insert({p.rounded.x, p.rounded.y, p.rounded.z});
    for (const Position& p : corners) expected.erase(p);
    for (const Position& p : corners) {
      if (is_on_another(scene, p)) expected.insert(p);
    }
    CHECK(found.size() == whole.map.contact_points.size());
    CHECK(found == expected);
  }
}
