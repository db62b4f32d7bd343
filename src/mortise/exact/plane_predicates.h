// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact answers about planes given by a normal and an offset. Finite doubles of any range.
#pragma once

#include "mortise/exact/sign.h"
#include "mortise/geom/plane.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Sign of normal . p - offset: Positive in front of the plane.
[[nodiscard]] Sign side_of(const Plane& plane, const Vec3d& p);

/// The nearest double (ties to even, never -0) of each coordinate of the point where the line through a and b, on different
/// sides, meets the plane.
/// @throws Error{OutOfRange} if a coordinate does not fit a double
[[nodiscard]] Vec3d nearest_crossing(const Plane& plane, const Vec3d& a, const Vec3d& b);

}  // namespace mortise
