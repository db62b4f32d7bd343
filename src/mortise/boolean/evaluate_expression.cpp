// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The one rule with a predicate of the caller.
#include "mortise/boolean/evaluate_expression.h"

#include "mortise/base/error.h"
#include "mortise/boolean/evaluate_selection.h"
#include "mortise/boolean/expression.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "evaluate_expression";

void refuse_unbounded(bool is_true_outside) {
  if (is_true_outside)
    throw Error(ErrorCode::InvalidArgument, stage_name, "the result would reach to infinity: it contains what is outside all operands");
}

}  // namespace

BooleanResult evaluate_expression(std::string_view expression, const OperandList& operands, const BooleanOptions& options) {
  const Expression parsed(expression, operands.size());
  refuse_unbounded(RunningExpression(parsed).value());
  const auto selector = [&](const OperandFaces& faces, const Facets& facets, const Categories& categories) {
    RunningExpression running(parsed);
    return select([&](const RunningWinding& w) { return running.value_in(w); }, faces, facets, categories);
  };
  return evaluate_selection(stage_name, selector, operands, options);
}

BooleanResult evaluate_where(const std::function<bool(const RunningWinding&)>& is_inside_result, const OperandList& operands,
                             const BooleanOptions& options) {
  refuse_unbounded(is_inside_result(RunningWinding(std::vector<int>(operands.size(), 0))));
  const auto selector = [&](const OperandFaces& faces, const Facets& facets, const Categories& categories) {
    return select(is_inside_result, faces, facets, categories);
  };
  return evaluate_selection(stage_name, selector, operands, options);
}

}  // namespace mortise
