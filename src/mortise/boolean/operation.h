// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The operations and their names.
#pragma once

#include <cstdint>
#include <string_view>

namespace mortise {

enum class Operation : std::uint8_t {
  Union,                ///< inside any operand
  Intersect,            ///< inside all operands
  Subtract,             ///< inside the first operand and no other
  SymmetricDifference,  ///< inside an odd number of operands
  Partition,            ///< inside any operand, regions of different operands kept apart (the paper's non-regularized union)
};

/// "union", "intersect", "subtract", "symmetric_difference", "partition".
[[nodiscard]] std::string_view operation_name(Operation operation);

/// The operation of that name.
/// @throws Error{InvalidArgument}
[[nodiscard]] Operation operation_from_name(std::string_view name);

/// What of the cut is taken out of a result again (see simplify).
enum class Simplify : std::uint8_t {
  Off,
  Cut,       ///< what the cut made inside one face or on one edge of an operand
  Coplanar,  ///< also across faces of one plane, of any operand
};

}  // namespace mortise
