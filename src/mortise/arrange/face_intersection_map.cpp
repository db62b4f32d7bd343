// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Contacts -> points on lines, and segments per overlay.
#include "mortise/arrange/face_intersection_map.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

#include "mortise/base/sort_unique.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b); }

struct SegmentOfOverlay {
  OverlayId overlay;
  Segment segment;

  auto operator<=>(const SegmentOfOverlay&) const = default;
};

struct PointOfOverlay {
  OverlayId overlay;
  PointId point;

  auto operator<=>(const PointOfOverlay&) const = default;
};

class MapBuilder {
 public:
  MapBuilder(OperandFaces& faces, const Overlays& overlays) : faces_(faces), overlays_(overlays) {
    for (const SourceId f : overlays.face) {
      const PlanePoints& c = faces.corners[f];
      map_.edge_line.push_back({edge_line(c[0], c[1]), edge_line(c[1], c[2]), edge_line(c[2], c[0])});
    }
  }

  void add(const Contact& contact, std::span<const Incidence> incidences) {
    points_.clear();
    for (const Incidence& incidence : incidences) {
      const PointId p = point_of(contact, incidence);
      points_.push_back(p);
      map_.contact_points.push_back(p);
      place(p, contact.face_a, incidence.on_a);
      place(p, contact.face_b, incidence.on_b);
    }
    if (contact.kind == PairContact::Touching && points_.size() == 2 && points_[0] != points_[1]) add_segment(contact, incidences);
  }

  void add(const StrayPoint& stray) {
    map_.contact_points.push_back(stray.point);
    place(stray.point, stray.face, stray.feature);
  }

  [[nodiscard]] FaceIntersectionMap finish() && {
    sort_unique(segments_);
    sort_unique(isolated_);
    sort_unique(map_.contact_points);
    std::size_t s = 0;
    std::size_t p = 0;
    for (std::size_t i = 0; i < overlays_.size(); ++i) {
      const OverlayId o(i);
      map_.first_segment.push_back(static_cast<std::uint32_t>(map_.segments.size()));
      map_.first_isolated.push_back(static_cast<std::uint32_t>(map_.isolated.size()));
      ends_.clear();
      for (; s < segments_.size() && segments_[s].overlay == o; ++s) {
        map_.segments.push_back(segments_[s].segment);
        ends_.push_back(segments_[s].segment.p);
        ends_.push_back(segments_[s].segment.q);
      }
      sort_unique(ends_);
      for (; p < isolated_.size() && isolated_[p].overlay == o; ++p) {
        if (!std::binary_search(ends_.begin(), ends_.end(), isolated_[p].point)) map_.isolated.push_back(isolated_[p].point);
      }
    }
    map_.first_segment.push_back(static_cast<std::uint32_t>(map_.segments.size()));
    map_.first_isolated.push_back(static_cast<std::uint32_t>(map_.isolated.size()));
    return std::move(map_);
  }

 private:
  LineId edge_line(PointId p, PointId q) {
    const auto [found, is_new] = edge_lines_.try_emplace(pair_key(p.value, q.value), map_.lines.next_id());
    if (is_new) {
      map_.lines.push_back({{std::min(p, q), std::max(p, q)}, {}, {}});
      put_on_line(found->second, p);
      put_on_line(found->second, q);
    }
    return found->second;
  }

  LineId trace_line(OverlayId a, OverlayId b) {
    const auto [found, is_new] = trace_lines_.try_emplace(pair_key(a.value, b.value), map_.lines.next_id());
    if (is_new) map_.lines.push_back({{}, std::min(a, b), std::max(a, b)});
    return found->second;
  }

  void put_on_line(LineId line, PointId p) { map_.points_on_lines.push_back({line, p}); }

  LineId line_of_edge(SourceId f, std::size_t edge) const { return map_.edge_line[overlays_.slot_of_face[f]][edge]; }

  PointId point_of(const Contact& contact, const Incidence& incidence) {
    if (incidence.on_a.kind == Feature::Kind::Corner) return faces_.corners[contact.face_a][incidence.on_a.index];
    if (incidence.on_b.kind == Feature::Kind::Corner) return faces_.corners[contact.face_b][incidence.on_b.index];
    if (incidence.on_a.kind == Feature::Kind::Inside) return edge_through_face(contact.face_b, incidence.on_b.index, contact.face_a);
    if (incidence.on_b.kind == Feature::Kind::Inside) return edge_through_face(contact.face_a, incidence.on_a.index, contact.face_b);
    return edge_through_edge(line_of_edge(contact.face_a, incidence.on_a.index), line_of_edge(contact.face_b, incidence.on_b.index));
  }

