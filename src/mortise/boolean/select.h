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
  RegionId inside;       ///< on its inner side
  RegionId outside{};    ///< on its other side
  bool is_wall = false;  ///< the result lies on both sides, or on neither
};

struct Selection {
  std::vector<KeptFacet> kept;                                 ///< ascending
  IdVector<RegionId, std::vector<OperandId>> operands_inside;  ///< operands that contain a region of the result; else empty
  bool keeps_walls = false;                                    ///< some facets may be walls
  bool keeps_regions_apart = false;                            ///< regions of different operands are different
  bool keeps_all_sources = false;                              ///< of every operand, so that each stays closed by itself
  bool is_cut_by_sheets = false;                               ///< some walls divide a solid that loses what lies behind them
};

/// Does a region with these windings belong to the result?
[[nodiscard]] bool is_inside_result(Operation operation, const RunningWinding& winding);

/// Does a region with these windings belong to the result? A walk asks once for every region.
using InsideRule = std::function<bool(const RunningWinding&)>;

/// The facets of the result (paper 6.2, Fig. 16: the tags 10, 11, 20, 21 are names for the four cases of n = 2).
///
/// Sheets are sets of points without volume: no region lies inside one. A sheet's facet belongs to the result where the rule
/// holds for the operands that contain the facet, a solid's boundary being part of the solid, unless the result has volume on
/// a side of it. Sheets that are subtracted from a solid are kept as walls inside it (cut_by_sheets).
/// O(facets + regions).
[[nodiscard]] Selection select(const InsideRule& is_inside, const OperandFaces& faces, const Facets& facets, const Categories& categories);
[[nodiscard]] Selection select(Operation operation, const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// The facets on whose sides different operands are, those of the union and those between its regions, and all walls.
[[nodiscard]] Selection select_partition(const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// Every facet, none flipped.
[[nodiscard]] Selection select_all(const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// The facets on whose sides different operands are when the last of those that contain a region has it for itself; turned
/// outwards of the later operand.
[[nodiscard]] Selection select_implant(const OperandFaces& faces, const Facets& facets, const Categories& categories);

/// The facets that change any winding or are walls, none flipped.
[[nodiscard]] Selection select_cut_faces(const OperandFaces& faces, const Facets& facets, const Categories& categories);

}  // namespace mortise
