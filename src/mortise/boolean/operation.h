// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The operations and their names.
#pragma once

#include <cstdint>
#include <string_view>

namespace mortise {

enum class Operation : std::uint8_t {
  Union,      ///< inside any operand
  Intersect,  ///< inside all operands
  Subtract,   ///< inside the first operand and no other
};

/// "union", "intersect", "subtract".
[[nodiscard]] std::string_view operation_name(Operation operation);

}  // namespace mortise
