// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Interpolation in a triangle against rationals.
#include "mortise/exact/point_in_triangle.h"

#include <cmath>
#include <limits>

#include "mortise/exact/predicates.h"
#include "support/boolean_oracle.h"
#include "support/catch.h"
#include "support/random_source.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;
using oracle::Rational;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
using Corners = std::array<Vec3d, 3>;
using Values = std::array<double, 3>;

struct Triangle3 {
  PointSet points;
  PlanePoints corners;

  explicit Triangle3(const Corners& c) : corners{points.add_input(c[0]), points.add_input(c[1]), points.add_input(c[2])} {}
  [[nodiscard]] double at(const Vec3d& p, const Values& values) {
    const PointId id = points.add_input(p);
    return PointInTriangle(points, corners, id).interpolate(values);
  }
};

/// In the projection along z, by Cramer's rule.
Rational expected(const Corners& corners, const std::array<Rational, 2>& p, const Values& values) {
  const auto x = [&](std::size_t i) { return oracle::exact(corners[i].x); };
  const auto y = [&](std::size_t i) { return oracle::exact(corners[i].y); };
  const auto area = [](const Rational& ax, const Rational& ay, const Rational& bx, const Rational& by) { return ax * by - ay * bx; };
  const Rational whole = area(x(1) - x(0), y(1) - y(0), x(2) - x(0), y(2) - y(0));
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += oracle::exact(values[i]) * area(x(j) - p[0], y(j) - p[1], x(k) - p[0], y(k) - p[1]) / whole;
  }
  return sum;
}

bool is_negative_zero(double x) { return x == 0 && std::signbit(x); }

}  // namespace

