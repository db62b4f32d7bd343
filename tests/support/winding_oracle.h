// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Windings on both sides of facets by counting what a ray meets, in integers of any length.
#pragma once

#include <vector>

#include "support/arrangement.h"

namespace mortise::test {

/// Every operand's winding just in front of a facet, and just behind it.
struct WindingsBeside {
  std::vector<int> front, back;

  bool operator==(const WindingsBeside&) const = default;
};

/// By facet. Brute force over all faces; it shares no code with the library. Throws std::logic_error where the middle of a facet
/// lies on an edge: then the facets are wrong.
[[nodiscard]] std::vector<WindingsBeside> windings_beside_facets(const Arrangement& scene);

}  // namespace mortise::test
