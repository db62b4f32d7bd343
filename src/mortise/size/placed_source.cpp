// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/placed_source.h"

#include <algorithm>
#include <cmath>

namespace mortise {
namespace {

constexpr double thinnest = 1e-6;

// Values at the corners, then in the middles of edges 01, 12, 20 of a triangle, whatever the order.
std::array<double, 6> nodal_values(const SizeSource& source) {
  const std::array<double, 6>& s = source.strengths;
  if (source.order == StrengthOrder::Constant) return {s[0], s[0], s[0], s[0], s[0], s[0]};
  if (source.order == StrengthOrder::Quadratic) return s;
  return {s[0], s[1], s[2], (s[0] + s[1]) / 2, (s[1] + s[2]) / 2, (s[2] + s[0]) / 2};
}

// A quadratic over the triangle (0,0), (1,0), (0,1): q0 + q1 u + q2 v + q3 uu + q4 uv + q5 vv.
using Quadratic = std::array<double, 6>;

Quadratic through_nodes(const std::array<double, 6>& s) {
  return {s[0],
          4 * s[3] - 3 * s[0] - s[1],
          4 * s[5] - 3 * s[0] - s[2],
          2 * s[0] + 2 * s[1] - 4 * s[3],
          4 * (s[0] + s[4] - s[3] - s[5]),
          2 * s[0] + 2 * s[2] - 4 * s[5]};
}

// Least value of a + b t + c tt for t in 0 .. 1.
double least_between(double a, double b, double c) {
  const double ends = std::min(a, a + b + c);
  if (!(c > 0) || !(b < 0) || !(-b < 2 * c)) return ends;
  return std::min(ends, a - b * b / (4 * c));
}

double least_on_triangle(const Quadratic& q) {
  double least = std::min(least_between(q[0], q[1], q[3]), least_between(q[0], q[2], q[5]));
  least = std::min(least, least_between(q[0] + q[1] + q[3], q[2] - q[1] - 2 * q[3] + q[4], q[3] - q[4] + q[5]));
  const double determinant = 4 * q[3] * q[5] - q[4] * q[4];
  if (!(determinant > 0)) return least;
  const double u = (q[4] * q[2] - 2 * q[5] * q[1]) / determinant, v = (q[4] * q[1] - 2 * q[3] * q[2]) / determinant;
  if (!(u > 0 && v > 0 && u + v < 1)) return least;
  return std::min(least, q[0] + (q[1] * u + q[2] * v) / 2);
}

void vary_along_segment(const SizeSource& source, PlacedSource& placed) {
  const std::array<double, 6>& s = source.strengths;
  const double middle = source.order == StrengthOrder::Quadratic ? s[2] : (s[0] + s[1]) / 2, size = placed.shape.length;
  if (!(size > 0)) return;
  const double b = 4 * middle - 3 * s[0] - s[1], c = 2 * s[0] + 2 * s[1] - 4 * middle;
  placed.polynomial = {s[0], b / size, 0, c / size / size, 0, 0};
  placed.least = least_between(s[0], b, c);
  placed.steepest = std::max(std::fabs(b), std::fabs(b + 2 * c)) / size;
}

// With x = length u + apex_x v, y = apex_y v.
std::array<double, 6> in_axes(const Quadratic& q, const PlacedTriangle& t) {
  const double ux = 1 / t.length, vy = 1 / t.apex_y, uy = -t.apex_x / (t.length * t.apex_y);
  return {q[0],
          q[1] * ux,
          q[1] * uy + q[2] * vy,
          q[3] * ux * ux,
          2 * q[3] * ux * uy + q[4] * ux * vy,
          q[3] * uy * uy + q[4] * uy * vy + q[5] * vy * vy};
}

double steepness(const std::array<double, 6>& p, double x, double y) {
  return std::sqrt((p[1] + 2 * p[3] * x + p[4] * y) * (p[1] + 2 * p[3] * x + p[4] * y) +
                   (p[2] + p[4] * x + 2 * p[5] * y) * (p[2] + p[4] * x + 2 * p[5] * y));
}

void vary_over_triangle(const SizeSource& source, PlacedSource& placed) {
  const PlacedTriangle& t = placed.shape;
  if (!(t.apex_y > 0)) return;
  const std::size_t first = t.first, second = (first + 1) % 3, third = (first + 2) % 3;
  const std::array<double, 6> s = nodal_values(source);
  const Quadratic q = through_nodes({s[first], s[second], s[third], s[3 + first], s[3 + second], s[3 + third]});
  placed.polynomial = in_axes(q, t);
  placed.least = least_on_triangle(q);
  placed.steepest = std::max(
      {steepness(placed.polynomial, 0, 0), steepness(placed.polynomial, t.length, 0), steepness(placed.polynomial, t.apex_x, t.apex_y)});
}

double strength_at(const PlacedSource& s, const PlanePoint& p) {
  const std::array<double, 6>& c = s.polynomial;
  const double value = c[0] + p.x * (c[1] + c[3] * p.x + c[4] * p.y) + p.y * (c[2] + c[5] * p.y);
  return std::max(value, s.least);
}

}  // namespace

PlacedSource place_source(const SizeSource& source) {
  PlacedSource placed;
  placed.shape = place_triangle(source.corners, source.corner_count);
  placed.polynomial[0] = source.strengths[0];
  placed.is_constant = source.order == StrengthOrder::Constant || source.corner_count == 1;
  placed.least = source.strengths[0];
  placed.radius = source.radius;
  placed.rate = source.growth - 1;
  if (!placed.is_constant && source.corner_count == 2) vary_along_segment(source, placed);
  if (!placed.is_constant && source.corner_count == 3) vary_over_triangle(source, placed);
  return placed;
}

bool is_too_thin_to_vary(const PlacedSource& source) {
  return !source.is_constant && source.shape.corner_count == 3 && !(source.shape.apex_y > thinnest * source.shape.length);
}

double size_from(const PlacedSource& source, const Vec3d& p) {
  const PlanePoint closest = closest_in(source.shape, p).at;
  const Vec3d away = p - source.shape.origin - closest.x * source.shape.axis_x - closest.y * source.shape.axis_y;
  const double outside = std::sqrt(dot(away, away)) - source.radius;
  const double distance = outside <= 0 ? 0 : outside;  // NaN stays
  return (source.is_constant ? source.least : strength_at(source, closest)) + source.rate * distance;
}

double slope_of(const PlacedSource& source) { return std::sqrt(source.steepest * source.steepest + source.rate * source.rate); }

}  // namespace mortise
