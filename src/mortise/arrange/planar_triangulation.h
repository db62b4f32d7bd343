// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A triangulation of points of one plane that contains given edges (paper 5.1, Fig. 13); exact, no recursion.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "mortise/exact/point_set.h"

namespace mortise {

/// Triangulates the convex hull of points of one plane, seen along an axis along which the plane has area.
///
/// Points are inserted one by one along a space-filling curve, with swaps towards Delaunay (Lawson 1977); edges are recovered
/// by swaps of convex pairs. Which swaps improve the shape is decided in doubles (it decides no topology); which are possible
/// is decided exactly. O(n log n) for points that doubles can tell apart.
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

  // Where a point lies: in a cell, on a side or beyond a side of the hull.
  struct Place {
    Side side;
    bool is_outside, is_on_side;
  };
  static constexpr std::size_t few_vertices = 24;  // these are swapped once, at the end

  void take_shape();
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] std::vector<std::uint32_t> insertion_order() const;
  std::size_t add_first_cell();
  void insert(std::uint32_t p);
  [[nodiscard]] Place locate(std::uint32_t p);
  [[nodiscard]] Side seen_beside_last(std::uint32_t p) const;
  [[nodiscard]] bool sees(Side hull, std::uint32_t p) const;
  void add_outside(Side seen, std::uint32_t p);
  void split_cell(std::uint32_t cell, std::uint32_t p);
  void split_side(Side s, std::uint32_t p);
  std::array<std::uint32_t, 2> split_from_side(Side s, std::uint32_t p);
  std::uint32_t add_cell(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void link(Side s, Side t);
  void replace_neighbour(std::uint32_t cell, std::uint32_t before, Side now);
  [[nodiscard]] Side next_on_hull(Side s) const;
  [[nodiscard]] Side previous_on_hull(Side s) const;
  [[nodiscard]] std::uint32_t corner_index(std::uint32_t cell, std::uint32_t vertex) const;
  [[nodiscard]] Side find_side(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Side first_crossed(std::uint32_t a, std::uint32_t b) const;
  template <class Visit>
  void for_each_cell_at(std::uint32_t vertex, Visit visit) const;
  [[nodiscard]] bool is_swappable(Side s) const;
  [[nodiscard]] bool improves(Side s) const;
  Side swap(Side s);
  void swap_suspects();
  void fix(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> crossed_edges(std::uint32_t a, std::uint32_t b) const;

  const PointSet& points_;
  Axis axis_;
  std::span<const PointId> vertices_;
  std::span<const std::uint64_t> lines_;
  std::vector<std::array<double, 2>> shape_;  // positions in doubles within [0, 1], for judging shape only
  std::vector<std::uint32_t> order_;          // of insertion: vertices by their place in the plane
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> fixed_;
  std::vector<std::uint32_t> cell_at_;  // a cell of each vertex
  std::deque<Side> suspects_;           // sides that a swap may improve
  std::uint32_t last_ = none;           // the vertex inserted last, where the walk to the next one begins
  std::uint32_t walk_state_ = 0;
};

}  // namespace mortise
