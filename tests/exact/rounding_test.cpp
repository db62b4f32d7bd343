// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The nearest double of a made point, and the bounds kept beside it: ties, edges of binades, subnormals, all natures.
#include "mortise/exact/rounding.h"

#include <limits>

#include "exact/cases.h"
#include "exact/oracle.h"
#include "mortise/base/error.h"
#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using test::PointGenerator;
using Kind = Construction::Kind;

double next_up(double x) { return cast_bits<double>(cast_bits<std::uint64_t>(x) + 1); }

PointId id(std::size_t i) { return PointId(i); }

Construction construction_of(Kind kind) {
  if (kind == Kind::LinePlane) return Construction::line_plane({id(0), id(1)}, {id(2), id(3), id(4)});
  if (kind == Kind::LineLine) return Construction::line_line({id(0), id(1)}, {id(2), id(3)}, Axis::Z);
  return Construction::three_planes({id(0), id(1), id(2)}, {id(3), id(4), id(5)}, {id(6), id(7), id(8)});
}

oracle::Point exact_of(Kind kind, const std::vector<oracle::Position>& p) {
  if (kind == Kind::LinePlane) return oracle::line_plane(p[0], p[1], oracle::plane(p[2], p[3], p[4]));
  if (kind == Kind::LineLine) return oracle::line_line({p[0], p[1], p[2], p[3]}, 0, 1);
  return oracle::three_planes(oracle::plane(p[0], p[1], p[2]), oracle::plane(p[3], p[4], p[5]), oracle::plane(p[6], p[7], p[8]));
}

/// The coordinate x / w * 2^exponent is on the said side of `nearest`, and nearest + rest is within `error` of it.
bool is_bounded(const RoundedCoordinate& r, const oracle::Integer& x, const oracle::Integer& w, int exponent) {
  int low = exponent;
  for (const double value : {r.nearest, r.rest, r.error}) low = std::min(low, oracle::lowest_exponent(value));
  const oracle::Integer scaled_x = x << static_cast<unsigned>(exponent - low);
  const oracle::Integer beside = (scaled_x - oracle::scaled(r.nearest, low) * w) * w.sign();
  const oracle::Integer off = abs(oracle::Integer(beside - oracle::scaled(r.rest, low) * abs(w)));
  if (r.side == Sign::Zero) return beside.is_zero() && r.rest == 0 && r.error == 0;
  return sign_of(beside.sign()) == r.side && off <= oracle::scaled(r.error, low) * abs(w);
}

/// The x coordinate of the middle of (x0, 0, 0) and (x1, 0, 1), rounded.
RoundedCoordinate middle(double x0, double x1) {
  const std::array<Vec3d, 9> points{Vec3d{x0, 0, 0}, {x1, 0, 1}, {0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}};
  return round_point(construction_of(Kind::LinePlane), points).coordinates[0];
}

}  // namespace

