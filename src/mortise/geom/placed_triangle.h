// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A triangle, a segment or a point in axes of its own, where its closest point takes few operations and slivers do no harm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mortise/geom/vec.h"

namespace mortise {

struct PlanePoint {
  double x = 0, y = 0;
};

struct ClosestPlace {
  PlanePoint at;
  bool is_inside = false;  ///< a foot of the perpendicular, on no edge
  std::uint8_t edge = 0;   ///< otherwise: it is on the edge from this corner to the next
};

/// The longest edge runs from the origin along the first axis; the third corner lies above it, between its ends.
struct PlacedTriangle {
  Vec3d origin, axis_x, axis_y;   ///< axes of length 1, or zero where there is no direction
  double length = 0;              ///< the second corner is (length, 0)
  double apex_x = 0, apex_y = 0;  ///< the third corner, apex_y >= 0
  std::uint8_t corner_count = 3;  ///< 1 point, 2 segment
  std::uint8_t first = 0;         ///< the corner at the origin; the others follow in turn
};

/// The corner the longest edge of a triangle starts from; of equal ones the first.
[[nodiscard]] std::size_t longest_edge_of(const std::array<Vec3d, 3>& corners);

/// @param count  1 to 3 of the corners
[[nodiscard]] PlacedTriangle place_triangle(const std::array<Vec3d, 3>& corners, std::uint8_t count = 3);

/// The closest point of it to one of space, in its axes.
[[nodiscard]] ClosestPlace closest_in(const PlacedTriangle& t, const Vec3d& p);

[[nodiscard]] inline Vec3d in_space(const PlacedTriangle& t, const PlanePoint& p) { return t.origin + p.x * t.axis_x + p.y * t.axis_y; }

}  // namespace mortise
