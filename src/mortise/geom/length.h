// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lengths and heights in doubles that neither overflow nor vanish on the way.
#pragma once

#include <algorithm>
#include <cmath>

#include "mortise/geom/vec.h"

namespace mortise {

/// Euclidean length to a few units in the last place.
[[nodiscard]] inline double length(const Vec3d& v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(largest > 0)) return 0;
  const Vec3d unit{v.x / largest, v.y / largest, v.z / largest};
  return largest * std::sqrt(dot(unit, unit));
}

/// Height of the apex over the line a - b; a and b differ.
[[nodiscard]] inline double height_over(const Vec3d& a, const Vec3d& b, const Vec3d& apex) {
  const Vec3d along = b - a;
  const double size = length(along);
  return length(cross({along.x / size, along.y / size, along.z / size}, apex - a));
}

}  // namespace mortise
