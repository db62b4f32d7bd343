// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the exact core must answer, in integers of any length: coordinates times one power of two, Cramer's rule.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise::oracle {

using Integer = boost::multiprecision::cpp_int;
using Position = std::array<Integer, 3>;

/// x / w, w not zero.
struct Point {
  Position x;
  Integer w = 1;
};

/// normal . x = offset on the plane.
struct Plane {
  Position normal;
  Integer offset;
};

/// The largest exponent e, at most 0, for which x * 2^-e is an integer.
[[nodiscard]] inline int lowest_exponent(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  return std::min(exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa)), 0);
}

/// x * 2^-exponent.
[[nodiscard]] inline Integer scaled(double x, int exponent) {
  int e = 0;
  const Integer result = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
  const int shift = e - 53 - exponent;
  if (shift >= 0) return result << static_cast<unsigned>(shift);
  return result / (Integer(1) << static_cast<unsigned>(-shift));  // without rest: the exponent is low enough
}

/// Positions as integers, all times the same power of two.
struct Scaled {
  std::vector<Position> positions;
  int exponent = 0;
};

template <class Points>
[[nodiscard]] Scaled scaled(const Points& points) {
  Scaled result;
  for (const Vec3d& p : points) {
    for (std::size_t i = 0; i < 3; ++i) result.exponent = std::min(result.exponent, lowest_exponent(p[i]));
  }
  for (const Vec3d& p : points) {
    const int e = result.exponent;
    result.positions.push_back({scaled(p.x, e), scaled(p.y, e), scaled(p.z, e)});
  }
  return result;
}

[[nodiscard]] inline Sign sign_of_integer(const Integer& x) { return sign_of(x.sign()); }

[[nodiscard]] inline Position minus(const Position& a, const Position& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

[[nodiscard]] inline Integer dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

[[nodiscard]] inline Position cross(const Position& a, const Position& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The normal is zero for points on one line.
[[nodiscard]] inline Plane plane(const Position& a, const Position& b, const Position& c) {
  const Position normal = cross(minus(b, a), minus(c, a));
  return {normal, dot(normal, a)};
}

[[nodiscard]] inline bool is_zero(const Position& p) { return p[0].is_zero() && p[1].is_zero() && p[2].is_zero(); }

/// w is zero when there is no such point, or more than one.
[[nodiscard]] inline Point line_plane(const Position& p, const Position& q, const Plane& plane) {
  const Integer p_height = dot(plane.normal, p) - plane.offset, q_height = dot(plane.normal, q) - plane.offset;
  Point result;
  for (std::size_t i = 0; i < 3; ++i) result.x[i] = p[i] * q_height - q[i] * p_height;
  result.w = q_height - p_height;
  return result;
}

/// Lines (p, q) and (r, s) of one plane, by the line equations of their projections; w is zero when these are parallel.
[[nodiscard]] inline Point line_line(const std::array<Position, 4>& points, std::size_t u, std::size_t v) {
  const auto& [p, q, r, s] = points;
  const Integer a1 = p[v] - q[v], b1 = q[u] - p[u], c1 = a1 * p[u] + b1 * p[v];
  const Integer a2 = r[v] - s[v], b2 = s[u] - r[u], c2 = a2 * r[u] + b2 * r[v];
  const std::size_t k = 3 - u - v;
  const Integer det = a1 * b2 - a2 * b1;
  const std::size_t along = b1.is_zero() ? v : u;  // a coordinate that changes along the first line
  const Integer met = along == u ? Integer(c1 * b2 - c2 * b1) : Integer(a1 * c2 - a2 * c1);
  const Integer run = q[along] - p[along];
  Point result;
  result.w = det * run;
  result.x[u] = (c1 * b2 - c2 * b1) * run;
  result.x[v] = (a1 * c2 - a2 * c1) * run;
  result.x[k] = p[k] * result.w + (met - p[along] * det) * (q[k] - p[k]);
  return result;
}

[[nodiscard]] inline Point three_planes(const Plane& p, const Plane& q, const Plane& r) {
  const Position qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal), pq = cross(p.normal, q.normal);
  Point result;
  for (std::size_t i = 0; i < 3; ++i) result.x[i] = p.offset * qr[i] + q.offset * rp[i] + r.offset * pq[i];
  result.w = dot(p.normal, qr);
  return result;
}

[[nodiscard]] inline Sign orient3d(const Position& a, const Position& b, const Position& c, const Position& d) {
  const Plane p = plane(a, b, c);
  return sign_of_integer(dot(p.normal, d) - p.offset);
}

[[nodiscard]] inline Sign side_of_plane(const Plane& plane, const Point& p) {
  return sign_of_integer(dot(plane.normal, p.x) - plane.offset * p.w) * sign_of_integer(p.w);
}

/// Orientation in the coordinates (u, v).
[[nodiscard]] inline Sign orient2d(const Point& a, const Point& b, const Point& c, std::size_t u, std::size_t v) {
  const Integer determinant =
      a.x[u] * (b.x[v] * c.w - c.x[v] * b.w) - a.x[v] * (b.x[u] * c.w - c.x[u] * b.w) + a.w * (b.x[u] * c.x[v] - c.x[u] * b.x[v]);
  return sign_of_integer(determinant) * sign_of_integer(a.w) * sign_of_integer(b.w) * sign_of_integer(c.w);
}

/// Sign of a[coordinate] - b[coordinate].
[[nodiscard]] inline Sign compare(const Point& a, const Point& b, std::size_t coordinate) {
  return sign_of_integer(a.x[coordinate] * b.w - b.x[coordinate] * a.w) * sign_of_integer(a.w) * sign_of_integer(b.w);
}

[[nodiscard]] inline bool are_equal(const Point& a, const Point& b) {
  return compare(a, b, 0) == Sign::Zero && compare(a, b, 1) == Sign::Zero && compare(a, b, 2) == Sign::Zero;
}

/// The nearest double of numerator / denominator * 2^exponent, ties to even, by long division; inf when it does not fit.
[[nodiscard]] inline double nearest(Integer numerator, Integer denominator, int exponent) {
  if (numerator.is_zero()) return 0;
  const bool is_negative = (numerator.sign() < 0) != (denominator.sign() < 0);
  numerator = abs(numerator);
  denominator = abs(denominator);
  const auto shifted = [](const Integer& x, int shift) { return shift > 0 ? Integer(x << static_cast<unsigned>(shift)) : x; };
  int size = static_cast<int>(msb(numerator)) - static_cast<int>(msb(denominator));
  if (shifted(numerator, -size) < shifted(denominator, size)) --size;  // now 2^size <= quotient < 2^(size + 1)
  const int last = std::max(size + exponent - 52, -1074);              // exponent of the last bit of the result
  const Integer divisor = shifted(denominator, last - exponent);
  Integer quotient, rest;
  divide_qr(shifted(numerator, exponent - last), divisor, quotient, rest);
  rest *= 2;
  if (rest > divisor || (rest == divisor && bit_test(quotient, 0))) ++quotient;
  if (quotient.is_zero()) return 0;
  if (static_cast<int>(msb(quotient)) + last > 1023) return is_negative ? -HUGE_VAL : HUGE_VAL;
  const double size_of_result = std::ldexp(quotient.convert_to<double>(), last);
  return is_negative ? -size_of_result : size_of_result;
}

}  // namespace mortise::oracle
