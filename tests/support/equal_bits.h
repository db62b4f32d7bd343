// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Points compared bit by bit: 0 and -0 differ.
#pragma once

#include <cstring>

#include "mortise/geom/vec.h"

namespace mortise::test {

[[nodiscard]] inline bool have_equal_bits(const Vec3d& a, const Vec3d& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace mortise::test
