// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A parser with two stacks, and counts of true children that change upwards only.
#include "mortise/boolean/expression.h"

#include <string>

#include "mortise/base/error.h"

namespace mortise {

/// Operators wait on one stack until a looser one comes; terms wait on the other.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, Expression& expression) : text_(text), expression_(expression) {}

  void parse() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == ' ' || text_[at_] == '\t') continue;
      if (wants_operand_) {
        read_operand();
      } else {
        read_operator();
      }
    }
    if (wants_operand_) fail(text_.size(), "an operand is missing");
    while (!operators_.empty()) {
      if (operators_.back().symbol == '(') fail(operators_.back().column, "this '(' is not closed");
      apply_last();
    }
    expression_.root_ = new_node(Expression::NodeKind::Or, terms_.back());
  }

 private:
  // An operand, or a node.
  struct Term {
    bool is_operand;
    std::uint32_t id;
  };
  struct Operator {
    char symbol;
    std::size_t column;  // from 0
  };

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

  [[noreturn]] static void fail(std::size_t column, const std::string& what) {
    throw Error(ErrorCode::InvalidArgument, "parse_expression", "column " + std::to_string(column + 1) + ": " + what);
  }

  // The larger, the tighter.
  static int strength(char symbol) {
    constexpr std::string_view from_loose = "(|^&-!";
    return static_cast<int>(from_loose.find(symbol));
  }

  void read_operand() {
    const char c = text_[at_];
    if (c == '(' || c == '!') {
      operators_.push_back({c, at_});
    } else if (c == '#') {
      read_number();
    } else if (is_letter(c)) {
      read_letter();
    } else {
      fail(at_, std::string("an operand is expected, not '") + c + "'");
    }
  }

  void read_letter() {
    const std::size_t begin = at_;
    if (at_ + 1 < text_.size() && (is_letter(text_[at_ + 1]) || is_digit(text_[at_ + 1]))) {
      fail(begin, "operands are single letters, or # and a number");
    }
    const char c = text_[begin];
    add_operand(static_cast<std::uint64_t>(c >= 'a' ? c - 'a' : c - 'A'), begin);
  }

  void read_number() {
    const std::size_t begin = at_;
    std::uint64_t number = 0;
    while (at_ + 1 < text_.size() && is_digit(text_[at_ + 1])) {
      number = 10 * number + static_cast<std::uint64_t>(text_[++at_] - '0');
      if (number > Expression::none) fail(begin, "no operand has this number");
    }
    if (at_ == begin) fail(begin, "a number is expected after '#'");
    add_operand(number, begin);
  }

  void add_operand(std::uint64_t number, std::size_t column) {
    const std::size_t count = expression_.uses_.size();
    if (number >= count) {
      fail(column, "there is no such operand, the call has " + std::to_string(count));
    }
    terms_.push_back({true, static_cast<std::uint32_t>(number)});
    wants_operand_ = false;
  }

  void read_operator() {
    const char c = text_[at_];
    if (c == ')') return close();
    if (c != '|' && c != '^' && c != '&' && c != '-') fail(at_, std::string("an operator is expected, not '") + c + "'");
    while (!operators_.empty() && strength(operators_.back().symbol) >= strength(c)) apply_last();
    operators_.push_back({c, at_});
    wants_operand_ = true;
  }

  void close() {
    while (!operators_.empty() && operators_.back().symbol != '(') apply_last();
    if (operators_.empty()) fail(at_, "')' without '('");
    operators_.pop_back();
  }

  void apply_last() {
    const char symbol = operators_.back().symbol;
    operators_.pop_back();
    const Term right = terms_.back();
    terms_.pop_back();
    if (symbol == '!') {
      terms_.push_back({false, new_node(Expression::NodeKind::Not, right)});
      return;
    }
    const Term left = terms_.back();
    terms_.pop_back();
    if (symbol == '-') {
      terms_.push_back(combined(Expression::NodeKind::And, left, {false, new_node(Expression::NodeKind::Not, right)}));
    } else {
      const auto kind = symbol == '&' ? Expression::NodeKind::And : symbol == '|' ? Expression::NodeKind::Or : Expression::NodeKind::Xor;
      terms_.push_back(combined(kind, left, right));
    }
  }

  // A chain of one operator is one node.
  Term combined(Expression::NodeKind kind, const Term& left, const Term& right) {
    const bool continues = !left.is_operand && expression_.nodes_[left.id].kind == kind;
    const std::uint32_t node = continues ? left.id : new_node(kind, left);
    give(right, node);
    return {false, node};
  }

  std::uint32_t new_node(Expression::NodeKind kind, const Term& child) {
    const auto node = static_cast<std::uint32_t>(expression_.nodes_.size());
    expression_.nodes_.push_back({kind});
    give(child, node);
    return node;
  }

  void give(const Term& child, std::uint32_t parent) {
    ++expression_.nodes_[parent].child_count;
    if (child.is_operand) {
      expression_.uses_[OperandId(child.id)].push_back(parent);
    } else {
      expression_.nodes_[child.id].parent = parent;
    }
  }

  std::string_view text_;
  Expression& expression_;
  std::size_t at_ = 0;
  bool wants_operand_ = true;
  std::vector<Term> terms_;
  std::vector<Operator> operators_;
};

Expression::Expression(std::string_view text, std::size_t operand_count) : uses_(operand_count) { ExpressionParser(text, *this).parse(); }

RunningExpression::RunningExpression(const Expression& expression)
    : expression_(expression),
      true_children_(expression.nodes().size(), 0),
      value_(expression.nodes().size(), 0),
      is_inside_(expression.operand_count(), 0) {
  for (std::uint32_t node = 0; node < value_.size(); ++node) add(node, 0);
}

bool RunningExpression::value_in(const RunningWinding& winding) {
  for (const OperandId k : winding.crossed()) set(k, winding.is_inside(k));
  return value();
}

void RunningExpression::set(OperandId k, bool is_inside) {
  if ((is_inside_[k] != 0) == is_inside) return;
  is_inside_[k] = is_inside ? 1 : 0;
  for (const std::uint32_t node : expression_.uses_of(k)) add(node, is_inside ? 1U : ~0U);
}

// Unsigned, so that ~0 is one less. Goes up as long as values change.
void RunningExpression::add(std::uint32_t node, std::uint32_t by) {
  while (node != Expression::none) {
    true_children_[node] += by;
    const bool value = value_of(node);
    if (value == (value_[node] != 0)) return;
    value_[node] = value ? 1 : 0;
    by = value ? 1U : ~0U;
    node = expression_.nodes()[node].parent;
  }
}

bool RunningExpression::value_of(std::uint32_t node) const {
  switch (expression_.nodes()[node].kind) {
    case Expression::NodeKind::And:
      return true_children_[node] == expression_.nodes()[node].child_count;
    case Expression::NodeKind::Or:
      return true_children_[node] > 0;
    case Expression::NodeKind::Xor:
      return true_children_[node] % 2 == 1;
    case Expression::NodeKind::Not:
      return true_children_[node] == 0;
  }
  return false;
}

}  // namespace mortise
