// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One constrained triangulation per overlay, and the faces that cover each of its cells.
#include "mortise/arrange/triangulate_faces.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "mortise/arrange/planar_triangulation.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

using LocalEdge = std::array<std::uint32_t, 2>;

// The planar graph of one overlay in local vertex numbers.
struct PlanarGraph {
  std::vector<PointId> points;
  std::vector<std::uint64_t> lines;  // per point: bit i for the i-th line, for the first 64 lines
  std::vector<LocalEdge> edges;
};

class OverlayTriangulator {
 public:
  OverlayTriangulator(const OperandFaces& faces, const Overlays& overlays, const FaceIntersectionMap& map, const LineSubdivision& lines)
      : faces_(faces), overlays_(overlays), map_(map), lines_(lines) {}

  void triangulate(OverlayId o, Facets& facets) {
    overlay_ = o;
    build_graph();
    PlanarTriangulation triangulation(faces_.points, overlays_.axis[o], graph_.points, graph_.lines);
    triangulation.recover_edges(graph_.edges);
    triangulation.improve();
    const auto sources = overlays_.faces_of(o);
    if (sources.size() == 1) {
      for (const auto& cell : triangulation.cells()) add_facet(cell.corner, sources, facets);
      return;
    }
    cover_cells(triangulation);
    for (std::size_t c = 0; c < triangulation.cells().size(); ++c) {
      if (!covering_[c].empty()) add_facet(triangulation.cells()[c].corner, covering_[c], facets);
    }
  }

 private:
  struct Run {
    LineId root;
    std::span<const PointId> points;
  };

  std::span<const PointId> points_of_edge(SlotId slot, std::size_t i) const {
    const LineId line = map_.edge_line[slot][i];
    return lines_.between(line, map_.lines[line].edge[0], map_.lines[line].edge[1]);
  }

  void collect_runs() {
    runs_.clear();
    for (const SourceId f : overlays_.faces_of(overlay_)) {
      const SlotId slot = overlays_.slot_of_face[f];
      for (std::size_t i = 0; i < 3; ++i) runs_.push_back({lines_.root(map_.edge_line[slot][i]), points_of_edge(slot, i)});
    }
    for (const Segment& s : map_.segments_of(overlay_)) runs_.push_back({lines_.root(s.line), lines_.between(s.line, s.p, s.q)});
  }

  void build_graph() {
    collect_runs();
    graph_.points.clear();
    for (const Run& run : runs_) graph_.points.insert(graph_.points.end(), run.points.begin(), run.points.end());
    const auto isolated = map_.isolated_of(overlay_);
    graph_.points.insert(graph_.points.end(), isolated.begin(), isolated.end());
    std::sort(graph_.points.begin(), graph_.points.end());
    graph_.points.erase(std::unique(graph_.points.begin(), graph_.points.end()), graph_.points.end());
    add_edges_of_runs();
  }

  std::uint32_t local(PointId p) const {
    return static_cast<std::uint32_t>(std::lower_bound(graph_.points.begin(), graph_.points.end(), p) - graph_.points.begin());
  }

  void add_edges_of_runs() {
    graph_.edges.clear();
    graph_.lines.assign(graph_.points.size(), 0);
    roots_.clear();
    for (const Run& run : runs_) roots_.push_back(run.root);
    std::sort(roots_.begin(), roots_.end());
    roots_.erase(std::unique(roots_.begin(), roots_.end()), roots_.end());
    for (const Run& run : runs_) {
      const auto number = static_cast<std::size_t>(std::lower_bound(roots_.begin(), roots_.end(), run.root) - roots_.begin());
      const std::uint64_t bit = number < 64 ? std::uint64_t{1} << number : 0;
      std::uint32_t before = local(run.points.front());
      graph_.lines[before] |= bit;
      for (const PointId p : run.points.subspan(1)) {
        const std::uint32_t v = local(p);
        graph_.lines[v] |= bit;
        graph_.edges.push_back({std::min(before, v), std::max(before, v)});
        before = v;
      }
    }
    std::sort(graph_.edges.begin(), graph_.edges.end());
    graph_.edges.erase(std::unique(graph_.edges.begin(), graph_.edges.end()), graph_.edges.end());
  }

  // ---- several faces: which of them cover a cell ---------------------------------------------------------------------

  struct DirectedEdge {
    LocalEdge edge;
    std::uint32_t cell;
    std::uint32_t side;
    bool operator==(const DirectedEdge&) const = default;
    bool operator<(const DirectedEdge& o) const { return std::tie(edge, cell, side) < std::tie(o.edge, o.cell, o.side); }
  };