TEST_CASE("Every made coordinate is its nearest double, with a side and a bound that hold", "[exact]") {
  for (const Kind kind : {Kind::LinePlane, Kind::LineLine, Kind::ThreePlanes}) {
    const Construction construction = construction_of(kind);
    std::uint64_t seed = 0;
    for (std::size_t done = 0; done < test::scaled_count(20'000, 1'000'000); ++seed) {
      PointGenerator random(seed);
      std::vector<Vec3d> points = random.points(9);
      const double level = points[0].z;
      for (std::size_t i = 0; kind == Kind::LineLine && i < 4; ++i) points[i] = {points[i].x, points[i].y, level};
      const oracle::Scaled scaled = oracle::scaled(points);
      const oracle::Point exact = exact_of(kind, scaled.positions);
      if (exact.w.is_zero()) continue;
      ++done;
      std::array<Vec3d, 9> all;
      std::copy(points.begin(), points.end(), all.begin());
      std::array<double, 3> nearest;
      for (std::size_t i = 0; i < 3; ++i) nearest[i] = oracle::nearest(exact.x[i], exact.w, scaled.exponent);
      if (!std::isfinite(nearest[0]) || !std::isfinite(nearest[1]) || !std::isfinite(nearest[2])) {
        CHECK_THROWS_AS(round_point(construction, all), Error);
        continue;
      }
      const auto rounded = round_point(construction, all).coordinates;
      for (std::size_t i = 0; i < 3; ++i) {
        const bool holds = rounded[i].nearest == nearest[i] && is_bounded(rounded[i], exact.x[i], exact.w, scaled.exponent);
        if (!holds) FAIL(test::describe(seed, points));
      }
    }
  }
}

TEST_CASE("A tie is rounded to the even double", "[exact]") {
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < test::scaled_count(20'000, 1'000'000); ++i) {
    const double x = std::fabs(cast_bits<double>(random() & 0x7fefffffffffffffULL));
    const double above = next_up(x);
    if (!std::isfinite(above)) continue;
    const double even = (cast_bits<std::uint64_t>(x) & 1) == 0 ? x : above;
    CAPTURE(x);
    for (const double sign : {1.0, -1.0}) {
      const RoundedCoordinate rounded = middle(sign * x, sign * above);
      if (rounded.nearest != sign * even) FAIL("not even");
      if (rounded.side != sign_of(sign * (even == x ? 1 : -1))) FAIL("wrong side");
    }
  }
}

TEST_CASE("Next to a tie the nearer double wins", "[exact]") {
  // At height 1/2 +- 2^-53 of a line that rises by one unit in the last place.
  for (const double x : {1.0, 1.5, 0x1.fffffffffffffp0, 0x1p-1022, 5e-324, 0x1.8p-1060, 0x1p1022, 3.0}) {
    const double above = next_up(x);
    for (const double height : {0.5 - 0x1p-53, 0.5 + 0x1p-52}) {
      const std::array<Vec3d, 9> points{Vec3d{x, 0, 0}, {above, 0, 1}, {0, 0, height}, {1, 0, height}, {0, 1, height}};
      CAPTURE(x, height);
      CHECK(round_point(construction_of(Kind::LinePlane), points).coordinates[0].nearest == (height < 0.5 ? x : above));
    }
  }
}

TEST_CASE("Midpoints below a power of two, among subnormals and at the top are rounded right", "[exact]") {
  const double max = std::numeric_limits<double>::max();
  CHECK(middle(0, 5e-324).nearest == 0);
  CHECK_FALSE(std::signbit(middle(0, -5e-324).nearest));
  CHECK(middle(0, -5e-324).side == Sign::Negative);
  CHECK(middle(5e-324, 2 * 5e-324).nearest == 2 * 5e-324);
  CHECK(middle(0, 3 * 5e-324).nearest == 2 * 5e-324);
  CHECK(middle(0x1.fffffffffffffp-1, 1).nearest == 1);
  CHECK(middle(1, next_up(1)).nearest == 1);
  CHECK(middle(0x0.fffffffffffffp-1022, 0x1p-1022).nearest == 0x1p-1022);
  CHECK(middle(max, max).nearest == max);
  CHECK(middle(max, 0x1.ffffffffffffep1023).nearest == 0x1.ffffffffffffep1023);
  CHECK(middle(-max, max).nearest == 0);
  CHECK(middle(-max, max).side == Sign::Zero);
}

TEST_CASE("Half a unit above the largest double is out of range, less is not", "[exact]") {
  // x = max (1 - h) + h x1 at height h: beyond the points, at h = 2 and a little less.
  const double max = std::numeric_limits<double>::max(), below = 0x1.ffffffffffffep1023;
  const auto at = [&](double height) {
    const std::array<Vec3d, 9> points{Vec3d{below, 0, 0}, {max, 0, 1}, {0, 0, height}, {1, 0, height}, {0, 1, height}};
    return round_point(construction_of(Kind::LinePlane), points).coordinates[0].nearest;
  };
  CHECK(at(1.25) == max);
  CHECK(at(1.5 - 0x1p-52) == max);
  CHECK_THROWS_AS(at(1.5), Error);
  CHECK_THROWS_AS(at(2), Error);
}

TEST_CASE("Parallel lines and planes make no point", "[exact]") {
  const std::array<Vec3d, 9> points{Vec3d{0, 0, 0}, {1, 2, 3}, {0.5, 1, 1}, {1.5, 3, 4}, {2, 0, 1}};
  CHECK_THROWS_AS(exact_point(construction_of(Kind::LinePlane), points), Error);
}

}  // namespace mortise
