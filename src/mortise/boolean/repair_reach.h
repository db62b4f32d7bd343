// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the repairs of a rounded result share: how far they may move its surface, and what they must not forget.
#pragma once

#include <algorithm>
#include <cmath>

#include "mortise/boolean/merge.h"
#include "mortise/geom/coordinates.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// How far a repair may move a point: 128 times what rounding may have moved it. Local, so that a scene may span any range: detail
/// near the origin is not measured by what lies far out.
struct RepairReach {
  double share;  ///< of the largest coordinate of the point
  double least;  ///< where coordinates are so small that their spacing does not depend on them

  [[nodiscard]] double at(const Vec3d& p) const {
    return std::max(share * std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), least);
  }
};

[[nodiscard]] inline RepairReach repair_reach(Coordinates coordinates) {
  return coordinates == Coordinates::Float32 ? RepairReach{0x1p-17, 0x1p-142} : RepairReach{0x1p-46, 0x1p-1067};
}

/// Keeps the facets of the exact surface, before the first repair drops one.
inline void note_facets_before_repair(MergedMesh& merged) {
  if (merged.facets_before_repair.empty()) merged.facets_before_repair = merged.facet_of_triangle;
}

}  // namespace mortise
