// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What numbers the coordinates of a result are.
#pragma once

#include <cstdint>

#include "mortise/geom/vec.h"

namespace mortise {

enum class Coordinates : std::uint8_t {
  Float64,
  Float32,  ///< doubles that a float32 holds: for STL files, GLB files, graphics cards
};

/// Does every coordinate round to a float32 that is finite?
[[nodiscard]] bool fits_float32(const Vec3d& p);

/// Every coordinate rounded to the nearest float32.
[[nodiscard]] Vec3d nearest_float32(const Vec3d& p);

}  // namespace mortise
