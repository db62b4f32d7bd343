// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The contact of two triangles: every kind by its pattern of signs, one ulp to either side, and against brute force in integers.
#include "mortise/arrange/classify_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <tuple>

#include "mortise/exact/predicates.h"
#include "support/catch.h"
#include "support/test_scale.h"

using namespace mortise;
using mortise::test::scaled_count;

namespace {

constexpr Feature inside{Feature::Kind::Inside, 0};
constexpr Feature corner(std::uint8_t i) { return {Feature::Kind::Corner, i}; }
constexpr Feature edge(std::uint8_t i) { return {Feature::Kind::Edge, i}; }

using Corners = std::array<Vec3d, 3>;

TriangleCorners with_ids(const Corners& c, std::uint32_t first) { return {{first, first + 1, first + 2}, c}; }

PairClassification classify(const Corners& a, const Corners& b) {
  PairClassification result;
  classify_pair(with_ids(a, 0), with_ids(b, 3), result);
  return result;
}

using IncidenceKey = std::tuple<int, int, int, int>;

std::set<IncidenceKey> keys(const std::vector<Incidence>& incidences) {
  std::set<IncidenceKey> result;
  for (const Incidence& i : incidences) {
    result.emplace(static_cast<int>(i.on_a.kind), i.on_a.index, static_cast<int>(i.on_b.kind), i.on_b.index);
  }
  return result;
}

double up(double x) { return std::nextafter(x, HUGE_VAL); }
double down(double x) { return std::nextafter(x, -HUGE_VAL); }

// Lies in z = 1, its edge 0 along y = 1: at 1 an ulp is one to the eye and to arithmetic.
const Corners table{{{1, 1, 1}, {5, 1, 1}, {1, 5, 1}}};

/// A triangle that stands on the plane of the table with its corner 0, at (x, y, z).
Corners standing_at(double x, double y, double z) { return {{{x, y, z}, {x + 1, y, z + 2}, {x, y + 1, z + 3}}}; }

/// The only contact of the pair is this point, whichever triangle comes first.
void check_single(const Corners& a, const Corners& b, const Feature& on_a, const Feature& on_b) {
  const PairClassification forward = classify(a, b);
  CHECK(forward.contact == PairContact::Touching);
  CHECK(forward.incidences == std::vector<Incidence>{{on_a, on_b}});
  const PairClassification backward = classify(b, a);
  CHECK(backward.contact == PairContact::Touching);
  CHECK(backward.incidences == std::vector<Incidence>{{on_b, on_a}});
}

void check_apart(const Corners& a, const Corners& b) {
  CHECK(classify(a, b).contact == PairContact::None);
  CHECK(classify(a, b).incidences.empty());
  CHECK(classify(b, a).contact == PairContact::None);
}

void check_two(const Corners& a, const Corners& b, const Incidence& first, const Incidence& second) {
  const PairClassification result = classify(a, b);
  CHECK(result.contact == PairContact::Touching);
  CHECK(keys(result.incidences) == keys({first, second}));
}

}  // namespace

TEST_CASE("a corner on a corner is V-V, for every corner") {
  for (std::uint8_t i = 0; i < 3; ++i) {
    for (std::uint8_t j = 0; j < 3; ++j) {
      Corners b = standing_at(table[i].x, table[i].y, 1);
      std::rotate(b.begin(), b.end() - j, b.end());
      check_single(table, b, corner(i), corner(j));
    }
  }
}

TEST_CASE("a corner on an edge is V-E, on every edge") {
  check_single(table, standing_at(2, 1, 1), edge(0), corner(0));
  check_single(table, standing_at(3, 3, 1), edge(1), corner(0));
  check_single(table, standing_at(1, 4, 1), edge(2), corner(0));
}

TEST_CASE("a corner on the inside is V-F") { check_single(table, standing_at(2, 2, 1), inside, corner(0)); }

