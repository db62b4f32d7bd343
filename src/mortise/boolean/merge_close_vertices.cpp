// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex merges on the compact result, and the compaction after them.
#include "mortise/boolean/merge_close_vertices.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include "mortise/boolean/facet_order.h"
#include "mortise/boolean/join_coincident.h"
#include "mortise/boolean/keep_triangles.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/face_marks.h"

namespace mortise {
namespace {

// Which vertex stays where two are merged: input vertices first, then by position, first in doubles, then exactly. The order of
// operands decides nothing.
class Precedence {
 public:
  Precedence(const OperandFaces& faces, const MergedMesh& merged) : points_(faces.points), merged_(merged) {}

  [[nodiscard]] bool is_input(VertexId v) const { return points_.is_input(point_of(v)); }

  [[nodiscard]] bool operator()(VertexId a, VertexId b) const {
    if (is_input(a) != is_input(b)) return is_input(a);
    const Vec3d& p = merged_.mesh.points[a.index()];
    const Vec3d& q = merged_.mesh.points[b.index()];
    if (p != q) return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign order = points_.compare(point_of(a), point_of(b), i);
      if (order != Sign::Zero) return order == Sign::Negative;
    }
    return false;
  }

 private:
  [[nodiscard]] PointId point_of(VertexId v) const { return merged_.point_of_vertex[v.index()]; }

  const PointSet& points_;
  const MergedMesh& merged_;
};

struct ClosePair {
  double distance;
  VertexId a, b;  // a precedes b
};

// Pairs of different vertices. Triangles in a bad place fail with many others: what occurs again is dropped before it fills memory.
class VertexPairs {
 public:
  void add(VertexId a, VertexId b) {
    keys_.push_back((std::uint64_t{std::min(a, b).value} << 32U) | std::max(a, b).value);
    if (keys_.size() >= compact_at_) compact();
  }

  [[nodiscard]] const std::vector<std::uint64_t>& keys() {
    compact();
    return keys_;
  }

 private:
  void compact() {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    compact_at_ = std::max<std::size_t>(1024, 4 * keys_.size());
  }

  std::vector<std::uint64_t> keys_;
  std::size_t compact_at_ = 1024;
};

// Pairs of corners of failed pairs no farther apart than their reach, the nearest first.
std::vector<ClosePair> find_close_pairs(const MergedMesh& merged, const Precedence& precedes, std::span<const FailedPair> failed,
                                        const RepairReach& reach) {
  VertexPairs corner_pairs;
  for (const FailedPair& f : failed) {
    std::array<VertexId, 6> corners;
    const auto second = std::copy_n(merged.mesh.triangles[f.a.index()].begin(), 3, corners.begin());
    std::copy_n(merged.mesh.triangles[f.b.index()].begin(), 3, second);
    std::sort(corners.begin(), corners.end());
    const auto end = std::unique(corners.begin(), corners.end());
    for (auto p = corners.begin(); p != end; ++p) {
      for (auto q = p + 1; q != end; ++q) corner_pairs.add(*p, *q);
    }
  }
  std::vector<ClosePair> pairs;
  for (const std::uint64_t key : corner_pairs.keys()) {
    VertexId a(static_cast<std::uint32_t>(key >> 32U)), b(static_cast<std::uint32_t>(key));
    if (precedes(b, a)) std::swap(a, b);
    const Vec3d& p = merged.mesh.points[a.index()];
    const double distance = length(merged.mesh.points[b.index()] - p);
    if (distance <= reach.at(p)) pairs.push_back({distance, a, b});
  }
  std::sort(pairs.begin(), pairs.end(), [&](const ClosePair& p, const ClosePair& q) {
    if (p.distance != q.distance) return p.distance < q.distance;
    return p.a != q.a ? precedes(p.a, q.a) : precedes(p.b, q.b);
  });
  return pairs;
}

// The vertex that takes the place of each.
class Replacement {
 public:
  Replacement(const Precedence& precedes, std::size_t vertex_count) : precedes_(precedes) {
    for (std::size_t v = 0; v < vertex_count; ++v) of_.push_back(VertexId(v));
  }

  // Of vertices at one place.
  void merge_equal(VertexId a, VertexId b) {
    a = find(a);
    b = find(b);
    if (precedes_(b, a)) std::swap(a, b);
    of_[b.index()] = a;
  }

  // False when they are one already, or none may move.
  bool merge_close(VertexId a, VertexId b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (precedes_(b, a)) std::swap(a, b);
    if (precedes_.is_input(b)) return false;
    of_[b.index()] = a;
    return true;
  }

  [[nodiscard]] VertexId find(VertexId v) const {
    while (of_[v.index()] != v) v = of_[v.index()];
    return v;
  }

