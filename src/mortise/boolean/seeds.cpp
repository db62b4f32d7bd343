// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Extreme points of complexes, the region outside each, and exact rays.
#include "mortise/boolean/seeds.h"

#include <algorithm>
#include <limits>
#include <string>

#include "mortise/base/error.h"
#include "mortise/base/union_find.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/ray_crossing.h"

namespace mortise {
namespace {

bool is_lexicographically_less(const Vec3d& a, const Vec3d& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

class SeedFinder {
 public:
  SeedFinder(const OperandFaces& faces, const Facets& facets, const Patches& patches)
      : faces_(faces),
        facets_(facets),
        patches_(patches),
        complex_of_face_(faces.corners.size(), no_number),
        trees_(faces.operand_count()) {
    number_complexes();
  }

  [[nodiscard]] std::vector<Seed> find() {
    find_extreme_points();
    collect_facets_at_extremes();
    std::vector<Seed> seeds;
    for (std::uint32_t i = 0; i < complex_count_; ++i) {
      const auto begin = static_cast<std::size_t>(first_at_extreme_[i]);
      const auto end = static_cast<std::size_t>(first_at_extreme_[i + 1]);
      const std::span<const FacetId> incident = std::span<const FacetId>(facets_at_extreme_).subspan(begin, end - begin);
      SourceId face;
      const PointId v = extremes_[i];
      const PointId w = lowest_edge(v, incident, face);
      seeds.push_back({region_outside(v, w, face, incident), windings_at(v, w, face, i)});
    }
    return seeds;
  }

 private:
  static constexpr std::uint32_t no_number = std::numeric_limits<std::uint32_t>::max();

  // Complexes in the order of their first facets.
  void number_complexes() {
    UnionFind joined(patches_.first_facet.size());
    for (const Junction& j : patches_.junctions) {
      const std::uint32_t first = patches_.patch_of_facet[patches_.facets_round(j).front().facet].value;
      for (const FacetAtEdge& f : patches_.facets_round(j)) joined.join(first, patches_.patch_of_facet[f.facet].value);
    }
    std::vector<std::uint32_t> number(joined.size(), no_number);
    for (std::uint32_t p = 0; p < joined.size(); ++p) {
      const std::uint32_t root = joined.find(p);
      if (root == p) number[p] = complex_count_++;
      complex_of_patch_.push_back(number[root]);
    }
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      for (const FacetSource& s : facets_.sources_of(FacetId(i))) complex_of_face_[s.face] = complex_of(FacetId(i));
    }
  }

  [[nodiscard]] std::uint32_t complex_of(FacetId f) const { return complex_of_patch_[patches_.patch_of_facet[f]]; }

  void find_extreme_points() {
    extremes_.assign(complex_count_, PointId());
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      PointId& extreme = extremes_[complex_of(FacetId(i))];
      for (const PointId p : facets_.corners[FacetId(i)]) {
        if (!faces_.points.is_input(p)) continue;
        if (!extreme.is_valid() || is_lexicographically_less(faces_.points.nearest(p), faces_.points.nearest(extreme))) extreme = p;
      }
    }
  }

  void collect_facets_at_extremes() {
    std::vector<std::pair<std::uint32_t, FacetId>> incident;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const PlanePoints& c = facets_.corners[FacetId(i)];
      const std::uint32_t complex = complex_of(FacetId(i));
      if (std::find(c.begin(), c.end(), extremes_[complex]) != c.end()) incident.emplace_back(complex, FacetId(i));
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

  RegionId region_outside(PointId v, PointId w, SourceId face, std::span<const FacetId> incident) const {
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

  // Every edge at the smallest point belongs to one complex, so a start next to one lies on no other.
  std::vector<int> windings_at(PointId v, PointId w, SourceId face, std::uint32_t own) {
    const PlanePoints& c = faces_.corners[face];
    const PointId x = c[0] != v && c[0] != w ? c[0] : c[1] != v && c[1] != w ? c[1] : c[2];
    const RayStart start{faces_.points.nearest(v), faces_.points.nearest(w), faces_.points.nearest(x)};
    std::vector<int> winding(faces_.operand_count(), 0);
    for (std::size_t i = 0; i < winding.size(); ++i) {
      const OperandId k(i);
      if (!boxes_meet(faces_.bounds[k], ray_box(start))) continue;
      for_each_face_on_ray(k, ray_box(start), [&](SourceId f) {
        if (faces_.shape[f] != FaceShape::Proper || faces_.is_wall[f] != 0 || complex_of_face_[f] == own) return;
        winding[i] += winding_step(faces_.corner_position(f, 0), faces_.corner_position(f, 1), faces_.corner_position(f, 2), start);
      });
    }
    return winding;
  }

  // Few rays look at all faces, many deserve a tree; a prepared operand has one.
  template <class Visit>
  void for_each_face_on_ray(OperandId k, const Box3& ray, Visit visit) {
    constexpr std::uint32_t few_rays = 8;
    if (complex_count_ <= few_rays || faces_.known[k].prepared != nullptr) return for_each_face_meeting(ray, faces_, k, visit);
    if (trees_[k].empty()) {
      std::vector<Box3> boxes;
      for (std::uint32_t f = faces_.first[k]; f < faces_.end(k); ++f) boxes.push_back(faces_.box(SourceId(f)));
      trees_[k] = BoxTree(boxes);
    }
    trees_[k].for_each_meeting(ray, [&](std::uint32_t i) { visit(SourceId(faces_.first[k] + i)); });
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  const Patches& patches_;
  std::uint32_t complex_count_ = 0;
  IdVector<PatchId, std::uint32_t> complex_of_patch_;
  IdVector<SourceId, std::uint32_t> complex_of_face_;
  IdVector<OperandId, BoxTree> trees_;  // of all faces, made when needed
  std::vector<PointId> extremes_;
  std::vector<FacetId> facets_at_extreme_;
  std::vector<std::ptrdiff_t> first_at_extreme_;
};

}  // namespace

std::vector<Seed> find_seeds(const OperandFaces& faces, const Facets& facets, const Patches& patches) {
  return SeedFinder(faces, facets, patches).find();
}

}  // namespace mortise
