// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/closest_pieces.h"

#include <cmath>
#include <limits>
#include <utility>

namespace mortise {

void ClosestPieces::add(const std::array<Vec3d, 3>& corners, std::uint8_t count) {
  Box3 box;
  for (std::size_t k = 0; k < count; ++k) box.extend(corners[k]);
  placed_.push_back(place_triangle(corners, count));
  boxes_.push_back(box);
}

void ClosestPieces::close() { tree_ = BoxTree(std::exchange(boxes_, {})); }

ClosestPiece ClosestPieces::closest(const Vec3d& p) {
  if (tree_.empty()) return {0, std::numeric_limits<double>::infinity()};
  double least = square_to(last_, p);
  stack_.assign(1, {0, 0});
  while (!stack_.empty()) {
    const auto [square, at] = stack_.back();
    stack_.pop_back();
    if (square >= least) continue;
    const BoxTree::Node& node = tree_.nodes()[at];
    if (node.is_leaf()) {
      look_in(node, p, least);
    } else {
      push_children(node.first, p, least);
    }
  }
  return {last_, std::sqrt(least)};
}

double ClosestPieces::distance_to(std::uint32_t piece, const Vec3d& p) const { return std::sqrt(square_to(piece, p)); }

double ClosestPieces::square_to(std::uint32_t piece, const Vec3d& p) const {
  const Vec3d way = in_space(placed_[piece], closest_in(placed_[piece], p).at) - p;
  return dot(way, way);
}

// The closer one on top.
void ClosestPieces::push_children(std::uint32_t first, const Vec3d& p, double least) {
  Waiting closer{square_distance(tree_.nodes()[first].box, p), first}, other{square_distance(tree_.nodes()[first + 1].box, p), first + 1};
  if (other.square < closer.square) std::swap(closer, other);
  if (other.square < least) stack_.push_back(other);
  if (closer.square < least) stack_.push_back(closer);
}

void ClosestPieces::look_in(const BoxTree::Node& leaf, const Vec3d& p, double& least) {
  for (const BoxTree::Item& item : tree_.items_of(leaf)) {
    if (square_distance(item.box, p) >= least) continue;
    const double square = square_to(item.id, p);
    if (square >= least) continue;
    least = square;
    last_ = item.id;
  }
}

}  // namespace mortise
