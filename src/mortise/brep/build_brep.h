// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The discrete geometry builder: a model from any surface mesh (paper 2.1).
#pragma once

#include "mortise/brep/brep.h"
#include "mortise/brep/feature_edges.h"
#include "mortise/brep/seams.h"

namespace mortise {

struct BrepRules {
  FeatureRules features;
  double edge_angle_deg = 45;  ///< a model edge that turns more at a mesh vertex has a model vertex there; 180: it does not matter
  Seams seams = Seams::Annulus;
};

/// The model of a mesh: open or closed, with any number of triangles at an edge, of any number of regions. Faces are numbered by
/// their lowest triangles, edges by their lowest mesh edges, vertices by their mesh vertices, regions and shells by their faces.
///
/// @param normals  measure_normals, or source_normals for the result of an operation
/// @throws what validate and find_feature_edges do; Error{InvalidArgument} for an edge angle outside 0 .. 180, and naming triangles
///         that repeat a vertex
///         or when there is not one normal per triangle
/// O(n log n); linear apart from seams.
[[nodiscard]] ClassifiedBrep build_brep(const SurfaceMesh& mesh, const BrepRules& rules, const FaceNormals& normals);
[[nodiscard]] ClassifiedBrep build_brep(const SurfaceMesh& mesh, const BrepRules& rules = {});

}  // namespace mortise
