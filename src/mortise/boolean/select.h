// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Step 11 of the paper: an operation is a predicate on "inside operand k"; a facet stays where it differs on the two sides.
#pragma once

#include <functional>
#include <vector>

#include "mortise/boolean/categorize.h"
#include "mortise/boolean/operation.h"
#include "mortise/mesh/provenance.h"

namespace mortise {

/// A facet of the result.
struct KeptFacet {
  FacetId facet;
  bool is_flipped = false;  ///< the inside of the result lies in front of the facet
  FacetCategory category = FacetCategory::Outside;
  RegionId inside;     ///< on its inner side
  RegionId outside{};  ///< on its other side
};

struct Selection {
  std::vector<KeptFacet> kept;                                 ///< ascending
  IdVector<RegionId, std::vector<OperandId>> operands_inside;  ///< operands that contain a region of the result; else empty
  bool keeps_inner_faces = false;                              ///< both sides of a facet may belong to the result
  bool keeps_all_sources = false;                              ///< of every operand, so that each stays closed by itself
};

/// Does a region with these windings belong to the result?
[[nodiscard]] bool is_inside_result(Operation operation, const RunningWinding& winding);

/// Does a region with these windings belong to the result? A walk asks once for every region.
using InsideRule = std::function<bool(const RunningWinding&)>;

/// The facets of the result (paper 6.2, Fig. 16: the tags 10, 11, 20, 21 are names for the four cases of n = 2).
/// O(facets + regions).
[[nodiscard]] Selection select(const InsideRule& is_inside, const OperandFaces& faces, const Facets& facets, const Categories& categories);
[[nodiscard]] Selection select(Operation operation, const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// The facets on whose sides different operands are: those of the union, and those between its regions.
[[nodiscard]] Selection select_partition(const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// Every facet, none flipped.
[[nodiscard]] Selection select_all(const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// The facets on whose sides different operands are when the last of those that contain a region has it for itself; turned
/// outwards of the later operand.
[[nodiscard]] Selection select_implant(const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// The facets that change any winding, none flipped.
[[nodiscard]] Selection select_cut_faces(const OperandFaces& faces, const Facets& facets, const Categories& categories);

}  // namespace mortise
