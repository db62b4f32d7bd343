// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Arguments are reduced to a sum of two doubles, then Taylor series are short. Large angles: Payne and Hanek 1983.
#include "mortise/base/trig.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "mortise/base/bits.h"

namespace mortise::trig {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The number hi + lo, |lo| at most half an ulp of hi.
struct Two {
  double hi, lo;
};

constexpr Two pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Two half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Two degree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
constexpr double radian_in_degrees = 0x1.ca5dc1a63c1f8p+5;
constexpr double ln2 = 0x1.62e42fefa39efp-1;
constexpr double ln2_high = 0x1.62e42feep-1;  // 32 bits: exact times an exponent
constexpr Two ln2_low{0x1.a39ef35793c76p-33, 0x1.cc01f97b57a08p-87};

bool has_sign_bit(double x) { return cast_bits<std::uint64_t>(x) >> 63 != 0; }

double with_sign_of(double x, double size) { return has_sign_bit(x) ? -size : size; }

Two exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

Two exact_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double a_hi = splitter * a - (splitter * a - a);
  const double b_hi = splitter * b - (splitter * b - b);
  const double a_lo = a - a_hi;
  const double b_lo = b - b_hi;
  const double product = a * b;
  return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

Two sum(const Two& a, const Two& b) {
  const Two s = exact_sum(a.hi, b.hi);
  return exact_sum(s.hi, s.lo + (a.lo + b.lo));
}

Two product(const Two& a, const Two& b) {
  const Two p = exact_product(a.hi, b.hi);
  return exact_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

Two quotient(const Two& a, const Two& b) {
  const double q = a.hi / b.hi;
  const Two back = exact_product(q, b.hi);
  return exact_sum(q, ((a.hi - back.hi) - back.lo + a.lo - q * b.lo) / b.hi);
}

/// c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t size>
double polynomial(const std::array<double, size>& c, double x) {
  double value = 0;
  for (std::size_t i = size; i-- > 0;) value = value * x + c[i];
  return value;
}

/// 1/first!, sign/(first + step)!, 1/(first + 2 step)!, ...
template <std::size_t size>
constexpr std::array<double, size> inverse_factorials(int first, int step, double sign) {
  std::array<double, size> c{};
  double factorial = 1;
  double numerator = 1;
  int n = 1;
  for (std::size_t i = 0; i < size; ++i) {
    for (; n <= first + static_cast<int>(i) * step; ++n) factorial *= n;
    c[i] = numerator / factorial;
    numerator *= sign;
  }
  return c;
}

/// 1/first, sign/(first + 2), 1/(first + 4), ...
template <std::size_t size>
constexpr std::array<double, size> inverse_odds(int first, double sign) {
  std::array<double, size> c{};
  double numerator = 1;
  for (std::size_t i = 0; i < size; ++i) {
    c[i] = numerator / (first + 2 * static_cast<int>(i));
    numerator *= sign;
  }
  return c;
}

/// Sine of a reduced angle, at most a little over pi/4 in size.
double small_sin(const Two& x) {
  constexpr auto c = inverse_factorials<8>(3, 2, -1);
  const double square = x.hi * x.hi;
  return x.hi + (x.lo * (1 - 0.5 * square) - x.hi * square * polynomial(c, square));
}

/// Cosine of a reduced angle.
double small_cos(const Two& x) {
  constexpr auto c = inverse_factorials<8>(4, 2, -1);
  const Two square = exact_product(x.hi, x.hi);
  const Two head = exact_sum(1, -0.5 * square.hi);
  return head.hi + (head.lo - 0.5 * square.lo + (square.hi * square.hi * polynomial(c, square.hi) - x.hi * x.lo));
}

/// An angle as quarter turns and a rest.
struct ReducedAngle {
  unsigned quarter;  ///< modulo 4
  Two rest;          ///< radians, at most pi/4 up to rounding
};

/// 32 bits of 2/pi that begin with bit `first`; bit i has the weight 2^-i.
std::uint32_t bits_of_two_over_pi(int first) {
  static constexpr std::array<std::uint32_t, 40> words{
      0xa2f9836eU, 0x4e441529U, 0xfc2757d1U, 0xf534ddc0U, 0xdb629599U, 0x3c439041U, 0xfe5163abU, 0xdebbc561U, 0xb7246e3aU, 0x424dd2e0U,
      0x06492eeaU, 0x09d1921cU, 0xfe1deb1cU, 0xb129a73eU, 0xe88235f5U, 0x2ebb4484U, 0xe99c7026U, 0xb45f7e41U, 0x3991d639U, 0x835339f4U,
      0x9c845f8bU, 0xbdf9283bU, 0x1ff897ffU, 0xde05980fU, 0xef2f118bU, 0x5a0a6d1fU, 0x6d367ecfU, 0x27cb09b7U, 0x4f463f66U, 0x9e5fea2dU,
      0x7527bac7U, 0xebe5f17bU, 0x3d0739f7U, 0x8a5292eaU, 0x6bfb5fb1U, 0x1f8d5d08U, 0x56033046U, 0xfc7b6babU, 0xf0cfbc20U, 0x9af4361dU};
  const auto word = [](int i) { return i < 0 ? 0U : words[static_cast<std::size_t>(i)]; };
  const int offset = first - 1 + 128;  // not negative
  const int index = offset / 32 - 4;
  const std::uint64_t two_words = std::uint64_t{word(index)} << 32 | word(index + 1);
  return static_cast<std::uint32_t>(two_words >> (32 - offset % 32));
}

using Fraction = std::array<std::uint32_t, 8>;  ///< 256 bits, most significant word first

void negate(Fraction& f) {
  std::uint64_t carry = 1;
  for (std::size_t i = f.size(); i-- > 0;) {
    carry += static_cast<std::uint32_t>(~f[i]);
    f[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

/// The first 128 bits from the first word that is not zero, as a number below 2^2: the first two bits count fours and twos.
Two to_two(const Fraction& f) {
  std::size_t i = 0;
  while (i + 4 < f.size() && f[i] == 0) ++i;
  Two value{0, 0};
  for (std::size_t k = i + 4; k-- > i;) value = sum(value, {std::ldexp(static_cast<double>(f[k]), -30 - 32 * static_cast<int>(k)), 0});
  return value;
}

/// mantissa * 2^exponent * 2/pi modulo 4, with 254 bits after the point.
Fraction quarter_turns(std::uint64_t mantissa, int exponent) {
  Fraction turns{};
  const std::array<std::uint64_t, 2> factor{mantissa & 0xffffffffU, mantissa >> 32};
  for (std::size_t shift = 0; shift < 2; ++shift) {
    std::uint64_t carry = 0;
    for (std::size_t i = turns.size() - shift; i-- > 0;) {
      const std::uint32_t bits = bits_of_two_over_pi(exponent - 1 + 32 * static_cast<int>(i + shift));
      carry += turns[i] + factor[shift] * bits;
      turns[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }
  return turns;
}

ReducedAngle reduce(double x) {
  constexpr double quarter_pi = 0x1.921fb54442d18p-1;
  if (std::fabs(x) <= quarter_pi) return {0, {x, 0}};
  int exponent = 0;
  const double mantissa = std::frexp(std::fabs(x), &exponent);
  Fraction turns = quarter_turns(static_cast<std::uint64_t>(std::ldexp(mantissa, 53)), exponent - 53);
  unsigned quarter = turns[0] >> 30;
  turns[0] &= 0x3fffffffU;
  bool is_negative = x < 0;
  if (turns[0] >> 29 != 0) {
    negate(turns);
    turns[0] &= 0x3fffffffU;
    ++quarter;
    is_negative = !is_negative;
  }
  const Two rest = product(to_two(turns), half_pi);
  return {(x < 0 ? 0U - quarter : quarter) % 4, is_negative ? Two{-rest.hi, -rest.lo} : rest};
}

double sin_of(const ReducedAngle& angle) {
  const double value = angle.quarter % 2 == 0 ? small_sin(angle.rest) : small_cos(angle.rest);
  return angle.quarter < 2 ? value : -value;
}

/// Degrees as quarter turns and a rest in [-45, 45], exactly.
struct ReducedDegrees {
  unsigned quarter;
  double rest;
};

ReducedDegrees reduce_degrees(double degrees) {
  double rest = std::fabs(degrees);
  for (int exponent = 1024 - 9; exponent >= 0 && rest >= 360; --exponent) {
    const double turns = std::ldexp(360.0, exponent);
    if (rest >= turns) rest -= turns;
  }
  const auto quarter = static_cast<unsigned>(std::floor((rest + 45) / 90));
  rest -= 90.0 * quarter;
  if (degrees < 0) return {(4 - quarter % 4) % 4, -rest};
  return {quarter % 4, rest};
}

double small_sin_deg(double degrees) {
  if (std::fabs(degrees) == 30) return degrees / 60;
  if (std::fabs(degrees) == 45) return degrees / 45 * std::sqrt(0.5);
  return small_sin(product({degrees, 0}, degree));
}

double small_cos_deg(double degrees) { return std::fabs(degrees) == 45 ? std::sqrt(0.5) : small_cos(product({degrees, 0}, degree)); }

double sin_of(const ReducedDegrees& angle) {
  const double value = angle.quarter % 2 == 0 ? small_sin_deg(angle.rest) : small_cos_deg(angle.rest);
  return (angle.quarter < 2 ? value : -value) + 0.0;
}

/// Arc tangent of a number in [0, 1]: that of the nearest eighth, plus a series.
Two small_atan(const Two& x) {
  static constexpr std::array<Two, 9> atan_of_eighths{{{0, 0},
                                                       {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                       {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                       {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                       {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                       {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                       {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                       {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                       {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
  constexpr auto c = inverse_odds<8>(3, -1);
  const double eighths = std::floor(8 * x.hi + 0.5);
  const double base = eighths / 8;
  const Two t = eighths == 0 ? x : quotient(sum(x, {-base, 0}), sum({1, 0}, product(x, {base, 0})));
  const double square = t.hi * t.hi;
  const Two& known = atan_of_eighths[static_cast<std::size_t>(eighths)];
  const Two head = exact_sum(known.hi, t.hi);
  return exact_sum(head.hi, head.lo + (known.lo + (t.lo - t.hi * square * polynomial(c, square))));
}

/// Angle of (x, y), not both zero, of sizes between 2^-500 and 2^500 or zero.
double angle_of(const Two& y, const Two& x) {
  const Two y_size = y.hi < 0 ? Two{-y.hi, -y.lo} : y;
  const Two x_size = x.hi < 0 ? Two{-x.hi, -x.lo} : x;
  const bool is_steep = y_size.hi > x_size.hi;
  Two angle = is_steep ? small_atan(quotient(x_size, y_size)) : small_atan(quotient(y_size, x_size));
  if (is_steep) angle = sum(half_pi, {-angle.hi, -angle.lo});
  if (x.hi < 0) angle = sum(pi, {-angle.hi, -angle.lo});
  const double value = angle.hi + angle.lo;
  return y.hi < 0 ? -value : value;
}

/// As atan2, when the smaller of the two sizes is zero or negligible.
double angle_near_axis(double y, double x, bool is_steep) {
  if (is_steep) return y < 0 ? -half_pi.hi : half_pi.hi;
  if (has_sign_bit(x)) return has_sign_bit(y) ? -pi.hi : pi.hi;
  return x == 0 ? y : y / x;
}

}  // namespace

double sin(double x) { return std::fabs(x) < infinity ? sin_of(reduce(x)) : nan; }

double cos(double x) {
  if (!(std::fabs(x) < infinity)) return nan;
  const ReducedAngle angle = reduce(x);
  return sin_of(ReducedAngle{(angle.quarter + 1) % 4, angle.rest});
}

double sin_deg(double degrees) { return std::fabs(degrees) < infinity ? sin_of(reduce_degrees(degrees)) : nan; }

double cos_deg(double degrees) {
  if (!(std::fabs(degrees) < infinity)) return nan;
  const ReducedDegrees angle = reduce_degrees(degrees);
  return sin_of(ReducedDegrees{(angle.quarter + 1) % 4, angle.rest});
}

double atan2(double y, double x) {
  if (y != y || x != x) return nan;
  const bool x_is_infinite = std::fabs(x) == infinity;
  const bool y_is_infinite = std::fabs(y) == infinity;
  if (x_is_infinite || y_is_infinite) return atan2(with_sign_of(y, y_is_infinite ? 1 : 0), with_sign_of(x, x_is_infinite ? 1 : 0));
  const bool is_steep = std::fabs(y) > std::fabs(x);
  const double larger = is_steep ? std::fabs(y) : std::fabs(x);
  int exponent = 0;
  std::frexp(larger, &exponent);
  const double y_scaled = std::ldexp(y, -exponent);
  const double x_scaled = std::ldexp(x, -exponent);
  constexpr double negligible = 0x1p-300;
  if (!(std::fabs(is_steep ? x_scaled : y_scaled) > negligible)) return angle_near_axis(y, x, is_steep);
  return angle_of({y_scaled, 0}, {x_scaled, 0});
}

double acos(double x) {
  if (!(std::fabs(x) <= 1)) return nan;
  if (x == 1) return 0;
  const Two square = std::fabs(x) < 0x1p-300 ? Two{0, 0} : exact_product(x, x);
  const Two rest = sum({1, 0}, {-square.hi, -square.lo});  // sin^2
  const double sine = std::sqrt(rest.hi);
  if (sine == 0) return pi.hi;
  const Two back = exact_product(sine, sine);
  const double correction = ((rest.hi - back.hi) - back.lo + rest.lo) / (2 * sine);
  return angle_of({sine, correction}, {std::fabs(x) < 0x1p-300 ? 0 : x, 0});
}

double exp(double x) {
  if (x != x) return nan;
  if (x > 710) return infinity;
  if (x < -746) return 0;
  const double k = std::floor(x / ln2 + 0.5);
  const Two r = sum(exact_sum(x - k * ln2_high, -k * ln2_low.hi), {-k * ln2_low.lo, 0});
  constexpr auto c = inverse_factorials<13>(2, 1, 1);
  const Two head = exact_sum(1, r.hi);
  const double value = head.hi + (head.lo + (r.lo + r.hi * r.lo + r.hi * r.hi * polynomial(c, r.hi)));
  return std::ldexp(value, static_cast<int>(k));
}

double log(double x) {
  if (x != x || x < 0) return nan;
  if (x == 0) return -infinity;
  if (x == infinity) return infinity;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < std::sqrt(0.5)) {
    mantissa *= 2;
    --exponent;
  }
  // log(m) = 2 atanh(s), s = (m - 1) / (m + 1)
  constexpr auto c = inverse_odds<11>(3, 1);
  const Two s = quotient({mantissa - 1, 0}, exact_sum(mantissa, 1));
  const double square = s.hi * s.hi;
  const Two head = exact_sum(exponent * ln2_high, 2 * s.hi);
  const Two low = exact_product(exponent, ln2_low.hi);
  const Two tail = exact_sum(low.hi, 2 * (s.lo + s.hi * square * polynomial(c, square)));
  return head.hi + (tail.hi + (tail.lo + (low.lo + head.lo)));
}

double to_degrees(double radians) { return radians * radian_in_degrees; }

}  // namespace mortise::trig
