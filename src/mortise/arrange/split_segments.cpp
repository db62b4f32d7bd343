// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Crossing segments inside overlays, and points in order along lines.
#include "mortise/arrange/split_segments.h"

#include <algorithm>
#include <string>

#include "mortise/base/union_find.h"
#include "mortise/geom/box_tree.h"

namespace mortise {
namespace {

// A coordinate in which two different points differ, the one with the widest gap in doubles.
std::size_t distinguishing_coordinate(const PointSet& points, PointId p, PointId q) {
  const Vec3d gap = points.nearest(q) - points.nearest(p);
  const double size[3] = {gap.x < 0 ? -gap.x : gap.x, gap.y < 0 ? -gap.y : gap.y, gap.z < 0 ? -gap.z : gap.z};
  const std::size_t widest = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
  if (size[widest] > 0) return widest;
  for (std::size_t i = 0; i < 3; ++i) {
    if (points.compare(p, q, i) != Sign::Zero) return i;
  }
  return 0;
}

// One overlay's segments against each other.
class OverlaySplitter {
 public:
  OverlaySplitter(OperandFaces& faces, const Overlays& overlays, FaceIntersectionMap& map)
      : points_(faces.points), overlays_(overlays), map_(map) {}

  void split(OverlayId o) {
    overlay_ = o;
    collect();
    if (items_.size() < 2) return;
    constexpr std::size_t most_without_tree = 12;
    if (items_.size() <= most_without_tree) {
      for (std::size_t i = 0; i < items_.size(); ++i) {
        for (std::size_t j = i + 1; j < items_.size(); ++j) {
          if (boxes_meet(boxes_[i], boxes_[j])) split_pair(items_[i], items_[j]);
        }
      }
      return;
    }
    const BoxTree tree(boxes_);
    for_each_meeting_pair_within(tree, [&](std::uint32_t i, std::uint32_t j) { split_pair(items_[i], items_[j]); });
  }

 private:
  // A segment, or an isolated point as a segment from it to itself on no line.
  void collect() {
    items_.clear();
    const auto segments = map_.segments_of(overlay_);
    items_.assign(segments.begin(), segments.end());
    for (const PointId p : map_.isolated_of(overlay_)) items_.push_back({LineId(), p, p});
    if (overlays_.faces_of(overlay_).size() > 1) add_edges();
    boxes_.clear();
    for (const Segment& s : items_) {
      Box3 box;  // rounding is monotone, so the box of the rounded ends holds every rounded point of the segment
      box.extend(points_.nearest(s.p));
      box.extend(points_.nearest(s.q));
      boxes_.push_back(box);
    }
  }

  void add_edges() {
    const std::size_t first = items_.size();
    for (const SourceId f : overlays_.faces_of(overlay_)) {
      for (const LineId line : map_.edge_line[overlays_.slot_of_face[f]]) {
        items_.push_back({line, map_.lines[line].edge[0], map_.lines[line].edge[1]});
      }
    }
    std::sort(items_.begin() + static_cast<std::ptrdiff_t>(first), items_.end());
    items_.erase(std::unique(items_.begin() + static_cast<std::ptrdiff_t>(first), items_.end()), items_.end());
  }

  static bool is_point(const Segment& s) { return s.p == s.q; }

  OverlayId other_overlay(const Line& line) const { return line.overlay_a == overlay_ ? line.overlay_b : line.overlay_a; }

  // On which side of the line of `s` is p? The sense is the line's own.
  Sign side(const Segment& s, PointId p) const {
    if (p == s.p || p == s.q) return Sign::Zero;
    const Line& line = map_.lines[s.line];
    if (line.is_edge()) return points_.orient2d(line.edge[0], line.edge[1], p, overlays_.axis[overlay_]);
    return points_.side_of_plane(overlays_.plane[other_overlay(line)], p);
  }

  // Is p, a point of the line of s, on the closed segment?
  bool is_between(const Segment& s, PointId p) const {
    if (p == s.p || p == s.q) return true;
    const std::size_t c = distinguishing_coordinate(points_, s.p, s.q);
    return points_.compare(s.p, p, c) * points_.compare(p, s.q, c) == Sign::Positive;
  }

  void put_on(const Segment& s, PointId p) {
    if (p == s.p || p == s.q) return;
    map_.points_on_lines.push_back({s.line, p});
    map_.contact_points.push_back(p);
  }

  void split_at_point(const Segment& s, PointId p) {
    if (side(s, p) == Sign::Zero && is_between(s, p)) put_on(s, p);
  }

  void split_pair(const Segment& s, const Segment& t) {
    if (is_point(s) && is_point(t)) return;
    if (is_point(s)) return split_at_point(t, s.p);
    if (is_point(t)) return split_at_point(s, t.p);
    if (s.line == t.line) return;
    const Sign tp = side(s, t.p);
    const Sign tq = side(s, t.q);
    if (tp == tq && tp != Sign::Zero) return;
    const Sign sp = side(t, s.p);
    const Sign sq = side(t, s.q);
    if (sp == sq && sp != Sign::Zero) return;
    if (tp == Sign::Zero && tq == Sign::Zero) return join_collinear(s, t);
    if (tp * tq == Sign::Negative && sp * sq == Sign::Negative) return add_crossing(s, t);
    if (tp == Sign::Zero && is_between(s, t.p)) put_on(s, t.p);
    if (tq == Sign::Zero && is_between(s, t.q)) put_on(s, t.q);
    if (sp == Sign::Zero && is_between(t, s.p)) put_on(t, s.p);
    if (sq == Sign::Zero && is_between(t, s.q)) put_on(t, s.q);
  }

