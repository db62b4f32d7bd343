// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Time and memory of a call.
#pragma once

#include <functional>

#include "shape.h"

namespace mortise::peers {

/// Runs the call. Memory is that of the whole process (Linux), so calls are measured one at a time.
[[nodiscard]] Cost measure_cost(const std::function<void()>& call);

}  // namespace mortise::peers
