// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The points of an arrangement in rationals.
#pragma once

#include <vector>

#include "support/arrangement.h"
#include "support/boolean_oracle.h"

namespace mortise::test {

/// The exact position of every point: input points as they are, made points as the oracle finds them by brute force.
/// Throws std::logic_error for a made point that is none of the oracle's, or where two of these share a nearest double.
[[nodiscard]] std::vector<oracle::RationalPoint> exact_points(const Arrangement& arrangement);

}  // namespace mortise::test
