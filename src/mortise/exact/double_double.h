// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers of about 104 bits that know how wrong they may be: double-double arithmetic (Dekker, Knuth; bounds of Joldes,
// Muller and Popescu 2017) with a running error bound. Round-to-nearest only, no FMA.
#pragma once

#include <cmath>
#include <optional>

#include "mortise/exact/sign.h"

namespace mortise {

/// a + b = sum + error exactly, unless it overflows.
struct ExactSum {
  double sum, error;
};

[[nodiscard]] inline ExactSum two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// As two_sum, for |a| >= |b| or a = 0.
[[nodiscard]] inline ExactSum quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b = sum + error exactly, unless it overflows, a or b exceeds 2^995, or the product is below 2^-968.
[[nodiscard]] inline ExactSum two_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double a_big = splitter * a, b_big = splitter * b;
  const double a_hi = a_big - (a_big - a), b_hi = b_big - (b_big - b);
  const double a_lo = a - a_hi, b_lo = b - b_hi;
  const double product = a * b;
  return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

/// Some number within `error` of hi + lo, |lo| <= ulp(hi) / 2.
///
/// `error` itself is rounded, to at most one part in 2^53 per operation: certain_sign allows for 2^12 of them. An overflow
/// makes it inf or NaN, and then nothing is certain; an underflow is covered by `tiny`.
struct DoubleDouble {
  double hi = 0, lo = 0, error = 0;

  /// a - b, exactly.
  [[nodiscard]] static DoubleDouble difference(double a, double b) {
    const ExactSum s = two_sum(a, -b);
    return {s.sum, s.error, 0};
  }
};

namespace double_double {
inline constexpr double relative = 0x1p-100;  // the operations below are within 7 * 2^-106 of their result
inline constexpr double tiny = 0x1p-1000;     // more than products lose when they underflow
inline constexpr double slack = 1 + 0x1p-40;
inline constexpr double smallest_certain = 0x1p-900;
}  // namespace double_double

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo, a.error}; }

[[nodiscard]] inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const ExactSum s = two_sum(a.hi, b.hi);
  const ExactSum t = two_sum(a.lo, b.lo);
  const ExactSum v = quick_two_sum(s.sum, s.error + t.sum);
  const ExactSum z = quick_two_sum(v.sum, t.error + v.error);
  return {z.sum, z.error, (a.error + b.error) + double_double::relative * std::fabs(z.sum)};
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }

[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const ExactSum p = two_product(a.hi, b.hi);
  const ExactSum z = quick_two_sum(p.sum, p.error + (a.hi * b.lo + a.lo * b.hi));
  const double operands = std::fabs(a.hi) * b.error + a.error * (std::fabs(b.hi) + b.error);
  return {z.sum, z.error, operands + (double_double::relative * std::fabs(z.sum) + double_double::tiny)};
}

/// The quotient, bounded by its residual; error is NaN or inf when the divisor may be zero.
[[nodiscard]] inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q1 = a.hi / b.hi;
  const DoubleDouble rest = a - DoubleDouble{q1, 0, 0} * b;
  const ExactSum q = quick_two_sum(q1, rest.hi / b.hi);
  const DoubleDouble residual = a - DoubleDouble{q.sum, q.error, 0} * b;  // its error covers those of a and b
  const double divisor = std::fabs(b.hi) * (1 - 0x1p-40) - b.error * double_double::slack;
  const double error = (std::fabs(residual.hi) + residual.error) * double_double::slack / divisor + double_double::tiny;
  return {q.sum, q.error, divisor > double_double::smallest_certain ? error : HUGE_VAL};
}

/// The sign, or nothing when it is not certain (a zero never is).
[[nodiscard]] inline std::optional<Sign> certain_sign(const DoubleDouble& a) {
  const double size = std::fabs(a.hi) * (1 - 0x1p-40);
  if (size > a.error * double_double::slack && size > double_double::smallest_certain) return sign_of(a.hi);
  return std::nullopt;
}

}  // namespace mortise
