// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Segments of one face that cross, touch and lie on each other, and the one subdivision that all faces of a line share.
#include "mortise/arrange/split_segments.h"

#include <algorithm>

#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return make_mesh({a, b, c}, {{0, 1, 2}}); }

// Big triangles of the planes z = 0, y = 0 and x = 0 round the origin.
const SurfaceMesh floor_z = triangle({-20, -20, 0}, {40, -20, 0}, {-20, 40, 0});
const SurfaceMesh wall_y = triangle({-20, 0, -20}, {40, 0, -20}, {-20, 0, 40});
const SurfaceMesh wall_x = triangle({0, -20, -20}, {0, 40, -20}, {0, -20, 40});

/// An upright triangle over the segment from (x0, y0) to (x1, y1) of z = 0, which is exactly its trace there.
SurfaceMesh upright(double x0, double y0, double x1, double y1) {
  return make_mesh({{x0, y0, -2}, {x1, y1, -2}, {x1, y1, 2}, {x0, y0, 2}}, {{0, 1, 2}, {0, 2, 3}});
}

/// The line on which faces f and g, one per operand, cross.
LineId trace(const Arrangement& scene, std::size_t f, std::size_t g) {
  const OverlayId a = scene.overlays.of_face(SourceId(f)), b = scene.overlays.of_face(SourceId(g));
  for (std::size_t i = 0; i < scene.map.lines.size(); ++i) {
    const Line& line = scene.map.lines[LineId(i)];
    if (!line.is_edge() && line.overlay_a == std::min(a, b) && line.overlay_b == std::max(a, b)) return LineId(i);
  }
  return LineId();
}

std::vector<Vec3d> positions(const Arrangement& scene, std::span<const PointId> points) {
  std::vector<Vec3d> result;
  for (const PointId p : points) result.push_back(scene.faces.points.nearest(p));
  return result;
}

/// The points of a line from one position to another, as that line of the map sees them.
std::vector<Vec3d> between(const Arrangement& scene, LineId line, const Vec3d& p, const Vec3d& q) {
  return positions(scene, scene.lines.between(line, scene.point_at(p), scene.point_at(q)));
}

/// All segments of face f's row, each as its subdivision.
std::vector<std::vector<Vec3d>> rows(const Arrangement& scene, std::size_t f) {
  std::vector<std::vector<Vec3d>> result;
  for (const Segment& s : scene.map.segments_of(scene.overlays.of_face(SourceId(f)))) {
    std::vector<Vec3d> row = positions(scene, scene.lines.between(s.line, s.p, s.q));
    if (row.front().x > row.back().x || (row.front().x == row.back().x && row.front().y > row.back().y))
      std::reverse(row.begin(), row.end());
    result.push_back(row);
  }
  return result;
}

bool has_row(const Arrangement& scene, std::size_t f, const std::vector<Vec3d>& row) {
  const auto all = rows(scene, f);
  return std::find(all.begin(), all.end(), row) != all.end();
}

}  // namespace

TEST_CASE("three faces through each other meet in one point that all three lines know") {
  const Arrangement scene({floor_z, wall_y, wall_x});
  const PointId origin = scene.point_at({0, 0, 0});
  REQUIRE(origin.is_valid());
  CHECK_FALSE(scene.faces.points.is_input(origin));
  for (const auto& [f, g] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    const LineId line = trace(scene, f, g);
    REQUIRE(line.is_valid());
    std::size_t count = 0;
    for (const PointOnLine& p : scene.map.points_on_lines) count += p.line == line && p.point == origin ? 1 : 0;
    CHECK(count > 0);
    const auto row = scene.map.segments_of(scene.overlays.of_face(SourceId(f)));
    for (const Segment& s : row) {
      if (s.line != line) continue;
      const auto points = scene.lines.between(line, s.p, s.q);
      CHECK(std::count(points.begin(), points.end(), origin) == 1);
    }
  }
  const auto& contact = scene.map.contact_points;
  CHECK(std::binary_search(contact.begin(), contact.end(), origin));
  for (std::size_t f = 0; f < 3; ++f) CHECK(scene.map.segments_of(scene.overlays.of_face(SourceId(f))).size() == 2);
}

TEST_CASE("a segment that ends on another splits it, and its face") {
  // The second wall starts in the plane y = 0 of the first.
  const Arrangement scene({floor_z, wall_y, triangle({3, 0, -4}, {3, 0, 4}, {3, 8, 0})});
  CHECK(has_row(scene, 0, {{-20, 0, 0}, {3, 0, 0}, {20, 0, 0}}));
  CHECK(has_row(scene, 0, {{3, 0, 0}, {3, 8, 0}}));
  CHECK(std::binary_search(scene.map.contact_points.begin(), scene.map.contact_points.end(), scene.point_at({3, 0, 0})));
}

