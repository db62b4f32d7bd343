// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sides of planes and points on them against integers of any length.
#include "mortise/exact/plane_predicates.h"

#include <cmath>

#include "exact/oracle.h"
#include "mortise/base/error.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_source.h"

namespace mortise {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational exact(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const oracle::Integer power = oracle::Integer(1) << static_cast<unsigned>(std::abs(exponent - 53));
  return exponent >= 53 ? Rational(mantissa * power) : Rational(oracle::Integer(mantissa), power);
}

Rational exact_height(const Plane& plane, const Vec3d& p) {
  Rational sum = -exact(plane.offset);
  for (std::size_t i = 0; i < 3; ++i) sum += exact(plane.normal[i]) * exact(p[i]);
  return sum;
}

/// Is no double nearer to the exact coordinate?
bool is_nearest(double x, const Rational& truth) {
  const Rational off = abs(Rational(exact(x) - truth));
  return off <= abs(Rational(exact(std::nextafter(x, HUGE_VAL)) - truth)) &&
         off <= abs(Rational(exact(std::nextafter(x, -HUGE_VAL)) - truth));
}

}  // namespace

TEST_CASE("The side of a plane is exact, next to it too", "[exact][plane]") {
  test::RandomSource random(1);
  int zeros = 0;
  for (int i = 0; i < 2000; ++i) {
    const double scale = random.octaves(-40, 40);
    const Vec3d normal = scale * random.direction(), p = random.point(-100, 100);
    // an offset next to, and sometimes at, the height of the point
    const double offset = static_cast<double>(exact_height({normal, 0}, p));
    for (const double d : {offset, std::nextafter(offset, HUGE_VAL), std::nextafter(offset, -HUGE_VAL)}) {
      CHECK(static_cast<int>(side_of({normal, d}, p)) == exact_height({normal, d}, p).sign());
    }
    const Vec3d whole{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const Plane through{{3, -5, 7}, 3 * whole.x - 5 * whole.y + 7 * whole.z};
    zeros += side_of(through, whole) == Sign::Zero ? 1 : 0;
  }
  CHECK(zeros == 2000);
  CHECK(side_of({{1e-200, 0, 0}, 0}, {1e-200, 0, 0}) == Sign::Positive);
  CHECK(side_of({{1e300, -1e300, 0}, 0}, {1e300, 1e300, 5}) == Sign::Zero);
}

TEST_CASE("A point on a plane is the nearest double", "[exact][plane]") {
  test::RandomSource random(2);
  for (int i = 0; i < 2000; ++i) {
    const Plane plane{random.direction(), random.between(-1, 1)};
    const Vec3d a = random.point(-10, 10), b = random.point(-10, 10);
    if (side_of(plane, a) * side_of(plane, b) != Sign::Negative) continue;
    const Vec3d p = nearest_crossing(plane, a, b);
    CHECK(p == nearest_crossing(plane, b, a));
    const Rational t = exact_height(plane, a) / (exact_height(plane, a) - exact_height(plane, b));
    for (std::size_t k = 0; k < 3; ++k) CHECK(is_nearest(p[k], exact(a[k]) + t * (exact(b[k]) - exact(a[k]))));
  }
}

TEST_CASE("A point on a plane along an axis has its coordinate", "[exact][plane]") {
  const Vec3d p = nearest_crossing({{0, 0, 3}, 0.3}, {1, 2, -7}, {1, 5, 11});
  CHECK(p.x == 1);
  CHECK(p.z == 0.3 / 3);
}

}  // namespace mortise
