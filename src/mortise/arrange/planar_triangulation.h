// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A triangulation of points of one plane that contains given edges (paper 5.1, Fig. 13); exact, no recursion.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mortise/exact/point_set.h"

namespace mortise {

/// Triangulates the convex hull of points of one plane, seen along an axis along which the plane has area.
///
/// Sweep over the points in lexicographic order, swaps towards Delaunay, recovery of edges by swaps of convex pairs. Which
/// swaps improve the shape is decided in doubles (it decides no topology); which are possible is decided exactly.
class PlanarTriangulation {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Neighbour i lies across the edge from corner i to corner i + 1.
  struct Cell {
    std::array<std::uint32_t, 3> corner;
    std::array<std::uint32_t, 3> neighbour;
  };

  /// @param points  different points, not all on one line
  /// @param lines   per point: bit i set when it lies on line i; three points with a common bit are on one line
  PlanarTriangulation(const PointSet& points, Axis axis, std::span<const PointId> vertices, std::span<const std::uint64_t> lines);

  /// Makes the segment from vertex a to vertex b an edge that stays; no vertex lies inside it and it crosses no such edge.
  void recover_edge(std::uint32_t a, std::uint32_t b);

  /// The same for many segments, in an order that depends on where their ends are and not on their numbers.
  void recover_edges(std::span<const std::array<std::uint32_t, 2>> segments);

  /// Swaps every edge that may go towards Delaunay.
  void improve();

  /// Counterclockwise seen along the axis; they tile the convex hull.
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] bool is_fixed(std::uint32_t cell, std::size_t edge) const { return fixed_[3 * cell + edge] != 0; }

 private:
  struct Side {
    std::uint32_t cell, edge;
  };

  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] std::vector<std::uint32_t> sweep_order() const;
  void take_shape();
  void sweep();
  std::size_t start_sweep(const std::vector<std::uint32_t>& order);
  void add_outside(std::uint32_t previous, std::uint32_t p);
  void add_start_cells(const std::vector<std::uint32_t>& order, std::size_t apex, bool is_left);
  std::uint32_t add_cell(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void link(Side s, Side t);
  [[nodiscard]] std::size_t corner_index(std::uint32_t cell, std::uint32_t vertex) const;
  [[nodiscard]] Side find_side(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Side first_crossed(std::uint32_t a, std::uint32_t b) const;
  template <class Visit>
  void for_each_cell_at(std::uint32_t vertex, Visit visit) const;
  [[nodiscard]] bool is_swappable(Side s) const;
  [[nodiscard]] bool improves(Side s) const;
  Side swap(Side s);
  void fix(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> crossed_edges(std::uint32_t a, std::uint32_t b) const;

  const PointSet& points_;
  Axis axis_;
  std::span<const PointId> vertices_;
  std::span<const std::uint64_t> lines_;
  std::vector<std::uint32_t> order_;          // of the sweep: vertices by their place in the plane
  std::vector<std::array<double, 2>> shape_;  // positions in doubles, for judging shape only
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> fixed_;
  std::vector<std::uint32_t> cell_at_;  // a cell of each vertex
  std::vector<std::uint32_t> hull_next_, hull_previous_;
  std::vector<Side> hull_side_;  // inner side of the hull edge from each vertex to its next
};

}  // namespace mortise
