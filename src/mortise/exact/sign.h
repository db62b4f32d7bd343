// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The answer of every predicate.
#pragma once

namespace mortise {

enum class Sign : signed char { Negative = -1, Zero = 0, Positive = 1 };

[[nodiscard]] constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }
[[nodiscard]] constexpr Sign sign_of(double x) { return x > 0 ? Sign::Positive : x < 0 ? Sign::Negative : Sign::Zero; }
[[nodiscard]] constexpr Sign sign_of(int x) { return x > 0 ? Sign::Positive : x < 0 ? Sign::Negative : Sign::Zero; }

}  // namespace mortise
