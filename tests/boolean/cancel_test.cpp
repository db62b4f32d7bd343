// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A call can be stopped at every report, in every stage, and leaves nothing behind.
#include <functional>
#include <map>
#include <string>

#include "boolean/evaluation.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Call {
  std::vector<std::string> stages;  ///< of the reports, in order
  std::vector<double> fractions;
  BooleanResult result;
};

using Operands = std::span<const SurfaceMesh* const>;
using Evaluate = std::function<BooleanResult(Operands, const BooleanOptions&)>;

/// The operation on the operands, stopped at report `stop`; 0: not stopped.
Call call(const Evaluate& evaluate_operands, const std::vector<SurfaceMesh>& operands, int stop) {
  Call made;
  BooleanOptions options;
  options.progress = [&](std::string_view stage, double fraction) {
    made.stages.emplace_back(stage);
    made.fractions.push_back(fraction);
    return static_cast<int>(made.stages.size()) != stop;
  };
  made.result = evaluate_operands(pointers_to(operands), options);
  return made;
}

void check_every_stop(const Evaluate& evaluate_operands, const std::vector<SurfaceMesh>& operands, int passes) {
  const std::vector<SurfaceMesh> before = operands;
  const Call whole = call(evaluate_operands, operands, 0);
  std::map<std::string, int> reports;
  for (const std::string& stage : whole.stages) ++reports[stage];
  for (const char* stage : {"find_contacts", "split_segments", "triangulate_faces", "categorize"}) CHECK(reports[stage] >= passes);
  for (const char* stage : {"gather_operands", "select", "certify"}) CHECK(reports[stage] >= 1);
  for (const double f : whole.fractions) CHECK((f >= 0 && f <= 1));
  for (int stop = 1; stop <= static_cast<int>(whole.stages.size()); ++stop) {
    const auto error = error_of([&] { (void)call(evaluate_operands, operands, stop); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(error->stage == whole.stages[static_cast<std::size_t>(stop) - 1]);
    for (std::size_t k = 0; k < operands.size(); ++k) CHECK(has_same_bits(operands[k], before[k]));
  }
  CHECK(has_same_bits(call(evaluate_operands, operands, 0).result.mesh, whole.result.mesh));
}

BooleanResult unite_all(Operands operands, const BooleanOptions& options) { return evaluate_boolean(Operation::Union, operands, options); }

Evaluate evaluation_of(Operation operation) {
  return [operation](Operands operands, const BooleanOptions& options) { return evaluate_boolean(operation, operands, options); };
}

/// Everything that takes a callback.
std::map<std::string, Evaluate> operations() {
  const KeepMask outside = static_cast<KeepMask>(KeepTag::FirstOutside);
  return {
      {"union", unite_all},
      {"intersect", evaluation_of(Operation::Intersect)},
      {"subtract", evaluation_of(Operation::Subtract)},
      {"symmetric difference", evaluation_of(Operation::SymmetricDifference)},
      {"partition", evaluation_of(Operation::Partition)},
      {"imprint", [](Operands operands, const BooleanOptions& options) { return imprint(operands, options).whole; }},
      {"implant", [](Operands operands, const BooleanOptions& options) { return implant(operands, ImplantContact::Keep, options); }},
      {"implant, drop", [](Operands operands, const BooleanOptions& options) { return implant(operands, ImplantContact::Drop, options); }},
      {"keep", [=](Operands operands, const BooleanOptions& options) { return keep_faces(outside, operands, options); }},
      {"expression", [](Operands operands, const BooleanOptions& options) { return evaluate_expression("a - b | c", operands, options); }},
      {"rule",
       [](Operands operands, const BooleanOptions& options) {
         return evaluate_where([](const RunningWinding& winding) { return winding.is_inside(OperandId(1)); }, operands, options);
       }},
      {"resolve", [](Operands operands, const BooleanOptions& options) { return resolve(*operands[0], options); }},
  };
}

}  // namespace

TEST_CASE("a call can be cancelled at every report, and the next call is right") {
  check_every_stop(unite_all, {box({0, 0, 0}, {1, 1, 1}), tetrahedron({0.3, 0.2, -0.5}, {1.7, 0.3, 0.4}, {0.2, 1.6, 0.5}, {0.4, 0.3, 1.9})},
                   1);
}

TEST_CASE("a call that arranges twice can be cancelled in either pass") {
  check_every_stop(unite_all, {pentagram_prism(0, 2), box({-0.5, -0.5, -1}, {0.5, 0.5, 3})}, 2);
}

TEST_CASE("every operation can be cancelled at every report") {
  const SurfaceMesh overlap = joined({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  const SurfaceMesh sheet = make_mesh({{-1, -1, 0.5}, {5, -1, 0.5}, {5, 5, 1.25}, {-1, 5, 1.25}}, {{0, 1, 2}, {0, 2, 3}});
  for (const auto& [name, evaluate_operands] : operations()) {
    INFO(name);
    check_every_stop(evaluate_operands, {overlap, box({2, 0, 0}, {4, 2, 2}), sheet}, 1);
  }
}

TEST_CASE("an exception of the callback passes through, and the next call is right") {
  const std::vector<SurfaceMesh> operands{box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2})};
  BooleanOptions options;
  options.progress = [](std::string_view stage, double) -> bool { throw std::string(stage); };
  CHECK_THROWS_AS(evaluate_boolean(Operation::Union, pointers_to(operands), options), std::string);
  CHECK(call(unite_all, operands, 0).result.report.certificate.status == CertificateStatus::Certified);
}
