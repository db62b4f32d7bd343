// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The edge length wanted at any point of space (paper 7.3, Fig. 19): the least that any source asks for.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/geom/box_tree.h"
#include "mortise/size/placed_source.h"

namespace mortise {

struct SizeLimits {
  double global = 1;    ///< the size where no source asks for less
  double smallest = 0;  ///< nothing below this, whatever sources ask for
};

/// Differs from the paper, which keeps the sources that matter in regular bins: near a curve of thousands of short segments almost all
/// of them matter to a bin of useful size. Sources are in a tree of boxes; a part of it is left out when its least possible size is above
/// one already found. Sizes are those of all sources, bit for bit.
class SizingProxy {
 public:
  /// @throws what check_sources does; Error{InvalidArgument} for limits that are not finite or not 0 <= smallest <= global > 0
  /// O(n log n) for n sources.
  SizingProxy(std::span<const SizeSource> sources, const SizeLimits& limits);

  /// This one and more sources.
  /// @throws what check_sources does
  [[nodiscard]] SizingProxy with(std::span<const SizeSource> more) const;

  /// In smallest .. global.
  [[nodiscard]] double size_at(const Vec3d& p) const;
  [[nodiscard]] std::vector<double> sizes_at(std::span<const Vec3d> points) const;

  /// The least that any source asks for, whatever the limits; infinity without sources.
  [[nodiscard]] double least_asked_at(const Vec3d& p) const;

  /// No two sizes differ by more than this times the way between their places: growth - 1, and more where a strength varies.
  [[nodiscard]] double slope() const { return slope_; }
  [[nodiscard]] const SizeLimits& limits() const { return limits_; }

 private:
  /// What bounds the sizes of all sources below a node of the tree: strength `least` in its box, and `rate` away from it.
  struct Bound {
    double least = 0, rate = 0;
  };

  explicit SizingProxy(const SizeLimits& limits) : limits_(limits) {}
  void build(const std::vector<Box3>& boxes, const std::vector<PlacedSource>& placed);
  [[nodiscard]] Bound bound_below(std::size_t node, const std::vector<PlacedSource>& placed);
  [[nodiscard]] double least_below(double size, const Vec3d& p) const;
  [[nodiscard]] double least_possible(std::uint32_t node, const Vec3d& p) const;

  SizeLimits limits_;
  double slope_ = 0;
  std::vector<PlacedSource> sources_;  ///< in the order of the leaves of the tree
  BoxTree tree_;                       ///< over the boxes round sources and their radii
  std::vector<Bound> bounds_;          ///< per node
  double doubt_ = 0;                   ///< by which rounding may lift a bound, relative to it
};

}  // namespace mortise
