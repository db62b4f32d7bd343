// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operands split along their contacts, nothing removed (paper 5.2, Fig. 2f, 14).
#pragma once

#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/imprinted_operand.h"

namespace mortise {

/// Operands that share numbers: those of `whole`.
///
/// Vertices of two operands are one vertex when their `vertex_ids` are equal, edges when the ids of both ends are, triangles when
/// their `facet_ids` are (they may run against each other). A model is glued by these: `whole.mesh` is the glued one, every
/// coincident facet in it once, its sources in the provenance; or an operand is taken as it is, and tied to others by number.
struct ImprintResult {
  BooleanResult whole;  ///< all facets of all operands; covering sets on both sides, as of a partition
  std::vector<ImprintedOperand> operands;
};

/// Splits every operand where it meets others, or itself.
///
/// Operands are those of evaluate_boolean. Vertices the cut did not make keep their bits; every operand is as closed as it was.
/// Faces without area go, vertices without faces too. There is one certificate, about all facets together; a repair moves
/// vertices for all operands alike. An imprint of imprinted operands adds nothing.
/// @throws what evaluate_boolean does
[[nodiscard]] ImprintResult imprint(const OperandList& operands, const BooleanOptions& options = {});
[[nodiscard]] ImprintResult imprint(const Operand& a, const Operand& b, const BooleanOptions& options = {});

}  // namespace mortise