  void join_collinear(const Segment& s, const Segment& t) {
    int common = 0;
    for (const PointId p : {t.p, t.q}) common += is_between(s, p) ? 1 : 0;
    for (const PointId p : {s.p, s.q}) common += p != t.p && p != t.q && is_between(t, p) ? 1 : 0;
    if (common >= 2) map_.same_line.push_back({s.line, t.line});
  }

  void add_crossing(const Segment& s, const Segment& t) {
    const Segment& first = s.line < t.line ? s : t;
    const Segment& second = s.line < t.line ? t : s;
    const PointId p = crossing_point(map_.lines[first.line], map_.lines[second.line]);
    put_on(first, p);
    put_on(second, p);
  }

  PointId crossing_point(const Line& s, const Line& t) {
    if (s.is_edge() && t.is_edge()) return points_.add_line_line(s.edge, t.edge, overlays_.axis[overlay_]);
    if (s.is_edge()) return points_.add_line_plane(s.edge, overlays_.plane[other_overlay(t)]);
    if (t.is_edge()) return points_.add_line_plane(t.edge, overlays_.plane[other_overlay(s)]);
    std::array<OverlayId, 3> o{overlay_, other_overlay(s), other_overlay(t)};
    std::sort(o.begin(), o.end());
    return points_.add_three_planes(overlays_.plane[o[0]], overlays_.plane[o[1]], overlays_.plane[o[2]]);
  }

  PointSet& points_;
  const Overlays& overlays_;
  FaceIntersectionMap& map_;
  OverlayId overlay_;
  std::vector<Segment> items_;
  std::vector<Box3> boxes_;
};

IdVector<LineId, LineId> roots_of(const FaceIntersectionMap& map) {
  UnionFind sets(map.lines.size());
  for (const auto& [a, b] : map.same_line) sets.join(a.value, b.value);
  IdVector<LineId, LineId> roots;
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) roots.push_back(LineId(sets.find(i)));
  return roots;
}

// The two extreme points of a line in doubles tell the coordinate that orders it.
std::size_t ordering_coordinate(const PointSet& points, std::span<const PointId> line) {
  Box3 box;
  for (const PointId p : line) box.extend(points.nearest(p));
  const Vec3d size = box.hi - box.lo;
  const std::size_t widest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return size[widest] > 0 ? widest : distinguishing_coordinate(points, line.front(), line.back());
}

}  // namespace

LineSubdivision::LineSubdivision(const PointSet& points, const FaceIntersectionMap& map) : points_(points), root_(roots_of(map)) {
  std::vector<PointOnLine> entries = map.points_on_lines;
  for (PointOnLine& e : entries) e.line = root_[e.line];
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  std::size_t next = 0;
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    const std::size_t begin = sorted_.size();
    first_.push_back(static_cast<std::uint32_t>(begin));
    for (; next < entries.size() && entries[next].line == LineId(i); ++next) sorted_.push_back(entries[next].point);
    const std::span<PointId> line(sorted_.data() + begin, sorted_.size() - begin);
    coordinate_.push_back(0);
    if (line.size() < 2) continue;
    const std::size_t c = ordering_coordinate(points, line);
    coordinate_[LineId(i)] = static_cast<std::uint8_t>(c);
    std::sort(line.begin(), line.end(), [&](PointId p, PointId q) { return p != q && points.compare(p, q, c) == Sign::Negative; });
  }
  first_.push_back(static_cast<std::uint32_t>(sorted_.size()));
}

std::size_t LineSubdivision::position(LineId root, PointId p) const {
  const auto begin = sorted_.begin() + first_[root];
  const auto end = sorted_.begin() + first_[LineId(root.index() + 1)];
  const std::size_t c = coordinate_[root];
  const auto found =
      std::lower_bound(begin, end, p, [&](PointId a, PointId b) { return a != b && points_.compare(a, b, c) == Sign::Negative; });
  MORTISE_CHECK(found != end && *found == p, "point " + std::to_string(p.value) + " of line " + std::to_string(root.value));
  return static_cast<std::size_t>(found - sorted_.begin());
}

std::span<const PointId> LineSubdivision::between(LineId line, PointId p, PointId q) const {
  const LineId root = root_[line];
  const std::size_t i = position(root, p);
  const std::size_t j = position(root, q);
  return std::span<const PointId>(sorted_).subspan(std::min(i, j), std::max(i, j) - std::min(i, j) + 1);
}

LineSubdivision split_segments(OperandFaces& faces, const Overlays& overlays, FaceIntersectionMap& map, const ProgressCallback& progress) {
  OverlaySplitter splitter(faces, overlays, map);
  constexpr std::size_t overlays_per_report = 4096;
  for (std::size_t i = 0; i < overlays.size(); ++i) {
    if (i % overlays_per_report == 0) {
      report_progress(progress, "split_segments", 0.35 + 0.1 * static_cast<double>(i) / static_cast<double>(overlays.size()));
    }
    splitter.split(OverlayId(i));
  }
  std::sort(map.contact_points.begin(), map.contact_points.end());
  map.contact_points.erase(std::unique(map.contact_points.begin(), map.contact_points.end()), map.contact_points.end());
  return LineSubdivision(faces.points, map);
}

}  // namespace mortise
