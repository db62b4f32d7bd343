// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The faces of a mesh round an edge, in order of angle.
#pragma once

#include <array>
#include <vector>

#include "mortise/mesh/topology.h"

namespace mortise {

/// Sorts half-edges on the edge from edge[0] to edge[1] counterclockwise, looking from edge[1] to edge[0], by exact signs; the
/// start is arbitrary. Faces at one angle, and faces without a direction, in the order of their numbers.
void sort_round_edge(const SurfaceMesh& mesh, const std::array<VertexId, 2>& edge, std::vector<HalfEdge>& half_edges);

}  // namespace mortise
