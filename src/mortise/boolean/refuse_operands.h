// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Says which operands are no solids, and where.
#pragma once

#include <span>

#include "mortise/boolean/categorize.h"

namespace mortise {

/// Returns when every operand is a solid: balanced at every edge of the arrangement, and somewhere of positive winding.
/// @throws Error{NotClosed} or Error{NotOriented} naming the vertex pairs of edges of the lowest such operand, as the caller
/// numbered them; an edge that only exists after splitting is named by the given edges it lies on
/// @throws Error{InsideOut} naming faces
void refuse_operands(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Categories& categories);

}  // namespace mortise
