// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The spacing of intersection curves as size sources (paper 7.3), so that surfaces near them are meshed as finely as they are.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mortise/base/ids.h"
#include "mortise/size/size_source.h"

namespace mortise {

/// A segment for each edge, of size length / number of edges of its chain. Chains end at points that have not two of the edges;
/// one without ends is closed.
///
/// @param points  of an intersection graph, or of a mesh
/// @param edges  of the graph; of a mesh find_graph_edges, or what lies on model edges; in any order, either end first
/// @return by ends, the lower first, each edge once; none for chains without length
/// @throws Error{InvalidArgument} naming edges between points that are not there
/// O(n log n).
[[nodiscard]] std::vector<SizeSource> sources_of_graph(std::span<const Vec3d> points, std::span<const std::array<VertexId, 2>> edges,
                                                       double growth);

}  // namespace mortise
