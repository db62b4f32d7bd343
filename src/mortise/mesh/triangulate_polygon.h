// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cuts a polygon into triangles by exact ear clipping.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mortise/geom/vec.h"

namespace mortise {

struct PolygonTriangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< positions in the corners; each runs the way the polygon runs
  bool is_simple = true;                                ///< false: the projected polygon meets itself or has no area
};

/// Is a closed polygon free of contact with itself when projected along an axis? Exact; O(n log n) for ordinary polygons.
[[nodiscard]] bool is_simple_polygon(std::span<const Vec3d> corners, Axis axis);

/// n - 2 triangles over the n corners of a polygon, of any shape, in a plane or nearly so; nothing below three corners.
///
/// Works in the projection along the largest component of the polygon's normal. When that is a simple polygon every
/// triangle has area there, and no triangle holds a further corner when it is cut off, corners in straight edges included. A
/// polygon that meets itself is still cut up, always the same way, and reported. Finite coordinates. O(n r), r corners
/// that are not convex.
[[nodiscard]] PolygonTriangulation triangulate_polygon(std::span<const Vec3d> corners);

}  // namespace mortise
