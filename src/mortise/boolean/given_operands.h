// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The result of operands that were made from others, seen from these.
#pragma once

#include <span>
#include <vector>

#include "mortise/boolean/evaluate_selection.h"
#include "mortise/boolean/imprinted_operand.h"

namespace mortise {

/// Gives the provenance of a result the faces and vertices of the operands as given. A vertex that is not where it was given,
/// in coordinates of the result, is a made one.
/// @param made    what was evaluated, operand by operand
/// @return vertices of the operands as given that are in the result, but moved; ascending
[[nodiscard]] std::vector<OperandVertex> name_given_sources(std::span<const SurfaceMesh* const> operands,
                                                            std::span<const ImprintedOperand> made, Coordinates coordinates,
                                                            EvaluatedSelection& evaluated);

/// The result as one whose vertices are exactly their doubles.
[[nodiscard]] EvaluatedSelection at_its_doubles(const OperandList& operands, BooleanResult result);

}  // namespace mortise
