// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How far two meshes of one model are apart: surfaces and model edges, both ways. No code of the remesher it judges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

/// What is measured against what.
enum class Matching : std::uint8_t {
  None,      ///< any point against all of the other mesh
  Faces,     ///< model faces against those of the same number, model edges against all
  Entities,  ///< model edges too against those of the same number
};

/// From points of one to the closest points of the other: zeros without points, infinite where there is no other.
struct OneWayDistance {
  double greatest = 0;
  double in_sizes = 0;  ///< the greatest in units of the size wanted at the point
  Vec3d at;             ///< where that is
};

struct Deviation {
  OneWayDistance to_reference, from_reference;                ///< at vertices, middles of edges and centroids of triangles
  OneWayDistance curves_to_reference, curves_from_reference;  ///< of model edges: at vertices; at vertices and middles between them
  std::vector<std::array<double, 2>> of_faces;  ///< per model face in_sizes to and from the reference; empty when none are matched
};

/// One-sided Hausdorff distances from so many points to the exact surfaces and polylines.
///
/// @throws Error{InvalidArgument} when what is to be matched differs in number
/// O(n log n) where the meshes are close.
[[nodiscard]] Deviation measure_deviation(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SurfaceMesh& reference,
                                          const ClassifiedBrep& reference_model, const SizingProxy& sizes, Matching matching);

}  // namespace mortise
