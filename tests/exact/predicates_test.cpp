// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// orient3d, orient2d and what is built on them, rung by rung, against integers of any length.
#include "mortise/exact/predicates.h"

#include "exact/cases.h"
#include "exact/oracle.h"
#include "mortise/exact/big_float.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/expansion.h"
#include "mortise/exact/filters.h"
#include "mortise/exact/formulas.h"
#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using test::describe;
using test::PointGenerator;
using test::RungTally;

std::size_t explicit_count() { return test::scaled_count(1'000'000, 1'000'000); }

void require_rungs_agree(Sign expected, const std::vector<Vec3d>& p, std::uint64_t seed) {
  const auto filter = filters::orient3d(p[0], p[1], p[2], {p[3], {}});
  const auto near = certain_sign(orient3d_value<DoubleDouble>(p[0], p[1], p[2], p[3]));
  const bool in_range = is_in_expansion_range({p[0], p[1], p[2], p[3]});
  bool agree = filter.value_or(expected) == expected && near.value_or(expected) == expected;
  agree = agree && orient3d_value<BigFloat>(p[0], p[1], p[2], p[3]).sign() == expected;
  agree = agree && (!in_range || orient3d_value<Expansion<2>>(p[0], p[1], p[2], p[3]).sign() == expected);
  if (!agree) FAIL(describe(seed, p));
}

void require_rungs_agree_2d(Sign expected, const std::vector<Vec3d>& p, Axis axis, std::uint64_t seed) {
  const auto filter = filters::orient2d(p[0], p[1], p[2], axis);
  const auto [u, v] = kept_coordinates(axis);
  const auto near_filter = filters::orient2d({p[0][u], p[0][v], 0, 0}, {p[1][u], p[1][v], 0, 0}, {p[2][u], p[2][v], 0, 0});
  const auto near = certain_sign(orient2d_value<DoubleDouble>(p[0], p[1], p[2], axis));
  bool agree = filter.value_or(expected) == expected && near_filter.value_or(expected) == expected && near.value_or(expected) == expected;
  agree = agree && orient2d_value<BigFloat>(p[0], p[1], p[2], axis).sign() == expected;
  agree = agree && (!is_in_expansion_range({p[0], p[1], p[2]}) || orient2d_value<Expansion<2>>(p[0], p[1], p[2], axis).sign() == expected);
  if (!agree) FAIL(describe(seed, p));
}

Sign expected_orient2d(const std::vector<oracle::Position>& p, Axis axis) {
  const auto [u, v] = kept_coordinates(axis);
  return oracle::orient2d({p[0], 1}, {p[1], 1}, {p[2], 1}, u, v);
}

}  // namespace

TEST_CASE("orient3d is exact on every rung, for every nature of points", "[exact]") {
  RungTally tally;
  for (std::uint64_t seed = 0; seed < explicit_count(); ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(4);
    const auto q = oracle::scaled(p).positions;
    const Sign expected = oracle::orient3d(q[0], q[1], q[2], q[3]);
    const Answer answer = explain_orient3d(p[0], p[1], p[2], p[3]);
    tally.add(answer.rung);
    if (answer.sign != expected) FAIL(describe(seed, p));
    require_rungs_agree(expected, p, seed);
  }
  tally.print("orient3d");
  CHECK(tally.of(Rung::Filter) > explicit_count() / 4);
  CHECK(tally.of(Rung::Expansion) > explicit_count() / 10);
  CHECK(tally.of(Rung::BigFloat) > explicit_count() / 10);
}

TEST_CASE("orient2d is exact on every rung, along every axis", "[exact]") {
  RungTally tally;
  for (std::uint64_t seed = 0; seed < explicit_count(); ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(3);
    const auto axis = static_cast<Axis>(seed / test::nature_count % 3);
    const Sign expected = expected_orient2d(oracle::scaled(p).positions, axis);
    const Answer answer = explain_orient2d(p[0], p[1], p[2], axis);
    tally.add(answer.rung);
    if (answer.sign != expected) FAIL(describe(seed, p));
    require_rungs_agree_2d(expected, p, axis, seed);
  }
  tally.print("orient2d");
  CHECK(tally.of(Rung::Filter) > explicit_count() / 4);
  CHECK(tally.of(Rung::Expansion) > explicit_count() / 1000);
  CHECK(tally.of(Rung::BigFloat) > explicit_count() / 100);
}

