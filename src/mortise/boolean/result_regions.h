// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The solids a result consists of, and who covers them.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/boolean/result.h"

namespace mortise {

struct ResultRegion {
  std::vector<std::uint32_t> operands;  ///< that contain the region next to its boundary, ascending
  double volume = 0;
  double area = 0;  ///< of its whole boundary
};

struct ResultRegions {
  std::vector<std::uint32_t> region_of_facet;  ///< the region behind it; in front of it is none
  std::vector<ResultRegion> regions;           ///< in the order of their lowest facets
};

/// Connected solids of a certified result; bodies that touch in an edge or a corner are two.
/// O(n log n) in facets.
[[nodiscard]] ResultRegions find_result_regions(const BooleanResult& result);

}  // namespace mortise
