// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Double-double where it is certain, else exact comparison with the doubles and midpoints around the quotient.
#include "mortise/exact/rounding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "mortise/base/bits.h"
#include "mortise/base/error.h"

namespace mortise {

namespace {

/// base + quotient as nearest and rest, when the error bound leaves no doubt about the rounding; `side` is that of the rest found.
std::optional<RoundedCoordinate> round_nearly(double base, const DoubleDouble& quotient) {
  const ExactSum s = two_sum(base, quotient.hi);
  const double tail = s.error + quotient.lo;
  const ExactSum x = two_sum(s.sum, tail);
  const double error = (quotient.error + 0x1p-52 * std::fabs(tail)) * double_double::slack;
  const bool certain = x.sum + (x.error - error) == x.sum && x.sum + (x.error + error) == x.sum;
  if (!certain || std::fabs(x.sum) < double_double::smallest_certain) return std::nullopt;
  return RoundedCoordinate{x.sum, x.error, error, sign_of(x.error)};
}

/// The same when there is no doubt about the side either.
std::optional<RoundedCoordinate> round_certainly(double base, const DoubleDouble& quotient) {
  const std::optional<RoundedCoordinate> x = round_nearly(base, quotient);
  return x && (x->rest - x->error > 0 || x->rest + x->error < 0) ? x : std::nullopt;
}

double approximate_quotient(const BigFloat& a, const BigFloat& b) {
  const BigFloat::Leading p = a.leading(), q = b.leading();
  return std::ldexp(p.value / q.value, p.exponent - q.exponent);
}

/// The double above |x|; 2^1024 above the largest one.
BigFloat next_above(double x) {
  if (x == std::numeric_limits<double>::max()) return BigFloat(0x1p1023) + BigFloat(0x1p1023);
  return BigFloat(cast_bits<double>(cast_bits<std::uint64_t>(x) + 1));
}

/// Sign of x / w - (a + b) / 2.
Sign side_of_midpoint(const BigFloat& twice_x, const BigFloat& w, const BigFloat& a, const BigFloat& b) {
  return (twice_x - (a + b) * w).sign();
}

/// The nearest double of x / w, both not negative, w not zero: a few steps from the quotient of their leading bits.
double nearest_of_quotient(const BigFloat& x, const BigFloat& w) {
  constexpr double max = std::numeric_limits<double>::max();
  const BigFloat twice_x = x + x;
  double h = std::min(approximate_quotient(x, w), max);
  while (true) {
    const bool is_odd = (cast_bits<std::uint64_t>(h) & 1) != 0;
    const Sign above = side_of_midpoint(twice_x, w, BigFloat(h), next_above(h));
    if (above == Sign::Positive || (above == Sign::Zero && is_odd)) {
      if (h == max) throw Error(ErrorCode::OutOfRange, "exact", "a point of intersection does not fit the range of doubles");
      h = cast_bits<double>(cast_bits<std::uint64_t>(h) + 1);
      continue;
    }
    if (h == 0) return h;
    const double below = cast_bits<double>(cast_bits<std::uint64_t>(h) - 1);
    const Sign side = side_of_midpoint(twice_x, w, BigFloat(below), BigFloat(h));
    if (side == Sign::Positive || (side == Sign::Zero && !is_odd)) return h;
    h = below;
  }
}

/// As round_certainly, always: w > 0.
RoundedCoordinate round_exactly(double base, const BigFloat& offset, const BigFloat& w) {
  const BigFloat x = BigFloat(base) * w + offset;
  RoundedCoordinate result;
  if (x.sign() == Sign::Zero) return result;
  result.nearest = x.sign() == Sign::Positive ? nearest_of_quotient(x, w) : -nearest_of_quotient(-x, w);
  if (result.nearest == 0) result.nearest = 0;
  const BigFloat rest = x - BigFloat(result.nearest) * w;
  result.side = rest.sign();
  if (result.side == Sign::Zero) return result;
  result.rest = approximate_quotient(rest, w);
  result.error = std::fabs(result.rest) * 0x1p-48 + std::numeric_limits<double>::min();
  return result;
}

Homogeneous<BigFloat> with_positive_w(Homogeneous<BigFloat> h) {
  MORTISE_CHECK(h.w.sign() != Sign::Zero, "a point made from parallel lines or planes");
  if (h.w.sign() == Sign::Positive) return h;
  for (BigFloat& coordinate : h.offset) coordinate = -std::move(coordinate);
  h.w = -std::move(h.w);
  return h;
}

}  // namespace

Homogeneous<BigFloat> exact_point(const Construction& construction, const std::array<Vec3d, 9>& points) {
  return with_positive_w(homogeneous_point<BigFloat>(construction, points));
}

RoundedPoint round_point(const Construction& construction, const std::array<Vec3d, 9>& points) {
  RoundedPoint result;
  const Homogeneous<DoubleDouble> near = homogeneous_point<DoubleDouble>(construction, points);
  for (std::size_t i = 0; i < 3; ++i) {
    RoundedCoordinate& coordinate = result.coordinates[i];
    if (const auto shared = shared_coordinate(construction, points, i)) {
      coordinate.nearest = *shared == 0 ? 0 : *shared;
    } else if (const auto rounded = round_certainly(points[0][i], near.offset[i] / near.w)) {
      coordinate = *rounded;
    } else {
      if (!result.exact) result.exact = std::make_unique<const Homogeneous<BigFloat>>(exact_point(construction, points));
      coordinate = round_exactly(points[0][i], result.exact->offset[i], result.exact->w);
    }
  }
  return result;
}

Vec3d round_homogeneous(const Vec3d& base, Homogeneous<BigFloat> point) {
  const Homogeneous<BigFloat> h = with_positive_w(std::move(point));
  Vec3d rounded;
  for (std::size_t i = 0; i < 3; ++i) rounded[i] = round_exactly(base[i], h.offset[i], h.w).nearest;
  return rounded;
}

std::optional<double> nearest_sum(double base, const DoubleDouble& offset) {
  const std::optional<RoundedCoordinate> x = round_nearly(base, offset);
  return x ? std::optional(x->nearest) : std::nullopt;
}

double nearest_sum(double base, const BigFloat& offset, const BigFloat& w) { return round_exactly(base, offset, w).nearest; }

}  // namespace mortise
