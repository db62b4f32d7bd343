// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A plane as people give it.
#pragma once

#include "mortise/geom/vec.h"

namespace mortise {

/// The points p with normal . p = offset. The normal points to the front; its length does not matter.
struct Plane {
  Vec3d normal{0, 0, 1};
  double offset = 0;
};

}  // namespace mortise
