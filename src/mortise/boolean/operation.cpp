// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Names of operations, both ways.
#include "mortise/boolean/operation.h"

#include <string>

#include "mortise/base/error.h"

namespace mortise {

std::string_view operation_name(Operation operation) {
  switch (operation) {
    case Operation::Union:
      return "union";
    case Operation::Intersect:
      return "intersect";
    case Operation::Subtract:
      return "subtract";
    case Operation::SymmetricDifference:
      return "symmetric_difference";
    case Operation::Partition:
      return "partition";
  }
  return "";
}

Operation operation_from_name(std::string_view name) {
  for (const Operation operation :
       {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference, Operation::Partition}) {
    if (name == operation_name(operation)) return operation;
  }
  throw Error(ErrorCode::InvalidArgument, "evaluate_boolean", "no operation has this name: " + std::string(name));
}

}  // namespace mortise
