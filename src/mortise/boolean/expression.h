// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Expressions over operands, "(a | b) & !c": parsed once, evaluated again along one path only.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mortise/boolean/running_winding.h"

namespace mortise {

/// A parsed expression: a tree of nodes with any number of children.
///
/// Operands are a, b, c ... in their order, large or small, or #0, #1, #2 ... for any number of them. From tight to loose: `!`
/// (outside), `-` (without), `&` (and), `^` (either, an odd number), `|` (or); equal ones from the left; parentheses.
class Expression {
 public:
  /// @throws Error{InvalidArgument} naming the column, the first is 1
  Expression(std::string_view text, std::size_t operand_count);

  enum class NodeKind : std::uint8_t { And, Or, Xor, Not };
  struct Node {
    NodeKind kind;
    std::uint32_t parent = none;
    std::uint32_t child_count = 0;
  };
  static constexpr std::uint32_t none = 0xffffffffU;

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::uint32_t root() const { return root_; }
  /// The nodes an operand is a child of, as often as it is.
  [[nodiscard]] const std::vector<std::uint32_t>& uses_of(OperandId k) const { return uses_[k]; }
  [[nodiscard]] std::size_t operand_count() const { return uses_.size(); }

 private:
  friend class ExpressionParser;

  std::vector<Node> nodes_;
  IdVector<OperandId, std::vector<std::uint32_t>> uses_;
  std::uint32_t root_ = none;
};

/// The value of an expression while operands are entered and left. O(depth of the expression) for each of its uses.
class RunningExpression {
 public:
  /// All operands are outside.
  explicit RunningExpression(const Expression& expression);

  [[nodiscard]] bool value() const { return value_[expression_.root()] != 0; }
  /// Follows a walk that began with all operands outside, or with the last windings given.
  bool value_in(const RunningWinding& winding);

 private:
  void set(OperandId k, bool is_inside);
  void add(std::uint32_t node, std::uint32_t by);
  [[nodiscard]] bool value_of(std::uint32_t node) const;

  const Expression& expression_;
  std::vector<std::uint32_t> true_children_;
  std::vector<std::uint8_t> value_;
  IdVector<OperandId, std::uint8_t> is_inside_;
};

}  // namespace mortise