TEST_CASE("edges that cross in one point are E-E") {
  // Edge 0 of b runs from (2, 0, 0) to (2, 2, 2): through (2, 1, 1) on edge 0 of the table; b stays outside.
  const Corners b{{{2, 0, 0}, {2, 2, 2}, {2, -4, 4}}};
  check_single(table, b, edge(0), edge(0));
}

TEST_CASE("a triangle through another meets it in the points where edges pass through: E-F") {
  // Edges 0 and 2 of b go down from (2, 2, 2) through the table.
  const Corners b{{{2, 2, 2}, {1.5, 2, 0}, {2.5, 2, 0}}};
  check_two(table, b, {inside, edge(0)}, {inside, edge(2)});
}

TEST_CASE("half of the contact may lie on either triangle") {
  // b stands in y = 2 and reaches beyond the slanted edge of the table: it passes through edge 1 at (4, 2, 1).
  const Corners b{{{2, 2, 2}, {2, 2, 0}, {9, 2, 1}}};
  check_two(table, b, {inside, edge(0)}, {edge(1), inside});
}

TEST_CASE("a triangle standing on the inside with an edge touches with two corners") {
  const Corners b{{{2, 2, 1}, {3, 2, 1}, {2, 2, 3}}};
  check_two(table, b, {inside, corner(0)}, {inside, corner(1)});
}

TEST_CASE("a triangle standing on an edge with an edge touches along what both share") {
  const Corners within{{{2, 1, 1}, {3, 1, 1}, {2, 1, 3}}};
  check_two(table, within, {edge(0), corner(0)}, {edge(0), corner(1)});
  const Corners beyond{{{2, 1, 1}, {9, 1, 1}, {2, 1, 3}}};
  check_two(table, beyond, {edge(0), corner(0)}, {corner(1), edge(0)});
  const Corners whole{{{1, 1, 1}, {5, 1, 1}, {1, 1, 3}}};
  check_two(table, whole, {corner(0), corner(0)}, {corner(1), corner(1)});
}

TEST_CASE("one ulp decides whether a corner touches the inside") {
  check_apart(table, standing_at(2, 2, up(1)));
  const PairClassification through = classify(table, standing_at(2, 2, down(1)));
  CHECK(keys(through.incidences) == keys({{inside, edge(0)}, {inside, edge(2)}}));
}

TEST_CASE("one ulp decides whether a corner touches an edge") {
  check_apart(table, standing_at(2, down(1), 1));
  check_single(table, standing_at(2, up(1), 1), inside, corner(0));
  // The slanted edge x + y = 6.
  check_single(table, standing_at(3, down(3), 1), inside, corner(0));
  check_apart(table, standing_at(3, up(3), 1));
}

TEST_CASE("one ulp decides whether a corner touches a corner") {
  check_apart(table, standing_at(down(1), 1, 1));
  check_apart(table, standing_at(1, down(1), 1));
  check_single(table, standing_at(up(1), 1, 1), edge(0), corner(0));
  check_single(table, standing_at(1, up(1), 1), edge(2), corner(0));
}

TEST_CASE("one ulp decides whether edges cross") {
  const Corners away{{{2, down(0.5), 0.5}, {2, 1.5, 1.5}, {2, -4, 4}}};
  check_apart(table, away);
  const Corners in{{{2, up(0.5), 0.5}, {2, 1.5, 1.5}, {2, -4, 4}}};
  check_two(table, in, {edge(0), inside}, {inside, edge(0)});
}

TEST_CASE("a triangle may pass one ulp beside another") {
  const Corners b{{{2, down(1), 0}, {2, down(1), 2}, {9, -5, 1}}};
  check_apart(table, b);
}

TEST_CASE("planes that cross far from the triangles are no contact") {
  check_apart(table, {{{10, 10, 0}, {11, 10, 2}, {10, 11, 2}}});
  check_apart(table, {{{1, 1, 2}, {5, 1, 2}, {1, 5, 2}}});
  check_apart(table, {{{1, 1, 2}, {5, 1, 3}, {1, 5, 4}}});
}

