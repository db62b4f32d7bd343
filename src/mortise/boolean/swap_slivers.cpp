// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Edge swaps on the compact result, near failed triangles only.
#include "mortise/boolean/swap_slivers.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "mortise/boolean/repair_reach.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

struct DirectedEdge {
  VertexId from, to;
  FaceId triangle;

  auto operator<=>(const DirectedEdge&) const = default;
};

class SliverSwapper {
 public:
  SliverSwapper(std::span<const FailedPair> failed, double least_reach, MergedMesh& merged)
      : least_reach_(least_reach), merged_(merged), mesh_(merged.mesh) {
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
      const Vec3d &p = position(t[i]), &q = position(t[longest]);
      // Lengths that round alike are told apart by where they are, not by which corner comes first.
      const bool is_before = std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
      if (size[i] > size[longest] || (size[i] == size[longest] && is_before)) longest = i;
    }
    if (!(size[longest] > 0)) return false;
    const Vec3d& top = position(t[(longest + 2) % 3]);
    height = height_over(position(t[longest]), position(t[(longest + 1) % 3]), top);
    return height <= std::max(repair_reach(top), least_reach_);
  }

  //      a               a
  //    /   \           / | \ .
  //   u-----v   ->    u  |  v     the sliver is u v a
  //    \   /           \ | /
  //      w               w
  bool swap_if_sliver(FaceId t) {
    std::size_t longest = 0;
    double height = 0;
    if (was_swapped(t) || !is_sliver(mesh_.triangles[t.index()], longest, height)) return false;
    const VertexId u = mesh_.triangles[t.index()][longest];
    const VertexId v = mesh_.triangles[t.index()][(longest + 1) % 3];
    const VertexId a = mesh_.triangles[t.index()][(longest + 2) % 3];
    const auto across = find(v, u);
    if (find(u, v).size() != 1 || across.size() != 1 || was_swapped(across[0].triangle)) return false;
    const FaceId n = across[0].triangle;
    const Triangle& c = mesh_.triangles[n.index()];
    const VertexId w = c[0] != u && c[0] != v ? c[0] : c[1] != u && c[1] != v ? c[1] : c[2];
    if (w == a || !find(a, w).empty() || !find(w, a).empty()) return false;
    note_facets_before_repair(merged_);
    replace(t, n, {a, u, w}, {w, v, a});
    merged_.repair_displacement = std::max(merged_.repair_displacement, height);
    return true;
  }

  [[nodiscard]] bool was_swapped(FaceId t) const { return std::find(swapped_.begin(), swapped_.end(), t) != swapped_.end(); }

  // Triangles t and n get new corners; both belong to the face of n.
  void replace(FaceId t, FaceId n, const Triangle& first, const Triangle& second) {
    mesh_.triangles[t.index()] = first;
    mesh_.triangles[n.index()] = second;
    merged_.facet_of_triangle[t.index()] = merged_.facet_of_triangle[n.index()];
    merged_.is_repaired[t.index()] = merged_.is_repaired[n.index()] = 1;
    if (!mesh_.face_labels.empty()) mesh_.face_labels[t.index()] = mesh_.face_labels[n.index()];
    Provenance& p = merged_.provenance;
    p.source_operand[t.index()] = p.source_operand[n.index()];
    p.source_face[t.index()] = p.source_face[n.index()];
    p.flipped[t.index()] = p.flipped[n.index()];
    p.category[t.index()] = p.category[n.index()];
    p.covering[t.index()] = p.covering[n.index()];
    if (!p.covering_front.empty()) p.covering_front[t.index()] = p.covering_front[n.index()];
    copy_other_sources(t, n);
    swapped_.push_back(t);
    swapped_.push_back(n);
  }

  void copy_other_sources(FaceId to, FaceId from) {
    Provenance& p = merged_.provenance;
    const auto copy_one = [&](std::vector<std::uint32_t>& entries) {
      const std::vector<std::uint32_t> source(entries.begin() + p.other_source_begin[from.index()],
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
    for (std::size_t i = to.index() + 1; i < p.other_source_begin.size(); ++i) p.other_source_begin[i] += new_count - old_count;
  }

  double least_reach_;
  MergedMesh& merged_;
  SurfaceMesh& mesh_;
  std::vector<FaceId> candidates_;
  std::vector<DirectedEdge> edges_;
  std::vector<FaceId> swapped_;
};

}  // namespace

bool swap_slivers(std::span<const FailedPair> failed, double least_reach, MergedMesh& merged) {
  return SliverSwapper(failed, least_reach, merged).run();
}

}  // namespace mortise
