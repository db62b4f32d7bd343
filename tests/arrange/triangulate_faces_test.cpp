// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Facets: every face is tiled, both sides of every line share its edges, and facets meet in whole corners and edges only.
#include "mortise/arrange/triangulate_faces.h"

#include <algorithm>
#include <random>
#include <set>

#include "mortise/mesh/shapes.h"
#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return make_mesh({a, b, c}, {{0, 1, 2}}); }

using PointPair = std::array<PointId, 2>;

std::set<PointPair> edges_of(const Arrangement& scene, OverlayId o) {
  std::set<PointPair> edges;
  for (const SourceId f : scene.overlays.faces_of(o)) {
    for (const FacetId facet : scene.facets_of(f)) {
      const PlanePoints& c = scene.facets.corners[facet];
      for (std::size_t i = 0; i < 3; ++i) edges.insert({std::min(c[i], c[(i + 1) % 3]), std::max(c[i], c[(i + 1) % 3])});
    }
  }
  return edges;
}

std::set<PointId> corners_of_face(const Arrangement& scene, SourceId f) {
  std::set<PointId> corners;
  for (const FacetId facet : scene.facets_of(f)) corners.insert(scene.facets.corners[facet].begin(), scene.facets.corners[facet].end());
  return corners;
}

/// Is every piece of this part of a line an edge of the overlay?
bool has_edges(const std::set<PointPair>& edges, std::span<const PointId> points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (edges.count({std::min(points[i], points[i + 1]), std::max(points[i], points[i + 1])}) == 0) return false;
  }
  return true;
}

/// Sub-edges of every edge and segment occur in each overlay they belong to.
void check_lines(const Arrangement& scene) {
  for (std::size_t i = 0; i < scene.overlays.size(); ++i) {
    const OverlayId o(i);
    const std::set<PointPair> edges = edges_of(scene, o);
    for (const Segment& s : scene.map.segments_of(o)) CHECK(has_edges(edges, scene.lines.between(s.line, s.p, s.q)));
    for (const SourceId f : scene.overlays.faces_of(o)) {
      for (const LineId line : scene.map.edge_line[scene.overlays.slot_of_face[f]]) {
        const LinePoints& ends = scene.map.lines[line].edge;
        CHECK(has_edges(edges, scene.lines.between(line, ends[0], ends[1])));
      }
    }
    for (const PointId p : scene.map.isolated_of(o)) {
      CHECK(std::any_of(edges.begin(), edges.end(), [&](const PointPair& e) { return e[0] == p || e[1] == p; }));
    }
  }
}

/// What holds for every arrangement by its numbers alone.
void check_arrays(const Arrangement& scene) {
  const Facets& facets = scene.facets;
  CHECK(facets.first_source.size() == facets.size() + 1);
  CHECK(facets.first_source.values().back() == facets.sources.size());
  std::vector<std::uint8_t> is_covered(scene.faces.corners.size(), 0);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto sources = facets.sources_of(FacetId(i));
    REQUIRE(!sources.empty());
    CHECK_FALSE(sources.front().is_opposite);
    for (std::size_t s = 0; s < sources.size(); ++s) {
      is_covered[sources[s].face.index()] = 1;
      if (s > 0) CHECK(sources[s - 1].face < sources[s].face);
    }
  }
  for (std::size_t f = 0; f < is_covered.size(); ++f) CHECK((is_covered[f] != 0) == (scene.faces.shape[SourceId(f)] == FaceShape::Proper));
}

std::set<std::array<std::array<double, 3>, 3>> facet_positions(const Arrangement& scene) {
  std::set<std::array<std::array<double, 3>, 3>> result;
  for (const PlanePoints& c : scene.facets.corners) {
    std::array<std::array<double, 3>, 3> key{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& p = scene.faces.points.nearest(c[i]);
      key[i] = {p.x, p.y, p.z};
    }
    std::sort(key.begin(), key.end());
    result.insert(key);
  }
  return result;
}

}  // namespace

TEST_CASE("facets of the small scenes tile their faces and meet in whole corners and edges, in rationals") {
  for (const Scene& scene : scenes_for_rationals()) {
    INFO(scene.name);
    CHECK(faults_of_facets(Arrangement(scene.operands)) == "");
  }
}

TEST_CASE("every piece of a line is an edge of every face on the line") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const Arrangement arrangement(scene.operands);
    check_arrays(arrangement);
    check_lines(arrangement);
  }
}

