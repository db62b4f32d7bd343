// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Makes vertices of exactly equal position one vertex.
#pragma once

#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

struct WeldedMesh {
  SurfaceMesh mesh;
  std::vector<VertexId> new_vertex;  ///< per old vertex: its vertex in `mesh`
  std::vector<VertexId> old_vertex;  ///< per vertex of `mesh`: the lowest old one at its position
};

/// The mesh with one vertex per position: -0 equals +0, the lowest vertex's bits and order are kept.
///
/// All faces stay, in order and with their labels, those that now repeat a vertex too; so do vertices no face uses. All data become
/// corner data: vertices at one position may have had different values.
/// Needs a mesh whose indices are in range. O(n).
[[nodiscard]] WeldedMesh weld(const SurfaceMesh& mesh);

}  // namespace mortise
