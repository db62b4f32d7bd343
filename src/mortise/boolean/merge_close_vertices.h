// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Repair of a result that rounding folded: made vertices next to another vertex become that vertex.
#pragma once

#include <span>

#include "mortise/boolean/certify.h"
#include "mortise/boolean/repair_reach.h"

namespace mortise {

/// Merges made vertices that rounding put on the same doubles: whatever uses two of them would fail. Rounding to float32 does the same
/// to vertices of operands.
/// @return how many of these went
/// O(n log n) in the vertices that may have moved.
std::size_t merge_equal_vertices(const OperandFaces& faces, const Facets& facets, Coordinates coordinates, MergedMesh& merged);

/// Merges made vertices of failed triangles into the nearest vertex there, closest first, made before input; an input vertex
/// never moves. Triangles that lose a corner go, opposite triangles on the same corners cancel, so every edge stays
/// balanced (exact-core 5, repair b). The caller certifies again.
/// @param reach  vertices farther apart are left alone
/// @return false when there was nothing to merge
[[nodiscard]] bool merge_close_vertices(const OperandFaces& faces, const Facets& facets, std::span<const FailedPair> failed,
                                        const RepairReach& reach, MergedMesh& merged);

}  // namespace mortise
