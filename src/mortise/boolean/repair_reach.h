// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the repairs of a rounded result share: how far they may move its surface, and what they must not forget.
#pragma once

#include <algorithm>
#include <cmath>

#include "mortise/boolean/merge.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// 2^-46 of the largest coordinate of the point: 128 times what rounding may have moved it. Local, so that a scene may span
/// any range: detail near the origin is not measured by what lies far out.
[[nodiscard]] inline double repair_reach(const Vec3d& p) {
  constexpr double finest_grid = 0x1p-46;
  return finest_grid * std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

/// Keeps the facets of the exact surface, before the first repair drops one.
inline void note_facets_before_repair(MergedMesh& merged) {
  if (merged.facets_before_repair.empty()) merged.facets_before_repair = merged.facet_of_triangle;
}

}  // namespace mortise
