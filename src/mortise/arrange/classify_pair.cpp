// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How two faces touch: a pattern of exact signs.
#include "mortise/arrange/classify_pair.h"

#include <algorithm>

#include "mortise/exact/sides_of_plane.h"

namespace mortise {
namespace {

using Signs = std::array<Sign, 3>;

constexpr std::uint8_t next(std::size_t i) { return static_cast<std::uint8_t>((i + 1) % 3); }

Feature corner(std::size_t i) { return {Feature::Kind::Corner, static_cast<std::uint8_t>(i)}; }
Feature edge(std::size_t i) { return {Feature::Kind::Edge, static_cast<std::uint8_t>(i)}; }

bool has_corner(const TriangleCorners& t, std::uint32_t id) { return t.id[0] == id || t.id[1] == id || t.id[2] == id; }

// Sides of the corners of `t` to the plane of `plane`; shared corners are zero without arithmetic.
Signs sides_to_plane(const TriangleCorners& plane, const TriangleCorners& t) {
  const SidesOfPlane sides(plane.position[0], plane.position[1], plane.position[2]);
  Signs s{};
  for (std::size_t i = 0; i < 3; ++i) s[i] = has_corner(plane, t.id[i]) ? Sign::Zero : sides.of(t.position[i]);
  return s;
}

bool all_equal(const Signs& s, Sign value) { return s[0] == value && s[1] == value && s[2] == value; }

// Three signs to the edges of a triangle, positive inside, say where the point is.
bool feature_of_signs(const Signs& inner, Feature& feature) {
  int zeros = 0;
  std::size_t last_zero = 0;
  std::size_t last_positive = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (inner[i] == Sign::Negative) return false;
    if (inner[i] == Sign::Zero) {
      ++zeros;
      last_zero = i;
    } else {
      last_positive = i;
    }
  }
  if (zeros == 0) feature = {};
  if (zeros == 1) feature = edge(last_zero);
  if (zeros == 2) feature = corner((last_positive + 2) % 3);
  return zeros < 3;
}

// Where the line p -> q, which crosses the plane of `t` between p and q, passes through `t`.
bool locate_crossing(const TriangleCorners& t, const Vec3d& p, const Vec3d& q, Sign side_of_p, Feature& feature) {
  Signs inner{};
  for (std::size_t i = 0; i < 3; ++i) {
    // Seen from the positive side the triangle is counterclockwise: a line that comes from there has its edges on one hand.
    inner[i] = side_of_p * orient3d(q, p, t.position[i], t.position[next(i)]);
    if (inner[i] == Sign::Negative) return false;
  }
  return feature_of_signs(inner, feature);
}

void add_once(std::vector<Incidence>& incidences, const Incidence& incidence) {
  if (std::find(incidences.begin(), incidences.end(), incidence) == incidences.end()) incidences.push_back(incidence);
}

Incidence in_order(const Feature& mine, const Feature& other, bool mine_is_a) {
  return mine_is_a ? Incidence{mine, other} : Incidence{other, mine};
}

// Points where the boundary of `mine` meets `other`, the two not in one plane.
void add_boundary_points(const TriangleCorners& mine, const Signs& sides, const TriangleCorners& other, bool mine_is_a,
                         std::vector<Incidence>& incidences) {
  Feature feature;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] == Sign::Zero) {
      const auto shared = std::find(other.id.begin(), other.id.end(), mine.id[i]);
      if (shared != other.id.end()) {
        add_once(incidences, in_order(corner(i), corner(static_cast<std::size_t>(shared - other.id.begin())), mine_is_a));
        continue;
      }
      const Axis axis = *projection_axis(other.position[0], other.position[1], other.position[2]);
      if (locate_in_plane(other, axis, mine.position[i], feature)) add_once(incidences, in_order(corner(i), feature, mine_is_a));
    } else if (sides[next(i)] == -sides[i]) {
      if (locate_crossing(other, mine.position[i], mine.position[next(i)], sides[i], feature)) {
        add_once(incidences, in_order(edge(i), feature, mine_is_a));
      }
    }
  }
}