 private:
  const Precedence& precedes_;
  std::vector<VertexId> of_;
};

void replace_corners(const Replacement& replacement, MergedMesh& merged) {
  for (std::size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
    for (VertexId& v : merged.mesh.triangles[t]) {
      const VertexId other = replacement.find(v);
      if (other == v) continue;
      const double distance = length(merged.mesh.points[other.index()] - merged.mesh.points[v.index()]);
      merged.repair_displacement = std::max(merged.repair_displacement, distance);
      merged.is_repaired[t] = 1;
      forget_diagonals(FaceId(t), merged.mesh);
      v = other;
    }
  }
}

struct SortedTriangle {
  Triangle corners;  // ascending
  bool is_even;
  std::uint32_t triangle;
};

SortedTriangle sorted_triangle(const Triangle& t, std::uint32_t number) {
  const auto first = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  const VertexId a = t[first];
  const VertexId b = t[(first + 1) % 3];
  const VertexId c = t[(first + 2) % 3];
  return b < c ? SortedTriangle{{a, b, c}, true, number} : SortedTriangle{{a, c, b}, false, number};
}

// Triangles that remain: not those with a corner twice, not pairs that cancel. Of some on the same corners the first facets remain.
std::vector<std::uint8_t> find_remaining(const FacetOrder& precedes, const MergedMesh& merged) {
  const std::vector<Triangle>& triangles = merged.mesh.triangles;
  std::vector<std::uint8_t> remains(triangles.size(), 1);
  std::vector<SortedTriangle> sorted;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle& c = triangles[t];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) {
      remains[t] = 0;
    } else {
      sorted.push_back(sorted_triangle(c, t));
    }
  }
  std::sort(sorted.begin(), sorted.end(), [&](const SortedTriangle& s, const SortedTriangle& t) {
    if (s.corners != t.corners) return s.corners < t.corners;
    const FacetId f = merged.facet_of_triangle[s.triangle].facet, g = merged.facet_of_triangle[t.triangle].facet;
    return precedes(f, g) || (!precedes(g, f) && s.triangle < t.triangle);
  });
  std::vector<std::uint32_t> open;  // triangles on the same corners that nothing has cancelled, all of one sense
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].corners != sorted[i - 1].corners) open.clear();
    const bool cancels = !open.empty() && sorted[open.back()].is_even != sorted[i].is_even;
    if (!cancels) {
      open.push_back(static_cast<std::uint32_t>(i));
      continue;
    }
    remains[sorted[i].triangle] = remains[sorted[open.back()].triangle] = 0;
    open.pop_back();
  }
  return remains;
}

void apply(const Replacement& replacement, const FacetOrder& precedes, MergedMesh& merged) {
  note_facets_before_repair(merged);
  replace_corners(replacement, merged);
  const bool has_walls = !merged.provenance.covering_front.empty();
  keep_triangles(has_walls ? join_coincident(precedes, merged) : find_remaining(precedes, merged), merged);
}

}  // namespace

std::size_t merge_equal_vertices(const OperandFaces& faces, const Facets& facets, Coordinates coordinates, MergedMesh& merged) {
  const std::vector<Vec3d>& points = merged.mesh.points;
  const Precedence precedes(faces, merged);
  std::vector<VertexId> rounded;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (coordinates == Coordinates::Float32 || !precedes.is_input(VertexId(v))) rounded.push_back(VertexId(v));
  }
  std::sort(rounded.begin(), rounded.end(), [&](VertexId a, VertexId b) {
    const Vec3d &p = points[a.index()], &q = points[b.index()];
    return p != q ? std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z) : precedes(a, b);
  });
  Replacement replacement(precedes, points.size());
  std::size_t merged_inputs = 0;
  bool any = false;
  for (std::size_t i = 1; i < rounded.size(); ++i) {
    if (points[rounded[i].index()] != points[rounded[i - 1].index()]) continue;
    merged_inputs += precedes.is_input(rounded[i]) ? 1 : 0;
    replacement.merge_equal(rounded[i - 1], rounded[i]);
    any = true;
  }
  if (any) apply(replacement, FacetOrder(faces, facets), merged);
  return merged_inputs;
}

bool merge_close_vertices(const OperandFaces& faces, const Facets& facets, std::span<const FailedPair> failed, const RepairReach& reach,
                          MergedMesh& merged) {
  const Precedence precedes(faces, merged);
  Replacement replacement(precedes, merged.mesh.points.size());
  bool any = false;
  for (const ClosePair& pair : find_close_pairs(merged, precedes, failed, reach)) any |= replacement.merge_close(pair.a, pair.b);
  if (any) apply(replacement, FacetOrder(faces, facets), merged);
  return any;
}

}  // namespace mortise
