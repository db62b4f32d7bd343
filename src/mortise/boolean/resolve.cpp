// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The only operand of a call is searched for all contacts with itself.
#include "mortise/boolean/resolve.h"

#include <array>

namespace mortise {

BooleanResult resolve(const Operand& mesh, const BooleanOptions& options) {
  return evaluate_boolean(Operation::Union, std::array{mesh}, options);
}

}  // namespace mortise
