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
/// whole faces, and no point inside a face or an edge is smaller than all corners. Other complexes may touch it there, so the
/// ray starts next to that point on an edge of the complex; it runs towards -x, ties are broken by position.
/// O(n) in the facets for each of few complexes, a walk down a box tree for each of many.
[[nodiscard]] std::vector<Seed> find_seeds(const OperandFaces& faces, const Facets& facets, const Patches& patches);

}  // namespace mortise