  PointId edge_through_face(SourceId with_edge, std::size_t edge, SourceId face) {
    const LineId line = line_of_edge(with_edge, edge);
    const OverlayId overlay = overlays_.of_face(face);
    const std::uint64_t key = (std::uint64_t{line.value} << 32U) | overlay.value;
    const auto [found, is_new] = edge_face_points_.try_emplace(key);
    if (is_new) found->second = faces_.points.add_line_plane(map_.lines[line].edge, overlays_.plane[overlay]);
    return found->second;
  }

  PointId edge_through_edge(LineId line_a, LineId line_b) {
    const auto [found, is_new] = edge_edge_points_.try_emplace(pair_key(line_a.value, line_b.value));
    if (is_new) {
      const LinePoints& a = map_.lines[std::min(line_a, line_b)].edge;
      const LinePoints& b = map_.lines[std::max(line_a, line_b)].edge;
      const PointSet& points = faces_.points;
      const std::optional<Axis> axis = projection_axis(points.nearest(a[0]), points.nearest(a[1]), points.nearest(b[0]));
      MORTISE_CHECK(axis.has_value(), "edges of lines " + std::to_string(line_a.value) + " and " + std::to_string(line_b.value));
      found->second = faces_.points.add_line_line(a, b, *axis);
    }
    return found->second;
  }

  void place(PointId p, SourceId f, const Feature& feature) {
    if (feature.kind == Feature::Kind::Edge) put_on_line(line_of_edge(f, feature.index), p);
    if (feature.kind == Feature::Kind::Inside) isolated_.push_back({overlays_.of_face(f), p});
  }

  // The edge of a face along which both points lie, if any.
  static std::optional<std::size_t> common_edge(const Feature& first, const Feature& second) {
    for (std::uint8_t e = 0; e < 3; ++e) {
      if (is_on_edge(first, e) && is_on_edge(second, e)) return e;
    }
    return std::nullopt;
  }

  void add_segment(const Contact& contact, std::span<const Incidence> incidences) {
    const auto edge_a = common_edge(incidences[0].on_a, incidences[1].on_a);
    const auto edge_b = common_edge(incidences[0].on_b, incidences[1].on_b);
    if (edge_a && edge_b) {
      map_.same_line.push_back({line_of_edge(contact.face_a, *edge_a), line_of_edge(contact.face_b, *edge_b)});
      return;
    }
    const OverlayId overlay_a = overlays_.of_face(contact.face_a);
    const OverlayId overlay_b = overlays_.of_face(contact.face_b);
    const LineId line = edge_a   ? line_of_edge(contact.face_a, *edge_a)
                        : edge_b ? line_of_edge(contact.face_b, *edge_b)
                                 : trace_line(overlay_a, overlay_b);
    const Segment segment{line, std::min(points_[0], points_[1]), std::max(points_[0], points_[1])};
    put_on_line(line, segment.p);
    put_on_line(line, segment.q);
    if (!edge_a) segments_.push_back({overlay_a, segment});
    if (!edge_b) segments_.push_back({overlay_b, segment});
  }

  OperandFaces& faces_;
  const Overlays& overlays_;
  FaceIntersectionMap map_;
  std::vector<SegmentOfOverlay> segments_;
  std::vector<PointOfOverlay> isolated_;
  std::vector<PointId> points_;
  std::vector<PointId> ends_;
  std::unordered_map<std::uint64_t, LineId> edge_lines_, trace_lines_;
  std::unordered_map<std::uint64_t, PointId> edge_face_points_, edge_edge_points_;
};

}  // namespace

FaceIntersectionMap build_face_intersection_map(OperandFaces& faces, const Contacts& contacts, const Overlays& overlays) {
  MapBuilder builder(faces, overlays);
  for (const Contact& contact : contacts.contacts) builder.add(contact, contacts.incidences_of(contact));
  for (const StrayPoint& stray : contacts.stray_points) builder.add(stray);
  return std::move(builder).finish();
}

}  // namespace mortise
