// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Mesh vertices along model edges, while these change.
#pragma once

#include <vector>

#include "mortise/remesh/working_mesh.h"

namespace mortise {

/// Per model edge its mesh vertices from start to end.
[[nodiscard]] IdVector<ModelEdgeId, std::vector<VertexId>> trace_chains(const WorkingMesh& w);

/// A half-edge between two vertices on a model edge, in either direction; no_half_edge when there is none.
[[nodiscard]] HalfEdge find_step(const WorkingMesh& w, VertexId a, VertexId b, ModelEdgeId edge);

}  // namespace mortise
