// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An order of points that does not depend on how they are numbered.
#pragma once

#include "mortise/geom/vec.h"

namespace mortise {

/// By x, then y, then z.
[[nodiscard]] inline bool is_lexicographically_less(const Vec3d& a, const Vec3d& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace mortise
