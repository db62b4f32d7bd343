// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which edges and vertices stay, then a triangulation of every group of joined facets that lost a vertex.
#include "mortise/boolean/simplify.h"

#include <algorithm>
#include <array>

#include "mortise/arrange/triangulate_region.h"
#include "mortise/base/error.h"
#include "mortise/base/sort_unique.h"
#include "mortise/base/union_find.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

using KeptId = Id<struct KeptTag>;  // position in Selection::kept

// A side of a kept facet, as it runs in the result.
struct Side {
  PointId from, to;
  KeptId facet;

  [[nodiscard]] PointId low() const { return std::min(from, to); }
  [[nodiscard]] PointId high() const { return std::max(from, to); }
};

bool is_before(const Side& a, const Side& b) {
  if (a.low() != b.low()) return a.low() < b.low();
  return a.high() != b.high() ? a.high() < b.high() : a.facet < b.facet;
}

struct GroupAtPoint {
  PointId point;
  KeptId group;

  auto operator<=>(const GroupAtPoint&) const = default;
};

class Simplifier {
 public:
  Simplifier(const SimplifyRule& rule, const OperandFaces& faces, Facets& facets, Selection& selection)
      : rule_(rule), faces_(faces), facets_(facets), selection_(selection), groups_(selection.kept.size()) {}

  void run() {
    find_touched();
    collect_sides();
    join_across_sides();
    decide_vertices();
    replace_groups();
  }

 private:
  [[nodiscard]] const KeptFacet& kept(KeptId k) const { return selection_.kept[k.index()]; }
  [[nodiscard]] const PlanePoints& corners(KeptId k) const { return facets_.corners[kept(k).facet]; }
  [[nodiscard]] const FacetSource& first_source(KeptId k) const { return facets_.sources_of(kept(k).facet).front(); }
  [[nodiscard]] KeptId group_of(KeptId k) { return KeptId(groups_.find(k.value)); }

  // ---- which facets take part

  void find_touched() {
    is_touched_.assign(selection_.kept.size(), 0);
    is_pinned_.assign(faces_.points.size(), 0);
    const bool is_alone = faces_.operand_count() == 1;
    for (std::size_t i = 0; i < is_touched_.size(); ++i) {
      const PlanePoints& c = corners(KeptId(i));
      is_touched_[i] = is_alone || std::any_of(c.begin(), c.end(), [&](PointId p) { return is_at_contact(p); }) ? 1 : 0;
      for (const PointId p : c) {
        if (is_touched_[i] == 0 || is_own_vertex(KeptId(i), p)) is_pinned_[p.index()] = 1;
      }
    }
  }

  [[nodiscard]] bool is_at_contact(PointId p) const {
    return !faces_.points.is_input(p) || std::binary_search(rule_.contact_points.begin(), rule_.contact_points.end(), p);
  }

  // A vertex of the operand, which only Simplify::Coplanar may remove.
  [[nodiscard]] bool is_own_vertex(KeptId k, PointId p) const {
    if (rule_.level == Simplify::Coplanar) return false;
    const PlanePoints& c = faces_.corners[first_source(k).face];
    return std::find(c.begin(), c.end(), p) != c.end();
  }

  // ---- which edges stay

  // Those of touched facets, and of others between their vertices.
  void collect_sides() {
    std::vector<std::uint8_t> is_near(faces_.points.size(), 0);
    for (std::size_t i = 0; i < is_touched_.size(); ++i) {
      if (is_touched_[i] == 0) continue;
      for (const PointId p : corners(KeptId(i))) is_near[p.index()] = 1;
    }
    for (std::size_t i = 0; i < is_touched_.size(); ++i) {
      PlanePoints c = corners(KeptId(i));
      if (selection_.kept[i].is_flipped) std::swap(c[1], c[2]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Side side{c[k], c[(k + 1) % 3], KeptId(i)};
        if (is_near[side.from.index()] != 0 && is_near[side.to.index()] != 0) sides_.push_back(side);
      }
    }
    std::sort(sides_.begin(), sides_.end(), is_before);
  }

