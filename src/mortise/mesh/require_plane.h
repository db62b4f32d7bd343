// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Refuses planes that are none.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "mortise/base/error.h"
#include "mortise/geom/plane.h"

namespace mortise {

/// @throws Error{InvalidArgument} in this stage when a number is not finite or there is no normal
inline void require_plane(const Plane& plane, std::string_view stage) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Vec3d& n = plane.normal;
  const bool is_finite =
      std::fabs(n.x) <= largest && std::fabs(n.y) <= largest && std::fabs(n.z) <= largest && std::fabs(plane.offset) <= largest;
  if (is_finite && n != Vec3d{}) return;
  throw Error(ErrorCode::InvalidArgument, stage, "a plane has four finite numbers and a normal that is not zero");
}

}  // namespace mortise
