// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Whether two results are the same to the last bit, times left out.
#pragma once

#include <string>

#include "mortise/boolean/imprint.h"

namespace mortise::test {

/// Names of what differs, -0 and +0 told apart; empty when nothing does.
[[nodiscard]] std::string difference_of(const BooleanResult& a, const BooleanResult& b);
[[nodiscard]] std::string difference_of(const ImprintResult& a, const ImprintResult& b);

/// The same of two errors.
[[nodiscard]] std::string difference_of(const Error& a, const Error& b);

}  // namespace mortise::test
