// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/geom/placed_triangle.h"

#include <algorithm>

#include "mortise/geom/length.h"

namespace mortise {
namespace {

Vec3d unit(const Vec3d& v) {
  const double size = length(v);
  return size > 0 ? Vec3d{v.x / size, v.y / size, v.z / size} : Vec3d{};
}

// The closest point of the segment from a to b.
PlanePoint closest_between(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return {a.x + t * dx, a.y + t * dy};
}

double square_between(const PlanePoint& a, const PlanePoint& b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

}  // namespace

std::size_t longest_edge_of(const std::array<Vec3d, 3>& corners) {
  std::size_t first = 0;
  double longest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double size = length(corners[(k + 1) % 3] - corners[k]);
    if (size > longest) first = k;
    longest = std::max(longest, size);
  }
  return first;
}

PlacedTriangle place_triangle(const std::array<Vec3d, 3>& corners, std::uint8_t count) {
  PlacedTriangle t;
  t.corner_count = count;
  t.first = count == 3 ? static_cast<std::uint8_t>(longest_edge_of(corners)) : std::uint8_t{0};
  t.origin = corners[t.first];
  if (count == 1) return t;
  const Vec3d along = corners[(t.first + 1U) % 3] - t.origin;
  t.axis_x = unit(along);
  t.length = length(along);
  if (count == 2) return t;
  const Vec3d to_apex = corners[(t.first + 2U) % 3] - t.origin;
  t.apex_x = dot(to_apex, t.axis_x);
  const Vec3d height = to_apex - t.apex_x * t.axis_x;
  t.apex_y = length(height);
  const Vec3d rough = unit(height);
  t.axis_y = unit(rough - dot(rough, t.axis_x) * t.axis_x);
  return t;
}

ClosestPlace closest_in(const PlacedTriangle& t, const Vec3d& p) {
  const Vec3d from = p - t.origin;
  const PlanePoint at{dot(from, t.axis_x), dot(from, t.axis_y)}, apex{t.apex_x, t.apex_y};
  if (t.corner_count < 3 || !(at.y > 0)) return {{std::clamp(at.x, 0.0, t.length), 0}, false, t.first};
  const bool is_left = apex.x * at.y - apex.y * at.x > 0;
  const bool is_right = (at.x - t.length) * apex.y - (apex.x - t.length) * at.y > 0;
  if (!is_left && !is_right && at.y <= apex.y) return {at, true};
  const PlanePoint left = closest_between({0, 0}, apex, at), right = closest_between({t.length, 0}, apex, at);
  const bool is_on_left = square_between(left, at) <= square_between(right, at);
  return {is_on_left ? left : right, false, static_cast<std::uint8_t>((t.first + (is_on_left ? 2U : 1U)) % 3)};
}

}  // namespace mortise
