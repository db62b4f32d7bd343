// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Edge swaps on the compact result, near failed triangles only.
#include "mortise/boolean/swap_slivers.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mortise/boolean/join_coincident.h"
#include "mortise/boolean/keep_triangles.h"
#include "mortise/geom/length.h"
#include "mortise/geom/lexicographic.h"
#include "mortise/mesh/face_marks.h"

namespace mortise {
namespace {

struct DirectedEdge {
  VertexId from, to;
  FaceId triangle;

  auto operator<=>(const DirectedEdge&) const = default;
};

class SliverSwapper {
 public:
  SliverSwapper(const FacetOrder& precedes, std::span<const FailedPair> failed, const RepairReach& reach, MergedMesh& merged)
      : precedes_(precedes), reach_(reach), has_walls_(!merged.provenance.covering_front.empty()), merged_(merged), mesh_(merged.mesh) {
    std::vector<std::uint8_t> is_near(mesh_.points.size(), 0);
    for (const FailedPair& f : failed) {
      for (const FaceId t : {f.a, f.b}) {
        for (const VertexId v : mesh_.triangles[t.index()]) is_near[v.index()] = 1;
      }
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& c = mesh_.triangles[t];
      const int near = is_near[c[0].index()] + is_near[c[1].index()] + is_near[c[2].index()];
      if (near == 0) continue;
      if (near >= 2) candidates_.push_back(FaceId(t));
      for (std::size_t i = 0; i < 3; ++i) edges_.push_back({c[i], c[(i + 1) % 3], FaceId(t)});
    }
    std::sort(edges_.begin(), edges_.end());
    sort_by_position(candidates_);
  }

  bool run() {
    bool any = false;
    for (const FaceId t : candidates_) any |= swap_if_sliver(t);
    if (any && has_walls_) keep_triangles(join_coincident(precedes_, merged_), merged_);
    return any;
  }

 private:
  [[nodiscard]] const Vec3d& position(VertexId v) const { return mesh_.points[v.index()]; }

  // Swaps exclude one another: their order must not be that of the operands.
  void sort_by_position(std::vector<FaceId>& triangles) const {
    using Key = std::array<std::array<double, 3>, 3>;
    std::vector<std::pair<Key, FaceId>> keyed;
    for (const FaceId t : triangles) {
      Key key;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d& p = position(mesh_.triangles[t.index()][i]);
        key[i] = {p.x, p.y, p.z};
      }
      std::sort(key.begin(), key.end());
      keyed.emplace_back(key, t);
    }
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t i = 0; i < keyed.size(); ++i) triangles[i] = keyed[i].second;
  }

  [[nodiscard]] std::span<const DirectedEdge> find(VertexId from, VertexId to) const {
    const auto begin = std::lower_bound(edges_.begin(), edges_.end(), DirectedEdge{from, to, FaceId(std::size_t{0})});
    auto end = begin;
    while (end != edges_.end() && end->from == from && end->to == to) ++end;
    return std::span<const DirectedEdge>(edges_).subspan(static_cast<std::size_t>(begin - edges_.begin()),
                                                         static_cast<std::size_t>(end - begin));
  }