TEST_CASE("a corner has its value bit for bit, an edge and the inside what is linear between", "[interpolation]") {
  Triangle3 t({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  CHECK(is_negative_zero(t.at({0, 0, 0}, {-0.0, 1, 2})));
  CHECK(t.at({4, 0, 0}, {5, 0.1, 7}) == 0.1);
  CHECK(t.at({1, 0, 0}, {8, 16, 3}) == 10);
  CHECK(t.at({1, 1, 0}, {8, 16, 4}) == 9);
  CHECK(t.at({1, 2, 0}, {0.1, 0.1, 0.1}) == 0.1);
  CHECK(t.at({2, 1, 0}, {1, -1, 1}) == 0);
  CHECK_FALSE(is_negative_zero(t.at({2, 1, 0}, {1, -1, 1})));
}

TEST_CASE("a corner without value counts unless the point is on the line of the others", "[interpolation]") {
  Triangle3 t({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  CHECK(t.at({1, 0, 0}, {8, 16, none}) == 10);
  CHECK(t.at({2, 2, 0}, {none, 3, 5}) == 4);
  CHECK(t.at({0, 3, 0}, {5, none, 5}) == 5);
  CHECK(std::isnan(t.at({1, 1, 0}, {8, 16, none})));
  CHECK(std::isnan(t.at({1, 0, 0}, {none, 16, 4})));
  CHECK(std::isnan(t.at({0, 0, 0}, {none, 16, 4})));
  CHECK(t.at({0, 4, 0}, {none, none, 4}) == 4);
  CHECK(std::isnan(t.at({1, 1, 0}, {none, none, none})));
}

TEST_CASE("values do not go beyond those of the corners, wherever the point is seen", "[interpolation]") {
  Triangle3 t({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  CHECK(t.at({1, 0, 9}, {8, 16, 3}) == 10);
  CHECK(t.at({-1, -1, 0}, {1, 2, 2}) == 1);
  CHECK(t.at({9, 9, 0}, {1, 2, 3}) == 3);
  CHECK(t.at({1e300, 0, 0}, {-1e300, 1e300, 3}) == 1e300);
  CHECK(t.at({-1e300, 0, 0}, {-1e300, 1e300, 3}) == -1e300);
}

TEST_CASE("values of any size are interpolated", "[interpolation]") {
  Triangle3 t({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK(t.at({2, 0, 0}, {most, -most, 0}) == 0);
  CHECK(t.at({2, 0, 0}, {most, most / 2, 0}) == 0.75 * most);
  CHECK(t.at({2, 0, 0}, {4 * least, 2 * least, 0}) == 3 * least);
  CHECK(t.at({2, 0, 0}, {3 * least, 2 * least, 0}) == 2 * least);  // a tie
  Triangle3 tiny({{{0, 0, 0}, {0x1p-1070, 0, 0}, {0, 0x1p-1070, 0}}});
  CHECK(tiny.at({0x1p-1071, 0, 0}, {1, 2, 3}) == 1.5);
  Triangle3 large({{{0, 0, 0}, {0x1p1020, 0, 0}, {0, 0x1p1020, 0}}});
  CHECK(large.at({0x1p1018, 0x1p1019, 0}, {1, 2, 3}) == 2.25);
}

TEST_CASE("values at input points are the nearest doubles of the rational ones", "[interpolation]") {
  RandomSource random(11);
  for (std::size_t i = 0; i < scaled_count(20000, 1000000); ++i) {
    INFO("case " << i);
    const double spread = random.once_in(3) ? random.octaves(-50, 0) : 1;  // needles
    Corners c{random.point(-1, 1), random.point(-1, 1), {}};
    c[2] = c[0] + random.between(0, 1) * (c[1] - c[0]) + spread * random.point(-1, 1);
    const Values values{random.between(-1, 1), random.between(-1, 1), random.once_in(2) ? random.between(-1, 1) : random.octaves(-40, 40)};
    for (Vec3d& p : c) p.z = 0;
    if (are_collinear(c[0], c[1], c[2])) continue;
    const double s = random.between(0, 1), u = random.between(0, 1 - s);
    const Vec3d p = c[0] + s * (c[1] - c[0]) + u * (c[2] - c[0]);
    Triangle3 t(c);
    const double wanted = oracle::nearest_double(expected(c, {oracle::exact(p.x), oracle::exact(p.y)}, values));
    const auto [least, most] = std::minmax({values[0], values[1], values[2]});
    CHECK(t.at(p, values) == std::clamp(wanted, least, most));  // rounding may have put the point beside a needle
  }
}

TEST_CASE("values at made points are the nearest doubles of the rational ones", "[interpolation]") {
  RandomSource random(12);
  for (std::size_t i = 0; i < scaled_count(20000, 1000000); ++i) {
    INFO("case " << i);
    // The plane z = 0 and a line across it, all with full mantissas: the point has the weights of the heights.
    const double z = random.once_in(4) ? random.octaves(-60, 0) : 0;
    const Corners c{{{random.between(-2, -1), random.between(-2, -1), z},
                     {random.between(3, 4), random.between(-1, 0), z},
                     {random.between(-1, 0), random.between(3, 4), z}}};
    const Vec3d above{random.between(0, 0.5), random.between(0, 0.5), z + random.between(1, 2)};
    const Vec3d below{random.between(0, 0.5), random.between(0, 0.5), z - random.between(1, 2)};
    const Values values{random.between(-1, 1), random.between(-1, 1), random.once_in(3) ? 0 : random.octaves(-30, 30)};
    Triangle3 t(c);
    const PointId a = t.points.add_input(above), b = t.points.add_input(below);
    const PointId p = t.points.add_line_plane({a, b}, t.corners);
    const Rational h = (oracle::exact(above.z) - oracle::exact(z)) / (oracle::exact(above.z) - oracle::exact(below.z));
    const std::array<Rational, 2> at{oracle::exact(above.x) + h * (oracle::exact(below.x) - oracle::exact(above.x)),
                                     oracle::exact(above.y) + h * (oracle::exact(below.y) - oracle::exact(above.y))};
    CHECK(PointInTriangle(t.points, t.corners, p).interpolate(values) == oracle::nearest_double(expected(c, at, values)));
  }
}
