// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Seen along the axis of the face's plane: an edge is taken when it runs inside the border, past all vertices and across no edge taken.
#include "mortise/boolean/triangulate_shared_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mortise/geom/box_tree.h"

namespace mortise {
namespace {

using Loop = std::vector<std::uint32_t>;

// A closed walk cut where it comes back to a vertex; to and fro along one edge is nothing.
std::vector<Loop> simple_loops(const Loop& walk) {
  std::vector<Loop> loops;
  Loop open;
  for (const std::uint32_t v : walk) {
    const auto before = std::find(open.begin(), open.end(), v);
    if (before == open.end()) {
      open.push_back(v);
      continue;
    }
    if (open.end() - before > 2) loops.emplace_back(before, open.end());
    open.erase(before + 1, open.end());
  }
  if (open.size() > 2) loops.push_back(std::move(open));
  return loops;
}

// Closed towards the border, but maybe folded.
void fan(const Loop& loop, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) triangles.push_back({loop[0], loop[i], loop[i + 1]});
}

}  // namespace

struct SharedFaceTriangulator::Plate {
  Loop border;  // counterclockwise as seen, simple
  std::map<std::uint32_t, std::size_t> place_in_border;
  Loop vertices;                  // of the border, then inside
  std::vector<SharedEdge> edges;  // inside
};

SharedFaceTriangulator::SharedFaceTriangulator(const SharedVertices& vertices, const SharedEdges& edges)
    : vertices_(vertices), edges_(edges), edges_at_(vertices.size()) {
  for (std::uint32_t v = 0; v < vertices.size(); ++v) point_.push_back(points_.add_input(vertices[v]));
  for (const SharedEdge& e : edges.pieces()) join(e);
}

bool SharedFaceTriangulator::triangulate(const std::array<std::uint32_t, 3>& corners, std::span<const std::uint32_t> inside,
                                         std::vector<std::array<std::uint32_t, 3>>& triangles) {
  triangles.clear();
  Loop walk;
  for (std::size_t i = 0; i < 3; ++i) {
    const Loop along = edges_.vertices_along(corners[i], corners[(i + 1) % 3]);
    walk.insert(walk.end(), along.begin(), along.end() - 1);
  }
  if (walk.size() == 3 && inside.empty()) {
    triangles.push_back(corners);
    return true;
  }
  const bool has_plane = set_plane(corners);
  bool fits = has_plane;
  for (const Loop& loop : simple_loops(walk)) {
    if (has_plane) {
      fits = triangulate_loop(loop, inside, triangles) && fits;
    } else {
      fan(loop, triangles);
    }
  }
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) join(edge_between(t[i], t[(i + 1) % 3]));
  }
  return fits;
}

void SharedFaceTriangulator::join(const SharedEdge& e) {
  for (const std::size_t end : {0U, 1U}) {
    std::vector<std::uint32_t>& others = edges_at_[e[end]];
    const auto at = std::lower_bound(others.begin(), others.end(), e[1 - end]);
    if (at == others.end() || *at != e[1 - end]) others.insert(at, e[1 - end]);
  }
}

bool SharedFaceTriangulator::set_plane(const std::array<std::uint32_t, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3d normal = cross(vertices_[b] - vertices_[a], vertices_[c] - vertices_[a]);
  axis_ = Axis::X;
  for (const Axis axis : {Axis::Y, Axis::Z}) {
    if (std::fabs(normal[static_cast<std::size_t>(axis)]) > std::fabs(normal[static_cast<std::size_t>(axis_)])) axis_ = axis;
  }
  turn_ = turn(a, b, c);
  return turn_ != Sign::Zero;
}

