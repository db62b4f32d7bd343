// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Prepared operands stay on this side of the border; JavaScript knows them by number.
#pragma once

#include <cstdint>
#include <memory>

#include "mortise/arrange/prepared_operand.h"

namespace mortise::wasm {

using KeptOperand = std::shared_ptr<const PreparedOperand>;

/// @throws Error{InvalidArgument} when there is none of that number
[[nodiscard]] KeptOperand prepared_operand(std::uint32_t number);

}  // namespace mortise::wasm
