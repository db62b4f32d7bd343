// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which faces stay together where a mesh touches itself.
#pragma once

#include <vector>

#include "mortise/mesh/topology.h"

namespace mortise {

inline constexpr HalfEdge no_partner = 0xffffffffU;

/// Per half-edge the one on its edge it stays joined with when split_pinches takes the mesh apart: the other one of two; of
/// more, the one that bounds the same wedge of the inside. no_partner where there is none. O(n log k) for at most k faces round
/// an edge.
[[nodiscard]] std::vector<HalfEdge> find_wedge_partners(const SurfaceMesh& mesh, const MeshTopology& topology);

}  // namespace mortise
