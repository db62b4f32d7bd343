// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Patches by union-find over free corners and plain edges; regions by the order round junctions.
#include "mortise/boolean/patches.h"

#include <algorithm>
#include <functional>

#include "mortise/base/sort_in_buckets.h"
#include "mortise/base/union_find.h"

namespace mortise {
namespace {

// An edge of a facet between two points that are not free.
struct FacetEdge {
  std::uint64_t key;  // smaller point, larger point
  FacetId facet;
  bool is_forward;  // runs from the smaller to the larger point

  bool operator<(const FacetEdge& other) const { return key != other.key ? key < other.key : facet < other.facet; }
};

void add_jump(std::vector<Jump>& jumps, OperandId k, int change) {
  const auto at = std::lower_bound(jumps.begin(), jumps.end(), k, [](const Jump& j, OperandId operand) { return j.operand < operand; });
  if (at != jumps.end() && at->operand == k) {
    at->change += change;
  } else {
    jumps.insert(at, {k, change});
  }
}

class PatchBuilder {
 public:
  PatchBuilder(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets)
      : faces_(faces), facets_(facets), joined_(faces.points.size()), is_free_(faces.points.size(), 0) {
    mark_free_points(map);
  }

  [[nodiscard]] Patches build() && {
    join_at_free_points();
    sort_edges();
    for (std::size_t i = 0; i < edges_.size();) {
      std::size_t end = i;
      while (end < edges_.size() && edges_[end].key == edges_[i].key) ++end;
      visit_edge(std::span(edges_).subspan(i, end - i));
      i = end;
    }
    number_patches();
    join_sides();
    return std::move(patches_);
  }

 private:
  void mark_free_points(const FaceIntersectionMap& map) {
    std::fill(is_free_.begin(), is_free_.begin() + static_cast<std::ptrdiff_t>(faces_.points.input_count()), std::uint8_t{1});
    for (const PointId p : map.contact_points) is_free_[p.index()] = 0;
    for (std::size_t k = 0; k < faces_.operand_count(); ++k) {
      if (faces_.self_contacts[OperandId(k)] != SelfContacts::All && !has_walls(faces_.kind[OperandId(k)])) continue;
      for (const PointId p : faces_.point_of_vertex[OperandId(k)]) is_free_[p.index()] = 0;
    }
  }

  // A facet with a free corner is part of what is joined at that corner; any other facet starts on its own.
  void join_at_free_points() {
    node_.resize(facets_.size());
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const FacetId f(i);
      const PlanePoints& c = facets_.corners[f];
      std::uint32_t node = 0;
      bool has_free = false;
      for (const PointId p : c) {
        if (is_free_[p.index()] == 0) continue;
        if (has_free) joined_.join(node, p.value);
        node = p.value;
        has_free = true;
      }
      node_[f] = has_free ? node : joined_.add();
      for (std::size_t e = 0; e < 3; ++e) add_edge(f, c[e], c[(e + 1) % 3]);
    }
  }

  void add_edge(FacetId f, PointId p, PointId q) {
    if (is_free_[p.index()] != 0 || is_free_[q.index()] != 0) return;
    const bool is_forward = p < q;
    const std::uint64_t key = (std::uint64_t{std::min(p, q).value} << 32U) | std::max(p, q).value;
    edges_.push_back({key, f, is_forward});
  }

  // By key, then facet; few edges share their smaller point.
  void sort_edges() {
    const auto smaller_point = [](const FacetEdge& e) { return static_cast<std::size_t>(e.key >> 32U); };
    edges_ = sorted_in_buckets(edges_, faces_.points.size(), smaller_point, std::less<>());
  }

  bool continue_each_other(const FacetEdge& a, const FacetEdge& b) const {
    if (a.is_forward == b.is_forward) return false;
    const auto of_a = facets_.sources_of(a.facet);
    const auto of_b = facets_.sources_of(b.facet);
    if (of_a.size() == 1 && of_b.size() == 1) {
      const SourceId f = of_a[0].face, g = of_b[0].face;
      return faces_.operand[f] == faces_.operand[g] && faces_.is_wall[f] == faces_.is_wall[g];
    }
    return jumps_of(faces_, facets_, a.facet) == jumps_of(faces_, facets_, b.facet) &&
           walls_of(faces_, facets_, a.facet) == walls_of(faces_, facets_, b.facet);
  }

