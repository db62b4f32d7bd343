// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A grid finds vertices, a tree of boxes edges; nearness is measured from edges as they were before anything was put into them.
#include "mortise/boolean/shared_edges.h"

#include <algorithm>
#include <cmath>

#include "mortise/geom/box_tree.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

constexpr std::size_t items_per_report = 4096;

void report(const ProgressCallback& progress, std::size_t i) {
  if (i % items_per_report == 0) report_progress(progress, "share_within_tolerance", 0);
}

// Where on a segment a point is nearest: 0 at a, 1 at b.
double place_on_segment(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const Vec3d along = b - a;
  return std::min(1.0, std::max(0.0, dot(p - a, along) / dot(along, along)));
}

Vec3d point_on_segment(const Vec3d& a, const Vec3d& b, double place) { return a + place * (b - a); }

// The place on the first of two segments that is nearest to the second.
double nearest_place(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const Vec3d u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), area = uu * vv - uv * uv;
  double place = area > 0 ? std::min(1.0, std::max(0.0, (uv * dot(v, w) - vv * dot(u, w)) / area)) : 0;
  constexpr int corrections = 4;
  for (int i = 0; i < corrections; ++i) {
    const Vec3d on_other = point_on_segment(c, d, place_on_segment(c, d, point_on_segment(a, b, place)));
    place = place_on_segment(a, b, on_other);
  }
  return place;
}

}  // namespace

SharedEdge edge_between(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

Box3 box_round(std::initializer_list<Vec3d> points, double margin) {
  Box3 box;
  for (const Vec3d& p : points) {
    box.extend(p - Vec3d{margin, margin, margin});
    box.extend(p + Vec3d{margin, margin, margin});
  }
  return box;
}

// ---- vertices -------------------------------------------------------------------------------------------------------

// Cells are large enough that most points look into one only, and that their numbers are finite.
SharedVertices::SharedVertices(double tolerance, double largest_coordinate)
    : tolerance_(tolerance), cell_size_(std::max(8 * tolerance, std::ldexp(largest_coordinate, -50))) {}

std::uint32_t SharedVertices::find_or_add(const Vec3d& p) {
  const std::uint32_t found = nearest(p);
  if (found != none) return found;
  const std::uint32_t v = size();
  points_.push_back(p);
  cells_[cell_of(p)].push_back(v);
  return v;
}

std::uint32_t SharedVertices::nearest(const Vec3d& p) const {
  std::uint32_t best = none;
  double least = tolerance_;
  const auto look_into = [&](const Cell& cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const std::uint32_t v : found->second) {
      const double distance = length(points_[v] - p);
      if (distance > least || (distance == least && v > best)) continue;
      least = distance;
      best = v;
    }
  };
  const Vec3d margin{tolerance_, tolerance_, tolerance_};
  const Cell lo = cell_of(p - margin), hi = cell_of(p + margin);
  for (int i = 0; i < 8; ++i) {
    const std::array<bool, 3> is_high{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
    Cell cell = lo;
    bool is_other = true;
    for (std::size_t c = 0; c < 3; ++c) {
      if (is_high[c]) cell[c] = hi[c];
      is_other = is_other && (!is_high[c] || hi[c] != lo[c]);
    }
    if (is_other) look_into(cell);
  }
  return best;
}

SharedVertices::Cell SharedVertices::cell_of(const Vec3d& p) const {
  return {std::floor(p.x / cell_size_), std::floor(p.y / cell_size_), std::floor(p.z / cell_size_)};
}

// ---- edges ----------------------------------------------------------------------------------------------------------

SharedEdges::SharedEdges(SharedVertices& vertices, double tolerance, std::vector<SharedEdge> edges)
    : vertices_(vertices), tolerance_(tolerance), edges_(std::move(edges)) {
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  inside_.resize(edges_.size());
}

void SharedEdges::put_in_vertices(const ProgressCallback& progress) { put_in_from(0, progress); }

void SharedEdges::join_crossings(const ProgressCallback& progress) {
  const std::uint32_t first_new = vertices_.size();
  const std::vector<Piece> pieces = all_pieces();
  std::vector<Box3> boxes;
  for (const Piece& p : pieces) boxes.push_back(box_round({vertices_[p.ends[0]], vertices_[p.ends[1]]}, 0));
  const BoxTree tree(boxes);
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    report(progress, i);
    others.clear();
    tree.for_each_meeting(box_round({vertices_[pieces[i].ends[0]], vertices_[pieces[i].ends[1]]}, tolerance_), [&](std::uint32_t j) {
      if (j > i) others.push_back(j);
    });
    std::sort(others.begin(), others.end());
    for (const std::uint32_t j : others) join(pieces[i], pieces[j]);
  }
  put_in_from(first_new, progress);
}

