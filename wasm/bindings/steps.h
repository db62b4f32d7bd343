// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The steps of a transformation as JavaScript writes them.
#pragma once

#include <emscripten/val.h>

#include "mortise/mesh/transform.h"

namespace mortise::wasm {

/// The one map of all steps in order.
/// @param steps  arrays [name, numbers...]: factors, degrees, an offset, the unit vector of an axis, or a matrix of 16, column after column
[[nodiscard]] AffineMap map_of_steps(const emscripten::val& steps);

}  // namespace mortise::wasm
