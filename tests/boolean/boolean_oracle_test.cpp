// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The oracle itself, against values known by hand and against plain double arithmetic where that is exact.
#include "support/boolean_oracle.h"

#include <cmath>
#include <limits>
#include <random>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;
using oracle::Rational;

namespace {

std::vector<Vec3d> rounded(const std::vector<oracle::MadePoint>& points) {
  std::vector<Vec3d> doubles;
  for (const auto& p : points) doubles.push_back(p.rounded);
  return doubles;
}

}  // namespace

TEST_CASE("the oracle rounds a quotient of two doubles as the processor does") {
  std::mt19937_64 random(20130114);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 1200) - 700);
    const double b = std::ldexp(static_cast<double>((random() >> 11) | 1U), static_cast<int>(random() % 600) - 300);
    CHECK(oracle::nearest_double(oracle::exact(a) / oracle::exact(b)) == a / b);
  }
}

TEST_CASE("the oracle rounds ties to even, subnormal numbers and overflow") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  CHECK(oracle::nearest_double(oracle::exact(tiny) / 2) == 0.0);
  CHECK(oracle::nearest_double(oracle::exact(3 * tiny) / 2) == 2 * tiny);
  CHECK(oracle::nearest_double(oracle::exact(tiny) * Rational(2, 3)) == tiny);
  CHECK(oracle::nearest_double(oracle::exact(std::numeric_limits<double>::max()) * 2) == std::numeric_limits<double>::infinity());
  CHECK(oracle::nearest_double(Rational(9007199254740993)) == 9007199254740992.0);    // 2^53 + 1: halfway, down to even
  CHECK(oracle::nearest_double(Rational(-9007199254740995)) == -9007199254740996.0);  // 2^53 + 3: halfway, away to even
  CHECK(oracle::nearest_double(Rational(1, 10)) == 0.1);
  CHECK(oracle::nearest_double(oracle::exact(-0.7)) == -0.7);
}

TEST_CASE("the oracle counts windings inside, outside, on and in an overlap") {
  const SurfaceMesh overlapping = joined({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  CHECK(oracle::winding_number(overlapping, oracle::exact({0.5, 0.5, 0.5})) == 1);
  CHECK(oracle::winding_number(overlapping, oracle::exact({1.5, 1.5, 1.5})) == 2);
  CHECK(oracle::winding_number(overlapping, oracle::exact({5, 1, 1})) == 0);
  CHECK(oracle::winding_number(overlapping, oracle::exact({2, 0.5, 1})) == std::nullopt);
  CHECK(oracle::winding_number(inside_out(overlapping), oracle::exact({0.5, 0.5, 0.5})) == -1);
}

TEST_CASE("the oracle finds the volumes of two boxes of side 2 sharing a box of side 1") {
  const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  CHECK(oracle::boolean_volume(Operation::Union, pointers_to(boxes)) == 15);
  CHECK(oracle::boolean_volume(Operation::Intersect, pointers_to(boxes)) == 1);
  CHECK(oracle::boolean_volume(Operation::Subtract, pointers_to(boxes)) == 7);
}

TEST_CASE("the oracle cuts a tetrahedron out of a cube exactly") {
  // The corner x + y + z <= 3/2 of the unit cube: 27/48 of the corner tetrahedron minus three small ones of edge 1/2.
  const std::vector<SurfaceMesh> solids{box({0, 0, 0}, {1, 1, 1}), tetrahedron({0, 0, 0}, {1.5, 0, 0}, {0, 1.5, 0}, {0, 0, 1.5})};
  CHECK(oracle::boolean_volume(Operation::Intersect, pointers_to(solids)) == Rational(1, 2));
}

TEST_CASE("the oracle sees through cavities") {
  const SurfaceMesh hollow = joined({box({0, 0, 0}, {3, 3, 3}), inside_out(box({1, 1, 1}, {2, 2, 2}))});
  const std::vector<SurfaceMesh> solids{hollow, box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5})};
  CHECK(oracle::volume(hollow) == 26);
  CHECK(oracle::boolean_volume(Operation::Intersect, pointers_to(solids)) == Rational(7, 8));
}