TEST_CASE("random triangles on a small grid become facets that tile them, as operands and as faces of one operand") {
  constexpr std::uint32_t seed = 31;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::size_t facets = 0;
  for (std::size_t i = 0, n = scaled_count(60, 5000); i < n; ++i) {
    INFO("case " << i);
    std::vector<SurfaceMesh> triangles;
    while (triangles.size() < 6) {
      const auto coordinate = [&] { return static_cast<double>(random() % 4); };
      const auto corner = [&] { return Vec3d{coordinate(), coordinate(), coordinate()}; };
      const std::array<Vec3d, 3> c{corner(), corner(), corner()};  // drawn in this order by every compiler
      const SurfaceMesh t = triangle(c[0], c[1], c[2]);
      if (gather({t}).shape[SourceId(std::size_t{0})] == FaceShape::Proper) triangles.push_back(t);
    }
    const Arrangement apart(triangles), together({joined(triangles)});
    CHECK(faults_of_facets(apart) == "");
    check_arrays(apart);
    check_lines(apart);
    CHECK(facet_positions(apart) == facet_positions(together));
    facets += apart.facets.size();
  }
  CHECK(facets > 20 * scaled_count(60, 5000));
}

TEST_CASE("random triangles of one plane are cut into one overlay, each piece once") {
  constexpr std::uint32_t seed = 8;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (std::size_t i = 0, n = scaled_count(40, 5000); i < n; ++i) {
    INFO("case " << i);
    std::vector<SurfaceMesh> triangles;
    while (triangles.size() < 5) {
      // Whole steps along two directions: in z = 1, and in a plane with area along all three axes.
      const Vec3d along = i % 2 == 0 ? Vec3d{1, 0, 0} : Vec3d{1, 2, 3}, across = i % 2 == 0 ? Vec3d{0, 1, 0} : Vec3d{2, -1, 1};
      const auto step = [&] { return static_cast<double>(random() % 6); };
      const auto corner = [&] {
        const double a = step(), b = step();
        return Vec3d{0, 0, 1} + a * along + b * across;
      };
      const std::array<Vec3d, 3> c{corner(), corner(), corner()};  // drawn in this order by every compiler
      const SurfaceMesh t = triangle(c[0], c[1], c[2]);
      if (gather({t}).shape[SourceId(std::size_t{0})] == FaceShape::Proper) triangles.push_back(t);
    }
    const Arrangement scene(triangles);
    CHECK(faults_of_facets(scene) == "");
    check_arrays(scene);
    check_lines(scene);
  }
}

TEST_CASE("faces without contact come back as they are, and in order") {
  const Arrangement scene({box({0, 0, 0}, {1, 1, 1}), tetrahedron({5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6})});
  REQUIRE(scene.facets.size() == 16);
  for (std::size_t f = 0; f < 16; ++f) {
    CHECK(scene.facets.corners[FacetId(f)] == scene.faces.corners[SourceId(f)]);
    REQUIRE(scene.facets.sources_of(FacetId(f)).size() == 1);
    CHECK(scene.facets.sources_of(FacetId(f))[0].face == SourceId(f));
  }
}

TEST_CASE("faces without area are gone, and their points split the edges they lay on") {
  const SurfaceMesh mesh =
      make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, -4, 0}, {1, 0, 0}}, {{0, 1, 2}, {0, 4, 1}, {1, 0, 3}, {2, 2, 1}});
  const Arrangement scene({mesh});
  CHECK(scene.facets.size() == 4);
  CHECK(scene.facets_of(SourceId(std::size_t{1})).empty());
  CHECK(scene.facets_of(SourceId(std::size_t{3})).empty());
  CHECK(faults_of_facets(scene) == "");
}

TEST_CASE("facets come in the order of the lowest face of their overlay") {
  for (const Scene& scene : small_scenes()) {
    const Arrangement arrangement(scene.operands);
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < arrangement.facets.size(); ++i) {
      const SourceId first = arrangement.facets.sources_of(FacetId(i)).front().face;
      const SlotId slot = arrangement.overlays.slot_of_face[first];
      const SourceId lowest = slot.is_valid() ? arrangement.overlays.faces_of(arrangement.overlays.of_face(first)).front() : first;
      CHECK(lowest.value >= last);
      last = lowest.value;
    }
  }
}

TEST_CASE("the example of the paper: faces split along the map, with matching edges (Fig. 12)") {
  const SurfaceMesh first = make_mesh({{4, 0, 0}, {4, 0, 8}, {0, 4, 4}, {8, 4, 4}}, {{0, 1, 2}, {1, 0, 3}});
  const Arrangement scene({triangle({1, 1, 4}, {4, -9, 4}, {7, 1, 4}), first});
  // F1 and F2: 3 corners, the point on the common edge, the one inside: 2 n - 2 - h = 8 - 4 = 4 facets each.
  CHECK(scene.facets_of(SourceId(std::size_t{1})).size() == 4);
  CHECK(scene.facets_of(SourceId(std::size_t{2})).size() == 4);
  // F3: 3 corners, two points on one edge, one inside.
  CHECK(scene.facets_of(SourceId(std::size_t{0})).size() == 5);
  CHECK(faults_of_facets(scene) == "");
  check_lines(scene);
}

