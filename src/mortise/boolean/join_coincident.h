// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangles with spaces on both sides, as in a partition, that a repair put on the same corners become one, or none.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/boolean/facet_order.h"
#include "mortise/boolean/merge.h"

namespace mortise {

/// Which triangles remain: not those with a corner twice; of those on the same corners the lowest, with the spaces on the far
/// sides of them all and the sources of them all, unless these spaces are in the same operands and no sheet was among them.
///
/// Where all sources are kept (an imprint), these decide instead: faces of one operand that run against each other cancel, so
/// that every operand stays closed by itself, and a triangle remains for what is left.
///
/// @param precedes  decides which spaces stay when more than two are left, and whose facet the triangle has
/// @param merged    with both its coverings
/// @return per triangle 1 or 0; `merged` keeps all triangles
[[nodiscard]] std::vector<std::uint8_t> join_coincident(const FacetOrder& precedes, MergedMesh& merged);

}  // namespace mortise
