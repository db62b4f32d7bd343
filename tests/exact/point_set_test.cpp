// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Made points against integers of any length: identity, rounding, and every predicate on every rung.
#include "mortise/exact/point_set.h"

#include <cmath>

#include "exact/cases.h"
#include "exact/made_points.h"
#include "exact/oracle.h"
#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using test::describe;
using test::Form;
using test::PointGenerator;
using test::PointPair;
using test::RungTally;

std::size_t implicit_count() { return test::scaled_count(50'000, 1'000'000); }

struct Tallies {
  RungTally side_of_plane, orient2d, compare;
  std::size_t made_twice = 0;
};

bool is_rounded_right(const PointPair& pair, PointId p) {
  const oracle::Point& exact = pair.exact[p.index()];
  const Vec3d& nearest = pair.set.nearest(p);
  bool result = pair.set.is_representable(p) == pair.is_representable(exact);
  for (std::size_t i = 0; i < 3; ++i) result = result && nearest[i] == pair.nearest(exact, i);
  return result;
}

bool is_side_right(const PointPair& pair, const PlanePoints& plane, PointId p, RungTally& tally) {
  const Answer answer = pair.set.explain_side_of_plane(plane, p);
  tally.add(answer.rung);
  const bool is_odd = pair.set.side_of_plane({plane[1], plane[0], plane[2]}, p) == -answer.sign;
  return is_odd && answer.sign == oracle::side_of_plane(pair.plane(plane), pair.exact[p.index()]);
}

bool is_orientation_right(const PointPair& pair, const std::array<PointId, 3>& p, Axis axis, RungTally& tally) {
  const Answer answer = pair.set.explain_orient2d(p[0], p[1], p[2], axis);
  tally.add(answer.rung);
  const auto [u, v] = kept_coordinates(axis);
  const bool is_odd =
      pair.set.orient2d(p[1], p[0], p[2], axis) == -answer.sign && pair.set.orient2d(p[0], p[2], p[1], axis) == -answer.sign;
  return is_odd && answer.sign == oracle::orient2d(pair.exact[p[0].index()], pair.exact[p[1].index()], pair.exact[p[2].index()], u, v);
}

bool is_order_right(const PointPair& pair, PointId a, PointId b, std::size_t coordinate, RungTally& tally) {
  const Answer answer = pair.set.explain_compare(a, b, coordinate);
  tally.add(answer.rung);
  const bool is_odd = pair.set.compare(b, a, coordinate) == -answer.sign;
  return is_odd && answer.sign == oracle::compare(pair.exact[a.index()], pair.exact[b.index()], coordinate);
}

/// One made point and what can be asked about it; false: the inputs made none. Some planes hold it by construction, and some
/// of the points compared with it are made, too.
bool check_case(Form form, std::uint64_t seed, Tallies& tallies) {
  PointGenerator random(seed);
  PointPair pair(test::points_for(form, random, 10));
  const auto made = pair.make(form, random);
  if (!made) return false;
  CHECK(is_rounded_right(pair, *made));
  const auto other = pair.make(form, random);
  pair.make(static_cast<Form>(random.below(3)), random);
  for (int i = 0; i < 3; ++i) {
    const PlanePoints plane = pair.random_plane(random);
    if (oracle::is_zero(pair.plane(plane).normal)) continue;
    CHECK(is_side_right(pair, plane, *made, tallies.side_of_plane));
  }
  const std::array<PointId, 3> three{*made, other.value_or(pair.random_point(random)), pair.random_point(random)};
  CHECK(is_orientation_right(pair, three, static_cast<Axis>(random.below(3)), tallies.orient2d));
  for (std::size_t i = 0; i < 3; ++i) CHECK(is_order_right(pair, *made, pair.random_point(random), i, tallies.compare));
  tallies.made_twice += pair.made_twice;
  return true;
}

void check_form(Form form) {
  Tallies tallies;
  std::uint64_t seed = 0;
  for (std::size_t done = 0; done < implicit_count(); ++seed) {
    CAPTURE(seed, test::nature_names[seed % test::nature_count]);
    if (check_case(form, seed, tallies)) ++done;
  }
  std::printf("%s\n", test::form_names[static_cast<std::size_t>(form)]);
  tallies.side_of_plane.print("  side_of_plane");
  tallies.orient2d.print("  orient2d");
  tallies.compare.print("  compare");
  CHECK(tallies.made_twice > implicit_count() / 10);
  for (const RungTally* tally : {&tallies.side_of_plane, &tallies.orient2d}) {
    for (const Rung rung : {Rung::Construction, Rung::Filter, Rung::DoubleDouble, Rung::BigFloat}) CHECK(tally->of(rung) > 0);
  }
}

}  // namespace

TEST_CASE("Points of a line and a plane are exact in every answer", "[exact]") { check_form(Form::LinePlane); }

TEST_CASE("Points of two lines are exact in every answer", "[exact]") { check_form(Form::LineLine); }

TEST_CASE("Points of three planes are exact in every answer", "[exact]") { check_form(Form::ThreePlanes); }

TEST_CASE("Coordinates that agree without being doubles compare as equal", "[exact]") {
  RungTally tally;
  for (std::uint64_t seed = 0; seed < implicit_count() / 10; ++seed) {
    PointGenerator random(test::nature_count * seed + static_cast<std::uint64_t>(test::Nature::Single));
    std::vector<Vec3d> points = random.points(5);
    const auto exact = oracle::scaled(points).positions;
    if (oracle::line_plane(exact[0], exact[1], oracle::plane(exact[2], exact[3], exact[4])).w.is_zero()) continue;
    for (std::size_t i = 0; i < 5; ++i) points.push_back(points[i] + Vec3d{0, 16, 0});  // 24 bits and 4 more: exact
    PointSet set;
    std::array<PointId, 10> p;
    for (std::size_t i = 0; i < 10; ++i) p[i] = set.add_input(points[i]);
    const PointId a = set.add_line_plane({p[0], p[1]}, {p[2], p[3], p[4]}), b = set.add_line_plane({p[5], p[6]}, {p[7], p[8], p[9]});
    for (const std::size_t coordinate : {0U, 2U}) {
      const Answer answer = set.explain_compare(a, b, coordinate);
      tally.add(answer.rung);
      if (answer.sign != Sign::Zero) FAIL(test::describe(seed, points));
    }
    CHECK(set.compare(a, b, 1) == Sign::Negative);
  }
  tally.print("compare, equal coordinates");
  CHECK(tally.of(Rung::BigFloat) > implicit_count() / 20);
}

TEST_CASE("The double-double rung of compare tells what the nearest doubles do not", "[exact]") {
  // x = 1/3 and x = 1/3 + 2^-60 * 8/9: nearest to one double and both above it.
  PointSet set;
  const PointId o = set.add_input({0, 0, 0}), beside = set.add_input({0x1p-60, 0, 0}), far = set.add_input({3, 0, 9});
  const PlanePoints at_one{set.add_input({0, 0, 1}), set.add_input({1, 0, 1}), set.add_input({0, 1, 1})};
  const PointId a = set.add_line_plane({o, far}, at_one), b = set.add_line_plane({beside, far}, at_one);
  CHECK(a != b);
  CHECK(set.nearest(a) == set.nearest(b));
  CHECK(set.explain_compare(a, b, 0).sign == Sign::Negative);
  CHECK(set.explain_compare(a, b, 0).rung == Rung::DoubleDouble);
  CHECK(set.compare(a, b, 2) == Sign::Zero);
}

TEST_CASE("A point made in three ways has one id", "[exact]") {
  PointSet set;
  const PointId o = set.add_input({0, 0, 0}), x = set.add_input({3, 0, 0}), y = set.add_input({0, 3, 0}), z = set.add_input({0, 0, 3});
  const PointId up = set.add_input({1, 1, 1}), xy = set.add_input({3, 3, 0});
  // The diagonals of the square cross at (1.5, 1.5, 0); those of (o, xy) and (x, y) are met by planes as well.
  const PointId crossing = set.add_line_line({o, xy}, {y, x}, Axis::Z);
  CHECK(set.nearest(crossing) == Vec3d{1.5, 1.5, 0});
  CHECK(set.is_representable(crossing));
  CHECK(set.add_line_line({x, y}, {xy, o}, Axis::Z) == crossing);
  CHECK(set.add_line_plane({o, xy}, {x, y, z}) == crossing);
  CHECK(set.add_three_planes({x, y, z}, {o, x, y}, {o, up, z}) == crossing);
  CHECK(set.add_three_planes({o, z, up}, {z, y, x}, {y, o, x}) == crossing);
  CHECK(set.size() == 7);
}

TEST_CASE("A point can be made again from its definition", "[exact]") {
  PointSet set;
  const PointId o = set.add_input({0, 0, 0}), x = set.add_input({3, 0, 0}), y = set.add_input({0, 3, 0}), z = set.add_input({0, 0, 3});
  const PointId up = set.add_input({1, 2, 1}), xy = set.add_input({3, 4, 0});
  CHECK(set.definition(up) == std::vector<PointId>{up});
  const PointId crossing = set.add_line_line({o, xy}, {y, x}, Axis::Z);
  const std::vector<PointId> lines = set.definition(crossing);
  REQUIRE(lines.size() == 4);
  CHECK(set.add_line_line({lines[0], lines[1]}, {lines[2], lines[3]}, Axis::Z) == crossing);
  const PointId pierced = set.add_line_plane({o, up}, {x, y, z});
  const std::vector<PointId> line_and_plane = set.definition(pierced);
  REQUIRE(line_and_plane.size() == 5);
  const auto plane_at = [](const std::vector<PointId>& points, std::size_t i) {
    return PlanePoints{points[i], points[i + 1], points[i + 2]};
  };
  CHECK(set.add_line_plane({line_and_plane[0], line_and_plane[1]}, plane_at(line_and_plane, 2)) == pierced);
  const PointId corner = set.add_three_planes({x, y, z}, {o, up, x}, {o, xy, z});
  const std::vector<PointId> planes = set.definition(corner);
  REQUIRE(planes.size() == 9);
  CHECK(set.add_three_planes(plane_at(planes, 0), plane_at(planes, 3), plane_at(planes, 6)) == corner);
  CHECK(set.size() == 9);
}

TEST_CASE("A made point on an input point gets its id", "[exact]") {
  PointSet set;
  const PointId o = set.add_input({-0.0, 0, 0}), x = set.add_input({1, 0, 0}), y = set.add_input({0, 1, 0}), z = set.add_input({0, 0, 1});
  const PointId below = set.add_input({0, 0, -1}), mid = set.add_input({0.5, 0.5, 0});
  CHECK(set.add_line_plane({z, below}, {o, x, y}) == o);
  CHECK(set.add_three_planes({o, x, y}, {o, y, z}, {o, z, x}) == o);
  CHECK(set.add_line_line({x, y}, {o, mid}, Axis::Z) == mid);
  CHECK(set.size() == 6);
  CHECK(set.input_count() == 6);
  CHECK(std::signbit(set.nearest(o).x));
}

TEST_CASE("Different points with one nearest double have two ids", "[exact]") {
  PointSet set;
  const PointId o = set.add_input({0, 0, 0});
  const PlanePoints at_one{set.add_input({0, 0, 1}), set.add_input({1, 0, 1}), set.add_input({0, 1, 1})};
  const PointId steep = set.add_input({1, 0, 3}), same = set.add_input({2, 0, 6}), far = set.add_input({2.9e15, 0, 8.7e15 + 1});
  const PointId rounded_third = set.add_input({1.0 / 3, 0, 1});
  const PointId third = set.add_line_plane({o, steep}, at_one);
  const PointId almost = set.add_line_plane({o, far}, at_one);
  CHECK(set.add_line_plane({o, same}, at_one) == third);
  CHECK(third != almost);
  CHECK(third != rounded_third);
  CHECK(set.nearest(third) == set.nearest(almost));
  CHECK(set.nearest(third) == set.nearest(rounded_third));
  CHECK_FALSE(set.is_representable(third));
  CHECK(set.compare(third, rounded_third, 0) == Sign::Positive);
}

TEST_CASE("Equal input coordinates are one point, and -0 is 0", "[exact]") {
  PointSet set;
  set.reserve(10);
  const PointId a = set.add_input({0.0, 1, 2});
  CHECK(set.add_input({-0.0, 1, 2}) == a);
  CHECK(set.add_input({5e-324, 1, 2}) != a);
  CHECK(set.add_input({0.0, 1, 2}) == a);
  CHECK(set.size() == 2);
}

TEST_CASE("A made point beyond the doubles is refused and nothing is added", "[exact]") {
  PointSet set;
  const double huge = 0x1.fffffffffffffp1023;
  const PointId a = set.add_input({huge / 2, 0, 0}), b = set.add_input({huge, 0, 1});
  const PlanePoints at_three{set.add_input({0, 0, 3}), set.add_input({1, 0, 3}), set.add_input({0, 1, 3})};
  try {
    set.add_line_plane({a, b}, at_three);
    FAIL("twice the largest double was accepted");
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::OutOfRange);
  }
  CHECK(set.size() == 5);
}

TEST_CASE("A set can be moved", "[exact]") {
  PointSet first;
  const PointId a = first.add_input({1, 2, 3});
  PointSet second = std::move(first);
  CHECK(second.nearest(a) == Vec3d{1, 2, 3});
  CHECK(second.add_input({1, 2, 3}) == a);
}

TEST_CASE("An input point after a made one is refused", "[exact]") {
  PointSet set;
  const PointId o = set.add_input({0, 0, 0}), x = set.add_input({2, 0, 0}), y = set.add_input({0, 2, 0}), z = set.add_input({1, 1, 0});
  set.add_line_line({o, z}, {x, set.add_input({0, 1, 0})}, Axis::Z);
  CHECK_THROWS_AS(set.add_input({9, 9, 9}), Error);
  CHECK_THROWS_AS(set.add_line_line({o, x}, {x, o}, Axis::Z), Error);
  CHECK(set.nearest(y) == Vec3d{0, 2, 0});
}

}  // namespace mortise
