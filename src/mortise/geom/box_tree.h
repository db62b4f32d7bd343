// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A static tree of closed boxes that finds the boxes meeting a box, and the meeting pairs of two trees or of one.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mortise/geom/vec.h"

namespace mortise {

/// Boxes in Morton order of their centres under a binary tree. The shape depends on the boxes and their order only.
///
/// Built in linear time for a fixed number of bits; any finite range of coordinates; equal boxes are fine; an empty box
/// meets nothing. Visits come in a fixed order that is not sorted. No function recurses.
class BoxTree {
 public:
  struct Node {
    Box3 box;
    std::uint32_t first = 0;  ///< leaf: position of the first item; inner: left child, the right child follows it
    std::uint32_t count = 0;  ///< items of a leaf; 0 for an inner node
    [[nodiscard]] bool is_leaf() const { return count != 0; }
  };
  struct Item {
    Box3 box;
    std::uint32_t id = 0;  ///< position in the boxes the tree was built from
  };

  BoxTree() = default;
  explicit BoxTree(std::span<const Box3> boxes);

  /// The tree of some of the items over other boxes: box_of(id) instead of that of item id, left out where that is empty. Items
  /// below a node are left out unasked unless may_keep(box of the node) holds. Its shape is what is left of this one.
  template <class MayKeep, class BoxOf>
  [[nodiscard]] BoxTree with_boxes(MayKeep may_keep, BoxOf box_of) const;

  /// Calls visit(node) for each leaf such that may_hold(box) holds for it and all nodes above it.
  template <class MayHold, class Visit>
  void for_each_leaf_below(MayHold may_hold, Visit visit) const;

  /// Calls visit(item) once for each box that shares a point with `query`.
  template <class Visit>
  void for_each_meeting(const Box3& query, Visit visit) const;

  /// The box round all boxes; empty when there are none.
  [[nodiscard]] const Box3& bounds() const { return bounds_; }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] std::size_t size() const { return items_.size(); }

  /// The root is node 0; there is no node when the tree is empty.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  [[nodiscard]] std::span<const Item> items_of(const Node& leaf) const {
    return std::span<const Item>(items_).subspan(leaf.first, leaf.count);
  }

 private:
  /// Items below a node that stay.
  struct KeptItems {
    std::uint32_t first = 0, count = 0;
  };

  void fit_nodes();
  /// Takes over the nodes of another tree with anything below them.
  void take_nodes(const BoxTree& other, std::vector<KeptItems> kept);

  std::vector<Node> nodes_;
  std::vector<Item> items_;
  Box3 bounds_;
};

template <class MayHold, class Visit>
void BoxTree::for_each_leaf_below(MayHold may_hold, Visit visit) const {
  std::vector<std::uint32_t> stack;
  if (!nodes_.empty() && may_hold(nodes_[0].box)) stack.push_back(0);
  while (!stack.empty()) {
    const std::uint32_t n = stack.back();
    stack.pop_back();
    if (nodes_[n].is_leaf()) {
      visit(n);
      continue;
    }
    for (const std::uint32_t child : {nodes_[n].first + 1, nodes_[n].first}) {
      if (may_hold(nodes_[child].box)) stack.push_back(child);
    }
  }
}

template <class MayKeep, class BoxOf>
BoxTree BoxTree::with_boxes(MayKeep may_keep, BoxOf box_of) const {
  BoxTree tree;
  std::vector<KeptItems> kept(nodes_.size());
  for_each_leaf_below(may_keep, [&](std::uint32_t leaf) {
    kept[leaf].first = static_cast<std::uint32_t>(tree.items_.size());
    for (const Item& item : items_of(nodes_[leaf])) {
      const Box3 box = box_of(item.id);
      if (!box.is_empty()) tree.items_.push_back({box, item.id});
    }
    kept[leaf].count = static_cast<std::uint32_t>(tree.items_.size()) - kept[leaf].first;
  });
  tree.take_nodes(*this, std::move(kept));
  return tree;
}

template <class Visit>
void BoxTree::for_each_meeting(const Box3& query, Visit visit) const {
  if (nodes_.empty() || !boxes_meet(nodes_[0].box, query)) return;
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (node.is_leaf()) {
      for (const Item& item : items_of(node)) {
        if (boxes_meet(item.box, query)) visit(item.id);
      }
      continue;
    }
    for (const std::uint32_t child : {node.first + 1, node.first}) {
      if (boxes_meet(nodes_[child].box, query)) stack.push_back(child);
    }
  }
}