std::vector<std::uint32_t> SharedEdges::vertices_along(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> along{std::min(a, b)};
  for (const Inside& i : inside_[number_of(edge_between(a, b))]) along.push_back(i.vertex);
  along.push_back(std::max(a, b));
  if (a > b) std::reverse(along.begin(), along.end());
  return along;
}

std::vector<SharedEdge> SharedEdges::pieces() const {
  std::vector<SharedEdge> edges;
  for (const Piece& p : all_pieces()) edges.push_back(edge_between(p.ends[0], p.ends[1]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::size_t SharedEdges::number_of(const SharedEdge& edge) const {
  return static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), edge) - edges_.begin());
}

std::vector<SharedEdges::Piece> SharedEdges::all_pieces() const {
  std::vector<Piece> pieces;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    std::uint32_t from = edges_[e][0];
    for (const Inside& i : inside_[e]) {
      pieces.push_back({e, {from, i.vertex}});
      from = i.vertex;
    }
    pieces.push_back({e, {from, edges_[e][1]}});
  }
  return pieces;
}

// Vertices from this number on.
void SharedEdges::put_in_from(std::uint32_t first, const ProgressCallback& progress) {
  std::vector<Box3> boxes;
  for (const SharedEdge& e : edges_) boxes.push_back(box_round({vertices_[e[0]], vertices_[e[1]]}, 0));
  const BoxTree tree(boxes);
  for (std::uint32_t v = first; v < vertices_.size(); ++v) {
    report(progress, v);
    tree.for_each_meeting(box_round({vertices_[v]}, tolerance_), [&](std::uint32_t e) { put_in_if_near(e, v); });
  }
}

void SharedEdges::put_in_if_near(std::size_t edge, std::uint32_t v) {
  const auto [from, to] = edges_[edge];
  if (v == from || v == to) return;
  const Vec3d &a = vertices_[from], &b = vertices_[to], &p = vertices_[v];
  const double place = place_on_segment(a, b, p);
  if (place <= 0 || place >= 1 || length(point_on_segment(a, b, place) - p) > tolerance_) return;
  std::vector<Inside>& inside = inside_[edge];
  if (std::any_of(inside.begin(), inside.end(), [&](const Inside& i) { return i.vertex == v; })) return;
  const Inside added{place, v};
  inside.insert(std::lower_bound(inside.begin(), inside.end(), added), added);
}

void SharedEdges::join(const Piece& p, const Piece& q) {
  for (const std::uint32_t v : p.ends) {
    if (v == q.ends[0] || v == q.ends[1]) return;
  }
  const Vec3d &a = vertices_[p.ends[0]], &b = vertices_[p.ends[1]], &c = vertices_[q.ends[0]], &d = vertices_[q.ends[1]];
  const Vec3d on_p = point_on_segment(a, b, nearest_place(a, b, c, d)), on_q = point_on_segment(c, d, nearest_place(c, d, a, b));
  if (length(on_p - on_q) > tolerance_) return;
  const std::uint32_t v = vertices_.find_or_add(0.5 * (on_p + on_q));
  put_in_if_near(p.edge, v);
  put_in_if_near(q.edge, v);
}

}  // namespace mortise