TEST_CASE("one ulp before another segment a segment ends without splitting it") {
  const Arrangement scene({floor_z, wall_y, triangle({3, 0x1p-1074, -4}, {3, 0x1p-1074, 4}, {3, 8, 0})});
  CHECK(has_row(scene, 0, {{-20, 0, 0}, {20, 0, 0}}));
}

TEST_CASE("segments that share an end stay as they are") {
  const Arrangement scene({floor_z, triangle({3, 0, -4}, {3, 0, 4}, {3, 8, 0}), triangle({3, 0, -4}, {3, 0, 4}, {8, 1, 0})});
  CHECK(has_row(scene, 0, {{3, 0, 0}, {3, 8, 0}}));
  CHECK(has_row(scene, 0, {{3, 0, 0}, {8, 1, 0}}));
  CHECK(rows(scene, 0).size() == 2);
}

TEST_CASE("collinear segments that overlap share one subdivision") {
  // Both cross the floor along y = 0: one upright from 3 to 7, one slanted from 5 to 9.
  const SurfaceMesh first = triangle({1, 0, -1}, {5, 0, 1}, {9, 0, -1}), second = triangle({3, -1, -1}, {7, 1, 1}, {11, -1, -1});
  const Arrangement scene({floor_z, first, second});
  CHECK(rows(scene, 0) == std::vector<std::vector<Vec3d>>{{{3, 0, 0}, {5, 0, 0}, {7, 0, 0}}, {{5, 0, 0}, {7, 0, 0}, {9, 0, 0}}});
  CHECK(scene.lines.root(trace(scene, 0, 1)) == scene.lines.root(trace(scene, 0, 2)));
  CHECK(scene.lines.root(trace(scene, 0, 1)) == scene.lines.root(trace(scene, 1, 2)));
  CHECK(has_row(scene, 1, {{3, 0, 0}, {5, 0, 0}, {7, 0, 0}}));
  CHECK(has_row(scene, 2, {{5, 0, 0}, {7, 0, 0}, {9, 0, 0}}));
  CHECK(faults_of_facets(scene) == "");
}

TEST_CASE("collinear segments apart, or end to end, do not split each other") {
  const Arrangement apart({floor_z, upright(0, 0, 1, 0), upright(3, 0, 4, 0)});
  CHECK(has_row(apart, 0, {{0, 0, 0}, {0.5, 0, 0}}));  // 0.5: the diagonal of the wall
  CHECK(has_row(apart, 0, {{3, 0, 0}, {3.5, 0, 0}}));
  const Arrangement end_to_end({floor_z, upright(0, 0, 2, 0), upright(2, 0, 4, 0)});
  CHECK(has_row(end_to_end, 0, {{0, 0, 0}, {1, 0, 0}}));
  CHECK(has_row(end_to_end, 0, {{3, 0, 0}, {4, 0, 0}}));
  CHECK(rows(end_to_end, 0).size() == 4);
}

TEST_CASE("four faces through one line share all their ends along it") {
  // Pages round the x axis, each from its own start to its own end.
  const auto page = [](double from, double to, double y, double z) {
    return make_mesh({{from, -y, -z}, {to, -y, -z}, {to, y, z}, {from, y, z}}, {{0, 1, 2}, {0, 2, 3}});
  };
  const Arrangement scene({page(0, 8, 1, 0), page(1, 9, 0, 1), page(2, 10, 1, 1), page(3, 11, 1, -1)});
  CHECK(faults_of_facets(scene) == "");
  // Ends 0 .. 3 and 8 .. 11, and the middles 4, 5, 6, 7 where the diagonals cross the axis; 0 and 11 touch no other page.
  for (std::size_t k = 0; k < 4; ++k) {
    for (double x = static_cast<double>(k); x <= static_cast<double>(k) + 8; x += 1) {
      if (x == 0 || x == 11) continue;
      const PointId p = scene.point_at({x, 0, 0});
      bool is_corner = false;
      for (const SourceId f : {scene.face(k, 0), scene.face(k, 1)}) {
        for (const FacetId facet : scene.facets_of(f)) {
          const PlanePoints& c = scene.facets.corners[facet];
          is_corner |= std::find(c.begin(), c.end(), p) != c.end();
        }
      }
      INFO("page " << k << " at " << x);
      CHECK(is_corner);
    }
  }
}

TEST_CASE("an isolated point on a segment of the same face splits it") {
  const SurfaceMesh tip = triangle({5, 0, 0}, {5, -1, 4}, {6, -1, 4});
  const Arrangement scene({floor_z, wall_y, tip});
  CHECK(has_row(scene, 0, {{-20, 0, 0}, {5, 0, 0}, {20, 0, 0}}));
  const Arrangement beside({floor_z, wall_y, moved(tip, {0, -0.5, 0})});
  CHECK(has_row(beside, 0, {{-20, 0, 0}, {20, 0, 0}}));
  CHECK(beside.map.isolated_of(beside.overlays.of_face(SourceId(std::size_t{0}))).size() == 1);
}

