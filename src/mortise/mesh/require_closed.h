// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Refuses meshes that bound nothing.
#pragma once

#include <string_view>

#include "mortise/mesh/surface_mesh.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/weld.h"

namespace mortise {

/// Checks that along every edge of a welded mesh as many faces run one way as the other.
/// @param stage  who asks
/// @throws Error{NotClosed} when an odd number of faces ends at some edge, else Error{NotOriented}; the ids are vertex pairs of
/// the mesh that was welded
void require_closed(const WeldedMesh& welded, const MeshTopology& topology, std::string_view stage);

}  // namespace mortise
