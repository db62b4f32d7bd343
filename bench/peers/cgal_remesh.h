// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// CGAL's answer (Polygon_mesh_processing, isotropic remeshing of three iterations).
#pragma once

#include "../remesh/remesher_answer.h"

namespace mortise::peers {

/// What happens to model edges.
enum class ModelEdges : std::uint8_t {
  Protected,   ///< split to the size beforehand, as CGAL asks for, then left alone
  Constrained  ///< split and collapsed along themselves, model vertices left alone
};

/// With the edges of our model constrained. Building CGAL's mesh and taking the result out again are not in the cost.
[[nodiscard]] RemesherAnswer cgal_remesh(const SurfaceMesh& mesh, const ClassifiedBrep& model, double size, ModelEdges edges);

}  // namespace mortise::peers
