// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps 4 and 5 of the paper: the intersection points, and for each face the segments it must contain as edges (FIM).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/arrange/overlay_coplanar.h"

namespace mortise {

/// A straight line shared by all faces that have an edge or a segment on it.
using LineId = Id<struct LineTag>;

/// An edge of operands (two input points) or the trace of two overlays in each other (their planes).
struct Line {
  LinePoints edge;                 ///< valid for an edge
  OverlayId overlay_a, overlay_b;  ///< valid for a trace, overlay_a < overlay_b

  [[nodiscard]] bool is_edge() const { return edge[0].is_valid(); }
};

/// The part of a line between two of its points that a face must contain as edges.
struct Segment {
  LineId line;
  PointId p, q;  ///< p != q

  auto operator<=>(const Segment&) const = default;
};

struct PointOnLine {
  LineId line;
  PointId point;

  auto operator<=>(const PointOnLine&) const = default;
};

/// Rows of the FIM are kept per overlay: the faces of an overlay share theirs.
///
/// Conformity rests on this: lines are shared by all their faces, and points are collected per line, so every face that
/// contains a part of a line is split there at the same points (paper 5.2, by construction).
struct FaceIntersectionMap {
  IdVector<LineId, Line> lines;
  IdVector<SlotId, std::array<LineId, 3>> edge_line;  ///< of edge i (corner i to i + 1) of a face in contact
  std::vector<PointOnLine> points_on_lines;           ///< any order, with duplicates: ends, contacts, crossings
  std::vector<std::array<LineId, 2>> same_line;       ///< lines found to lie on each other
  IdVector<OverlayId, std::uint32_t> first_segment;   ///< overlay count + 1 entries
  std::vector<Segment> segments;                      ///< of each overlay, sorted, no duplicates
  IdVector<OverlayId, std::uint32_t> first_isolated;  ///< overlay count + 1 entries
  std::vector<PointId> isolated;                      ///< points inside faces that end no segment there (paper 4.3), sorted
  std::vector<PointId> contact_points;                ///< all points of contacts, sorted, no duplicates

  [[nodiscard]] std::span<const Segment> segments_of(OverlayId o) const {
    return std::span<const Segment>(segments).subspan(first_segment[o], first_segment[OverlayId(o.index() + 1)] - first_segment[o]);
  }
  [[nodiscard]] std::span<const PointId> isolated_of(OverlayId o) const {
    return std::span<const PointId>(isolated).subspan(first_isolated[o], first_isolated[OverlayId(o.index() + 1)] - first_isolated[o]);
  }
};

/// Segments every face must contain as edges (paper 4.1, 4.2, Figs. 10 and 11).
///
/// Adds the made points to `faces.points`: line x plane for E-F, line x line for E-E. A pair that touches in a single point
/// has it on an edge or in `isolated`. A segment along an edge of the other face lies on the line of that edge.
/// O(n log n) in the contacts; independent of their order.
[[nodiscard]] FaceIntersectionMap build_face_intersection_map(OperandFaces& faces, const Contacts& contacts, const Overlays& overlays);

}  // namespace mortise
