// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where the boxes of a prepared operand are after it was moved, without its images.
#pragma once

#include <array>

#include "mortise/geom/vec.h"
#include "mortise/mesh/transform.h"

namespace mortise {

/// Moves boxes so that the rounded images of all points in them are inside.
class PlacedBoxes {
 public:
  PlacedBoxes() = default;
  /// @param bounds  of all boxes
  PlacedBoxes(const AffineMap& place, const Box3& bounds);

  [[nodiscard]] Box3 image_of(const Box3& box) const;

 private:
  AffineMap place_;
  std::array<Vec3d, 3> size_{};  // absolute values of its rows
  Vec3d margin_;                 // more than all rounding; infinite where a sum might overflow
};

}  // namespace mortise
