// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How two faces touch: a pattern of exact signs, never a distance (paper 4, Figs. 8 and 9 without the tolerance).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mortise/geom/vec.h"

namespace mortise {

/// A corner, an edge (edge i runs from corner i to corner i + 1) or the inside of a triangle.
struct Feature {
  enum class Kind : std::uint8_t { Corner, Edge, Inside };
  Kind kind = Kind::Inside;
  std::uint8_t index = 0;

  bool operator==(const Feature&) const = default;
};

/// Does the closed edge i of a triangle contain the feature?
[[nodiscard]] bool is_on_edge(const Feature& feature, std::uint8_t edge);

/// One point common to two triangles: V-V, V-E, V-F, E-E or E-F by the kinds of the two features.
struct Incidence {
  Feature on_a, on_b;

  bool operator==(const Incidence&) const = default;
};

enum class PairContact : std::uint8_t {
  None,      ///< the closed triangles are disjoint
  Touching,  ///< they share one point, or the segment between two points
  Overlap,   ///< they lie in one plane and share area
};

struct PairClassification {
  PairContact contact = PairContact::None;
  std::vector<Incidence> incidences;  ///< distinct points; Touching: one or two; Overlap: all corners and crossings of edges
};

/// Corners and their positions; equal ids mean the same point.
struct TriangleCorners {
  std::array<std::uint32_t, 3> id;
  std::array<Vec3d, 3> position;
};

/// The contact of two triangles with area. Exact; O(1).
void classify_pair(const TriangleCorners& a, const TriangleCorners& b, PairClassification& result);

/// Where a point lies in a triangle of its plane; nothing when outside. `axis`: one along which the triangle has area.
/// @return true and the feature when the point is in the closed triangle
[[nodiscard]] bool locate_in_plane(const TriangleCorners& triangle, Axis axis, const Vec3d& point, Feature& feature);

}  // namespace mortise
