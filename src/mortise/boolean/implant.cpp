// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An implant is a partition in which the last operand that contains a space has it for itself.
#include "mortise/boolean/implant.h"

#include "mortise/base/error.h"
#include "mortise/boolean/evaluate_selection.h"

namespace mortise {

BooleanResult implant(const OperandList& operands, ImplantContact contact, const BooleanOptions& options) {
  constexpr const char* name = "implant";
  if (operands.size() < 2) throw Error(ErrorCode::InvalidArgument, name, "a host and a component are needed");
  const auto unite = [](const OperandFaces& faces, const Facets& facets, const Categories& categories) {
    return select(Operation::Union, faces, facets, categories);
  };
  return evaluate_selection(name, contact == ImplantContact::Keep ? Selector(select_implant) : Selector(unite), operands, options);
}

}  // namespace mortise
