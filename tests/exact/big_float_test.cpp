// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sums, differences and products of doubles of any range against integers of any length.
#include "mortise/exact/big_float.h"

#include <limits>

#include "exact/cases.h"
#include "exact/oracle.h"
#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using test::PointGenerator;

/// The number and what it should be: value * 2^exponent.
struct Pair {
  BigFloat number;
  oracle::Integer value;
  int exponent;
};

Pair of(double x) {
  const int exponent = oracle::lowest_exponent(x);
  return {BigFloat(x), oracle::scaled(x, exponent), exponent};
}

oracle::Integer at(const Pair& a, int exponent) { return a.value << static_cast<unsigned>(a.exponent - exponent); }

Pair add(const Pair& a, const Pair& b, bool negate) {
  const int exponent = std::min(a.exponent, b.exponent);
  const oracle::Integer second = negate ? oracle::Integer(-at(b, exponent)) : at(b, exponent);
  return {negate ? a.number - b.number : a.number + b.number, at(a, exponent) + second, exponent};
}

Pair multiply(const Pair& a, const Pair& b) { return {a.number * b.number, a.value * b.value, a.exponent + b.exponent}; }

/// Same sign, and leading digits within one part in 2^50.
bool agrees(const Pair& a) {
  if (sign_of(a.value.sign()) != a.number.sign()) return false;
  const BigFloat::Leading leading = a.number.leading();
  if (a.value.is_zero()) return leading.value == 0;
  const int low = std::min(a.exponent, leading.exponent);
  const oracle::Integer exact = a.value << static_cast<unsigned>(a.exponent - low);
  const oracle::Integer near = oracle::Integer(leading.value) << static_cast<unsigned>(leading.exponent - low);
  return (abs(oracle::Integer(exact - near)) << 50) <= abs(exact) && std::fabs(leading.value) >= 0x1p64;
}

/// A random expression over the numbers: each step replaces one of them by a sum, difference or product of two.
void grow(std::vector<Pair>& numbers, PointGenerator& random, int steps) {
  for (int i = 0; i < steps; ++i) {
    const Pair& a = numbers[random.below(numbers.size())];
    const Pair& b = numbers[random.below(numbers.size())];
    const std::size_t operation = random.below(3);
    numbers[random.below(numbers.size())] = operation == 2 ? multiply(a, b) : add(a, b, operation == 1);
  }
}

}  // namespace

TEST_CASE("Random expressions of doubles have the sign and the leading digits of integers", "[exact]") {
  for (std::uint64_t seed = 0; seed < test::scaled_count(100'000, 1'000'000); ++seed) {
    PointGenerator random(seed);
    std::vector<Pair> numbers;
    const std::vector<Vec3d> points = random.points(3);
    for (const Vec3d& p : points) numbers.insert(numbers.end(), {of(p.x), of(p.y), of(p.z)});
    grow(numbers, random, 12);
    for (const Pair& number : numbers) {
      if (!agrees(number)) FAIL(test::describe(seed, points));
    }
  }
}

TEST_CASE("Numbers beyond the built-in storage behave as small ones", "[exact]") {
  const double max = std::numeric_limits<double>::max(), min = std::numeric_limits<double>::denorm_min();
  const BigFloat wide = BigFloat(max) + BigFloat(min);  // 2,098 bits
  CHECK((wide - BigFloat(max) - BigFloat(min)).sign() == Sign::Zero);
  CHECK((wide - BigFloat(max)).sign() == Sign::Positive);
  const BigFloat square = wide * wide;
  BigFloat copy = square;
  CHECK((copy - square).sign() == Sign::Zero);
  copy = wide;
  copy = copy * BigFloat(max) + copy * BigFloat(min);
  CHECK((copy - square).sign() == Sign::Zero);
  const BigFloat moved = std::move(copy);
  CHECK((moved - square).sign() == Sign::Zero);
  CHECK((-moved + square).sign() == Sign::Zero);
}

TEST_CASE("Carries and borrows run through every digit", "[exact]") {
  const BigFloat one(1.0), big(0x1p192), ones = big - one;  // 192 one bits
  CHECK((ones + one - big).sign() == Sign::Zero);
  CHECK((big - ones - one).sign() == Sign::Zero);
  CHECK((ones * ones - (big * big - big - big + one)).sign() == Sign::Zero);
  CHECK((ones - big).sign() == Sign::Negative);
}

TEST_CASE("Zero is neutral and has no sign", "[exact]") {
  const BigFloat zero(0.0), minus_zero(-0.0), x(-3.5);
  CHECK(zero.sign() == Sign::Zero);
  CHECK(minus_zero.sign() == Sign::Zero);
  CHECK((x * zero).sign() == Sign::Zero);
  CHECK((x + zero - x).sign() == Sign::Zero);
  CHECK((zero - x).sign() == Sign::Positive);
  CHECK((-x).sign() == Sign::Positive);
  CHECK(BigFloat().sign() == Sign::Zero);
}

TEST_CASE("A difference of doubles is exact, also where doubles overflow", "[exact]") {
  const double max = std::numeric_limits<double>::max();
  CHECK((BigFloat::difference(max, -max) - BigFloat(max) - BigFloat(max)).sign() == Sign::Zero);
  CHECK((BigFloat::difference(1, 0x1p-80) - BigFloat(1) + BigFloat(0x1p-80)).sign() == Sign::Zero);
  CHECK(BigFloat::difference(5e-324, 5e-324).sign() == Sign::Zero);
}

}  // namespace mortise
