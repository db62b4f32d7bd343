// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Booleans by expression, and by any rule a program can call.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/running_winding.h"

namespace mortise {

/// What an expression says, "(a | b) & !c".
///
/// Operands are a, b, c ... in their order, or #0, #1, #2 ...; from tight to loose: `!` (outside), `-` (without), `&`, `^` (an odd
/// number), `|`. Operands and result are those of evaluate_boolean; operands the expression does not name may leave vertices
/// and edges where they touch the others.
/// @throws Error{InvalidArgument} naming the column; also for an expression that is true outside all operands
[[nodiscard]] BooleanResult evaluate_expression(std::string_view expression, const OperandList& operands,
                                                const BooleanOptions& options = {});

/// The regions a function chooses: asked once per region of one complex of touching operands, in a fixed order.
///
/// @param is_inside_result  depends on which operands contain the region; false when none does
/// @throws Error{InvalidArgument} when it is true outside all operands
[[nodiscard]] BooleanResult evaluate_where(const std::function<bool(const RunningWinding&)>& is_inside_result, const OperandList& operands,
                                           const BooleanOptions& options = {});

}  // namespace mortise
