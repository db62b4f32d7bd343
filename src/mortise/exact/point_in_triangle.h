// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where a point lies in a triangle, exactly: what is linear on the triangle is interpolated there and rounded once.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "mortise/exact/big_float.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/point_set.h"

namespace mortise {

/// A point in the plane of a triangle by its barycentric coordinates. A point off the plane counts where it is seen along the
/// axis of the triangle's projection_axis(), off the triangle too.
class PointInTriangle {
 public:
  /// @param triangle  has area, unless the point is one of its corners; both must stay as long as this is used
  PointInTriangle(const PointSet& points, const PlanePoints& triangle, PointId p);

  /// The value at the point of the linear function with these values at the corners, finite or NaN.
  ///
  /// At a corner its bits; else the nearest double (ties to even) of the exact value, never -0 where they differ, and not
  /// beyond the values at the corners. A corner that is NaN counts only if the point is not on the line of the other two; then
  /// the answer is NaN.
  [[nodiscard]] double interpolate(std::array<double, 3> values) const;

 private:
  /// The function is values[0] + (first * (values[1] - values[0]) + second * (values[2] - values[0])) / w.
  struct ExactWeights {
    BigFloat first, second, w;  ///< w > 0
  };

  [[nodiscard]] bool is_on_side_across(std::size_t corner) const;
  [[nodiscard]] const ExactWeights& exact_weights() const;
  [[nodiscard]] double interpolate_exactly(const std::array<double, 3>& values) const;

  const PointSet& points_;
  const PlanePoints& triangle_;
  PointId point_;
  std::size_t corner_;  ///< where the point is; 3 when it is none
  Axis axis_ = Axis::X;
  DoubleDouble first_, second_;  ///< weights of the second and the third corner
  mutable std::unique_ptr<const ExactWeights> exact_;
};

}  // namespace mortise
