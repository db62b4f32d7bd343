// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertices and edges of operands that share what lies within a tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Two numbers of shared vertices, the lower one first.
using SharedEdge = std::array<std::uint32_t, 2>;

[[nodiscard]] SharedEdge edge_between(std::uint32_t a, std::uint32_t b);

/// The box round some points, larger by a margin on every side.
[[nodiscard]] Box3 box_round(std::initializer_list<Vec3d> points, double margin);

/// Vertices that are found again by anything within the tolerance of them.
class SharedVertices {
 public:
  /// @param largest_coordinate  of all points that will come, without sign
  SharedVertices(double tolerance, double largest_coordinate);

  /// The nearest vertex within the tolerance, the lowest of equally near ones, or a new one here.
  std::uint32_t find_or_add(const Vec3d& p);

  [[nodiscard]] const Vec3d& operator[](std::uint32_t v) const { return points_[v]; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }

  static constexpr std::uint32_t none = 0xffffffffU;

 private:
  using Cell = std::array<double, 3>;

  [[nodiscard]] Cell cell_of(const Vec3d& p) const;
  [[nodiscard]] std::uint32_t nearest(const Vec3d& p) const;

  double tolerance_, cell_size_;
  std::vector<Vec3d> points_;
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

/// Edges of all operands, and the vertices put into them.
class SharedEdges {
 public:
  /// @param edges  any order, the same ones several times
  SharedEdges(SharedVertices& vertices, double tolerance, std::vector<SharedEdge> edges);

  /// Vertices within the tolerance of an edge, beside its ends, are put into it.
  void put_in_vertices(const ProgressCallback& progress);

  /// Edges that pass each other at less than the tolerance, without a vertex there, get one between them.
  void join_crossings(const ProgressCallback& progress);

  /// From a to b, both included.
  [[nodiscard]] std::vector<std::uint32_t> vertices_along(std::uint32_t a, std::uint32_t b) const;

  /// The edges between neighbours along an edge; ascending, each once.
  [[nodiscard]] std::vector<SharedEdge> pieces() const;

 private:
  struct Inside {
    double place;  // along the edge, from 0 to 1
    std::uint32_t vertex;

    bool operator<(const Inside& other) const { return place != other.place ? place < other.place : vertex < other.vertex; }
  };

  struct Piece {
    std::size_t edge;
    SharedEdge ends;
  };

  [[nodiscard]] std::size_t number_of(const SharedEdge& edge) const;
  [[nodiscard]] std::vector<Piece> all_pieces() const;
  void put_in_from(std::uint32_t first, const ProgressCallback& progress);
  void put_in_if_near(std::size_t edge, std::uint32_t v);
  void join(const Piece& p, const Piece& q);

  SharedVertices& vertices_;
  double tolerance_;
  std::vector<SharedEdge> edges_;            // ascending
  std::vector<std::vector<Inside>> inside_;  // per edge, from its lower vertex on
};

}  // namespace mortise
