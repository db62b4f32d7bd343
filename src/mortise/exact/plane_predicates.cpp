// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Double-double where it is certain, else exact.
#include "mortise/exact/plane_predicates.h"

#include "mortise/exact/big_float.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/formulas.h"
#include "mortise/exact/rounding.h"

namespace mortise {
namespace {

template <class T>
Triple<T> triple_of(const Vec3d& p) {
  return difference<T>(p, Vec3d{});
}

/// normal . p - offset.
template <class T>
T height_of(const Plane& plane, const Vec3d& p) {
  return dot(triple_of<T>(plane.normal), triple_of<T>(p)) - T::difference(plane.offset, 0);
}

}  // namespace

Sign side_of(const Plane& plane, const Vec3d& p) {
  if (const auto sign = certain_sign(height_of<DoubleDouble>(plane, p))) return *sign;
  return height_of<BigFloat>(plane, p).sign();
}

Vec3d nearest_crossing(const Plane& plane, const Vec3d& a, const Vec3d& b) {
  const Triple<BigFloat> direction = difference<BigFloat>(b, a);
  const BigFloat height = height_of<BigFloat>(plane, a);
  return round_homogeneous(a, {scaled(height, direction), -dot(triple_of<BigFloat>(plane.normal), direction)});
}

}  // namespace mortise
