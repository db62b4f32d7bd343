// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How good a triangle is.
#pragma once

#include <algorithm>
#include <cmath>

#include "mortise/geom/vec.h"

namespace mortise {

inline constexpr double flat_mean_ratio = 1e-9;  ///< a triangle of a lower one must not be made: which way it faces is chance
inline constexpr double cosine_of_most_turn = 0.3420201433256687;  ///< 70 degrees between a triangle and the one it replaces or lies on

/// Twice the area, along the normal.
[[nodiscard]] inline Vec3d area_vector(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a); }

/// 1 for an equilateral triangle, 0 for one without area: 4 sqrt(3) area over the sum of the squares of the edges.
[[nodiscard]] inline double mean_ratio(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, bc = c - b, ca = a - c, n = cross(ab, ca);
  const double squares = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  return squares > 0 ? 3.4641016151377544 * std::sqrt(dot(n, n)) / squares : 0;
}

/// Of two vectors by their product and that of their squares; 1 where one has no length.
[[nodiscard]] inline double cosine_between(double product, double squares) { return squares > 0 ? product / std::sqrt(squares) : 1; }

/// Cosine of the angle at a; 1 where an edge has no length.
[[nodiscard]] inline double cosine_at(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, ac = c - a;
  return cosine_between(dot(ab, ac), dot(ab, ab) * dot(ac, ac));
}

/// Cosine of the largest angle: the one opposite to the longest edge.
[[nodiscard]] inline double least_cosine(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, bc = c - b, ca = a - c;
  const double square_ab = dot(ab, ab), square_bc = dot(bc, bc), square_ca = dot(ca, ca);
  if (square_bc >= square_ab && square_bc >= square_ca) return cosine_between(-dot(ab, ca), square_ab * square_ca);
  return square_ca >= square_ab ? cosine_between(-dot(ab, bc), square_ab * square_bc) : cosine_between(-dot(bc, ca), square_bc * square_ca);
}

/// Cosine of the smallest angle.
[[nodiscard]] inline double greatest_cosine(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return std::max({cosine_at(a, b, c), cosine_at(b, c, a), cosine_at(c, a, b)});
}

/// Is the angle between two vectors smaller than the one of this cosine, and neither of them zero?
[[nodiscard]] inline bool is_within_angle(const Vec3d& u, const Vec3d& v, double cosine) {
  const double d = dot(u, v), squares = dot(u, u) * dot(v, v);
  return cosine >= 0 ? d > 0 && d * d > cosine * cosine * squares : d > 0 || d * d < cosine * cosine * squares;
}

}  // namespace mortise
