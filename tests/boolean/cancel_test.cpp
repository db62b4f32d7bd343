// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A call can be stopped at every report, in every stage, and leaves nothing behind.
#include <map>
#include <string>

#include "boolean/evaluation.h"
#include "mortise/boolean/evaluate_boolean.h"
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

/// The union of the operands, stopped at report `stop`; 0: not stopped.
Call call(const std::vector<SurfaceMesh>& operands, int stop) {
  Call made;
  BooleanOptions options;
  options.progress = [&](std::string_view stage, double fraction) {
    made.stages.emplace_back(stage);
    made.fractions.push_back(fraction);
    return static_cast<int>(made.stages.size()) != stop;
  };
  made.result = evaluate_boolean(Operation::Union, pointers_to(operands), options);
  return made;
}

void check_every_stop(const std::vector<SurfaceMesh>& operands, int passes) {
  const std::vector<SurfaceMesh> before = operands;
  const Call whole = call(operands, 0);
  std::map<std::string, int> reports;
  for (const std::string& stage : whole.stages) ++reports[stage];
  for (const char* stage : {"find_contacts", "split_segments", "triangulate_faces", "categorize"}) CHECK(reports[stage] >= passes);
  for (const char* stage : {"gather_operands", "select", "certify"}) CHECK(reports[stage] >= 1);
  for (const double f : whole.fractions) CHECK((f >= 0 && f <= 1));
  for (int stop = 1; stop <= static_cast<int>(whole.stages.size()); ++stop) {
    const auto error = error_of([&] { (void)call(operands, stop); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(error->stage == whole.stages[static_cast<std::size_t>(stop) - 1]);
    for (std::size_t k = 0; k < operands.size(); ++k) CHECK(has_same_bits(operands[k], before[k]));
  }
  CHECK(has_same_bits(call(operands, 0).result.mesh, whole.result.mesh));
}

}  // namespace

TEST_CASE("a call can be cancelled at every report, and the next call is right") {
  check_every_stop({box({0, 0, 0}, {1, 1, 1}), tetrahedron({0.3, 0.2, -0.5}, {1.7, 0.3, 0.4}, {0.2, 1.6, 0.5}, {0.4, 0.3, 1.9})}, 1);
}

TEST_CASE("a call that arranges twice can be cancelled in either pass") {
  check_every_stop({pentagram_prism(0, 2), box({-0.5, -0.5, -1}, {0.5, 0.5, 3})}, 2);
}

TEST_CASE("an exception of the callback passes through, and the next call is right") {
  const std::vector<SurfaceMesh> operands{box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2})};
  BooleanOptions options;
  options.progress = [](std::string_view stage, double) -> bool { throw std::string(stage); };
  CHECK_THROWS_AS(evaluate_boolean(Operation::Union, pointers_to(operands), options), std::string);
  CHECK(call(operands, 0).result.report.certificate.status == CertificateStatus::Certified);
}