  void visit_edge(std::span<const FacetEdge> group) {
    if (group.size() == 2 && continue_each_other(group[0], group[1])) {
      joined_.join(node_[group[0].facet], node_[group[1].facet]);
      return;
    }
    Junction junction{PointId(static_cast<std::uint32_t>(group[0].key >> 32U)), PointId(static_cast<std::uint32_t>(group[0].key)),
                      static_cast<std::uint32_t>(patches_.around.size()), static_cast<std::uint32_t>(group.size())};
    check_balance(junction, group);
    std::vector<FacetAtEdge> around;
    for (const FacetEdge& e : group) around.push_back(facet_at_edge(faces_, facets_, e.facet, junction.u, junction.v));
    sort_round_edge(faces_, around);
    check_half_planes(around);
    patches_.around.insert(patches_.around.end(), around.begin(), around.end());
    patches_.junctions.push_back(junction);
  }

  void check_balance(const Junction& junction, std::span<const FacetEdge> group) {
    std::vector<Jump> sum;
    std::vector<Jump> count;
    for (const FacetEdge& e : group) {
      for (const FacetSource& s : facets_.sources_of(e.facet)) {
        if (faces_.is_wall[s.face] != 0) continue;
        add_jump(sum, faces_.operand[s.face], s.is_opposite == e.is_forward ? -1 : 1);
        add_jump(count, faces_.operand[s.face], 1);
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (sum[i].change != 0) patches_.unbalanced.push_back({sum[i].operand, junction.u, junction.v, count[i].change % 2 != 0});
    }
  }

  void check_half_planes(std::span<const FacetAtEdge> around) {
    const auto check = [&](const FacetAtEdge& a, const FacetAtEdge& b) {
      const OperandId k = faces_.operand[a.face];
      if (k == faces_.operand[b.face] && share_half_plane(faces_, a, b)) patches_.stacked.push_back(k);
    };
    for (std::size_t i = 1; i < around.size(); ++i) {
      check(around[0], around[i]);  // those on its half-plane are sorted with the opposite ones
      if (i > 1) check(around[i - 1], around[i]);
    }
  }

  void number_patches() {
    std::vector<PatchId> patch_of_node(joined_.size());
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const FacetId f(i);
      PatchId& patch = patch_of_node[joined_.find(node_[f])];
      if (!patch.is_valid()) patch = patches_.first_facet.push_back(f);
      patches_.patch_of_facet.push_back(patch);
    }
  }

  // Between two neighbours round a junction lies one region: after the one and before the other.
  void join_sides() {
    UnionFind sides(2 * patches_.first_facet.size());  // 2 p: front of patch p, 2 p + 1: its back
    const auto after = [&](const FacetAtEdge& f) { return 2 * patches_.patch_of_facet[f.facet].value + (f.is_front_after() ? 0U : 1U); };
    const auto before = [&](const FacetAtEdge& f) { return 2 * patches_.patch_of_facet[f.facet].value + (f.is_front_after() ? 1U : 0U); };
    for (const Junction& j : patches_.junctions) {
      const auto around = patches_.facets_round(j);
      for (std::size_t i = 0; i < around.size(); ++i) sides.join(after(around[i]), before(around[(i + 1) % around.size()]));
    }
    std::vector<RegionId> region_of(sides.size());
    const auto region = [&](std::uint32_t side) {
      RegionId& r = region_of[sides.find(side)];
      if (!r.is_valid()) r = RegionId(patches_.region_count++);
      return r;
    };
    for (std::uint32_t p = 0; p < patches_.first_facet.size(); ++p) {
      patches_.front.push_back(region(2 * p));
      patches_.back.push_back(region(2 * p + 1));
    }
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  UnionFind joined_;  // points, then facets without a free corner
  std::vector<std::uint8_t> is_free_;
  IdVector<FacetId, std::uint32_t> node_;
  std::vector<FacetEdge> edges_;
  Patches patches_;
};

}  // namespace

std::vector<Jump> jumps_of(const OperandFaces& faces, const Facets& facets, FacetId f) {
  std::vector<Jump> jumps;
  for (const FacetSource& s : facets.sources_of(f)) {
    if (faces.is_wall[s.face] == 0) add_jump(jumps, faces.operand[s.face], s.is_opposite ? -1 : 1);
  }
  jumps.erase(std::remove_if(jumps.begin(), jumps.end(), [](const Jump& j) { return j.change == 0; }), jumps.end());
  return jumps;
}

std::vector<OperandId> walls_of(const OperandFaces& faces, const Facets& facets, FacetId f) {
  std::vector<OperandId> operands;
  for (const FacetSource& s : facets.sources_of(f)) {
    const OperandId k = faces.operand[s.face];
    if (faces.is_wall[s.face] != 0 && (operands.empty() || operands.back() != k)) operands.push_back(k);
  }
  return operands;
}

Patches build_patches(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets) {
  return PatchBuilder(faces, map, facets).build();
}

}  // namespace mortise
