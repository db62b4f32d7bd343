// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Extreme points of complexes, the region outside each, and exact rays.
#include "mortise/boolean/seeds.h"

#include <algorithm>
#include <limits>
#include <string>

#include "mortise/base/union_find.h"
#include "mortise/base/error.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

bool is_lexicographically_less(const Vec3d& a, const Vec3d& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

class SeedFinder {
 public:
  SeedFinder(const OperandFaces& faces, const Facets& facets, const Patches& patches)
      : faces_(faces), facets_(facets), patches_(patches), complexes_(faces.points.size()) {
    for (const PlanePoints& c : facets.corners) {
      complexes_.join(c[0].value, c[1].value);
      complexes_.join(c[1].value, c[2].value);
    }
  }

  [[nodiscard]] std::vector<Seed> find() {
    find_extreme_points();
    collect_facets_at_extremes();
    std::vector<Seed> seeds;
    for (std::size_t i = 0; i < extremes_.size(); ++i) {
      const auto begin = facets_at_extreme_.begin() + first_at_extreme_[i];
      const auto end = facets_at_extreme_.begin() + first_at_extreme_[i + 1];
      seeds.push_back({region_outside(extremes_[i], {begin, end}), windings_at(extremes_[i])});
    }
    return seeds;
  }

 private:
  void find_extreme_points() {
    std::vector<std::uint32_t> number(faces_.points.size(), std::numeric_limits<std::uint32_t>::max());
    for (const PlanePoints& c : facets_.corners) {
      std::uint32_t& n = number[complexes_.find(c[0].value)];
      if (n == std::numeric_limits<std::uint32_t>::max()) {
        n = static_cast<std::uint32_t>(extremes_.size());
        extremes_.push_back(PointId());
      }
      for (const PointId p : c) {
        if (!faces_.points.is_input(p)) continue;
        PointId& extreme = extremes_[n];
        if (!extreme.is_valid() || is_lexicographically_less(faces_.points.nearest(p), faces_.points.nearest(extreme))) extreme = p;
      }
    }
  }

  void collect_facets_at_extremes() {
    std::vector<std::uint32_t> number(faces_.points.size(), std::numeric_limits<std::uint32_t>::max());
    for (std::size_t i = 0; i < extremes_.size(); ++i) number[extremes_[i].index()] = static_cast<std::uint32_t>(i);
    std::vector<std::pair<std::uint32_t, FacetId>> incident;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      for (const PointId p : facets_.corners[FacetId(i)]) {
        if (number[p.index()] != std::numeric_limits<std::uint32_t>::max()) incident.emplace_back(number[p.index()], FacetId(i));
      }
    }
    std::sort(incident.begin(), incident.end());
    std::size_t next = 0;
    for (std::size_t i = 0; i <= extremes_.size(); ++i) {
      while (next < incident.size() && incident[next].first < i) facets_at_extreme_.push_back(incident[next++].second);
      first_at_extreme_.push_back(static_cast<std::ptrdiff_t>(facets_at_extreme_.size()));
    }
  }

  // The end of the edge at v that leaves v at the smallest slope in (x, y): nothing lies below it.
  PointId lowest_edge(PointId v, std::span<const FacetId> incident, SourceId& face) const {
    const Vec3d& at = faces_.points.nearest(v);
    PointId lowest;
    for (const FacetId f : incident) {
      for (const FacetSource& s : facets_.sources_of(f)) {
        for (const PointId w : faces_.corners[s.face]) {
          const Vec3d& end = faces_.points.nearest(w);
          if (end.x == at.x && end.y == at.y) continue;
          if (lowest.is_valid() && orient2d(at, faces_.points.nearest(lowest), end, Axis::Z) != Sign::Negative) continue;
          lowest = w;
          face = s.face;
        }
      }
    }
    MORTISE_CHECK(lowest.is_valid(), "point " + std::to_string(v.value));
    return lowest;
  }

  // The first point of the arrangement on the edge of `face` from v to w.
  PointId first_point_on_edge(PointId v, PointId w, SourceId face, std::span<const FacetId> incident) const {
    const PlanePoints& c = faces_.corners[face];
    const Axis axis = *projection_axis(faces_.points.nearest(c[0]), faces_.points.nearest(c[1]), faces_.points.nearest(c[2]));
    for (const FacetId f : incident) {
      const auto sources = facets_.sources_of(f);
      if (std::none_of(sources.begin(), sources.end(), [&](const FacetSource& s) { return s.face == face; })) continue;
      for (const PointId p : facets_.corners[f]) {
        if (p != v && (p == w || faces_.points.orient2d(v, w, p, axis) == Sign::Zero)) return p;
      }
    }
    MORTISE_CHECK(false, "edge " + std::to_string(v.value) + "-" + std::to_string(w.value));
  }

  RegionId region_outside(PointId v, std::span<const FacetId> incident) const {
    SourceId face;
    const PointId w = lowest_edge(v, incident, face);
    const PointId p = first_point_on_edge(v, w, face, incident);
    std::vector<FacetAtEdge> around;
    for (const FacetId f : incident) {
      const PlanePoints& c = facets_.corners[f];
      if (std::find(c.begin(), c.end(), p) != c.end()) around.push_back(facet_at_edge(faces_, facets_, f, v, p));
    }
    const FacetAtEdge first = first_after_minus_y(faces_, around);
    const PatchId patch = patches_.patch_of_facet[first.facet];
    return first.is_front_after() ? patches_.back[patch] : patches_.front[patch];
  }

  // Is the point, moved by (epsilon, epsilon^2) in (y, z), left of a -> b in that projection?
  static Sign perturbed_turn(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
    const Sign turn = orient2d(a, b, p, Axis::X);
    if (turn != Sign::Zero) return turn;
    if (a.z != b.z) return a.z > b.z ? Sign::Positive : Sign::Negative;
    return a.y < b.y ? Sign::Positive : Sign::Negative;
  }

  // How much the winding grows across a face on the way from -x infinity to p.
  int crossing_before(SourceId f, const Vec3d& p) const {
    const Vec3d& a = faces_.corner_position(f, 0);
    const Vec3d& b = faces_.corner_position(f, 1);
    const Vec3d& c = faces_.corner_position(f, 2);
    const Sign turn = orient2d(a, b, c, Axis::X);
    if (turn == Sign::Zero) return 0;
    if (perturbed_turn(a, b, p) != turn || perturbed_turn(b, c, p) != turn || perturbed_turn(c, a, p) != turn) return 0;
    if (orient3d(a, b, c, p) != turn) return 0;  // the face lies beyond p
    return -static_cast<int>(turn);
  }

  std::vector<int> windings_at(PointId v) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec3d& p = faces_.points.nearest(v);
    const std::uint32_t own = complexes_.find(v.value);
    Box3 ray;
    ray.lo = {-infinity, p.y, p.z};
    ray.hi = p;
    std::vector<int> winding(faces_.operand_count(), 0);
    for (std::size_t k = 0; k < winding.size(); ++k) {
      const OperandId operand(k);
      faces_.trees[operand].for_each_meeting(ray, [&](std::uint32_t i) {
        const SourceId f(faces_.first[operand] + i);
        if (faces_.shape[f] != FaceShape::Proper || complexes_.find(faces_.corners[f][0].value) == own) return;
        winding[k] += crossing_before(f, p);
      });
    }
    return winding;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  const Patches& patches_;
  UnionFind complexes_;
  std::vector<PointId> extremes_;
  std::vector<FacetId> facets_at_extreme_;
  std::vector<std::ptrdiff_t> first_at_extreme_;
};

}  // namespace

std::vector<Seed> find_seeds(const OperandFaces& faces, const Facets& facets, const Patches& patches) {
  return SeedFinder(faces, facets, patches).find();
}

}  // namespace mortise
