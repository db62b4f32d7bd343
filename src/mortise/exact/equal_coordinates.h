// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Determinants that equal coordinates reduce to comparisons: the exact zeros of axis-aligned models, without arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "mortise/exact/formulas.h"
#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Sign of a - b, without the difference.
[[nodiscard]] constexpr Sign compare(double a, double b) { return sign_of(static_cast<int>(a > b) - static_cast<int>(a < b)); }

/// orient2d of points 0, 1, 2 when two of them share a coordinate; nothing when none do or a comparison is not certain.
///
/// @param compare  (i, j, coordinate) -> the sign of point i minus point j in this coordinate: a Sign, or an optional one
template <class Compare>
[[nodiscard]] inline std::optional<Sign> orient2d_of_equal_coordinates(Axis axis, const Compare& compare) {
  const auto [u, v] = kept_coordinates(axis);
  constexpr std::array<std::array<std::size_t, 3>, 3> turns{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};
  for (const auto& [i, j, k] : turns) {
    const bool share_u = compare(i, j, u) == Sign::Zero;
    if (!share_u && compare(i, j, v) != Sign::Zero) continue;
    const std::optional<Sign> along = share_u ? compare(i, j, v) : compare(j, i, u);
    const std::optional<Sign> across = compare(k, i, share_u ? u : v);
    return along && across ? std::optional<Sign>(*along * *across) : std::nullopt;
  }
  return std::nullopt;
}

/// The same for input points.
[[nodiscard]] inline std::optional<Sign> orient2d_of_equal_coordinates(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  const std::array<const Vec3d*, 3> p{&a, &b, &c};
  return orient2d_of_equal_coordinates(
      axis, [&](std::size_t i, std::size_t j, std::size_t coordinate) { return compare((*p[i])[coordinate], (*p[j])[coordinate]); });
}

/// A triangle across an axis, and a point beside it.
struct AxisTriangle {
  std::array<const Vec3d*, 3> corners;
  Axis axis;
  Sign side;  ///< of the fourth point, along the axis; turned over when the order of the four points was odd
};

/// Three of the points a, b, c, d that share a coordinate: orient3d is `side` times their orientation along `axis`.
[[nodiscard]] inline std::optional<AxisTriangle> find_axis_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Axis>(i);
    if (a[i] == b[i] && a[i] == c[i]) return AxisTriangle{{&a, &b, &c}, axis, compare(d[i], a[i])};
    if (a[i] == b[i] && a[i] == d[i]) return AxisTriangle{{&a, &b, &d}, axis, -compare(c[i], a[i])};
    if (a[i] == c[i] && a[i] == d[i]) return AxisTriangle{{&a, &c, &d}, axis, compare(b[i], a[i])};
    if (b[i] == c[i] && b[i] == d[i]) return AxisTriangle{{&b, &c, &d}, axis, -compare(a[i], b[i])};
  }
  return std::nullopt;
}

}  // namespace mortise