TEST_CASE("triangles of one plane touch in a corner, along an edge, or overlap") {
  const Corners at_corner{{{5, 1, 1}, {6, 1, 1}, {6, 0, 1}}};
  CHECK(classify(table, at_corner).contact == PairContact::Touching);
  CHECK(classify(table, at_corner).incidences == std::vector<Incidence>{{corner(1), corner(0)}});
  const Corners at_edge{{{2, 1, 1}, {7, 1, 1}, {3, 0, 1}}};
  check_two(table, at_edge, {edge(0), corner(0)}, {corner(1), edge(0)});
  const Corners over{{{2, 0, 1}, {3, 0, 1}, {2.5, 2, 1}}};
  const PairClassification overlap = classify(table, over);
  CHECK(overlap.contact == PairContact::Overlap);
  CHECK(keys(overlap.incidences) == keys({{inside, corner(2)}, {edge(0), edge(1)}, {edge(0), edge(2)}}));
  check_apart(table, {{{2, 0.5, 1}, {3, 0, 1}, {3, 0.5, 1}}});
}

TEST_CASE("one ulp makes triangles of one plane overlap, touch or lie apart") {
  const auto below = [](double y) { return Corners{{{2, y, 1}, {2.5, 0, 1}, {3, 0, 1}}}; };
  check_apart(table, below(down(1)));
  check_single(table, below(1), edge(0), corner(0));
  CHECK(classify(table, below(up(1))).contact == PairContact::Overlap);
  const auto beside = [](double y) { return Corners{{{2, y, 1}, {3, 0, 1}, {4, y, 1}}}; };
  check_apart(table, beside(down(1)));
  CHECK(classify(table, beside(1)).contact == PairContact::Touching);
  CHECK(classify(table, beside(up(1))).contact == PairContact::Overlap);
}

TEST_CASE("the same triangle, either way round, overlaps in its three corners") {
  const std::set<IncidenceKey> same = keys({{corner(0), corner(0)}, {corner(1), corner(1)}, {corner(2), corner(2)}});
  CHECK(classify(table, table).contact == PairContact::Overlap);
  CHECK(keys(classify(table, table).incidences) == same);
  const Corners turned{{table[0], table[2], table[1]}};
  CHECK(classify(table, turned).contact == PairContact::Overlap);
  CHECK(keys(classify(table, turned).incidences) == keys({{corner(0), corner(0)}, {corner(1), corner(2)}, {corner(2), corner(1)}}));
}

TEST_CASE("a star of two triangles overlaps in six crossings of edges") {
  const Corners up_triangle{{{0, 0, 0}, {6, 0, 0}, {3, 6, 0}}}, down_triangle{{{0, 4, 0}, {3, -2, 0}, {6, 4, 0}}};
  const PairClassification star = classify(up_triangle, down_triangle);
  CHECK(star.contact == PairContact::Overlap);
  CHECK(star.incidences.size() == 6);
  for (const Incidence& i : star.incidences) CHECK((i.on_a.kind == Feature::Kind::Edge && i.on_b.kind == Feature::Kind::Edge));
}

TEST_CASE("a triangle inside another of its plane gives its corners") {
  const Corners small{{{1.5, 1.5, 1}, {2, 1.5, 1}, {1.5, 2, 1}}};
  const PairClassification result = classify(table, small);
  CHECK(result.contact == PairContact::Overlap);
  CHECK(keys(result.incidences) == keys({{inside, corner(0)}, {inside, corner(1)}, {inside, corner(2)}}));
}

TEST_CASE("a former result does not shine through") {
  PairClassification result;
  classify_pair(with_ids(table, 0), with_ids(table, 3), result);
  classify_pair(with_ids(table, 0), with_ids(standing_at(2, 2, 5), 3), result);
  CHECK(result.contact == PairContact::None);
  CHECK(result.incidences.empty());
}