  void join_across_sides() {
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t end = i;
      while (end < sides_.size() && sides_[end].low() == sides_[i].low() && sides_[end].high() == sides_[i].high()) ++end;
      if (end - i == 2 && can_join(sides_[i], sides_[i + 1])) {
        groups_.join(sides_[i].facet.value, sides_[i + 1].facet.value);
      } else {
        staying_.insert(staying_.end(), sides_.begin() + static_cast<std::ptrdiff_t>(i), sides_.begin() + static_cast<std::ptrdiff_t>(end));
      }
      i = end;
    }
  }

  [[nodiscard]] bool can_join(const Side& a, const Side& b) const {
    if (a.from == b.from || is_touched_[a.facet.index()] == 0 || is_touched_[b.facet.index()] == 0) return false;
    const KeptFacet &f = kept(a.facet), &g = kept(b.facet);
    if (f.is_wall != g.is_wall || !have_same_operands(f, g)) return false;
    const SourceId s = first_source(a.facet).face, t = first_source(b.facet).face;
    if (s == t) return f.is_flipped == g.is_flipped;
    return rule_.level == Simplify::Coplanar && rule_.agree(s, t) && lie_in_one_plane(s, t) &&
           turn_in(f, axis_of(s)) == turn_in(g, axis_of(s));
  }

  // Where the result keeps more than inside and outside apart: on both sides, and the tag.
  [[nodiscard]] bool have_same_operands(const KeptFacet& f, const KeptFacet& g) const {
    if (!selection_.keeps_walls && !selection_.keeps_regions_apart) return true;
    const auto& inside = selection_.operands_inside;
    return f.category == g.category && inside[f.inside] == inside[g.inside] &&
           (!selection_.keeps_walls || inside[f.outside] == inside[g.outside]);
  }

  [[nodiscard]] const Vec3d& corner(SourceId s, std::size_t i) const { return faces_.corner_position(s, i); }

  [[nodiscard]] bool lie_in_one_plane(SourceId s, SourceId t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (orient3d(corner(s, 0), corner(s, 1), corner(s, 2), corner(t, i)) != Sign::Zero) return false;
    }
    return true;
  }

  [[nodiscard]] Axis axis_of(SourceId s) const { return *projection_axis(corner(s, 0), corner(s, 1), corner(s, 2)); }
  [[nodiscard]] Sign turn_of(SourceId s, Axis axis) const { return orient2d(corner(s, 0), corner(s, 1), corner(s, 2), axis); }

  // How a facet lies in the result, seen along an axis.
  [[nodiscard]] Sign turn_in(const KeptFacet& f, Axis axis) const {
    const Sign turn = turn_of(facets_.sources_of(f.facet).front().face, axis);
    return f.is_flipped ? -turn : turn;
  }

  // ---- which vertices stay

  void decide_vertices() {
    is_removed_.assign(faces_.points.size(), 0);
    neighbours_.resize(faces_.points.size());
    std::vector<std::uint32_t> degree(faces_.points.size(), 0), groups(degree), groups_on_sides(degree);
    count_groups(groups, groups_on_sides);
    for (std::size_t i = 0; i < staying_.size(); ++i) {
      const Side& s = staying_[i];
      if (i > 0 && staying_[i - 1].low() == s.low() && staying_[i - 1].high() == s.high()) continue;
      add_neighbour(s.from, s.to, degree);
      add_neighbour(s.to, s.from, degree);
    }
    for (std::size_t i = 0; i < is_removed_.size(); ++i) {
      if (is_pinned_[i] != 0) continue;
      const bool is_inside = degree[i] == 0 && groups[i] == 1;
      const bool may_be_straight = degree[i] == 2 && groups[i] == groups_on_sides[i];
      is_removed_[i] = is_inside || (may_be_straight && is_straight(PointId(i))) ? 1 : 0;
    }
  }

  // Per point: the groups that have it, and those for which it is on an edge that stays. Two that touch in it alone need it.
  void count_groups(std::vector<std::uint32_t>& groups, std::vector<std::uint32_t>& groups_on_sides) {
    const auto count = [&](const std::vector<Side>& sides, std::vector<std::uint32_t>& counts) {
      std::vector<GroupAtPoint> list;
      for (const Side& s : sides) {
        list.push_back({s.from, group_of(s.facet)});
        list.push_back({s.to, group_of(s.facet)});
      }
      sort_unique(list);
      for (const GroupAtPoint& g : list) ++counts[g.point.index()];
    };
    count(sides_, groups);
    count(staying_, groups_on_sides);
  }

  void add_neighbour(PointId p, PointId neighbour, std::vector<std::uint32_t>& degree) {
    std::uint32_t& d = degree[p.index()];
    if (d < 2) neighbours_[p.index()][d] = neighbour;
    ++d;
  }

  // Do the two edges at the point continue each other?
  [[nodiscard]] bool is_straight(PointId p) const {
    const auto& [a, b] = neighbours_[p.index()];
    const PointSet& points = faces_.points;
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      if (points.orient2d(a, p, b, axis) != Sign::Zero) return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign to_a = points.compare(a, p, i);
      if (to_a != Sign::Zero) return points.compare(b, p, i) == -to_a;
    }
    return false;
  }

  // ---- what takes the place of a group

  void replace_groups() {
    std::vector<std::vector<LinePoints>> borders(selection_.kept.size());
    for (const Side& s : staying_) {
      if (is_removed_[s.from.index()] == 0) borders[group_of(s.facet).index()].push_back({s.from, end_of_chain(s)});
    }
    std::vector<std::vector<KeptId>> members(selection_.kept.size());
    for (std::size_t i = 0; i < is_touched_.size(); ++i) {
      if (is_touched_[i] != 0) members[group_of(KeptId(i)).index()].push_back(KeptId(i));
    }
    is_replaced_.assign(selection_.kept.size(), 0);
    std::vector<KeptFacet> added;
    for (std::size_t g = 0; g < members.size(); ++g) {
      if (has_removed_vertex(members[g])) replace_group(members[g], borders[g], added);
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < is_replaced_.size(); ++i) {
      if (is_replaced_[i] == 0) selection_.kept[next++] = selection_.kept[i];
    }
    selection_.kept.resize(next);
    selection_.kept.insert(selection_.kept.end(), added.begin(), added.end());
  }

  // Along removed vertices to the first that stays.
  [[nodiscard]] PointId end_of_chain(const Side& s) const {
    PointId before = s.from, p = s.to;
    while (is_removed_[p.index()] != 0) {
      const auto& [a, b] = neighbours_[p.index()];
      const PointId next = a == before ? b : a;
      before = p;
      p = next;
    }
    return p;
  }

  [[nodiscard]] bool has_removed_vertex(const std::vector<KeptId>& group) const {
    for (const KeptId k : group) {
      const PlanePoints& c = corners(k);
      if (std::any_of(c.begin(), c.end(), [&](PointId p) { return is_removed_[p.index()] != 0; })) return true;
    }
    return false;
  }

  void replace_group(const std::vector<KeptId>& group, std::vector<LinePoints>& border, std::vector<KeptFacet>& added) {
    const SourceId face = first_source(group.front()).face;
    const Axis axis = axis_of(face);
    const Sign turn = turn_in(kept(group.front()), axis);
    if (turn == Sign::Negative) {
      for (LinePoints& segment : border) std::swap(segment[0], segment[1]);
    }
    const std::vector<PlanePoints> triangles = triangulate_region(faces_.points, axis, border, staying_points(group));
    const std::vector<FacetSource> sources = sources_of(group, axis);
    KeptFacet facet = kept(group.front());
    for (const KeptId k : group) {
      is_replaced_[k.index()] = 1;
      facet.category = std::min(facet.category, kept(k).category);
    }
    const Sign turn_of_first = turn_of(sources.front().face, axis);
    facet.is_flipped = turn_of_first != turn;
    for (PlanePoints t : triangles) {
      if (turn_of_first == Sign::Negative) std::swap(t[1], t[2]);
      facet.facet = add_facet(t, sources);
      added.push_back(facet);
    }
  }

  [[nodiscard]] std::vector<PointId> staying_points(const std::vector<KeptId>& group) const {
    std::vector<PointId> points;
    for (const KeptId k : group) {
      for (const PointId p : corners(k)) {
        if (is_removed_[p.index()] == 0) points.push_back(p);
      }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  // All faces the facets of a group have, lowest first; under Simplify::Cut, only those that all of them have.
  [[nodiscard]] std::vector<FacetSource> sources_of(const std::vector<KeptId>& group, Axis axis) const {
    std::vector<SourceId> all;
    for (const KeptId k : group) {
      for (const FacetSource& s : facets_.sources_of(kept(k).facet)) all.push_back(s.face);
    }
    std::sort(all.begin(), all.end());
    std::vector<FacetSource> sources;
    const std::size_t least = rule_.level == Simplify::Cut ? group.size() : 1;
    for (std::size_t i = 0; i < all.size();) {
      const auto end =
          static_cast<std::size_t>(std::upper_bound(all.begin() + static_cast<std::ptrdiff_t>(i), all.end(), all[i]) - all.begin());
      if (end - i >= least) sources.push_back({all[i], false});
      i = end;
    }
    for (FacetSource& s : sources) s.is_opposite = turn_of(s.face, axis) != turn_of(sources.front().face, axis);
    return sources;
  }

  FacetId add_facet(const PlanePoints& corners, const std::vector<FacetSource>& sources) {
    const FacetId f = facets_.corners.push_back(corners);
    facets_.sources.insert(facets_.sources.end(), sources.begin(), sources.end());
    facets_.first_source.push_back(static_cast<std::uint32_t>(facets_.sources.size()));
    return f;
  }

  const SimplifyRule& rule_;
  const OperandFaces& faces_;
  Facets& facets_;
  Selection& selection_;
  UnionFind groups_;  // of kept facets
  std::vector<std::uint8_t> is_touched_, is_replaced_;
  std::vector<Side> sides_, staying_;                 // by edge; staying: those that no two facets are joined across
  std::vector<std::uint8_t> is_pinned_, is_removed_;  // per point
  std::vector<std::array<PointId, 2>> neighbours_;    // per point: the first two along edges that stay
};

}  // namespace

Selection simplify(const SimplifyRule& rule, const OperandFaces& faces, Facets& facets, Selection selection) {
  if (rule.level == Simplify::Off) return selection;
  if (selection.keeps_all_sources)
    throw Error(ErrorCode::InvalidArgument, "simplify", "an imprint keeps every edge of the cut: it cannot be simplified");
  Simplifier(rule, faces, facets, selection).run();
  return selection;
}

}  // namespace mortise
