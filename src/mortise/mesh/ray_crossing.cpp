// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Signs at a symbolic point: the first of the corners that is not on the plane or line decides.
#include "mortise/mesh/ray_crossing.h"

#include <limits>

#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

// Is the start left of a -> b in the projection along x?
Sign turn_at(const Vec3d& a, const Vec3d& b, const RayStart& start) {
  for (const Vec3d* p : {&start.at, &start.towards, &start.beyond}) {
    const Sign turn = orient2d(a, b, *p, Axis::X);
    if (turn != Sign::Zero) return turn;
  }
  if (a.z != b.z) return a.z > b.z ? Sign::Positive : Sign::Negative;
  return a.y < b.y ? Sign::Positive : Sign::Negative;
}

Sign side_at(const Vec3d& a, const Vec3d& b, const Vec3d& c, const RayStart& start) {
  for (const Vec3d* p : {&start.at, &start.towards}) {
    const Sign side = orient3d(a, b, c, *p);
    if (side != Sign::Zero) return side;
  }
  return orient3d(a, b, c, start.beyond);
}

}  // namespace

int winding_step(const Vec3d& a, const Vec3d& b, const Vec3d& c, const RayStart& start) {
  const Sign turn = orient2d(a, b, c, Axis::X);
  if (turn == Sign::Zero) return 0;
  if (turn_at(a, b, start) != turn || turn_at(b, c, start) != turn || turn_at(c, a, start) != turn) return 0;
  if (side_at(a, b, c, start) != turn) return 0;  // the triangle lies beyond the start
  return -static_cast<int>(turn);
}

Box3 ray_box(const RayStart& start) {
  Box3 ray;
  ray.lo = {-std::numeric_limits<double>::infinity(), start.at.y, start.at.z};
  ray.hi = start.at;
  return ray;
}

}  // namespace mortise