TEST_CASE("is_on_edge knows the closed edge") {
  for (std::uint8_t e = 0; e < 3; ++e) {
    for (std::uint8_t i = 0; i < 3; ++i) {
      CHECK(is_on_edge(edge(i), e) == (i == e));
      CHECK(is_on_edge(corner(i), e) == (i == e || i == (e + 1) % 3));
    }
    CHECK_FALSE(is_on_edge(inside, e));
  }
}

TEST_CASE("locate_in_plane finds the corner, the edge or the inside, along every axis that shows area") {
  const Corners slanted{{{1, 1, 1}, {5, 1, 3}, {1, 5, 2}}};  // area along all three axes
  for (const Corners& c : {slanted, Corners{{slanted[0], slanted[2], slanted[1]}}}) {
    const TriangleCorners t = with_ids(c, 0);
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      Feature feature;
      for (std::uint8_t i = 0; i < 3; ++i) {
        REQUIRE(locate_in_plane(t, axis, c[i], feature));
        CHECK(feature == corner(i));
        REQUIRE(locate_in_plane(t, axis, 0.5 * (c[i] + c[(i + 1) % 3]), feature));
        CHECK(feature == edge(i));
        CHECK_FALSE(locate_in_plane(t, axis, 2.0 * c[i] - c[(i + 1) % 3], feature));
      }
      REQUIRE(locate_in_plane(t, axis, 0.5 * c[0] + 0.25 * (c[1] + c[2]), feature));
      CHECK(feature == inside);
    }
  }
}

// ---- brute force: all pairs of open features of triangles with small integer corners -------------------------------------

