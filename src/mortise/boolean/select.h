// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Step 11 of the paper: an operation is a predicate on "inside operand k"; a facet stays where it differs on the two sides.
#pragma once

#include <vector>

#include "mortise/boolean/categorize.h"
#include "mortise/boolean/operation.h"

namespace mortise {

/// A facet of the result.
struct KeptFacet {
  FacetId facet;
  bool is_flipped = false;  ///< the inside of the result lies in front of the facet
};

/// Does a region with these windings belong to the result?
[[nodiscard]] bool is_inside_result(Operation operation, const RunningWinding& winding);

/// The facets of the result, ascending (paper 6.2, Fig. 16: the tags 10, 11, 20, 21 are names for the four cases of n = 2).
/// O(facets + regions).
[[nodiscard]] std::vector<KeptFacet> select(Operation operation, const OperandFaces& faces, const Facets& facets,
                                            const Categories& categories);

}  // namespace mortise