TEST_CASE("many segments in one face cross in all their points, each known to three faces") {
  // 20 walls along x, 20 along y, through one floor: above a dozen segments a tree finds the pairs.
  std::vector<SurfaceMesh> faces{triangle({-100, -100, 0}, {300, -100, 0}, {-100, 300, 0})};
  for (int i = 0; i < 20; ++i) {
    faces.push_back(triangle({-50, 1.0 + i, -50}, {150, 1.0 + i, -50}, {-50, 1.0 + i, 150}));
    faces.push_back(triangle({1.0 + i, -50, -50}, {1.0 + i, 150, -50}, {1.0 + i, -50, 150}));
  }
  const Arrangement scene(faces);
  const auto row = scene.map.segments_of(scene.overlays.of_face(SourceId(std::size_t{0})));
  CHECK(row.size() == 40);
  for (const Segment& s : row) CHECK(scene.lines.between(s.line, s.p, s.q).size() == 22);
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) CHECK(scene.point_at({1.0 + i, 1.0 + j, 0}).is_valid());
  }
  CHECK(faces.size() == 41);
  // The floor: 3 corners, 2 ends of 40 segments, 400 crossings; hull of 3, so 2 n - 2 - h with all ends inside.
  CHECK(scene.facets_of(SourceId(std::size_t{0})).size() == 2 * (3 + 80 + 400) - 2 - 3);
}

TEST_CASE("points of a line come in order, from either end and in part") {
  const Arrangement scene({floor_z, wall_y, upright(3, -1, 3, 1), upright(-7, -1, -7, 1), upright(5, -1, 5, 1), upright(1, -1, 1, 1)});
  const LineId line = trace(scene, 0, 1);
  const std::vector<Vec3d> whole = between(scene, line, {-20, 0, 0}, {20, 0, 0});
  const bool ascends = whole.front().x < whole.back().x;
  for (std::size_t i = 0; i + 1 < whole.size(); ++i) CHECK((whole[i].x < whole[i + 1].x) == ascends);
  CHECK(whole.size() == 6);
  CHECK(between(scene, line, {20, 0, 0}, {-20, 0, 0}) == whole);
  CHECK(between(scene, line, {1, 0, 0}, {5, 0, 0}).size() == 3);
  CHECK(between(scene, line, {5, 0, 0}, {1, 0, 0}) == between(scene, line, {1, 0, 0}, {5, 0, 0}));
  CHECK(between(scene, line, {3, 0, 0}, {3, 0, 0}).size() == 1);
}

TEST_CASE("a point that is not on a line is a broken belief, and says which") {
  const Arrangement scene({floor_z, wall_y, upright(3, 2, 3, 4)});
  const PointId elsewhere = scene.point_at({3, 2, 0});
  REQUIRE(elsewhere.is_valid());
  const auto error = error_of([&] { (void)scene.lines.between(trace(scene, 0, 1), elsewhere, elsewhere); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InternalError);
  CHECK(error->message.find("point " + std::to_string(elsewhere.value)) != std::string::npos);
}

TEST_CASE("points of one double are kept apart and in order") {
  // Two walls cut the x axis at 1/3 and at p/q a little before it, both of the same nearest double.
  constexpr double p = 3002399751580330, q = 9007199254740991;  // q = 3 p + 1 = 2^53 - 1
  const auto wall = [](double x, double y0, double y1) {
    return make_mesh({{0, y0, -1}, {x, y1, -1}, {x, y1, 1}, {0, y0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  };
  const Arrangement scene({floor_z, wall_y, wall(1, 1, -2), wall(p, 1, 1 - q)});
  const LineId line = trace(scene, 0, 1);
  const auto points = scene.lines.between(line, scene.point_at({-20, 0, 0}), scene.point_at({20, 0, 0}));
  std::vector<PointId> near;
  for (const PointId x : points) {
    if (scene.faces.points.nearest(x) == Vec3d{1.0 / 3, 0, 0}) near.push_back(x);
  }
  REQUIRE(near.size() == 2);
  const bool ascends = scene.faces.points.nearest(points.front()).x < 0;
  CHECK(scene.faces.points.compare(near[0], near[1], 0) == (ascends ? Sign::Negative : Sign::Positive));
}

TEST_CASE("splitting can be cancelled at every report") {
  const Arrangement scene({floor_z, wall_y, wall_x});
  OperandFaces faces = gather(scene.operands);
  FaceIntersectionMap map = build_face_intersection_map(faces, scene.contacts, scene.overlays);
  int calls = 0;
  (void)split_segments(faces, scene.overlays, map, [&](std::string_view stage, double) { return ++calls, stage == "split_segments"; });
  REQUIRE(calls > 0);
  for (int n = 1; n <= calls; ++n) {
    int left = n;
    const auto error =
        error_of([&] { (void)split_segments(faces, scene.overlays, map, [&](std::string_view, double) { return --left > 0; }); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(error->stage == "split_segments");
  }
}
