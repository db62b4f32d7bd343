// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex merges on the compact result, and the compaction after them.
#include "mortise/boolean/merge_close_vertices.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include "mortise/boolean/join_coincident.h"
#include "mortise/boolean/keep_triangles.h"
#include "mortise/boolean/repair_reach.h"
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

// Pairs of corners of failed pairs no farther apart than their reach, each once: triangles in a bad place fail with many others.
std::vector<ClosePair> find_close_pairs(const MergedMesh& merged, const Precedence& precedes, std::span<const FailedPair> failed,
                                        double least_reach) {
  std::vector<ClosePair> pairs;
  const auto add = [&](VertexId a, VertexId b) {
    if (precedes(b, a)) std::swap(a, b);
    const Vec3d& p = merged.mesh.points[a.index()];
    const double distance = length(merged.mesh.points[b.index()] - p);
    if (distance <= std::max(repair_reach(p), least_reach)) pairs.push_back({distance, a, b});
  };
  for (const FailedPair& f : failed) {
    std::array<VertexId, 6> corners;
    const auto second = std::copy_n(merged.mesh.triangles[f.a.index()].begin(), 3, corners.begin());
    std::copy_n(merged.mesh.triangles[f.b.index()].begin(), 3, second);
    std::sort(corners.begin(), corners.end());
    const auto end = std::unique(corners.begin(), corners.end());
    for (auto p = corners.begin(); p != end; ++p) {
      for (auto q = p + 1; q != end; ++q) add(*p, *q);
    }
  }
  std::sort(pairs.begin(), pairs.end(), [&](const ClosePair& p, const ClosePair& q) {
    if (p.distance != q.distance) return p.distance < q.distance;
    return p.a != q.a ? precedes(p.a, q.a) : precedes(p.b, q.b);
  });
  const auto is_same = [](const ClosePair& p, const ClosePair& q) { return p.a == q.a && p.b == q.b; };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), is_same), pairs.end());
  return pairs;
}

// The vertex that takes the place of each.
class Replacement {
 public:
  Replacement(const Precedence& precedes, std::size_t vertex_count) : precedes_(precedes) {
    for (std::size_t v = 0; v < vertex_count; ++v) of_.push_back(VertexId(v));
  }

  bool merge(VertexId a, VertexId b) {
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

  bool operator<(const SortedTriangle& other) const {
    return corners != other.corners ? corners < other.corners : triangle < other.triangle;
  }
};

SortedTriangle sorted_triangle(const Triangle& t, std::uint32_t number) {
  const auto first = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  const VertexId a = t[first];
  const VertexId b = t[(first + 1) % 3];
  const VertexId c = t[(first + 2) % 3];
  return b < c ? SortedTriangle{{a, b, c}, true, number} : SortedTriangle{{a, c, b}, false, number};
}

// Triangles that remain: not those with a corner twice, not pairs that cancel.
std::vector<std::uint8_t> find_remaining(const std::vector<Triangle>& triangles) {
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
  std::sort(sorted.begin(), sorted.end());
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

void apply(const Replacement& replacement, MergedMesh& merged) {
  note_facets_before_repair(merged);
  replace_corners(replacement, merged);
  const bool has_walls = !merged.provenance.covering_front.empty();
  keep_triangles(has_walls ? join_coincident(merged) : find_remaining(merged.mesh.triangles), merged);
}

}  // namespace

void merge_equal_vertices(const OperandFaces& faces, MergedMesh& merged) {
  const std::vector<Vec3d>& points = merged.mesh.points;
  const Precedence precedes(faces, merged);
  std::vector<VertexId> made;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!precedes.is_input(VertexId(v))) made.push_back(VertexId(v));
  }
  std::sort(made.begin(), made.end(), precedes);
  Replacement replacement(precedes, points.size());
  bool any = false;
  for (std::size_t i = 1; i < made.size(); ++i) {
    if (points[made[i].index()] == points[made[i - 1].index()]) any |= replacement.merge(made[i - 1], made[i]);
  }
  if (any) apply(replacement, merged);
}

bool merge_close_vertices(const OperandFaces& faces, std::span<const FailedPair> failed, double least_reach, MergedMesh& merged) {
  const Precedence precedes(faces, merged);
  Replacement replacement(precedes, merged.mesh.points.size());
  bool any = false;
  for (const ClosePair& pair : find_close_pairs(merged, precedes, failed, least_reach)) any |= replacement.merge(pair.a, pair.b);
  if (any) apply(replacement, merged);
  return any;
}

}  // namespace mortise
