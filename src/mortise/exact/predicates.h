// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact signs over input coordinates. Finite doubles of any range; no tolerance.
#pragma once

#include <optional>

#include "mortise/exact/rung.h"
#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// On which side of the plane (a, b, c) is d? Sign of ((b - a) x (c - a)) . (d - a): Positive where the normal of the
/// counterclockwise triangle points to.
[[nodiscard]] Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);

/// Orientation of the triangle (a, b, c) projected along `axis`; it is also the sign of that component of its normal.
[[nodiscard]] Sign orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis);

/// Do the three points lie on one line (or fewer)?
[[nodiscard]] bool are_collinear(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// An axis along which the triangle projects to positive area, the most favourable one in doubles when that is certain;
/// nothing when the triangle has no area.
[[nodiscard]] std::optional<Axis> projection_axis(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// orient3d and orient2d, and the rung that answered.
[[nodiscard]] Answer explain_orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);
[[nodiscard]] Answer explain_orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis);

}  // namespace mortise
