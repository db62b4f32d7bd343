// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must hold for every case of the random campaign.
#pragma once

#include <string>

#include "support/random_cases.h"

namespace mortise::test {

struct CaseOutcome {
  std::string faults;           ///< one line each; empty when the case passed
  bool is_uncertified = false;  ///< one of its results says so itself: no fault
  bool is_slow = false;         ///< an operation took more than 20 seconds of the processor: no fault
  double displacement = 0;      ///< the largest of its results, in units of 2^-52 of the largest coordinate
  double seconds = 0;           ///< of the processor
};

/// Evaluates the union, the intersection and both subtractions of a case, and what the identities need besides; the union and the
/// subtraction simplified, the symmetric difference, the partition and the imprint; the union as an expression, an implant and by
/// tags, of prepared operands, with float32 coordinates and with a tolerance; a subtraction certified absolutely.
///
/// For all: arrays, balanced edges, the order of operands, inclusion and exclusion of volumes, no error. Where the result is
/// certified and not large: no crossing by the oracle. Where operands are small: provenance in rationals and the oracle's
/// volumes, exact for families whose results need no repair. An operation of more than 300 seconds of the processor is a fault.
[[nodiscard]] CaseOutcome check_case(const RandomCase& random_case);

}  // namespace mortise::test
