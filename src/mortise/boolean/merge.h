// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Step 12 of the paper: the kept facets become one compact mesh that knows where it comes from.
#pragma once

#include <span>
#include <vector>

#include "mortise/boolean/result.h"
#include "mortise/boolean/select.h"

namespace mortise {

struct MergedMesh {
  SurfaceMesh mesh;
  Provenance provenance;
  std::vector<PointId> point_of_vertex;  ///< ascending: input points in the order of the operands, then made points
};

/// One mesh of the kept facets; vertices are the nearest doubles of their points (paper 6.3).
/// O(n).
[[nodiscard]] MergedMesh merge(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Facets& facets,
                               std::span<const KeptFacet> kept);

}  // namespace mortise