TEST_CASE("a face with a hole, a slit or an isolated point keeps them as edges and corners") {
  const SurfaceMesh plate = triangle({0, 0, 0}, {16, 0, 0}, {0, 16, 0});
  const Arrangement hole({plate, box({2, 2, -1}, {4, 4, 1})});
  CHECK(faults_of_facets(hole) == "");
  check_lines(hole);
  // 3 corners, the 4 corners of the hole and the 4 points where diagonals of the bar's sides pass through; hull of 3.
  CHECK(hole.facets_of(SourceId(std::size_t{0})).size() == 2 * 11 - 2 - 3);
  const Arrangement slit({plate, triangle({2, 2, 0}, {5, 3, 0}, {3, 3, 4})});
  CHECK(slit.facets_of(SourceId(std::size_t{0})).size() == 5);
  const OverlayId of_plate = slit.overlays.of_face(SourceId(std::size_t{0}));
  CHECK(edges_of(slit, of_plate).count({slit.point_at({2, 2, 0}), slit.point_at({5, 3, 0})}) == 1);
  const Arrangement point({plate, triangle({2, 2, 0}, {5, 3, 1}, {3, 3, 4})});
  CHECK(point.facets_of(SourceId(std::size_t{0})).size() == 3);
  CHECK(corners_of_face(point, SourceId(std::size_t{0})).count(point.point_at({2, 2, 0})) == 1);
}

TEST_CASE("coincident pieces are one facet that knows all its faces and which run against it") {
  const SurfaceMesh up = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), down = triangle({0, 0, 0}, {0, 4, 0}, {4, 0, 0});
  const Arrangement same({down, up, up});
  REQUIRE(same.facets.size() == 1);
  const auto sources = same.facets.sources_of(FacetId(std::size_t{0}));
  REQUIRE(sources.size() == 3);
  CHECK((!sources[0].is_opposite && sources[1].is_opposite && sources[2].is_opposite));
  CHECK(faults_of_facets(same) == "");

  // Half of a triangle in each of three: pieces covered by one, two and three of them.
  const Arrangement three({up, moved(up, {1, 0, 0}), moved(down, {0, 1, 0})});
  CHECK(faults_of_facets(three) == "");
  std::array<std::size_t, 4> by_cover{};
  for (std::size_t i = 0; i < three.facets.size(); ++i) ++by_cover[three.facets.sources_of(FacetId(i)).size()];
  CHECK((by_cover[1] > 0 && by_cover[2] > 0 && by_cover[3] > 0));
}

TEST_CASE("a face in the middle of a larger one leaves a ring of facets of one source") {
  const Arrangement scene({triangle({0, 0, 0}, {16, 0, 0}, {0, 16, 0}), triangle({2, 2, 0}, {4, 2, 0}, {2, 4, 0})});
  CHECK(scene.facets_of(SourceId(std::size_t{1})).size() == 1);
  CHECK(scene.facets_of(SourceId(std::size_t{0})).size() == 7);
  CHECK(faults_of_facets(scene) == "");
}

TEST_CASE("an overlay takes the segments that other faces trace in it") {
  const SurfaceMesh plate = triangle({0, 0, 0}, {16, 0, 0}, {0, 16, 0}), lower = triangle({2, 2, 0}, {2, 6, 0}, {6, 2, 0});
  const Arrangement scene({plate, lower, triangle({3, 1, -1}, {3, 5, -1}, {3, 3, 1})});
  CHECK(faults_of_facets(scene) == "");
  check_lines(scene);
  // The wall crosses the plate from y = 2 to y = 4: from edge 2 of the lower face inwards.
  const OverlayId o = scene.overlays.of_face(SourceId(std::size_t{0}));
  CHECK(o == scene.overlays.of_face(SourceId(std::size_t{1})));
  CHECK(edges_of(scene, o).count({std::min(scene.point_at({3, 2, 0}), scene.point_at({3, 4, 0})),
                                  std::max(scene.point_at({3, 2, 0}), scene.point_at({3, 4, 0}))}) == 1);
}

