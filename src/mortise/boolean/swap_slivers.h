// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Repair of a result that rounding folded: a triangle without height gives its longest edge another diagonal.
#pragma once

#include <span>

#include "mortise/boolean/certify.h"
#include "mortise/boolean/facet_order.h"
#include "mortise/boolean/repair_reach.h"

namespace mortise {

/// Swaps the longest edge of slivers among failed triangles and their neighbours (exact-core 5, repair a).
///
/// Both triangles after the swap belong to the face of the larger one; the surface moves by no more than the height of the
/// sliver. Where inner faces are kept, any number of triangles may meet at that edge: the sliver goes, each of the others takes
/// its corner into the edge, and those that then coincide are joined. The caller certifies again.
/// @param precedes  see join_coincident()
/// @param reach     triangles higher over their longest edge than this at their top are no slivers
/// @return false when there was nothing to swap
[[nodiscard]] bool swap_slivers(const FacetOrder& precedes, std::span<const FailedPair> failed, const RepairReach& reach,
                                MergedMesh& merged);

}  // namespace mortise