bool SharedFaceTriangulator::triangulate_loop(Loop loop, std::span<const std::uint32_t> inside,
                                              std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (turn_ == Sign::Negative) std::reverse(loop.begin(), loop.end());
  if (!is_simple(loop)) {
    if (turn_ == Sign::Negative) std::reverse(loop.begin(), loop.end());
    fan(loop, triangles);
    return false;
  }
  Plate plate;
  plate.vertices = loop;
  for (std::size_t i = 0; i < loop.size(); ++i) plate.place_in_border[loop[i]] = i;
  plate.border = std::move(loop);
  const bool all_vertices_fit = add_inside(inside, plate), all_edges_fit = add_edges(plate);

  std::vector<LinePoints> segments;
  for (std::size_t i = 0; i < plate.border.size(); ++i) {
    segments.push_back({point_[plate.border[i]], point_[plate.border[(i + 1) % plate.border.size()]]});
  }
  for (const auto& [u, v] : plate.edges) {
    segments.push_back({point_[u], point_[v]});
    segments.push_back({point_[v], point_[u]});
  }
  std::vector<PointId> points;
  std::map<PointId, std::uint32_t> vertex_of;
  for (const std::uint32_t v : plate.vertices) {
    points.push_back(point_[v]);
    vertex_of[point_[v]] = v;
  }
  for (const PlanePoints& t : triangulate_region(points_, axis_, segments, points)) {
    triangles.push_back({vertex_of[t[0]], vertex_of[t[1]], vertex_of[t[2]]});
    if (turn_ == Sign::Negative) std::swap(triangles.back()[1], triangles.back()[2]);
  }
  return all_vertices_fit && all_edges_fit;
}

// Of two at one place, as seen, the first fits.
bool SharedFaceTriangulator::add_inside(std::span<const std::uint32_t> inside, Plate& plate) const {
  bool fits = true;
  std::set<std::array<double, 2>> places;
  for (const std::uint32_t v : plate.border) places.insert(seen(v));
  for (const std::uint32_t v : inside) {
    if (plate.place_in_border.count(v) != 0) continue;
    const bool is_inside = lies_inside(v, plate.border) && places.insert(seen(v)).second;
    if (is_inside) plate.vertices.push_back(v);
    fits = fits && is_inside;
  }
  return fits;
}

bool SharedFaceTriangulator::add_edges(Plate& plate) const {
  Loop sorted = plate.vertices;
  std::sort(sorted.begin(), sorted.end());
  std::vector<SharedEdge> edges;
  for (std::size_t i = 0; i < plate.border.size(); ++i)
    edges.push_back(edge_between(plate.border[i], plate.border[(i + 1) % plate.border.size()]));
  const std::set<SharedEdge> border_edges(edges.begin(), edges.end());
  for (const std::uint32_t u : sorted) {
    for (const std::uint32_t v : edges_at_[u]) {
      if (v > u && std::binary_search(sorted.begin(), sorted.end(), v) && border_edges.count({u, v}) == 0) edges.push_back({u, v});
    }
  }
  if (edges.size() == border_edges.size()) return true;
  std::vector<Box3> edge_boxes, vertex_boxes;
  for (const SharedEdge& e : edges) edge_boxes.push_back(box_seen(e));
  for (const std::uint32_t v : plate.vertices) vertex_boxes.push_back(box_seen({v, v}));
  const BoxTree edge_tree(edge_boxes), vertex_tree(vertex_boxes);
  std::vector<std::uint8_t> is_taken(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    bool is_free = i < border_edges.size() || leaves_inwards(edges[i][0], edges[i][1], plate);
    if (is_free && i >= border_edges.size()) {
      edge_tree.for_each_meeting(edge_boxes[i],
                                 [&](std::uint32_t j) { is_free = is_free && !(is_taken[j] != 0 && crosses(edges[i], edges[j])); });
      vertex_tree.for_each_meeting(edge_boxes[i], [&](std::uint32_t k) { is_free = is_free && !passes(edges[i], plate.vertices[k]); });
      if (is_free) plate.edges.push_back(edges[i]);
    }
    is_taken[i] = is_free ? 1 : 0;
  }
  return border_edges.size() + plate.edges.size() == edges.size();
}

