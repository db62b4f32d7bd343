// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How much the surface that triangles stand for bends, estimated from the turn of normals (after Rusinkiewicz 2004).
#pragma once

#include <vector>

#include "mortise/brep/face_normals.h"
#include "mortise/brep/model_queries.h"

namespace mortise {

/// Per triangle the larger of its principal curvatures without their signs; 0 where it is flat or too thin to tell.
///
/// Normals at vertices are averaged by angle, but not across model edges, seams excepted, and linear on triangles; their gradient is the
/// second fundamental form. Differs from Rusinkiewicz: triangles that share edges and a plane are one piece with their mean gradient, so
/// that it matters little how flat pieces are triangulated, slivers included. A piece with neighbours on one side only, at the border of
/// a face, comes out less curved, by up to half; one that a boolean cut narrower, more.
///
/// @param normals  per triangle of the mesh
/// @throws Error{InvalidArgument} when there is not one per triangle
/// O(n log n).
[[nodiscard]] std::vector<double> measure_curvatures(const ModelView& view, const FaceNormals& normals);

}  // namespace mortise
