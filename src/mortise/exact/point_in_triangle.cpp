// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Barycentric coordinates as quotients of determinants: in double-double with bounds, exactly where these leave a doubt.
#include "mortise/exact/point_in_triangle.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/exact/formulas.h"
#include "mortise/exact/predicates.h"
#include "mortise/exact/rounding.h"

namespace mortise {
namespace {

template <class T>
struct Weights {
  T first, second, w;
};

/// Cramer's rule in the projection: how much of the second and of the third corner is in `offset`, a point less the first one.
template <class T>
Weights<T> weights_of(const std::array<T, 3>& offset, const std::array<Vec3d, 3>& corners, Axis axis) {
  const auto [u, v] = kept_coordinates(axis);
  const Triple<T> b = difference<T>(corners[1], corners[0]);
  const Triple<T> c = difference<T>(corners[2], corners[0]);
  return {determinant(offset[u], offset[v], c[u], c[v]), determinant(b[u], b[v], offset[u], offset[v]),
          determinant(b[u], b[v], c[u], c[v])};
}

std::array<Vec3d, 3> positions(const PointSet& points, const PlanePoints& triangle) {
  return {points.nearest(triangle[0]), points.nearest(triangle[1]), points.nearest(triangle[2])};
}

bool is_nan(double x) { return x != x; }

}  // namespace

PointInTriangle::PointInTriangle(const PointSet& points, const PlanePoints& triangle, PointId p)
    : points_(points),
      triangle_(triangle),
      point_(p),
      corner_(static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), p) - triangle.begin())) {
  if (corner_ < 3) return;
  const std::array<Vec3d, 3> corners = positions(points, triangle);
  const std::optional<Axis> axis = projection_axis(corners[0], corners[1], corners[2]);
  MORTISE_CHECK(axis, "a point in a triangle without area");
  axis_ = *axis;
  const Weights<DoubleDouble> weights = weights_of(points.near_offset(p, corners[0]), corners, axis_);
  first_ = weights.first / weights.w;
  second_ = weights.second / weights.w;
}

bool PointInTriangle::is_on_side_across(std::size_t corner) const {
  return points_.orient2d(point_, triangle_[(corner + 1) % 3], triangle_[(corner + 2) % 3], axis_) == Sign::Zero;
}

double PointInTriangle::interpolate(std::array<double, 3> values) const {
  if (corner_ < 3) return values[corner_];
  const auto are_equal = [&] { return values[0] == values[1] && values[1] == values[2]; };
  if (are_equal()) return values[0];
  // A corner of weight zero may have any value.
  for (std::size_t i = 0; i < 3; ++i) {
    const double next = values[(i + 1) % 3], last = values[(i + 2) % 3];
    if ((is_nan(values[i]) || next == last) && is_on_side_across(i)) values[i] = next;
  }
  if (are_equal()) return values[0];
  if (is_nan(values[0]) || is_nan(values[1]) || is_nan(values[2])) return std::numeric_limits<double>::quiet_NaN();
  const DoubleDouble offset =
      first_ * DoubleDouble::difference(values[1], values[0]) + second_ * DoubleDouble::difference(values[2], values[0]);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (const std::optional<double> near = nearest_sum(values[0], offset)) return std::clamp(*near, *least, *most);
  return interpolate_exactly(values);
}

const PointInTriangle::ExactWeights& PointInTriangle::exact_weights() const {
  if (exact_) return *exact_;
  const std::array<Vec3d, 3> corners = positions(points_, triangle_);
  const Homogeneous<BigFloat> p = points_.exact_offset(point_, corners[0]);
  Weights<BigFloat> weights = weights_of(p.offset, corners, axis_);
  BigFloat w = weights.w * p.w;
  if (w.sign() == Sign::Positive) {
    exact_.reset(new ExactWeights{std::move(weights.first), std::move(weights.second), std::move(w)});
  } else {
    exact_.reset(new ExactWeights{-std::move(weights.first), -std::move(weights.second), -std::move(w)});
  }
  return *exact_;
}

double PointInTriangle::interpolate_exactly(const std::array<double, 3>& values) const {
  const ExactWeights& weights = exact_weights();
  const BigFloat offset =
      weights.first * BigFloat::difference(values[1], values[0]) + weights.second * BigFloat::difference(values[2], values[0]);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if ((BigFloat::difference(*most, values[0]) * weights.w - offset).sign() != Sign::Positive) return *most;
  if ((BigFloat::difference(*least, values[0]) * weights.w - offset).sign() != Sign::Negative) return *least;
  return nearest_sum(values[0], offset, weights.w);
}

}  // namespace mortise
