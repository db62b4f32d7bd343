// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Expansions and double-doubles against integers of any length: the first exact, the second within its own bound.
#include <algorithm>

#include "exact/cases.h"
#include "exact/oracle.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/expansion.h"
#include "mortise/exact/formulas.h"
#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using test::PointGenerator;

oracle::Integer scaled_sum(std::initializer_list<double> terms, int exponent) {
  oracle::Integer sum = 0;
  for (const double x : terms) sum += oracle::scaled(x, exponent);
  return sum;
}

/// The value of a determinant of `degree` whose coordinates were scaled by 2^-exponent, at 2^-low.
oracle::Integer at(const oracle::Integer& value, int degree, int exponent, int low) {
  return value << static_cast<unsigned>(degree * exponent - low);
}

bool is_within_error(const DoubleDouble& near, const oracle::Integer& exact, int exponent) {
  if (!std::isfinite(near.error) || !std::isfinite(near.hi)) return true;
  const int low = std::min(3 * exponent, -1074);
  const oracle::Integer off = abs(oracle::Integer(scaled_sum({near.hi, near.lo}, low) - at(exact, 3, exponent, low)));
  return off <= scaled_sum({near.error * double_double::slack}, low);
}

/// Is the highest bit of every term below the lowest set bit of the next?
template <std::size_t N>
bool is_nonoverlapping(const Expansion<N>& e) {
  for (std::size_t i = 1; i < e.size; ++i) {
    int above_previous = 0;
    std::frexp(e.terms[i - 1], &above_previous);
    if (std::fmod(e.terms[i], std::ldexp(1.0, above_previous)) != 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("The expansion of a determinant is its exact value", "[exact]") {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < test::scaled_count(100'000, 1'000'000); ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(4);
    if (!is_in_expansion_range({p[0], p[1], p[2], p[3]})) continue;
    ++compared;
    const oracle::Scaled q = oracle::scaled(p);
    const oracle::Plane plane = oracle::plane(q.positions[0], q.positions[1], q.positions[2]);
    const auto e = orient3d_value<Expansion<2>>(p[0], p[1], p[2], p[3]);
    const int low = std::min(3 * q.exponent, -1074);
    oracle::Integer sum = 0;
    for (std::size_t i = 0; i < e.size; ++i) sum += oracle::scaled(e.terms[i], low);
    const oracle::Integer exact = oracle::dot(plane.normal, q.positions[3]) - plane.offset;
    if (sum != at(exact, 3, q.exponent, low) || !is_nonoverlapping(e)) FAIL(test::describe(seed, p));
  }
  CHECK(compared > test::scaled_count(100'000, 1'000'000) / 2);
}

TEST_CASE("A double-double determinant is within its own error bound", "[exact]") {
  for (std::uint64_t seed = 0; seed < test::scaled_count(100'000, 1'000'000); ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(4);
    const oracle::Scaled q = oracle::scaled(p);
    const oracle::Plane plane = oracle::plane(q.positions[0], q.positions[1], q.positions[2]);
    const oracle::Integer exact = oracle::dot(plane.normal, q.positions[3]) - plane.offset;
    if (!is_within_error(orient3d_value<DoubleDouble>(p[0], p[1], p[2], p[3]), exact, q.exponent)) FAIL(test::describe(seed, p));
  }
}

TEST_CASE("A double-double quotient is within its own error bound", "[exact]") {
  for (std::uint64_t seed = 0; seed < test::scaled_count(100'000, 1'000'000); ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(3);
    const oracle::Scaled q = oracle::scaled(p);
    const auto orientation = [&](std::size_t u, std::size_t v) {
      const oracle::Position n = oracle::plane(q.positions[0], q.positions[1], q.positions[2]).normal;
      return n[3 - u - v];
    };
    const oracle::Integer a = orientation(1, 2), b = orientation(0, 1);
    if (b.is_zero()) continue;
    const DoubleDouble quotient =
        orient2d_value<DoubleDouble>(p[0], p[1], p[2], Axis::X) / orient2d_value<DoubleDouble>(p[0], p[1], p[2], Axis::Z);
    if (!std::isfinite(quotient.error) || !std::isfinite(quotient.hi)) continue;
    const double error = quotient.error * double_double::slack;
    int low = -1074;
    for (const double x : {quotient.hi, quotient.lo, error}) low = std::min(low, oracle::lowest_exponent(x));
    const oracle::Integer off = abs(oracle::Integer(scaled_sum({quotient.hi, quotient.lo}, low) * b - (a << static_cast<unsigned>(-low))));
    if (off > oracle::scaled(error, low) * abs(b)) FAIL(test::describe(seed, p));
  }
}

TEST_CASE("Expansions drop zeros", "[exact]") {
  CHECK(Expansion<2>::difference(1, 1).size == 0);
  CHECK(Expansion<2>::difference(3, 1).size == 1);
  CHECK(Expansion<2>::difference(1, 0x1p-60).size == 2);
  const auto square = Expansion<2>::difference(3, 1) * Expansion<2>::difference(3, 1);
  CHECK((square - square).size == 0);
  CHECK((square - square).sign() == Sign::Zero);
}

TEST_CASE("A double-double zero is never certain", "[exact]") {
  CHECK_FALSE(certain_sign(DoubleDouble::difference(1, 1)).has_value());
  CHECK_FALSE(certain_sign(DoubleDouble{0x1p-950, 0, 0}).has_value());
  CHECK(certain_sign(DoubleDouble::difference(1, 1 + 0x1p-52)) == Sign::Negative);
  const double inf = HUGE_VAL;
  CHECK_FALSE(certain_sign(DoubleDouble{inf, 0, inf}).has_value());
  CHECK_FALSE(certain_sign(DoubleDouble{1, 0, inf - inf}).has_value());
}

}  // namespace mortise
