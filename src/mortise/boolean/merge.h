// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Step 12 of the paper: the kept facets become one compact mesh that knows where it comes from.
#pragma once

#include <span>
#include <vector>

#include "mortise/boolean/result.h"
#include "mortise/boolean/select.h"
#include "mortise/geom/coordinates.h"

namespace mortise {

/// The result as a mesh, and how it hangs on the arrangement.
struct MergedMesh {
  SurfaceMesh mesh;
  Provenance provenance;
  std::vector<PointId> point_of_vertex;                  ///< ascending: input points in the order of the operands, then made points
  std::vector<KeptFacet> facet_of_triangle;              ///< ascending, up to repairs
  std::vector<std::uint8_t> is_repaired;                 ///< per triangle: a repair gave it other corners than its facet has
  double rounding_displacement = 0;                      ///< the farthest rounding to float32 moved a vertex from its nearest doubles
  double repair_displacement = 0;                        ///< the farthest any repair moved a point of the surface
  std::vector<KeptFacet> facets_before_repair;           ///< facet_of_triangle before the first repair; empty when there was none
  bool keeps_all_sources = false;                        ///< Selection::keeps_all_sources
  IdVector<RegionId, std::uint32_t> covering_of_region;  ///< number of its covering set; none away from kept facets
};

/// One mesh of the kept facets; vertices are the nearest doubles of their points (paper 6.3), or the nearest float32 of these.
/// @throws Error{OutOfRange} when a coordinate does not fit a float32
/// O(n).
[[nodiscard]] MergedMesh merge(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Facets& facets,
                               const Selection& selection, Coordinates coordinates);

}  // namespace mortise
