// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Conversions to float32 and back.
#include "mortise/geom/coordinates.h"

#include <cmath>

namespace mortise {
namespace {

// Below the largest float and half a unit.
bool fits(double x) { return std::fabs(x) < 0x1.ffffffp127; }

// volatile: g++ 12.2 vectorizes the two conversions of neighbouring coordinates into none.
double nearest(double x) {
  const volatile float stored = static_cast<float>(x);
  return static_cast<double>(stored);
}

}  // namespace

bool fits_float32(const Vec3d& p) { return fits(p.x) && fits(p.y) && fits(p.z); }

Vec3d nearest_float32(const Vec3d& p) { return {nearest(p.x), nearest(p.y), nearest(p.z)}; }

}  // namespace mortise
