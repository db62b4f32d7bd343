// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Parts of one operand that cross with all their extreme vertices outside one another: the crossing was once not looked for.
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

// Crossed bars of 1 x 1 x 3: they share a unit box.
const SurfaceMesh cross_shape = joined({box({-1, 0, 0}, {2, 1, 1}), box({0, -1, 0}, {1, 2, 1})});

}  // namespace

TEST_CASE("two crossed bars in one operand are one solid") {
  CHECK(exact_volume(evaluate(Operation::Union, {cross_shape}).mesh) == 5);
  CHECK(exact_volume(evaluate(Operation::Union, {cross_shape, box({9, 9, 9}, {10, 10, 10})}).mesh) == 6);
  CHECK(exact_volume(evaluate(Operation::Subtract, {box({-3, -3, -3}, {3, 3, 3}), cross_shape}).mesh) == 216 - 5);
}

TEST_CASE("an operand that was only searched for crossings is not reported to have any") {
  const BooleanResult clean = evaluate(Operation::Union, {box({0, 0, 0}, {1, 1, 1})});
  CHECK(clean.report.self_contacts.empty());
  const BooleanResult crossed = evaluate(Operation::Union, {cross_shape});
  CHECK(crossed.report.self_contacts == std::vector<std::uint32_t>{0});
}
