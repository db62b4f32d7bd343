// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Says which operands are no solids, and where.
#pragma once

#include <span>

#include "mortise/boolean/categorize.h"

namespace mortise {

/// Returns when every operand is a solid: balanced at every edge of the arrangement, and somewhere of positive winding.
/// @throws Error{NotClosed} or Error{NotOriented} naming the vertex pairs of edges of the lowest such operand (pairs of
/// vertices that span the edge in the operand; of an edge that only exists after splitting, the faces on it)
/// @throws Error{InsideOut} naming faces
void refuse_operands(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Categories& categories);

}  // namespace mortise
