// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The nearest double of each coordinate of a made point, and how far the point is from it.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "mortise/exact/big_float.h"
#include "mortise/exact/construction.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/formulas.h"
#include "mortise/exact/sign.h"

namespace mortise {

/// nearest: correctly rounded, ties to even, never -0. rest: the coordinate minus `nearest`, within `error`; both 0 when
/// there is none. side: sign of the rest, exact.
struct RoundedCoordinate {
  double nearest = 0;
  double rest = 0;
  double error = 0;
  Sign side = Sign::Zero;

  [[nodiscard]] DoubleDouble value() const { return {nearest, rest, error}; }
};

/// base + offset / w for the construction's `points` (base: points[0]), w of any sign.
template <class T>
[[nodiscard]] Homogeneous<T> homogeneous_point(const Construction& construction, const std::array<Vec3d, 9>& points) {
  switch (construction.kind) {
    case Construction::Kind::LinePlane:
      return line_plane_point<T>(points);
    case Construction::Kind::LineLine:
      return line_line_point<T>(points, construction.axis);
    default:
      return three_plane_point<T>(points);
  }
}

/// The exact coordinates of a made point, w > 0.
/// @throws Error{InternalError} if the construction has no point (w = 0)
[[nodiscard]] Homogeneous<BigFloat> exact_point(const Construction& construction, const std::array<Vec3d, 9>& points);

/// A made point in doubles, and exactly where double-double was not enough to round it.
struct RoundedPoint {
  std::array<RoundedCoordinate, 3> coordinates;
  std::unique_ptr<const Homogeneous<BigFloat>> exact;
};

/// @throws Error{OutOfRange} if a coordinate does not fit a double; Error{InternalError} as exact_point
[[nodiscard]] RoundedPoint round_point(const Construction& construction, const std::array<Vec3d, 9>& points);

/// The nearest doubles of base + offset / w, w of any sign but not zero.
/// @throws Error{OutOfRange} if a coordinate does not fit a double
[[nodiscard]] Vec3d round_homogeneous(const Vec3d& base, Homogeneous<BigFloat> point);

/// The double nearest to base + offset, ties to even; nothing where the bounds of the offset leave a doubt.
[[nodiscard]] std::optional<double> nearest_sum(double base, const DoubleDouble& offset);

/// The double nearest to base + offset / w, w > 0, ties to even, never -0.
/// @throws Error{OutOfRange} if it does not fit a double
[[nodiscard]] double nearest_sum(double base, const BigFloat& offset, const BigFloat& w);

}  // namespace mortise
