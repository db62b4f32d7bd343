// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Builds a box tree: radix sort by Morton code (Lauterbach et al. 2009), split where the highest bit changes.
#include "mortise/geom/box_tree.h"

#include <algorithm>
#include <bit>

namespace mortise {
namespace {

constexpr std::uint32_t max_leaf_items = 4;
constexpr int bits_per_axis = 21;

struct CodedItem {
  std::uint64_t code;
  std::uint32_t id;
};

struct ItemRange {
  std::uint32_t node;
  std::uint32_t begin;
  std::uint32_t end;
};

/// Moves bit i of a 21-bit number to bit 3 i.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

/// Cuts space into cubes, 2^21 along the longest side. Works on quarters: no sum or difference can overflow.
class MortonGrid {
 public:
  explicit MortonGrid(const Box3& bounds) : origin_(0.25 * bounds.lo) {
    const Vec3d size = 0.25 * bounds.hi - origin_;
    size_ = std::max({size.x, size.y, size.z});
  }

  [[nodiscard]] std::uint64_t code_of(const Box3& box) const {
    const Vec3d from_origin = (0.125 * box.lo + 0.125 * box.hi) - origin_;
    return spread_bits(cell_of(from_origin.x)) << 2 | spread_bits(cell_of(from_origin.y)) << 1 | spread_bits(cell_of(from_origin.z));
  }

 private:
  [[nodiscard]] std::uint64_t cell_of(double from_origin) const {
    constexpr double cells = 1 << bits_per_axis;
    const double cell = from_origin / size_ * cells;
    if (!(cell > 0)) return 0;
    return static_cast<std::uint64_t>(std::min(cell, cells - 1));
  }

  Vec3d origin_;
  double size_ = 0;
};

/// Sorts by code; equal codes keep their order.
void radix_sort(std::vector<CodedItem>& items) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = 1 << digit_bits;
  std::vector<CodedItem> sorted(items.size());
  for (int shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
    std::vector<std::uint32_t> begin(digits + 1, 0);
    for (const CodedItem& item : items) ++begin[(item.code >> shift & (digits - 1)) + 1];
    for (std::size_t d = 0; d < digits; ++d) begin[d + 1] += begin[d];
    for (const CodedItem& item : items) sorted[begin[item.code >> shift & (digits - 1)]++] = item;
    items.swap(sorted);
  }
}

std::vector<CodedItem> sort_by_code(std::span<const Box3> boxes, const Box3& bounds) {
  const MortonGrid grid(bounds);
  std::vector<CodedItem> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) items[i] = {grid.code_of(boxes[i]), static_cast<std::uint32_t>(i)};
  radix_sort(items);
  return items;
}

/// The first item whose highest bit that varies in the range is set; the middle when all codes are equal.
std::uint32_t split_of(const std::vector<CodedItem>& items, const ItemRange& range) {
  const std::uint64_t varying = items[range.begin].code ^ items[range.end - 1].code;
  if (varying == 0) return range.begin + (range.end - range.begin) / 2;
  const std::uint64_t bit = std::uint64_t{1} << (63 - std::countl_zero(varying));
  const auto has_no_bit = [bit](const CodedItem& item) { return (item.code & bit) == 0; };
  const auto first = items.begin() + range.begin;
  return range.begin + static_cast<std::uint32_t>(std::partition_point(first, items.begin() + range.end, has_no_bit) - first);
}

std::vector<BoxTree::Node> build_nodes(const std::vector<CodedItem>& items) {
  std::vector<BoxTree::Node> nodes(1);
  std::vector<ItemRange> stack{{0, 0, static_cast<std::uint32_t>(items.size())}};
  while (!stack.empty()) {
    const ItemRange range = stack.back();
    stack.pop_back();
    if (range.end - range.begin <= max_leaf_items) {
      nodes[range.node].first = range.begin;
      nodes[range.node].count = range.end - range.begin;
      continue;
    }
    const std::uint32_t split = split_of(items, range);
    const auto left = static_cast<std::uint32_t>(nodes.size());
    nodes[range.node].first = left;
    nodes.resize(nodes.size() + 2);
    stack.push_back({left + 1, split, range.end});
    stack.push_back({left, range.begin, split});
  }
  return nodes;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) {
  if (boxes.empty()) return;
  Box3 bounds;
  for (const Box3& box : boxes) bounds.extend(box);
  const std::vector<CodedItem> sorted = sort_by_code(boxes, bounds);
  items_.reserve(boxes.size());
  for (const CodedItem& item : sorted) items_.push_back({boxes[item.id], item.id});
  nodes_ = build_nodes(sorted);
  fit_nodes();
}

void BoxTree::take_nodes(const BoxTree& other, std::vector<KeptItems> kept) {
  const std::vector<Node>& nodes = other.nodes_;
  for (std::size_t n = nodes.size(); n-- > 0;) {
    if (!nodes[n].is_leaf()) kept[n].count = kept[nodes[n].first].count + kept[nodes[n].first + 1].count;
  }
  if (items_.empty()) return;
  nodes_.emplace_back();
  std::vector<std::pair<std::uint32_t, std::size_t>> stack{{0, 0}};  // a node of the other tree and its place in this one
  while (!stack.empty()) {
    auto [from, to] = stack.back();
    stack.pop_back();
    while (!nodes[from].is_leaf() && (kept[nodes[from].first].count == 0 || kept[nodes[from].first + 1].count == 0)) {
      from = nodes[from].first + (kept[nodes[from].first].count == 0 ? 1 : 0);
    }
    if (nodes[from].is_leaf()) {
      nodes_[to].first = kept[from].first;
      nodes_[to].count = kept[from].count;
      continue;
    }
    const std::size_t left = nodes_.size();
    nodes_[to].first = static_cast<std::uint32_t>(left);
    nodes_.resize(left + 2);
    stack.emplace_back(nodes[from].first + 1, left + 1);
    stack.emplace_back(nodes[from].first, left);
  }
  fit_nodes();
}

/// Children come after their parents.
void BoxTree::fit_nodes() {
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    if (node.is_leaf()) {
      for (const Item& item : items_of(node)) node.box.extend(item.box);
    } else {
      node.box.extend(nodes_[node.first].box);
      node.box.extend(nodes_[node.first + 1].box);
    }
  }
  if (!nodes_.empty()) bounds_ = nodes_[0].box;
}

}  // namespace mortise