TEST_CASE("a fan of a thousand segments in one face") {
  // A thousand pages from a common axis pass through the plate, most of them beyond the first 64 lines of its row.
  constexpr std::size_t count = 1000;
  SurfaceMesh pages;
  pages.points = {{0, 0, -1}, {0, 0, 1}};
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) - 499.5;
    pages.points.push_back({x, 1000 + x * x, 0.25});
    pages.triangles.push_back({VertexId(0), VertexId(1), VertexId(i + 2)});
  }
  const Arrangement scene({triangle({-1e7, -1e7, 0}, {1e7, -1e7, 0}, {0, 1e7, 0}), pages});
  check_arrays(scene);
  check_lines(scene);
  // 3 corners, the axis and one end of each page.
  CHECK(scene.facets_of(SourceId(std::size_t{0})).size() == 2 * (3 + 1 + count) - 2 - 3);
}

TEST_CASE("a cone of a thousand faces through one face, and one that touches it with its tip") {
  const SurfaceMesh plate = triangle({-50, -50, 0}, {100, -50, 0}, {-50, 100, 0});
  SurfaceMesh cone;
  cone.points.push_back({0, 0, -1});
  constexpr std::size_t count = 1000;
  for (std::size_t i = 0; i < count; ++i) {  // over a convex polygon of two parabolas
    const double x = i < count / 2 ? static_cast<double>(i) - 250 : 750 - static_cast<double>(i);
    const double y = (250 * 250 - x * x) * 1e-4 + 1;
    cone.points.push_back({x * 0.01, i < count / 2 ? -y : y, 1});
    cone.triangles.push_back({VertexId(0), VertexId(1 + (i + 1) % count), VertexId(1 + i)});
  }
  const Arrangement through({plate, cone});
  check_arrays(through);
  check_lines(through);
  CHECK(through.map.segments_of(through.overlays.of_face(SourceId(std::size_t{0}))).size() == count);
  CHECK(through.facets_of(SourceId(std::size_t{0})).size() == 2 * (3 + count) - 2 - 3);
  const Arrangement touching({plate, moved(cone, {0, 0, 1})});
  check_lines(touching);
  CHECK(touching.facets_of(SourceId(std::size_t{0})).size() == 3);
  CHECK(touching.facets.size() == 3 + count);
}

TEST_CASE("two flush decks of many faces are one overlay, cut in bounded time") {
  const auto cells = static_cast<std::uint32_t>(is_reduced_run() ? 20 : 60);
  const SurfaceMesh deck = make_grid_sheet(cells, cells, cells, cells);
  OperandFaces faces = gather({deck, moved(deck, {0.5, 0.25, 0})});
  for (std::size_t k = 0; k < 2; ++k) faces.self_contacts[OperandId(k)] = SelfContacts::None;
  const Contacts contacts = find_contacts(faces, std::uint64_t{1} << 31, {});
  const Overlays overlays = overlay_coplanar(faces, contacts);
  CHECK(overlays.size() < 8);  // corners of either deck that stick out may be on their own
  FaceIntersectionMap map = build_face_intersection_map(faces, contacts, overlays);
  const LineSubdivision lines = split_segments(faces, overlays, map, {});
  const Facets facets = triangulate_faces(faces, overlays, map, lines, {});
  // Areas: the decks cover 2 n^2 - (n - 0.5) (n - 0.25), and (n - 0.5) (n - 0.25) twice. Coordinates are multiples of 1 / 8 or so.
  const double n = cells;
  double once = 0, twice = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const PlanePoints& c = facets.corners[FacetId(i)];
    const Vec3d& a = faces.points.nearest(c[0]);
    const double area = cross(faces.points.nearest(c[1]) - a, faces.points.nearest(c[2]) - a).z / 2;
    CHECK(area > 0);
    const std::size_t covers = facets.sources_of(FacetId(i)).size();
    CHECK((covers == 1 || covers == 2));
    (covers == 1 ? once : twice) += area;
  }
  const double common = (n - 0.5) * (n - 0.25);
  CHECK(std::abs(twice - common) < 1e-9 * common);
  CHECK(std::abs(once - 2 * (n * n - common)) < 1e-9 * common);
}

TEST_CASE("triangulating can be cancelled at every report") {
  const Arrangement scene({make_box({0, 0, 0}, {1, 1, 1}), make_box({0.5, 0.5, 0.5}, {2, 2, 2})});
  int calls = 0;
  const auto run = [&](const ProgressCallback& progress) {
    return triangulate_faces(scene.faces, scene.overlays, scene.map, scene.lines, progress).size();
  };
  CHECK(run([&](std::string_view stage, double) { return ++calls, stage == "triangulate_faces"; }) == scene.facets.size());
  REQUIRE(calls > 0);
  for (int n = 1; n <= calls; ++n) {
    int left = n;
    const auto error = error_of([&] { (void)run([&](std::string_view, double) { return --left > 0; }); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(error->stage == "triangulate_faces");
  }
}
