// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What may part faces in the model of a result, beside angles: where operands met, and which they are.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mortise/mesh/provenance.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Mesh edges of a result that lie on the intersection graph, for FeatureRules::user_edges: where facets of different operands meet, or of
/// one operand at different places to the others (FacetCategory, covering sets). Not where an operation left nothing of what touched a face
/// from behind. The lower vertex first, ascending.
/// @throws Error{InvalidArgument} when there is not one source per triangle
/// O(n log n).
[[nodiscard]] std::vector<std::array<VertexId, 2>> find_graph_edges(const SurfaceMesh& mesh, const Provenance& provenance);

/// Groups of facets for FeatureRules::groups: those of the same operands, all their sources counted, share one.
[[nodiscard]] std::vector<std::uint32_t> group_by_operands(const Provenance& provenance);

}  // namespace mortise
