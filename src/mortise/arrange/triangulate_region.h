// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangulates a piece of a plane given by its border.
#pragma once

#include <span>
#include <vector>

#include "mortise/exact/point_set.h"

namespace mortise {

/// Triangles of the bounded piece of a plane to the left of its borders, seen along an axis along which the plane has area.
///
/// @param border    directed segments that meet in ends only; holes run the other way round, slits occur in both directions
/// @param vertices  all ends, and points inside that must be corners; no two the same
/// @return counterclockwise seen along the axis, all of them with corners among the vertices
/// O(n log n)
[[nodiscard]] std::vector<PlanePoints> triangulate_region(const PointSet& points, Axis axis, std::span<const LinePoints> border,
                                                          std::span<const PointId> vertices);

}  // namespace mortise