TEST_CASE("the oracle makes the point where an edge passes through a face") {
  const std::vector<SurfaceMesh> solids{tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}),
                                        tetrahedron({0.25, 0.25, 0.25}, {5, 5, 5}, {5, 5, 6}, {6, 5, 5})};
  // The edge along (1, 1, 1) meets x + y + z = 3 in (1, 1, 1).
  const std::vector<Vec3d> points = rounded(oracle::made_points(pointers_to(solids)));
  CHECK(std::find(points.begin(), points.end(), Vec3d{1, 1, 1}) != points.end());
}

TEST_CASE("the oracle makes the common point of three faces of three solids") {
  const std::vector<SurfaceMesh> solids{
      box({0, 0, 0}, {1, 1, 1}),
      box({0.5, -5, -5}, {9, 5.25, 5.125}),
      box({-5, 0.25, -5}, {5.5, 9, 5.25}),
  };
  const std::vector<Vec3d> points = rounded(oracle::made_points(pointers_to(solids)));
  CHECK(std::find(points.begin(), points.end(), Vec3d{0.5, 0.25, 1}) != points.end());
}

TEST_CASE("three faces in general position determine their common point, and it is checked against a fourth") {
  const oracle::Corners x{{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}}, y{{{0, 2, 0}, {1, 2, 0}, {0, 2, 1}}}, z{{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}};
  const oracle::Corners elsewhere{{{9, 0, 0}, {0, 9, 0}, {0, 0, 9}}};
  CHECK(oracle::points_determined_by({1, 2, 3}, {x, y, z}) == std::vector{oracle::exact({1, 2, 3})});
  CHECK(oracle::points_determined_by({1, 2, 3}, {x, y, z, elsewhere}).empty());
}

TEST_CASE("two coplanar faces and a third determine points on their edges only") {
  const oracle::Corners low{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}}}, high{{{0, 0, 0}, {3, 3, 0}, {0, 3, 0}}},
      across{{{0, 1, -1}, {3, 1, -1}, {3, 1, 1}}};
  // The plane y = 1 meets the diagonal of the square at x = 1 and its sides at x = 0 and x = 3; between them there is
  // nothing but x = 1.5, where an edge of the face across passes through the square.
  CHECK(oracle::points_determined_by({1, 1, 0}, {low, high, across}) == std::vector{oracle::exact({1, 1, 0})});
  CHECK(oracle::points_determined_by({3, 1, 0}, {low, high, across}) == std::vector{oracle::exact({3, 1, 0})});
  CHECK(oracle::points_determined_by({1.5, 1, 0}, {low, high, across}) == std::vector{oracle::exact({1.5, 1, 0})});
  CHECK(oracle::points_determined_by({2, 1, 0}, {low, high, across}).empty());
}

TEST_CASE("two edges that cross in one plane determine their crossing") {
  const oracle::Corners face{{{0, 0, 0}, {3, 3, 0}, {0, 3, 0}}}, touching{{{0, 2, 0}, {2, 0, 0}, {1, 1, 5}}};
  CHECK(oracle::points_determined_by({1, 1, 0}, {face}).empty());
  CHECK(oracle::points_determined_by({1, 1, 0}, {face}, {touching}) == std::vector{oracle::exact({1, 1, 0})});
}

TEST_CASE("shells, genus and pinched edges are counted by the checks") {
  const Shape cube = shape_of(box({0, 0, 0}, {1, 1, 1}));
  CHECK((cube.shells == 1 && cube.genus == 0 && cube.pinched_edges == 0));
  CHECK((cube.volume == 1 && cube.area == 6));
  const Shape hollow = shape_of(joined({box({0, 0, 0}, {3, 3, 3}), inside_out(box({1, 1, 1}, {2, 2, 2}))}));
  CHECK((hollow.shells == 2 && hollow.genus == 0));
  CHECK((hollow.volume == 26 && hollow.area == 60));
}
