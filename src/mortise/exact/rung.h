// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which rung of the ladder answered: for tests and benchmarks.
#pragma once

#include "mortise/exact/sign.h"

namespace mortise {

/// Cheapest first. A predicate stops at the first rung that is certain.
enum class Rung : unsigned char {
  Construction,  ///< known from how the points were made, or from equal coordinates
  Filter,        ///< doubles with an error bound
  DoubleDouble,  ///< about 104 bits with an error bound
  Expansion,     ///< exact, sums of doubles
  BigFloat,      ///< exact, any range
};
inline constexpr int rung_count = 5;

struct Answer {
  Sign sign;
  Rung rung;
};

}  // namespace mortise
