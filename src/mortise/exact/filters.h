// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Semi-static filters: the determinants of orient2d and orient3d in plain doubles, with the error bound that follows from
// the size of their terms.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "mortise/exact/formulas.h"
#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise::filters {

/// A point in doubles and, per coordinate, a size with |point - true point| <= 2^-53 size (0: the point is exact).
struct NearPoint {
  Vec3d point;
  Vec3d size;
};

/// sign_of(value) when |value| exceeds its error bound and is far from underflow. An overflow makes the bound inf or NaN.
[[nodiscard]] inline std::optional<Sign> beyond(double value, double bound) {
  if (value > bound && value > 0x1p-900) return Sign::Positive;
  if (-value > bound && -value > 0x1p-900) return Sign::Negative;
  return std::nullopt;
}

/// Error: 1 unit of 2^-53 for each difference (its size includes those of uncertain points), 3 for each product, 4 for the
/// value; the bound takes 8 of the computed size, which itself is short by at most one part in 2^50.
[[nodiscard]] inline std::optional<Sign> orient2d(const NearPoint& a, const NearPoint& b, const NearPoint& c, Axis axis) {
  const auto [u, v] = kept_coordinates(axis);
  const double bu = b.point[u] - a.point[u], bv = b.point[v] - a.point[v];
  const double cu = c.point[u] - a.point[u], cv = c.point[v] - a.point[v];
  const double bu_size = std::fabs(bu) + (a.size[u] + b.size[u]), bv_size = std::fabs(bv) + (a.size[v] + b.size[v]);
  const double cu_size = std::fabs(cu) + (a.size[u] + c.size[u]), cv_size = std::fabs(cv) + (a.size[v] + c.size[v]);
  return beyond(bu * cv - bv * cu, 0x1p-50 * (bu_size * cv_size + bv_size * cu_size));
}

/// As above for input points: their differences alone set the size.
[[nodiscard]] inline std::optional<Sign> orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  const auto [u, v] = kept_coordinates(axis);
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  return beyond(left - right, 0x1p-50 * (std::fabs(left) + std::fabs(right)));
}

/// Side of the plane (a, b, c) of input points. Error: 4 units of 2^-53 for each component of the normal, 6 for the
/// products, 8 for the value; the bound takes 16. A product in the normal that underflows loses less than 2^-1074, which
/// the smallest normal double added to its size covers.
[[nodiscard]] inline std::optional<Sign> orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const NearPoint& d) {
  constexpr double underflow = std::numeric_limits<double>::min();
  const Vec3d p = b - a, q = c - a, r = d.point - a;
  const double yz = p.y * q.z, zy = p.z * q.y, zx = p.z * q.x, xz = p.x * q.z, xy = p.x * q.y, yx = p.y * q.x;
  const double x_size = (std::fabs(yz) + std::fabs(zy) + underflow) * (std::fabs(r.x) + d.size.x);
  const double y_size = (std::fabs(zx) + std::fabs(xz) + underflow) * (std::fabs(r.y) + d.size.y);
  const double z_size = (std::fabs(xy) + std::fabs(yx) + underflow) * (std::fabs(r.z) + d.size.z);
  return beyond((yz - zy) * r.x + (zx - xz) * r.y + (xy - yx) * r.z, 0x1p-49 * (x_size + y_size + z_size));
}

}  // namespace mortise::filters
