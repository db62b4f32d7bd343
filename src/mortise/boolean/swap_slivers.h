// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Repair of a result that rounding folded: a triangle without height gives its longest edge another diagonal.
#pragma once

#include <span>

#include "mortise/boolean/certify.h"

namespace mortise {

/// Swaps the longest edge of slivers among failed triangles and their neighbours (exact-core 5, repair a).
///
/// Both triangles after the swap belong to the face of the larger one; the surface moves by no more than the height of the
/// sliver. The caller certifies again.
/// @param reach  triangles higher than this over their longest edge are no slivers
/// @return false when there was nothing to swap
[[nodiscard]] bool swap_slivers(std::span<const FailedPair> failed, double reach, MergedMesh& merged);

}  // namespace mortise
