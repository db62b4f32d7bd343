// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Ear clipping covers simple polygons exactly and cuts up all others.
#include "mortise/mesh/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using Corners = std::vector<Vec3d>;

std::int64_t cross_2d(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return static_cast<std::int64_t>((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Twice the signed area of a polygon in (x, y) with small whole coordinates.
std::int64_t twice_area(const Corners& corners) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += cross_2d(corners[0], corners[i], corners[i + 1]);
  return sum;
}

/// n - 2 triangles, each running like the polygon, with the areas adding up: then they cover it once.
void check_covers(const Corners& corners, const PolygonTriangulation& result) {
  REQUIRE(result.is_simple);
  REQUIRE(result.triangles.size() == corners.size() - 2);
  const std::int64_t whole = twice_area(corners);
  std::int64_t sum = 0;
  for (const auto& [a, b, c] : result.triangles) {
    const std::int64_t area = cross_2d(corners[a], corners[b], corners[c]);
    REQUIRE((area > 0) == (whole > 0));
    REQUIRE(area != 0);
    sum += area;
  }
  REQUIRE(sum == whole);
}

/// All starts, both ways round.
void check_covers_from_everywhere(Corners corners) {
  for (int way = 0; way < 2; ++way) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      check_covers(corners, triangulate_polygon(corners));
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    std::reverse(corners.begin(), corners.end());
  }
}

/// The turn from the positive x axis in four quadrants, then by cross product.
bool comes_first(const Vec3d& p, const Vec3d& q) {
  const auto half = [](const Vec3d& v) { return v.y < 0 || (v.y == 0 && v.x < 0); };
  if (half(p) != half(q)) return half(q);
  return p.x * q.y - p.y * q.x > 0;
}

/// A polygon seen whole from the origin: one corner in each direction, with corners all round.
Corners star_polygon(std::mt19937& random) {
  const auto coordinate = [&] { return static_cast<double>(static_cast<int>(random() % 41) - 20); };
  Corners corners{{7, 0, 0}, {0, 9, 0}, {-5, 0, 0}, {0, -8, 0}};
  const std::size_t count = 4 + random() % 40;
  while (corners.size() < count) {
    const Vec3d p{coordinate(), coordinate(), 0};
    const auto is_parallel = [&](const Vec3d& q) { return p.x * q.y == p.y * q.x && p.x * q.x + p.y * q.y >= 0; };
    if (std::none_of(corners.begin(), corners.end(), is_parallel)) corners.push_back(p);
  }
  std::sort(corners.begin(), corners.end(), comes_first);
  return corners;
}

}  // namespace

TEST_CASE("Concave polygons are covered from every start and both ways round", "[mesh][triangulate_polygon]") {
  check_covers_from_everywhere({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  check_covers_from_everywhere({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
  check_covers_from_everywhere(
      {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {3, 9, 0}, {3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {7, 6, 0}, {7, 2, 0}, {2, 2, 0}, {2, 9, 0}, {0, 9, 0}});
}

TEST_CASE("Corners inside straight edges are kept and never make a triangle without area", "[mesh][triangulate_polygon]") {
  check_covers_from_everywhere({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
  check_covers_from_everywhere({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 3, 0}});
}

TEST_CASE("A convex quadrilateral is cut along the diagonal from its first corner", "[mesh][triangulate_polygon]") {
  const Corners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::array<std::uint32_t, 3>> expected{{0, 1, 2}, {2, 3, 0}};
  CHECK(triangulate_polygon(square).triangles == expected);
}

TEST_CASE("A comb with a hundred teeth is covered", "[mesh][triangulate_polygon]") {
  Corners comb{{200, -5, 0}, {0, -5, 0}};
  for (int i = 0; i < 100; ++i) {
    comb.push_back({2.0 * i, 0, 0});
    comb.push_back({2.0 * i + 1, 50, 0});
  }
  std::reverse(comb.begin(), comb.end());
  check_covers(comb, triangulate_polygon(comb));
}

TEST_CASE("Random star polygons are covered exactly", "[mesh][triangulate_polygon]") {
  const unsigned seed = 17;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < test::scaled_count(3000, 30000); ++i) {
    const Corners corners = star_polygon(random);
    check_covers(corners, triangulate_polygon(corners));
  }
}

TEST_CASE("A polygon in space is cut like its projection along the largest normal component", "[mesh][triangulate_polygon]") {
  const Corners flat{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  const auto expected = triangulate_polygon(flat).triangles;
  Corners turned, tilted, bent;
  for (const Vec3d& p : flat) {
    turned.push_back({p.y, 5, p.x});
    tilted.push_back({p.x, p.y, 0.75 * p.x - 0.5 * p.y});
    bent.push_back({p.x, p.y, 0.1 * p.x * p.y});
  }
  CHECK(triangulate_polygon(turned).triangles == expected);
  CHECK(triangulate_polygon(tilted).triangles == expected);
  CHECK(triangulate_polygon(bent).triangles == expected);
}

TEST_CASE("Scale does not matter", "[mesh][triangulate_polygon]") {
  const Corners flat{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (const double factor : {0x1p-1070, 0x1p-300, 0x1p300, 0x1p1022}) {
    Corners scaled;
    for (const Vec3d& p : flat) scaled.push_back(factor * p);
    const PolygonTriangulation result = triangulate_polygon(scaled);
    CHECK(result.is_simple);
    CHECK(result.triangles == triangulate_polygon(flat).triangles);
  }
}

TEST_CASE("Polygons that meet themselves are reported and still cut into n - 2 triangles", "[mesh][triangulate_polygon]") {
  const std::vector<Corners> polygons{
      {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}},                                                                    // crossing edges
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}},                                                         // corner on an edge
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}},  // a hole on a bridge
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                                                                    // no area
      {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},                                                                    // one point
      {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}},                                                                    // a spike
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
  };
  for (const Corners& corners : polygons) {
    const PolygonTriangulation result = triangulate_polygon(corners);
    CHECK_FALSE(result.is_simple);
    CHECK(result.triangles.size() == corners.size() - 2);
    for (const auto& [a, b, c] : result.triangles) CHECK((a != b && b != c && c != a));
    CHECK(triangulate_polygon(corners).triangles == result.triangles);
  }
}

TEST_CASE("Fewer than three corners give nothing", "[mesh][triangulate_polygon]") {
  CHECK(triangulate_polygon(Corners{{0, 0, 0}, {1, 0, 0}}).triangles.empty());
  CHECK_FALSE(triangulate_polygon(Corners{}).is_simple);
}

TEST_CASE("Simplicity is exact: one ulp decides", "[mesh][triangulate_polygon]") {
  const double above = std::nextafter(0.5, 1.0);
  CHECK(is_simple_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, above, 0}}, Axis::Z));
  CHECK(is_simple_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.5, 0}}, Axis::Z));
  CHECK_FALSE(is_simple_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0, 0}, {0.25, 0.75, 0}}, Axis::Z));
  CHECK(is_simple_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0x1p-1074, 0}, {0.25, 0.75, 0}}, Axis::Z));
}

}  // namespace mortise