namespace {

using Whole = std::array<long long, 3>;
using WholeCorners = std::array<Whole, 3>;

Whole operator-(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Whole cross_of(const Whole& a, const Whole& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
long long dot_of(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole normal_of(const WholeCorners& t) { return cross_of(t[1] - t[0], t[2] - t[0]); }

/// A point x / w, w > 0.
struct Fraction {
  Whole x;
  long long w = 1;
};

Whole times(long long s, const Whole& a) { return {s * a[0], s * a[1], s * a[2]}; }

/// Weights of a point of the plane of t, times something positive.
std::array<long long, 3> weights(const WholeCorners& t, const Fraction& p) {
  const Whole n = normal_of(t);
  std::array<long long, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Whole a = p.x - times(p.w, t[(i + 1) % 3]), b = t[(i + 2) % 3] - t[(i + 1) % 3];
    result[i] = dot_of(n, cross_of(b, a));
  }
  return result;
}

/// Where the point lies in t, or nothing; every point of space is allowed.
std::optional<Feature> locate(const WholeCorners& t, const Fraction& p) {
  if (dot_of(normal_of(t), p.x - times(p.w, t[0])) != 0) return std::nullopt;
  const auto w = weights(t, p);
  if (w[0] < 0 || w[1] < 0 || w[2] < 0) return std::nullopt;
  for (std::uint8_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (w[j] == 0 && w[k] == 0) return corner(i);
  }
  for (std::uint8_t i = 0; i < 3; ++i) {
    if (w[(i + 2) % 3] == 0) return edge(i);
  }
  return inside;
}

/// The point of the open edge i of t where it crosses the plane of u, transversally.
std::optional<Fraction> through_plane(const WholeCorners& t, std::size_t i, const WholeCorners& u) {
  const Whole n = normal_of(u);
  const long long p = dot_of(n, t[i] - u[0]), q = dot_of(n, t[(i + 1) % 3] - u[0]);
  if (p == 0 || q == 0 || (p < 0) == (q < 0)) return std::nullopt;
  const long long s = p > 0 ? 1 : -1;
  return Fraction{times(s * p, t[(i + 1) % 3]) - times(s * q, t[i]), s * (p - q)};
}

/// The point common to two open edges of one plane that are not parallel.
std::optional<Fraction> edge_crossing(const WholeCorners& a, std::size_t i, const WholeCorners& b, std::size_t j) {
  const Whole p = a[i], d = a[(i + 1) % 3] - a[i], r = b[j], e = b[(j + 1) % 3] - b[j];
  const Whole n = cross_of(d, e);
  if (dot_of(n, n) == 0 || dot_of(n, r - p) != 0) return std::nullopt;
  const long long w = dot_of(n, n), s = dot_of(n, cross_of(r - p, e)), t = dot_of(n, cross_of(r - p, d));
  if (s <= 0 || s >= w || t <= 0 || t >= w) return std::nullopt;
  const Whole from = times(w, p), step = times(s, d);
  return Fraction{{from[0] + step[0], from[1] + step[1], from[2] + step[2]}, w};
}

struct Expected {
  std::set<IncidenceKey> incidences;
  bool is_coplanar = false;
};

IncidenceKey key_of(const Feature& a, const Feature& b) { return {static_cast<int>(a.kind), a.index, static_cast<int>(b.kind), b.index}; }

/// All points that are a corner of one and lie in the other, or that an edge makes with an edge or an inside.
Expected brute_force(const WholeCorners& a, const WholeCorners& b) {
  Expected expected;
  const Whole n = normal_of(a);
  expected.is_coplanar = dot_of(n, b[0] - a[0]) == 0 && dot_of(n, b[1] - a[0]) == 0 && dot_of(n, b[2] - a[0]) == 0;
  for (std::uint8_t i = 0; i < 3; ++i) {
    if (const auto on_b = locate(b, {a[i], 1})) expected.incidences.insert(key_of(corner(i), *on_b));
    if (const auto on_a = locate(a, {b[i], 1})) expected.incidences.insert(key_of(*on_a, corner(i)));
    if (const auto p = through_plane(a, i, b)) {
      if (locate(b, *p) == inside) expected.incidences.insert(key_of(edge(i), inside));
    }
    if (const auto p = through_plane(b, i, a)) {
      if (locate(a, *p) == inside) expected.incidences.insert(key_of(inside, edge(i)));
    }
    for (std::uint8_t j = 0; j < 3; ++j) {
      if (edge_crossing(a, i, b, j)) expected.incidences.insert(key_of(edge(i), edge(j)));
    }
  }
  return expected;
}

class TriangleMaker {
 public:
  explicit TriangleMaker(std::uint32_t seed) : random_(seed) {}

  /// Corners on the grid 0 .. size, not on one line.
  WholeCorners make(int size) {
    while (true) {
      WholeCorners t{};
      for (Whole& p : t) {
        for (long long& x : p) x = static_cast<long long>(random_() % static_cast<std::uint32_t>(size + 1));
      }
      const Whole n = normal_of(t);
      if (dot_of(n, n) != 0) return t;
    }
  }
  /// A triangle of the plane z = 1.
  WholeCorners make_flat(int size) {
    while (true) {
      WholeCorners t = make(size);
      for (Whole& p : t) p[2] = 1;
      if (normal_of(t)[2] != 0) return t;
    }
  }

 private:
  std::mt19937 random_;
};

Corners in_doubles(const WholeCorners& t, double scale) {
  Corners c;
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = {scale * static_cast<double>(t[i][0]), scale * static_cast<double>(t[i][1]), scale * static_cast<double>(t[i][2])};
  }
  return c;
}

/// Corners at one place share an id, as after welding.
TriangleCorners with_shared_ids(const Corners& c, const Corners& other, std::uint32_t first) {
  TriangleCorners t = with_ids(c, first);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      if (c[i] == other[j]) t.id[i] = j;
    }
  }
  return t;
}

