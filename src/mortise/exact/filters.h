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
  const double size = std::fabs(value);
  if (size > bound && size > 0x1p-900) return sign_of(value);
  return std::nullopt;
}

/// Two coordinates of a point and their sizes.
struct NearCoordinates {
  double u, v, u_size, v_size;
};

/// Error: 1 unit of 2^-53 for each difference (its size includes those of uncertain points), 3 for each product, 4 for the
/// value; the bound takes 8 of the computed size, which itself is short by at most one part in 2^50.
[[nodiscard]] inline std::optional<Sign> orient2d(const NearCoordinates& a, const NearCoordinates& b, const NearCoordinates& c) {
  const double bu = b.u - a.u, bv = b.v - a.v, cu = c.u - a.u, cv = c.v - a.v;
  const double bu_size = std::fabs(bu) + (a.u_size + b.u_size), bv_size = std::fabs(bv) + (a.v_size + b.v_size);
  const double cu_size = std::fabs(cu) + (a.u_size + c.u_size), cv_size = std::fabs(cv) + (a.v_size + c.v_size);
  return beyond(bu * cv - bv * cu, 0x1p-50 * (bu_size * cv_size + bv_size * cu_size));
}

/// As above for exact points (u, v): their differences alone set the size.
[[nodiscard]] inline std::optional<Sign> orient2d_of_coordinates(const std::array<double, 2>& a, const std::array<double, 2>& b,
                                                                 const std::array<double, 2>& c) {
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  return beyond(left - right, 0x1p-50 * (std::fabs(left) + std::fabs(right)));
}

[[nodiscard]] inline std::optional<Sign> orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  switch (axis) {  // not an index: each case reads its coordinates directly
    case Axis::X:
      return orient2d_of_coordinates({a.y, a.z}, {b.y, b.z}, {c.y, c.z});
    case Axis::Y:
      return orient2d_of_coordinates({a.z, a.x}, {b.z, b.x}, {c.z, c.x});
    default:
      return orient2d_of_coordinates({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
  }
}

/// The plane (a, b, c) of input points. Error of a side: 4 units of 2^-53 for each component of the normal, 6 for the
/// products, 8 for the value; the bound takes 16. A product in the normal that underflows loses less than 2^-1074, which
/// the smallest normal double added to its size covers.
class Plane {
 public:
  Plane(const Vec3d& a, const Vec3d& b, const Vec3d& c) : origin_(a) {
    constexpr double underflow = std::numeric_limits<double>::min();
    const Vec3d p = b - a, q = c - a;
    const double yz = p.y * q.z, zy = p.z * q.y, zx = p.z * q.x, xz = p.x * q.z, xy = p.x * q.y, yx = p.y * q.x;
    normal_ = {yz - zy, zx - xz, xy - yx};
    size_ = {std::fabs(yz) + std::fabs(zy) + underflow, std::fabs(zx) + std::fabs(xz) + underflow,
             std::fabs(xy) + std::fabs(yx) + underflow};
  }

  /// orient3d(a, b, c, d).
  [[nodiscard]] std::optional<Sign> side_of(const NearPoint& d) const {
    const Vec3d r = d.point - origin_;
    const double x_size = size_.x * (std::fabs(r.x) + d.size.x);
    const double y_size = size_.y * (std::fabs(r.y) + d.size.y);
    const double z_size = size_.z * (std::fabs(r.z) + d.size.z);
    return beyond(normal_.x * r.x + normal_.y * r.y + normal_.z * r.z, 0x1p-49 * (x_size + y_size + z_size));
  }

 private:
  Vec3d origin_, normal_, size_;
};

[[nodiscard]] inline std::optional<Sign> orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const NearPoint& d) {
  return Plane(a, b, c).side_of(d);
}

}  // namespace mortise::filters
