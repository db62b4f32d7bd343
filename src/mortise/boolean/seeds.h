// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One known winding per complex: the region outside it, found by one exact ray.
#pragma once

#include <vector>

#include "mortise/boolean/patches.h"

namespace mortise {

/// Patches connected through junctions are a complex; `outside` is its region that reaches infinity if it were alone.
/// Complexes may touch each other in points.
struct Seed {
  RegionId outside;
  std::vector<int> winding;  ///< of every operand in `outside`, counted over all other complexes
};

/// One seed per complex (exact-core 4).
///
/// It is taken at the lexicographically smallest point of the complex, which is always an input point: a complex is made of
/// whole faces, and no point inside a face or an edge is smaller than all corners. The ray starts there and runs towards -x,
/// ties are broken by position; a face of another complex that contains the point is beyond its start.
/// O(n) in the facets, plus a walk down the box trees of all operands for each complex.
[[nodiscard]] std::vector<Seed> find_seeds(const OperandFaces& faces, const Facets& facets, const Patches& patches);

}  // namespace mortise
