// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact winding by a ray towards -x from a point next to a corner of a triangle; no case is degenerate.
#pragma once

#include "mortise/geom/vec.h"

namespace mortise {

/// A point inside the triangle (at, towards, beyond), as close to `at` as one likes, and of all those closer to the edge
/// at - towards than one likes; then moved by a still smaller (epsilon, epsilon^2) in (y, z).
struct RayStart {
  Vec3d at, towards, beyond;
};

/// How much the winding of a surface grows across its triangle (a, b, c) on the way from -x infinity to the start.
/// Add it over all triangles whose box meets ray_box. The start lies on none of them.
[[nodiscard]] int winding_step(const Vec3d& a, const Vec3d& b, const Vec3d& c, const RayStart& start);

/// The box of the ray.
[[nodiscard]] Box3 ray_box(const RayStart& start);

}  // namespace mortise
