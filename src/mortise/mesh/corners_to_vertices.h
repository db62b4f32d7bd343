// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A mesh whose data all are vertex data, for buffers of a graphics card and for formats that know no corners.
#pragma once

#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

struct MeshOfVertices {
  SurfaceMesh mesh;                     ///< the same triangles, no corner data
  std::vector<VertexId> source_vertex;  ///< per vertex, ascending: the vertex it is a copy of
};

/// The mesh with a vertex for every set of values that corners of its triangles have at a vertex, in the order of their first
/// corners; -0 becomes 0, vertices without triangles go. The surface stays the same, but is open where values differ: along seams.
///
/// @param missing  put where there is no value; where a normal has none, it is that of its triangle, of length 1. NaN: both stay
/// @throws what validate() throws
/// O(n log k) for k corners at a vertex.
[[nodiscard]] MeshOfVertices corners_to_vertices(const SurfaceMesh& mesh, double missing);

}  // namespace mortise
