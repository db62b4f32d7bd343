// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Half-planes round an edge compared by explicit orientations only.
#include "mortise/boolean/radial_order.h"

#include <algorithm>
#include <string>

#include "mortise/base/error.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

// Positive when the half-plane of b is less than half a turn counterclockwise from that of a; Zero when opposite.
// Seen from v to u, the normal of a forward facet points counterclockwise: n = (v - u) x (its direction).
Sign turn_between(const OperandFaces& faces, const FacetAtEdge& a, const FacetAtEdge& b) {
  const PlanePoints& c = faces.corners[a.face];
  if (b.witness == c[0] || b.witness == c[1] || b.witness == c[2]) return Sign::Zero;
  const Sign side =
      orient3d(faces.points.nearest(c[0]), faces.points.nearest(c[1]), faces.points.nearest(c[2]), faces.points.nearest(b.witness));
  return a.is_forward ? side : -side;
}

// Sign of n . (0, -1, 0) for the normal of a facet, turned like turn_between: how far minus y is from the facet.
Sign turn_to_minus_y(const OperandFaces& faces, const FacetAtEdge& a) {
  const Sign y = orient2d(faces.corner_position(a.face, 0), faces.corner_position(a.face, 1), faces.corner_position(a.face, 2), Axis::Y);
  return a.is_forward ? -y : y;
}

// Sorts half-planes by angle from a reference; turn(x): the turn from the reference to x.
template <class TurnFromReference>
void sort_by_angle(const OperandFaces& faces, std::span<FacetAtEdge> around, TurnFromReference turn) {
  struct Keyed {
    int half;  // 0: less than half a turn, 1: half a turn, 2: more
    FacetAtEdge facet;
  };
  std::vector<Keyed> keyed;
  for (const FacetAtEdge& f : around) keyed.push_back({1 - static_cast<int>(turn(f)), f});
  std::sort(keyed.begin(), keyed.end(), [&](const Keyed& a, const Keyed& b) {
    if (a.half != b.half) return a.half < b.half;
    return a.facet.facet != b.facet.facet && turn_between(faces, a.facet, b.facet) == Sign::Positive;
  });
  for (std::size_t i = 0; i < keyed.size(); ++i) around[i] = keyed[i].facet;
}

}  // namespace

FacetAtEdge facet_at_edge(const OperandFaces& faces, const Facets& facets, FacetId f, PointId u, PointId v) {
  const PlanePoints& c = facets.corners[f];
  FacetAtEdge result;
  result.facet = f;
  result.face = facets.sources_of(f).front().face;
  std::size_t i = 0;
  while (i < 3 && (c[i] == u || c[i] == v)) ++i;
  const PointId apex = c[i];
  result.is_forward = c[(i + 1) % 3] == u;
  const PlanePoints& source = faces.corners[result.face];
  if (std::find(source.begin(), source.end(), apex) != source.end()) {
    result.witness = apex;
    return result;
  }
  const auto axis = projection_axis(faces.points.nearest(source[0]), faces.points.nearest(source[1]), faces.points.nearest(source[2]));
  const Sign turn = orient2d(faces.points.nearest(source[0]), faces.points.nearest(source[1]), faces.points.nearest(source[2]), *axis);
  const Sign wanted = result.is_forward ? turn : -turn;
  for (const FacetSource& s : facets.sources_of(f)) {  // together they cover the facet
    for (const PointId corner : faces.corners[s.face]) {
      if (corner == u || corner == v || faces.points.orient2d(u, v, corner, *axis) != wanted) continue;
      result.witness = corner;
      return result;
    }
  }
  MORTISE_CHECK(false, "facet " + std::to_string(f.value) + " at edge " + std::to_string(u.value) + "-" + std::to_string(v.value));
}

void sort_round_edge(const OperandFaces& faces, std::vector<FacetAtEdge>& around) {
  if (around.size() < 3) return;
  const FacetAtEdge reference = around.front();
  sort_by_angle(faces, std::span(around).subspan(1), [&](const FacetAtEdge& f) { return turn_between(faces, reference, f); });
}

bool share_half_plane(const OperandFaces& faces, const FacetAtEdge& a, const FacetAtEdge& b) {
  if (turn_between(faces, a, b) != Sign::Zero) return false;
  const auto corner = [&](const FacetAtEdge& f, std::size_t i) { return faces.corner_position(f.face, i); };
  const Axis axis = *projection_axis(corner(a, 0), corner(a, 1), corner(a, 2));
  const auto side = [&](const FacetAtEdge& f) {
    const Sign turn = orient2d(corner(f, 0), corner(f, 1), corner(f, 2), axis);
    return f.is_forward ? turn : -turn;
  };
  return side(a) == side(b);
}

FacetAtEdge first_after_minus_y(const OperandFaces& faces, std::span<const FacetAtEdge> around) {
  std::vector<FacetAtEdge> sorted(around.begin(), around.end());
  sort_by_angle(faces, sorted, [&](const FacetAtEdge& f) { return -turn_to_minus_y(faces, f); });
  return sorted.front();
}

}  // namespace mortise
