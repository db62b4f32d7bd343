// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Our answers, measured.
#pragma once

#include "shape.h"

namespace mortise::peers {

/// All four booleans, from four calls.
[[nodiscard]] Answers our_answers(const SurfaceMesh& a, const SurfaceMesh& b, Depth depth);

}  // namespace mortise::peers
