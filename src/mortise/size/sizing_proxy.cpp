// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/sizing_proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mortise/base/error.h"

namespace mortise {
namespace {

constexpr double epsilon = 256 * std::numeric_limits<double>::epsilon();
constexpr std::size_t deepest = 128;  // more than a tree over boxes in Morton order can be

void check_limits(const SizeLimits& limits) {
  const bool is_fine =
      limits.global <= std::numeric_limits<double>::max() && limits.global > 0 && limits.smallest >= 0 && limits.smallest <= limits.global;
  if (!is_fine)
    throw Error(ErrorCode::InvalidArgument, "sizing_proxy", "sizes must be finite, with 0 <= smallest <= global and global > 0");
}

Box3 box_of(const SizeSource& source) {
  Box3 box;
  for (std::size_t k = 0; k < source.corner_count; ++k) box.extend(source.corners[k]);
  const double by = source.radius * (1 + epsilon);
  return {box.lo - Vec3d{by, by, by}, box.hi + Vec3d{by, by, by}};
}

}  // namespace

SizingProxy::SizingProxy(std::span<const SizeSource> sources, const SizeLimits& limits) : limits_(limits) {
  check_limits(limits);
  *this = with(sources);
}

SizingProxy SizingProxy::with(std::span<const SizeSource> more) const {
  check_sources(more);
  std::vector<Box3> boxes;
  for (const BoxTree::Node& node : tree_.nodes()) {
    if (!node.is_leaf()) continue;
    boxes.resize(std::max<std::size_t>(boxes.size(), node.first + node.count));
    for (std::uint32_t i = 0; i < node.count; ++i) boxes[node.first + i] = tree_.items_of(node)[i].box;
  }
  std::vector<PlacedSource> placed = sources_;
  for (const SizeSource& source : more) {
    boxes.push_back(box_of(source));
    placed.push_back(place_source(source));
  }
  SizingProxy proxy(limits_);
  proxy.build(boxes, placed);
  return proxy;
}

void SizingProxy::build(const std::vector<Box3>& boxes, const std::vector<PlacedSource>& placed) {
  tree_ = BoxTree(boxes);
  bounds_.resize(tree_.nodes().size());
  sources_.resize(placed.size());
  for (std::size_t n = bounds_.size(); n-- > 0;) bounds_[n] = bound_below(n, placed);
  for (const PlacedSource& source : sources_) {
    slope_ = std::max(slope_, slope_of(source));
    doubt_ = std::max(doubt_, epsilon * source.rate * (source.shape.length + source.radius));
  }
}

SizingProxy::Bound SizingProxy::bound_below(std::size_t node, const std::vector<PlacedSource>& placed) {
  const BoxTree::Node& n = tree_.nodes()[node];
  if (!n.is_leaf()) {
    const Bound &a = bounds_[n.first], &b = bounds_[n.first + 1];
    return {std::min(a.least, b.least), std::min(a.rate, b.rate)};
  }
  Bound bound{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::uint32_t i = 0; i < n.count; ++i) {
    PlacedSource& source = sources_[n.first + i];
    source = placed[tree_.items_of(n)[i].id];
    bound = {std::min(bound.least, source.least), std::min(bound.rate, source.rate)};
  }
  return bound;
}

double SizingProxy::least_possible(std::uint32_t node, const Vec3d& p) const {
  return (bounds_[node].least + bounds_[node].rate * std::sqrt(square_distance(tree_.nodes()[node].box, p))) * (1 - epsilon) - doubt_;
}

// The least of a size and those of all sources.
double SizingProxy::least_below(double size, const Vec3d& p) const {
  struct Entry {
    std::uint32_t node = 0;
    double least = 0;
  };
  std::array<Entry, deepest> stack;
  std::size_t depth = 0;
  if (!tree_.empty()) stack[depth++] = {0, least_possible(0, p)};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (!(entry.least < size)) continue;
    const BoxTree::Node& node = tree_.nodes()[entry.node];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const double here = size_from(sources_[node.first + i], p);
      if (here < size) size = here;
    }
    if (node.is_leaf()) continue;
    Entry near{node.first, least_possible(node.first, p)}, far{node.first + 1, least_possible(node.first + 1, p)};
    if (far.least < near.least) std::swap(near, far);
    if (far.least < size) stack[depth++] = far;
    if (near.least < size) stack[depth++] = near;
  }
  return size;
}

double SizingProxy::size_at(const Vec3d& p) const { return std::max(least_below(limits_.global, p), limits_.smallest); }

double SizingProxy::least_asked_at(const Vec3d& p) const { return least_below(std::numeric_limits<double>::infinity(), p); }

std::vector<double> SizingProxy::sizes_at(std::span<const Vec3d> points) const {
  std::vector<double> sizes;
  sizes.reserve(points.size());
  for (const Vec3d& p : points) sizes.push_back(size_at(p));
  return sizes;
}

}  // namespace mortise