TEST_CASE("A swap of two points changes the sign of orient3d and orient2d", "[exact]") {
  for (std::uint64_t seed = 0; seed < explicit_count() / 10; ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(4);
    const auto axis = static_cast<Axis>(seed % 3);
    const Sign three = orient3d(p[0], p[1], p[2], p[3]);
    const Sign two = orient2d(p[0], p[1], p[2], axis);
    const bool is_odd = orient3d(p[1], p[0], p[2], p[3]) == -three && orient3d(p[0], p[2], p[1], p[3]) == -three &&
                        orient3d(p[0], p[1], p[3], p[2]) == -three && orient2d(p[1], p[0], p[2], axis) == -two &&
                        orient2d(p[0], p[2], p[1], axis) == -two && orient2d(p[2], p[1], p[0], axis) == -two;
    if (!is_odd) FAIL(describe(seed, p));
  }
}

TEST_CASE("orient3d is positive where the normal of a counterclockwise triangle points to", "[exact]") {
  const Vec3d a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  CHECK(orient3d(a, b, c, {0, 0, 1}) == Sign::Positive);
  CHECK(orient3d(a, b, c, {0, 0, -5e-324}) == Sign::Negative);
  CHECK(orient3d(a, b, c, {7, -3, 0}) == Sign::Zero);
}

TEST_CASE("orient2d keeps orientation along each axis", "[exact]") {
  const Vec3d a{0, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, d{1, 0, 0};
  CHECK(orient2d(a, b, c, Axis::X) == Sign::Positive);
  CHECK(orient2d(a, c, d, Axis::Y) == Sign::Positive);
  CHECK(orient2d(a, d, b, Axis::Z) == Sign::Positive);
  CHECK(orient2d(a, b, c, Axis::Z) == Sign::Zero);
}

TEST_CASE("Numbers that overflow or underflow in doubles still have their sign", "[exact]") {
  const double huge = 0x1.fffffffffffffp1023, tiny = 5e-324;
  CHECK(orient3d({-huge, -huge, -huge}, {huge, -huge, -huge}, {-huge, huge, -huge}, {0, 0, huge}) == Sign::Positive);
  CHECK(orient3d({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, -tiny}) == Sign::Negative);
  CHECK(orient3d({0, 0, 0}, {tiny, 0, 0}, {0, huge, 0}, {huge, huge, tiny}) == Sign::Positive);
  // The first minor underflows to zero in doubles, and its factor is huge.
  CHECK(orient3d({0, 0, 0}, {0, 0x1p-538, 0}, {0, 0, 0x1p-538}, {0x1p1023, 0, 0}) == Sign::Positive);
  CHECK(orient2d({0, 0, 0}, {tiny, tiny, 0}, {huge, huge, 0}, Axis::Z) == Sign::Zero);
  CHECK(orient2d({0, 0, 0}, {tiny, 0, 0}, {huge, tiny, 0}, Axis::Z) == Sign::Positive);
}

TEST_CASE("are_collinear asks for all three projections", "[exact]") {
  CHECK(are_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
  CHECK(are_collinear({1, 1, 1}, {1, 1, 1}, {4, 5, 6}));
  CHECK_FALSE(are_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, 9 + 0x1p-49}));
  CHECK_FALSE(are_collinear({0, 0, 0}, {1, 0, 0}, {2, 0, 5e-324}));
  CHECK_FALSE(are_collinear({0, 0, 0}, {0, 1, 0}, {5e-324, 2, 0}));
}

TEST_CASE("projection_axis is an axis of positive area, the largest where doubles can tell", "[exact]") {
  CHECK(projection_axis({0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}) == Axis::Z);
  CHECK(projection_axis({0, 0, 0}, {0, 1, 0.5}, {0.5, 0, 1}) == Axis::X);
  CHECK(projection_axis({0, 0, 0}, {0, 0, 1}, {1, 0.5, 0}) == Axis::Y);
  CHECK_FALSE(projection_axis({0, 0, 0}, {1, 2, 3}, {2, 4, 6}).has_value());
  for (std::uint64_t seed = 0; seed < explicit_count() / 10; ++seed) {
    const std::vector<Vec3d> p = PointGenerator(seed).points(3);
    const auto axis = projection_axis(p[0], p[1], p[2]);
    const auto q = oracle::scaled(p).positions;
    const bool has_area = !oracle::is_zero(oracle::plane(q[0], q[1], q[2]).normal);
    if (axis.has_value() != has_area || (axis && expected_orient2d(q, *axis) == Sign::Zero)) FAIL(describe(seed, p));
  }
}

}  // namespace mortise
