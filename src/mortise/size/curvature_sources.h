// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Curved faces and edges as size sources (paper 7.3): as fine as it takes to follow them.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "mortise/brep/face_normals.h"
#include "mortise/brep/model_queries.h"
#include "mortise/size/size_source.h"

namespace mortise {

/// At least one of the first two; of both the smaller size.
struct CurvatureRules {
  std::optional<double> chord_error{};        ///< how far the middle of an element may be from the surface or curve it stands for
  std::optional<double> segments_per_turn{};  ///< elements round a full circle
  double smallest = 0;                        ///< no size below this
  double largest = std::numeric_limits<double>::infinity();  ///< no source for a larger size
  double growth = 1.2;
};

/// The edge length of elements that follow a circle or cylinder or sphere of radius r. By chord error e of equilateral triangles
/// sqrt(6 e r - 3 ee), sqrt(3) r at most; of segments 2 sqrt(2 r e - ee), 2 r at most; by n per turn 2 pi r / n for both.
[[nodiscard]] double triangle_size_for(double radius, const CurvatureRules& rules);
[[nodiscard]] double segment_size_for(double radius, const CurvatureRules& rules);

/// A triangle for each of the mesh that is curved (measure_curvatures), then a segment for each of the mesh edges on curved model edges:
/// the radius is that of the smaller circle through both ends and the next vertex before or after, straight pieces taken as one. Seams are
/// not curved. What asks for more than the diagonal of the box round the mesh is flat.
///
/// The result of an operation has the curvature of its operands, but pieces of facets to tell it from: give sources of these.
///
/// @param normals  per triangle
/// @throws Error{InvalidArgument} for rules that are no positive numbers or neither of the first two, or not one normal per triangle
/// O(n log n).
[[nodiscard]] std::vector<SizeSource> sources_of_curvature(const ModelView& view, const CurvatureRules& rules, const FaceNormals& normals);

}  // namespace mortise
