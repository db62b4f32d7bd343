// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Says which operands are no solids, and where: sheets, or errors.
#pragma once

#include <span>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/boolean/categorize.h"

namespace mortise {

/// Operands with a border: an odd number of their facets meets at an edge. Ascending.
[[nodiscard]] std::vector<OperandId> find_sheets(const Categories& categories);

/// Vertex pairs of the edges of an operand at which an odd number of its faces meets, as the caller numbered them.
[[nodiscard]] std::vector<std::uint32_t> open_edges(const SurfaceMesh& mesh, const OperandFaces& faces, OperandId k);

/// Returns when every operand is a sheet or a solid: balanced at every edge of the arrangement, and somewhere of positive
/// winding.
/// @throws Error{NotClosed} or Error{NotOriented} naming the vertex pairs of edges of the lowest other operand, as the caller
/// numbered them; an edge that only exists after splitting is named by the given edges it lies on
/// @throws Error{InsideOut} naming faces
void refuse_operands(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Categories& categories);

/// The error of refuse_operands about one operand.
/// @param code  NotClosed, NotOriented or InsideOut; returns for others
void refuse_operand(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, OperandId k, ErrorCode code);

}  // namespace mortise
