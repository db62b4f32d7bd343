// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The ladder of the predicates over input points: filter, equal coordinates, exact.
#include "mortise/exact/predicates.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mortise/exact/big_float.h"
#include "mortise/exact/equal_coordinates.h"
#include "mortise/exact/expansion.h"
#include "mortise/exact/filters.h"
#include "mortise/exact/formulas.h"

namespace mortise {

namespace {

Answer orient2d_beyond_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  if (const auto sign = orient2d_of_equal_coordinates(a, b, c, axis)) return {*sign, Rung::Construction};
  if (is_in_expansion_range({a, b, c})) return {orient2d_value<Expansion<2>>(a, b, c, axis).sign(), Rung::Expansion};
  return {orient2d_value<BigFloat>(a, b, c, axis).sign(), Rung::BigFloat};
}

Answer orient3d_beyond_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  if (d == a || d == b || d == c) return {Sign::Zero, Rung::Construction};
  if (const auto flat = find_axis_triangle(a, b, c, d)) {
    if (flat->side == Sign::Zero) return {Sign::Zero, Rung::Construction};
    const Answer answer = explain_orient2d(*flat->corners[0], *flat->corners[1], *flat->corners[2], flat->axis);
    return {flat->side * answer.sign, answer.rung};
  }
  if (is_in_expansion_range({a, b, c, d})) return {orient3d_value<Expansion<2>>(a, b, c, d).sign(), Rung::Expansion};
  return {orient3d_value<BigFloat>(a, b, c, d).sign(), Rung::BigFloat};
}

}  // namespace

Answer explain_orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto sign = filters::orient3d(a, b, c, {d, {}});
  return sign ? Answer{*sign, Rung::Filter} : orient3d_beyond_filter(a, b, c, d);
}

Answer explain_orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  const auto sign = filters::orient2d(a, b, c, axis);
  return sign ? Answer{*sign, Rung::Filter} : orient2d_beyond_filter(a, b, c, axis);
}

Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto sign = filters::orient3d(a, b, c, {d, {}});
  return sign ? *sign : orient3d_beyond_filter(a, b, c, d).sign;
}

Sign orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  const auto sign = filters::orient2d(a, b, c, axis);
  return sign ? *sign : orient2d_beyond_filter(a, b, c, axis).sign;
}

bool are_collinear(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return orient2d(a, b, c, Axis::Z) == Sign::Zero && orient2d(a, b, c, Axis::X) == Sign::Zero && orient2d(a, b, c, Axis::Y) == Sign::Zero;
}

std::optional<Axis> projection_axis(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d n = cross(b - a, c - a);
  std::array<double, 3> size{};
  for (std::size_t i = 0; i < 3; ++i) size[i] = std::fabs(n[i]) >= 0 ? std::fabs(n[i]) : std::numeric_limits<double>::infinity();
  std::array<Axis, 3> axes{Axis::X, Axis::Y, Axis::Z};
  const auto prefer = [&](std::size_t i, std::size_t j) {
    if (size[static_cast<std::size_t>(axes[j])] > size[static_cast<std::size_t>(axes[i])]) std::swap(axes[i], axes[j]);
  };
  prefer(0, 1);
  prefer(0, 2);
  prefer(1, 2);
  for (const Axis axis : axes) {
    if (orient2d(a, b, c, axis) != Sign::Zero) return axis;
  }
  return std::nullopt;
}

}  // namespace mortise