  // The edge of a triangle that is longest; the triangle's height over it is within reach.
  [[nodiscard]] bool is_sliver(const Triangle& t, std::size_t& longest, double& height) const {
    std::array<double, 3> size{};
    for (std::size_t i = 0; i < 3; ++i) size[i] = length(position(t[(i + 1) % 3]) - position(t[i]));
    longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      // Lengths that round alike are told apart by the corner that is not theirs: which comes first, and which way round, says nothing.
      const bool is_before = is_lexicographically_less(position(t[(i + 2) % 3]), position(t[(longest + 2) % 3]));
      if (size[i] > size[longest] || (size[i] == size[longest] && is_before)) longest = i;
    }
    if (!(size[longest] > 0)) return false;
    const Vec3d& top = position(t[(longest + 2) % 3]);
    height = height_over(position(t[longest]), position(t[(longest + 1) % 3]), top);
    return height <= reach_.at(top);
  }

  //      a               a
  //    /   \           / | \ .
  //   u-----v   ->    u  |  v     the sliver is u v a, w stands for every other triangle at u v
  //    \   /           \ | /
  //      w               w
  bool swap_if_sliver(FaceId t) {
    std::size_t longest = 0;
    double height = 0;
    if (was_swapped(t) || !is_sliver(mesh_.triangles[t.index()], longest, height)) return false;
    const VertexId u = mesh_.triangles[t.index()][longest];
    const VertexId v = mesh_.triangles[t.index()][(longest + 1) % 3];
    const VertexId a = mesh_.triangles[t.index()][(longest + 2) % 3];
    const std::vector<FaceId> others = others_at(t, u, v);
    const bool can_split = !others.empty() && (others.size() == 1 || has_walls_) &&
                           std::all_of(others.begin(), others.end(), [&](FaceId n) { return can_take(n, a, u, v); });
    if (!can_split) return false;
    note_facets_before_repair(merged_);
    swapped_.push_back(t);
    for (std::size_t i = 0; i < others.size(); ++i) split(others[i], i == 0 ? t : append_row(), {a, u, v});
    merged_.repair_displacement = std::max(merged_.repair_displacement, height);
    return true;
  }

  // All other triangles at the edge of a sliver.
  [[nodiscard]] std::vector<FaceId> others_at(FaceId t, VertexId u, VertexId v) const {
    std::vector<FaceId> others;
    for (const auto& at : {find(v, u), find(u, v)}) {
      for (const DirectedEdge& e : at) {
        if (e.triangle != t) others.push_back(e.triangle);
      }
    }
    return others;
  }

  [[nodiscard]] VertexId apex(FaceId n, VertexId u, VertexId v) const {
    const Triangle& c = mesh_.triangles[n.index()];
    return c[0] != u && c[0] != v ? c[0] : c[1] != u && c[1] != v ? c[1] : c[2];
  }

  // May vertex a go into the edge u v of a triangle? Where inner faces are kept, halves that coincide with others are joined.
  [[nodiscard]] bool can_take(FaceId n, VertexId a, VertexId u, VertexId v) const {
    if (was_swapped(n)) return false;
    const VertexId w = apex(n, u, v);
    return w != a && (has_walls_ || (find(a, w).empty() && find(w, a).empty()));
  }

  // Triangle n and the one in `slot` become the halves of n on both sides of vertex a in its edge u v.
  void split(FaceId n, FaceId slot, const Triangle& sliver) {
    const auto [a, u, v] = sliver;
    const VertexId w = apex(n, u, v);
    const Triangle& c = mesh_.triangles[n.index()];
    const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
    const bool runs_against = c[(at + 1) % 3] == u;
    copy_row(slot, n);
    set_corners(slot, runs_against ? Triangle{a, u, w} : Triangle{a, w, u}, mesh_);
    set_corners(n, runs_against ? Triangle{w, v, a} : Triangle{w, a, v}, mesh_);
    merged_.is_repaired[slot.index()] = merged_.is_repaired[n.index()] = 1;
    swapped_.push_back(n);
  }

  [[nodiscard]] bool was_swapped(FaceId t) const { return std::find(swapped_.begin(), swapped_.end(), t) != swapped_.end(); }

  // Triangle t belongs to the face of n from now on.
  void copy_row(FaceId t, FaceId n) {
    merged_.facet_of_triangle[t.index()] = merged_.facet_of_triangle[n.index()];
    copy_face_marks(n, t, mesh_);
    Provenance& p = merged_.provenance;
    p.source_operand[t.index()] = p.source_operand[n.index()];
    p.source_face[t.index()] = p.source_face[n.index()];
    p.flipped[t.index()] = p.flipped[n.index()];
    p.category[t.index()] = p.category[n.index()];
    p.covering[t.index()] = p.covering[n.index()];
    if (!p.covering_front.empty()) p.covering_front[t.index()] = p.covering_front[n.index()];
    copy_other_sources(t, n);
  }

  FaceId append_row() {
    Provenance& p = merged_.provenance;
    mesh_.triangles.emplace_back();
    resize_face_marks(mesh_);
    merged_.facet_of_triangle.emplace_back();
    merged_.is_repaired.push_back(0);
    for (auto* row : {&p.source_operand, &p.source_face, &p.covering, &p.covering_front}) row->push_back(0);
    p.flipped.push_back(0);
    p.category.push_back(FacetCategory::Outside);
    p.other_source_begin.push_back(p.other_source_begin.back());
    return FaceId(mesh_.triangles.size() - 1);
  }

  void copy_other_sources(FaceId to, FaceId from) {
    Provenance& p = merged_.provenance;
    const auto copy_one = [&](auto& entries) {
      const std::vector source(entries.begin() + p.other_source_begin[from.index()],
                               entries.begin() + p.other_source_begin[from.index() + 1]);
      const auto begin = entries.begin() + p.other_source_begin[to.index()];
      const auto at = entries.erase(begin, entries.begin() + p.other_source_begin[to.index() + 1]);
      entries.insert(at, source.begin(), source.end());
    };
    const std::uint32_t old_count = p.other_source_begin[to.index() + 1] - p.other_source_begin[to.index()];
    const std::uint32_t new_count = p.other_source_begin[from.index() + 1] - p.other_source_begin[from.index()];
    if (old_count == 0 && new_count == 0) return;
    copy_one(p.other_source_operand);
    copy_one(p.other_source_face);
    copy_one(p.other_source_flipped);
    for (std::size_t i = to.index() + 1; i < p.other_source_begin.size(); ++i) p.other_source_begin[i] += new_count - old_count;
  }

  const FacetOrder& precedes_;
  RepairReach reach_;
  bool has_walls_;
  MergedMesh& merged_;
  SurfaceMesh& mesh_;
  std::vector<FaceId> candidates_;
  std::vector<DirectedEdge> edges_;
  std::vector<FaceId> swapped_;
};

}  // namespace

bool swap_slivers(const FacetOrder& precedes, std::span<const FailedPair> failed, const RepairReach& reach, MergedMesh& merged) {
  return SliverSwapper(precedes, failed, reach, merged).run();
}

}  // namespace mortise