// inner[i][j]: is corner j of `t` on the inner side of edge i of `host`?
std::array<Signs, 3> sides_to_edges(const TriangleCorners& host, const TriangleCorners& t, Axis axis) {
  const Sign turn = orient2d(host.position[0], host.position[1], host.position[2], axis);
  std::array<Signs, 3> inner{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_end = t.id[j] == host.id[i] || t.id[j] == host.id[next(i)];
      inner[i][j] = is_end ? Sign::Zero : turn * orient2d(host.position[i], host.position[next(i)], t.position[j], axis);
    }
  }
  return inner;
}

void add_corners_inside(const std::array<Signs, 3>& inner, bool corners_are_of_a, std::vector<Incidence>& incidences) {
  Feature feature;
  for (std::size_t j = 0; j < 3; ++j) {
    if (feature_of_signs({inner[0][j], inner[1][j], inner[2][j]}, feature)) {
      add_once(incidences, in_order(corner(j), feature, corners_are_of_a));
    }
  }
}

void add_edge_crossings(const std::array<Signs, 3>& b_in_a, const std::array<Signs, 3>& a_in_b, std::vector<Incidence>& incidences) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool b_crosses = b_in_a[i][j] * b_in_a[i][next(j)] == Sign::Negative;
      const bool a_crosses = a_in_b[j][i] * a_in_b[j][next(i)] == Sign::Negative;
      if (b_crosses && a_crosses) add_once(incidences, {edge(i), edge(j)});
    }
  }
}

bool separates(const std::array<Signs, 3>& inner) {
  return std::any_of(inner.begin(), inner.end(),
                     [](const Signs& s) { return s[0] != Sign::Positive && s[1] != Sign::Positive && s[2] != Sign::Positive; });
}

void classify_coplanar(const TriangleCorners& a, const TriangleCorners& b, PairClassification& result) {
  const Axis axis = *projection_axis(a.position[0], a.position[1], a.position[2]);
  const auto b_in_a = sides_to_edges(a, b, axis);
  const auto a_in_b = sides_to_edges(b, a, axis);
  add_corners_inside(a_in_b, true, result.incidences);
  add_corners_inside(b_in_a, false, result.incidences);
  add_edge_crossings(b_in_a, a_in_b, result.incidences);
  if (!separates(b_in_a) && !separates(a_in_b)) {
    result.contact = PairContact::Overlap;
  } else if (!result.incidences.empty()) {
    result.contact = PairContact::Touching;
  }
}

}  // namespace

bool is_on_edge(const Feature& feature, std::uint8_t edge_index) {
  if (feature.kind == Feature::Kind::Edge) return feature.index == edge_index;
  return feature.kind == Feature::Kind::Corner && (feature.index == edge_index || feature.index == next(edge_index));
}

bool locate_in_plane(const TriangleCorners& triangle, Axis axis, const Vec3d& point, Feature& feature) {
  const Sign turn = orient2d(triangle.position[0], triangle.position[1], triangle.position[2], axis);
  Signs inner{};
  for (std::size_t i = 0; i < 3; ++i) {
    inner[i] = turn * orient2d(triangle.position[i], triangle.position[next(i)], point, axis);
    if (inner[i] == Sign::Negative) return false;
  }
  return feature_of_signs(inner, feature);
}

void classify_pair(const TriangleCorners& a, const TriangleCorners& b, PairClassification& result) {
  result.contact = PairContact::None;
  result.incidences.clear();
  const Signs a_to_b = sides_to_plane(b, a);
  if (all_equal(a_to_b, Sign::Positive) || all_equal(a_to_b, Sign::Negative)) return;
  if (all_equal(a_to_b, Sign::Zero)) return classify_coplanar(a, b, result);
  const Signs b_to_a = sides_to_plane(a, b);
  if (all_equal(b_to_a, Sign::Positive) || all_equal(b_to_a, Sign::Negative)) return;
  add_boundary_points(a, a_to_b, b, true, result.incidences);
  add_boundary_points(b, b_to_a, a, false, result.incidences);
  if (!result.incidences.empty()) result.contact = PairContact::Touching;
}

}  // namespace mortise
