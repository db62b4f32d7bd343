// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which triangles nothing keeps from being good ones of the size wanted: those away from small angles and small features of the model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/topology.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

/// What no mesh of the size wanted has good triangles at.
struct Obstacles {
  std::size_t frozen_edges = 0;    ///< model edges that were to stay as they are
  std::size_t short_edges = 0;     ///< others below 0.7 of the size, below 0.7 of three of them where closed
  std::size_t sharp_corners = 0;   ///< model edges that meet in a face below 60 degrees; a vertex with less than that round it in a face
  std::size_t close_features = 0;  ///< places on model edges with another part of those of the face nearer than the size, and nearer
                                   ///< than half of the way along them (so parts that meet at 60 degrees or more are not)
};

struct FreeTriangles {
  std::vector<std::uint8_t> is_free;  ///< per triangle: 0 when a vertex of it is within the size wanted there of an obstacle
  Obstacles obstacles;
};

/// Features are looked at at the vertices of the mesh and half-way between them. Seams are no features.
///
/// @param sizes  per vertex
/// @param frozen_edges  empty, or per model edge: 1 when it was to stay as it is
/// O(n log n) for edges of about the size.
[[nodiscard]] FreeTriangles find_free_triangles(const SurfaceMesh& mesh, const MeshTopology& topology, const ClassifiedBrep& model,
                                                const std::vector<double>& sizes, const std::vector<std::uint8_t>& frozen_edges);

}  // namespace mortise
