// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The middle goes with the map, the half sizes with the absolute values of its entries.
#include "mortise/arrange/placed_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

PlacedBoxes::PlacedBoxes(const AffineMap& place, const Box3& bounds) : place_(place) {
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = std::fabs(place.offset[i]);  // no term of any coordinate is larger
    for (std::size_t j = 0; j < 3; ++j) {
      size_[i][j] = std::fabs(place.linear[i][j]);
      sum += 2 * size_[i][j] * std::max(std::fabs(bounds.lo[j]), std::fabs(bounds.hi[j]));
    }
    margin_[i] = sum < 0x1p1000 ? 0x1p-48 * sum + 0x1p-1060 : infinity;
  }
}

Box3 PlacedBoxes::image_of(const Box3& box) const {
  const Vec3d middle = 0.5 * box.lo + 0.5 * box.hi, half = 0.5 * box.hi - 0.5 * box.lo;
  Box3 image;
  for (std::size_t i = 0; i < 3; ++i) {
    const double centre = dot(place_.linear[i], middle) + place_.offset[i];
    const double reach = dot(size_[i], half) + margin_[i];
    image.lo[i] = reach < infinity ? centre - reach : -infinity;
    image.hi[i] = reach < infinity ? centre + reach : infinity;
  }
  return image;
}

}  // namespace mortise
