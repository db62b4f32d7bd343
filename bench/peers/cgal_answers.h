// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// CGAL's answers (Polygon_mesh_processing, corefinement; exact predicates, doubles stored).
#pragma once

#include <span>

#include "shape.h"

namespace mortise::peers {

/// How exact a made coordinate of CGAL's is asked to be, relative to it. It decides by exact ones and rounds them last.
inline constexpr double cgal_precision = 1e-13;

/// What in CGAL's preconditions a mesh with shared vertices does not meet; empty: it may be an operand.
[[nodiscard]] std::string why_unfit_for_cgal(const SurfaceMesh& mesh);

struct CostOfUnion {
  Cost cost;
  double volume = 0;
};

/// The union of many, folded in runs of neighbours: see SpeedScene::runs. Building its meshes is not in the cost.
[[nodiscard]] CostOfUnion cgal_union(std::span<const SurfaceMesh> operands, std::span<const std::size_t> runs);

/// All four booleans, from one call. Operands must be fit.
[[nodiscard]] Answers cgal_answers(const SurfaceMesh& a, const SurfaceMesh& b, Depth depth);

}  // namespace mortise::peers
