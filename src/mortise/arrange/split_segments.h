// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where the segments of one face cross, and the final subdivision of every line.
#pragma once

#include <span>
#include <vector>

#include "mortise/arrange/face_intersection_map.h"

namespace mortise {

/// All points of each line, in order along it. Lines that lie on each other are one.
class LineSubdivision {
 public:
  LineSubdivision(const PointSet& points, const FaceIntersectionMap& map);

  /// The line that stands for all lines on the same straight line.
  [[nodiscard]] LineId root(LineId line) const { return root_[line]; }
  /// The points of the line between p and q, both included, in the direction of the line.
  [[nodiscard]] std::span<const PointId> between(LineId line, PointId p, PointId q) const;

 private:
  [[nodiscard]] std::size_t position(LineId root, PointId p) const;

  const PointSet& points_;
  IdVector<LineId, LineId> root_;
  IdVector<LineId, std::uint32_t> first_;      // line count + 1 entries; empty range for a line that is not a root
  IdVector<LineId, std::uint8_t> coordinate_;  // along which the points of the line are ordered
  std::vector<PointId> sorted_;
};

/// Adds the points where three faces meet: segments of one overlay that cross, touch or lie on each other.
///
/// Every crossing is put on both lines, so that the third face is split there too; collinear segments join their lines. In
/// an overlay of several faces their edges take part. Differs from the paper, which has no crossing segments in one face.
/// O(n log n) in the segments plus the pairs whose boxes meet.
/// @throws Error{Cancelled}
[[nodiscard]] LineSubdivision split_segments(OperandFaces& faces, const Overlays& overlays, FaceIntersectionMap& map,
                                             const ProgressCallback& progress);

}  // namespace mortise