// No edge has another vertex on it or crosses another one, and it turns to the left.
bool SharedFaceTriangulator::is_simple(const Loop& loop) const {
  std::vector<SharedEdge> edges;
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
    boxes.push_back(box_seen(edges.back()));
  }
  const BoxTree tree(boxes);
  bool is_free = true;
  for (std::size_t i = 0; i < edges.size() && is_free; ++i) {
    tree.for_each_meeting(
        boxes[i], [&](std::uint32_t j) { is_free = is_free && !passes(edges[i], edges[j][0]) && !(j < i && crosses(edges[i], edges[j])); });
  }
  if (!is_free) return false;
  const auto lowest = std::min_element(loop.begin(), loop.end(), [&](std::uint32_t u, std::uint32_t v) { return seen(u) < seen(v); });
  const std::size_t i = static_cast<std::size_t>(lowest - loop.begin()), count = loop.size();
  return turn(loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count]) == Sign::Positive;
}

// The border turns round the vertex once, and the vertex is not on it.
bool SharedFaceTriangulator::lies_inside(std::uint32_t v, const Loop& loop) const {
  int winding = 0;
  const double height = seen(v)[1];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
    const double from = seen(a)[1], to = seen(b)[1];
    if (std::min(from, to) > height || std::max(from, to) < height) continue;
    const Sign side = turn(a, b, v);
    if (side == Sign::Zero && is_between(a, v, b)) return false;
    if (from <= height && to > height && side == Sign::Positive) ++winding;
    if (from > height && to <= height && side == Sign::Negative) --winding;
  }
  return winding != 0;
}

// A segment that crosses nothing and has an end inside lies inside; between two border vertices it must leave into the inside.
bool SharedFaceTriangulator::leaves_inwards(std::uint32_t u, std::uint32_t v, const Plate& plate) const {
  const auto at = plate.place_in_border.find(u);
  if (at == plate.place_in_border.end() || plate.place_in_border.count(v) == 0) return true;
  const std::size_t count = plate.border.size();
  const std::uint32_t next = plate.border[(at->second + 1) % count], before = plate.border[(at->second + count - 1) % count];
  const bool is_left_of_next = turn(u, next, v) == Sign::Positive, is_left_of_before = turn(before, u, v) == Sign::Positive;
  return turn(before, u, next) == Sign::Negative ? is_left_of_next || is_left_of_before : is_left_of_next && is_left_of_before;
}

// Do edges without a common vertex meet?
bool SharedFaceTriangulator::crosses(const SharedEdge& e, const SharedEdge& f) const {
  if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return false;
  return turn(e[0], e[1], f[0]) != turn(e[0], e[1], f[1]) && turn(f[0], f[1], e[0]) != turn(f[0], f[1], e[1]);
}

// Is another vertex on an edge?
bool SharedFaceTriangulator::passes(const SharedEdge& e, std::uint32_t v) const {
  return v != e[0] && v != e[1] && turn(e[0], e[1], v) == Sign::Zero && is_between(e[0], v, e[1]);
}

// Of three on one line, or seen at one place.
bool SharedFaceTriangulator::is_between(std::uint32_t u, std::uint32_t w, std::uint32_t v) const {
  const std::array<double, 2> a = seen(u), b = seen(w), c = seen(v);
  for (const std::size_t i : {0U, 1U}) {
    if (b[i] < std::min(a[i], c[i]) || b[i] > std::max(a[i], c[i])) return false;
  }
  return true;
}

Sign SharedFaceTriangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return points_.orient2d(point_[a], point_[b], point_[c], axis_);
}

// The two coordinates that are left, in the order in which turns are counterclockwise.
std::array<double, 2> SharedFaceTriangulator::seen(std::uint32_t v) const {
  const std::size_t first = (static_cast<std::size_t>(axis_) + 1) % 3;
  return {vertices_[v][first], vertices_[v][(first + 1) % 3]};
}

Box3 SharedFaceTriangulator::box_seen(const SharedEdge& e) const {
  const std::array<double, 2> a = seen(e[0]), b = seen(e[1]);
  return box_round({{a[0], a[1], 0}, {b[0], b[1], 0}}, 0);
}

}  // namespace mortise
