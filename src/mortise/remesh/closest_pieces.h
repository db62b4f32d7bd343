// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The closest of many triangles, or segments, to points near one another.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mortise/geom/box_tree.h"
#include "mortise/geom/placed_triangle.h"

namespace mortise {

struct ClosestPiece {
  std::uint32_t piece = 0;  ///< in the order they were added
  double distance = 0;      ///< infinite where there is none
};

class ClosestPieces {
 public:
  /// @param count  of the corners: 2 for a segment, 3 for a triangle
  void add(const std::array<Vec3d, 3>& corners, std::uint8_t count);
  /// After the last was added, before the first question.
  void close();

  /// The last answer is where the next search starts, so points near one another are best asked for in turn; in another order a distance
  /// may differ in its last bits.
  [[nodiscard]] ClosestPiece closest(const Vec3d& p);

  [[nodiscard]] double distance_to(std::uint32_t piece, const Vec3d& p) const;
  [[nodiscard]] const PlacedTriangle& placed(std::uint32_t piece) const { return placed_[piece]; }

 private:
  /// A node to look at, and the square of the way to its box.
  struct Waiting {
    double square = 0;
    std::uint32_t node = 0;
  };

  [[nodiscard]] double square_to(std::uint32_t piece, const Vec3d& p) const;
  void push_children(std::uint32_t first, const Vec3d& p, double least);
  void look_in(const BoxTree::Node& leaf, const Vec3d& p, double& least);

  std::vector<PlacedTriangle> placed_;
  std::vector<Box3> boxes_;
  BoxTree tree_;
  std::vector<Waiting> stack_;
  std::uint32_t last_ = 0;
};

}  // namespace mortise
