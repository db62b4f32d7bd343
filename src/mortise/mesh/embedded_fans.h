// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertices whose faces certainly do not cross one another: they spare most pairs of neighbours an exact test.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/topology.h"

namespace mortise {

/// Per vertex 1 when its faces are one closed fan that a projection along an axis lays out once round the vertex: two of them
/// then meet exactly in what they share. 0 says nothing: it is what corners, borders and uncertain signs get.
/// Faces may repeat vertices or have no area. O(n)
[[nodiscard]] std::vector<std::uint8_t> find_embedded_fans(const SurfaceMesh& mesh, const MeshTopology& topology);

}  // namespace mortise
