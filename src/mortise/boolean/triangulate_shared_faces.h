// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces with shared vertices in and on them become triangles, the same ones where faces lie on each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mortise/arrange/triangulate_region.h"
#include "mortise/boolean/shared_edges.h"

namespace mortise {

/// Triangulates faces one after the other, each with the edges of those before it.
class SharedFaceTriangulator {
 public:
  SharedFaceTriangulator(const SharedVertices& vertices, const SharedEdges& edges);

  /// @param corners    of the face
  /// @param inside     further vertices it gets, ascending, none of its edges
  /// @param triangles  receives what the face becomes, closed towards its edges as they are divided; maybe nothing
  /// @return false when something did not fit: it was left out, or the triangles fold
  /// O(n log n) in what lies on the face, but for vertices inside times vertices on its border.
  bool triangulate(const std::array<std::uint32_t, 3>& corners, std::span<const std::uint32_t> inside,
                   std::vector<std::array<std::uint32_t, 3>>& triangles);

 private:
  using Loop = std::vector<std::uint32_t>;

  /// A border, and all that was put into it so far.
  struct Plate;

  void join(const SharedEdge& e);
  bool set_plane(const std::array<std::uint32_t, 3>& corners);
  bool triangulate_loop(Loop loop, std::span<const std::uint32_t> inside, std::vector<std::array<std::uint32_t, 3>>& triangles);
  bool add_inside(std::span<const std::uint32_t> inside, Plate& plate) const;
  bool add_edges(Plate& plate) const;
  [[nodiscard]] bool is_simple(const Loop& loop) const;
  [[nodiscard]] bool lies_inside(std::uint32_t v, const Loop& loop) const;
  [[nodiscard]] bool leaves_inwards(std::uint32_t u, std::uint32_t v, const Plate& plate) const;
  [[nodiscard]] bool crosses(const SharedEdge& e, const SharedEdge& f) const;
  [[nodiscard]] bool passes(const SharedEdge& e, std::uint32_t v) const;
  [[nodiscard]] bool is_between(std::uint32_t u, std::uint32_t w, std::uint32_t v) const;
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] std::array<double, 2> seen(std::uint32_t v) const;
  [[nodiscard]] Box3 box_seen(const SharedEdge& e) const;

  const SharedVertices& vertices_;
  const SharedEdges& edges_;
  std::vector<std::vector<std::uint32_t>> edges_at_;  // per vertex: to these, ascending
  PointSet points_;
  std::vector<PointId> point_;
  Axis axis_ = Axis::X;
  Sign turn_ = Sign::Zero;
};

}  // namespace mortise