namespace box_tree_detail {

using NodePair = std::pair<std::uint32_t, std::uint32_t>;

/// Is the first box at least as long, over the three axes together?
[[nodiscard]] inline bool is_longer(const Box3& a, const Box3& b) {
  const Vec3d size_a = a.hi - a.lo;
  const Vec3d size_b = b.hi - b.lo;
  return size_a.x + size_a.y + size_a.z >= size_b.x + size_b.y + size_b.z;
}

template <class Visit>
void visit_leaf_pair(std::span<const BoxTree::Item> items_a, std::span<const BoxTree::Item> items_b, Visit& visit) {
  for (const BoxTree::Item& a : items_a) {
    for (const BoxTree::Item& b : items_b) {
      if (boxes_meet(a.box, b.box)) visit(a.id, b.id);
    }
  }
}

/// The same for two leaves: most of the first one's boxes do not come near the second.
template <class Visit>
void visit_leaves(const BoxTree& a, const BoxTree::Node& leaf_a, const BoxTree& b, const BoxTree::Node& leaf_b, Visit& visit) {
  const std::span<const BoxTree::Item> items_a = a.items_of(leaf_a), items_b = b.items_of(leaf_b);
  for (std::size_t i = 0; i < items_a.size(); ++i) {
    if (boxes_meet(items_a[i].box, leaf_b.box)) visit_leaf_pair(items_a.subspan(i, 1), items_b, visit);
  }
}

/// Visits two leaves, or pushes the meeting pairs below two different nodes.
template <class Visit>
void descend(const BoxTree& a, const BoxTree& b, NodePair pair, std::vector<NodePair>& stack, Visit& visit) {
  const BoxTree::Node& node_a = a.nodes()[pair.first];
  const BoxTree::Node& node_b = b.nodes()[pair.second];
  if (node_a.is_leaf() && node_b.is_leaf()) return visit_leaves(a, node_a, b, node_b, visit);
  if (node_b.is_leaf() || (!node_a.is_leaf() && is_longer(node_a.box, node_b.box))) {
    for (const std::uint32_t child : {node_a.first + 1, node_a.first}) {
      if (boxes_meet(a.nodes()[child].box, node_b.box)) stack.emplace_back(child, pair.second);
    }
    return;
  }
  for (const std::uint32_t child : {node_b.first + 1, node_b.first}) {
    if (boxes_meet(node_a.box, b.nodes()[child].box)) stack.emplace_back(pair.first, child);
  }
}

/// Visits the meeting pairs inside one leaf.
template <class Visit>
void visit_leaf(std::span<const BoxTree::Item> items, Visit& visit) {
  for (std::size_t i = 0; i < items.size(); ++i) visit_leaf_pair(items.subspan(i, 1), items.subspan(i + 1), visit);
}

}  // namespace box_tree_detail

/// Calls visit(item_a, item_b) once for each pair of boxes, one of each tree, that share a point.
template <class Visit>
void for_each_meeting_pair(const BoxTree& a, const BoxTree& b, Visit visit) {
  if (a.empty() || b.empty() || !boxes_meet(a.bounds(), b.bounds())) return;
  std::vector<box_tree_detail::NodePair> stack{{0U, 0U}};
  while (!stack.empty()) {
    const box_tree_detail::NodePair pair = stack.back();
    stack.pop_back();
    box_tree_detail::descend(a, b, pair, stack, visit);
  }
}

/// Calls visit(i, j), i < j, once for each pair of boxes of one tree that share a point.
template <class Visit>
void for_each_meeting_pair_within(const BoxTree& tree, Visit visit) {
  if (tree.empty()) return;
  auto visit_sorted = [&visit](std::uint32_t a, std::uint32_t b) { a < b ? visit(a, b) : visit(b, a); };
  std::vector<box_tree_detail::NodePair> stack{{0U, 0U}};
  while (!stack.empty()) {
    const box_tree_detail::NodePair pair = stack.back();
    stack.pop_back();
    if (pair.first != pair.second) {
      box_tree_detail::descend(tree, tree, pair, stack, visit_sorted);
      continue;
    }
    const BoxTree::Node& node = tree.nodes()[pair.first];
    if (node.is_leaf()) {
      box_tree_detail::visit_leaf(tree.items_of(node), visit_sorted);
      continue;
    }
    const std::uint32_t left = node.first;
    if (boxes_meet(tree.nodes()[left].box, tree.nodes()[left + 1].box)) stack.emplace_back(left, left + 1);
    stack.emplace_back(left + 1, left + 1);
    stack.emplace_back(left, left);
  }
}

}  // namespace mortise
