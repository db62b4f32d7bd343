// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps 9 and 10 of the paper: on which side of every operand each piece of surface lies, as windings of regions.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mortise/boolean/patches.h"
#include "mortise/boolean/running_winding.h"
#include "mortise/boolean/seeds.h"

namespace mortise {

struct Categories {
  Patches patches;
  std::vector<Seed> seeds;
  /// Operands that are not as simple as their SelfContacts says: a winding other than 0 and 1, facets out of balance or on
  /// one half-plane of an edge, or windings that differ with the way they are reached.
  /// Their crossings with themselves must be resolved (exact-core 3); empty when the categories are final.
  std::vector<OperandId> doubtful;
  std::vector<OperandId> inside_out;  ///< final operands that enclose nothing but negative winding
};

/// Windings by radial order and one seed per complex. Differs from the paper, whose walk from a single box product fails at
/// tangency, coincident faces and touching parts.
/// O(n) in the facets, plus n log n in those in contact.
[[nodiscard]] Categories categorize(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets);

/// Visits every region once with its windings; memory O(operands + patches). Order: by complex, then depth first.
void walk_regions(const OperandFaces& faces, const Facets& facets, const Categories& categories,
                  const std::function<void(RegionId, const RunningWinding&)>& visit);

}  // namespace mortise