  void cover_cells(const PlanarTriangulation& triangulation) {
    const auto& cells = triangulation.cells();
    covering_.assign(cells.size(), {});
    stamp_.assign(3 * cells.size(), 0);
    directed_.clear();
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      for (std::uint32_t i = 0; i < 3; ++i) directed_.push_back({{cells[c].corner[i], cells[c].corner[(i + 1) % 3]}, c, i});
    }
    std::sort(directed_.begin(), directed_.end());
    std::uint32_t number = 0;
    for (const SourceId f : overlays_.faces_of(overlay_)) flood_face(triangulation, f, ++number);
  }

  const DirectedEdge* find_directed(std::uint32_t from, std::uint32_t to) const {
    const auto found = std::lower_bound(directed_.begin(), directed_.end(), DirectedEdge{{from, to}, 0, 0});
    return found != directed_.end() && found->edge == LocalEdge{from, to} ? &*found : nullptr;
  }

  // Marks both sides of every edge on the border of a face; returns a cell inside it.
  std::uint32_t mark_border(SourceId f, std::uint32_t number) {
    const SlotId slot = overlays_.slot_of_face[f];
    const bool runs_left = turn_of(f) == Sign::Positive;
    std::uint32_t inner = PlanarTriangulation::none;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto points = points_of_edge(slot, i);
      const bool along = points.front() == faces_.corners[f][i];
      for (std::size_t j = 0; j + 1 < points.size(); ++j) {
        const std::uint32_t u = local(points[j]);
        const std::uint32_t v = local(points[j + 1]);
        const DirectedEdge* uv = find_directed(u, v);
        const DirectedEdge* vu = find_directed(v, u);
        if (uv != nullptr) stamp_[3 * uv->cell + uv->side] = number;
        if (vu != nullptr) stamp_[3 * vu->cell + vu->side] = number;
        const DirectedEdge* inside = along == runs_left ? uv : vu;
        MORTISE_CHECK(inside != nullptr, "face " + std::to_string(f.value));
        inner = inside->cell;
      }
    }
    return inner;
  }

  void flood_face(const PlanarTriangulation& triangulation, SourceId f, std::uint32_t number) {
    const auto& cells = triangulation.cells();
    std::vector<std::uint32_t> stack{mark_border(f, number)};
    covering_[stack.back()].push_back(f);
    while (!stack.empty()) {
      const std::uint32_t c = stack.back();
      stack.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t n = cells[c].neighbour[i];
        if (n == PlanarTriangulation::none || stamp_[3 * c + i] == number) continue;
        if (!covering_[n].empty() && covering_[n].back() == f) continue;
        covering_[n].push_back(f);
        stack.push_back(n);
      }
    }
  }

  // ---- facets --------------------------------------------------------------------------------------------------------

  // Orientation of a face seen along the axis of its overlay.
  Sign turn_of(SourceId f) const {
    return orient2d(faces_.corner_position(f, 0), faces_.corner_position(f, 1), faces_.corner_position(f, 2), overlays_.axis[overlay_]);
  }

  void add_facet(const std::array<std::uint32_t, 3>& cell, std::span<const SourceId> sources, Facets& facets) const {
    PlanePoints corners{graph_.points[cell[0]], graph_.points[cell[1]], graph_.points[cell[2]]};
    const Sign turn = turn_of(sources.front());
    if (turn == Sign::Negative) std::swap(corners[1], corners[2]);
    facets.corners.push_back(corners);
    facets.first_source.push_back(static_cast<std::uint32_t>(facets.sources.size()));
    for (const SourceId f : sources) facets.sources.push_back({f, turn_of(f) != turn});
  }

  const OperandFaces& faces_;
  const Overlays& overlays_;
  const FaceIntersectionMap& map_;
  const LineSubdivision& lines_;
  OverlayId overlay_;
  PlanarGraph graph_;
  std::vector<Run> runs_;
  std::vector<LineId> roots_;
  std::vector<std::vector<SourceId>> covering_;
  std::vector<std::uint32_t> stamp_;
  std::vector<DirectedEdge> directed_;
};

void add_untouched_face(const OperandFaces& faces, SourceId f, Facets& facets) {
  facets.corners.push_back(faces.corners[f]);
  facets.first_source.push_back(static_cast<std::uint32_t>(facets.sources.size()));
  facets.sources.push_back({f, false});
}

}  // namespace

Facets triangulate_faces(const OperandFaces& faces, const Overlays& overlays, const FaceIntersectionMap& map, const LineSubdivision& lines,
                         const ProgressCallback& progress) {
  Facets facets;
  facets.corners.reserve(faces.corners.size());
  facets.first_source.reserve(faces.corners.size() + 1);
  facets.sources.reserve(faces.corners.size());
  OverlayTriangulator triangulator(faces, overlays, map, lines);
  constexpr std::size_t faces_per_report = 16384;
  for (std::size_t i = 0; i < faces.corners.size(); ++i) {
    if (i % faces_per_report == 0) {
      report_progress(progress, "triangulate_faces", 0.45 + 0.2 * static_cast<double>(i) / static_cast<double>(faces.corners.size()));
    }
    const SourceId f(i);
    if (faces.shape[f] != FaceShape::Proper) continue;
    if (!overlays.slot_of_face[f].is_valid()) {
      add_untouched_face(faces, f, facets);
    } else if (overlays.faces_of(overlays.of_face(f)).front() == f) {
      triangulator.triangulate(overlays.of_face(f), facets);
    }
  }
  facets.first_source.push_back(static_cast<std::uint32_t>(facets.sources.size()));
  return facets;
}

}  // namespace mortise