/// Twice the area that two triangles of the plane z = 1 share, by clipping, in doubles that hold it well enough to see zero.
double shared_area(const WholeCorners& a, const WholeCorners& b) {
  const auto side = [](const Whole& p, const Whole& q, const std::array<double, 2>& x) {
    return static_cast<double>(q[0] - p[0]) * (x[1] - static_cast<double>(p[1])) -
           static_cast<double>(q[1] - p[1]) * (x[0] - static_cast<double>(p[0]));
  };
  std::vector<std::array<double, 2>> polygon;
  for (const Whole& p : b) polygon.push_back({static_cast<double>(p[0]), static_cast<double>(p[1])});
  const double sense = normal_of(a)[2] > 0 ? 1 : -1;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<std::array<double, 2>> clipped;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto& p = polygon[k];
      const auto& q = polygon[(k + 1) % polygon.size()];
      const double sp = sense * side(a[i], a[(i + 1) % 3], p), sq = sense * side(a[i], a[(i + 1) % 3], q);
      if (sp >= 0) clipped.push_back(p);
      if ((sp < 0) != (sq < 0)) clipped.push_back({p[0] + sp / (sp - sq) * (q[0] - p[0]), p[1] + sp / (sp - sq) * (q[1] - p[1])});
    }
    polygon = clipped;
  }
  double area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& p = polygon[k];
    const auto& q = polygon[(k + 1) % polygon.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return std::fabs(area);
}

void compare_with_brute_force(const WholeCorners& a, const WholeCorners& b, double scale) {
  const Expected expected = brute_force(a, b);
  const Corners c = in_doubles(a, scale), d = in_doubles(b, scale);
  const PairClassification result = classify(c, d);
  CHECK(keys(result.incidences) == expected.incidences);
  CHECK(keys(result.incidences).size() == result.incidences.size());
  CHECK((result.contact == PairContact::None) == expected.incidences.empty());
  if (!expected.is_coplanar) {
    CHECK(result.contact != PairContact::Overlap);
    CHECK(result.incidences.size() <= 2);
  }
  PairClassification shared;
  classify_pair(with_ids(c, 0), with_shared_ids(d, c, 3), shared);
  CHECK(shared.contact == result.contact);
  CHECK(keys(shared.incidences) == expected.incidences);
}

}  // namespace

TEST_CASE("triangles on a small grid touch as brute force over all pairs of features says") {
  constexpr std::uint32_t seed = 20240611;
  INFO("seed " << seed);
  TriangleMaker maker(seed);
  std::size_t touching = 0;
  for (std::size_t i = 0, n = scaled_count(12000, 400000); i < n; ++i) {
    const int size = 2 + static_cast<int>(i % 5);
    const WholeCorners a = maker.make(size), b = maker.make(size);
    compare_with_brute_force(a, b, i % 3 == 0 ? 1 : i % 3 == 1 ? 0x1p300 : 0x1p-300);
    touching += brute_force(a, b).incidences.empty() ? 0 : 1;
  }
  CHECK(touching > scaled_count(12000, 400000) / 5);
}

TEST_CASE("triangles of one plane overlap exactly when clipping leaves area") {
  constexpr std::uint32_t seed = 715;
  INFO("seed " << seed);
  TriangleMaker maker(seed);
  std::array<std::size_t, 3> seen{};
  for (std::size_t i = 0, n = scaled_count(6000, 200000); i < n; ++i) {
    const WholeCorners a = maker.make_flat(4), b = maker.make_flat(4);
    compare_with_brute_force(a, b, 1);
    const PairContact contact = classify(in_doubles(a, 1), in_doubles(b, 1)).contact;
    ++seen[static_cast<std::size_t>(contact)];
    CHECK((contact == PairContact::Overlap) == (shared_area(a, b) > 1e-9));  // what they share is at least 1 / 30^4
  }
  for (const std::size_t count : seen) CHECK(count > 0);
}
