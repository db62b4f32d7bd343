// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paper 4, Figs. 8 and 9: where a segment goes through a face, and on which entity the point lies. Patterns of signs decide, not
// the tolerance of the paper.
#include <cmath>
#include <limits>

#include "mortise/arrange/classify_pair.h"
#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Feature corner(std::uint8_t i) { return {Feature::Kind::Corner, i}; }
constexpr Feature edge(std::uint8_t i) { return {Feature::Kind::Edge, i}; }
constexpr Feature inside{Feature::Kind::Inside, 0};

/// v0, v1, v2 of both figures, in z = 1.
const oracle::Corners face{{{1, 1, 1}, {5, 1, 1}, {1, 5, 1}}};

double up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double down(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

PairClassification contact_with(const oracle::Corners& other) {
  PairClassification result;
  classify_pair({{0, 1, 2}, face}, {{3, 4, 5}, other}, result);
  return result;
}

/// A triangle whose edge 0 runs from p0 to p1, and whose third corner is far away on the side of x + y > 6.
oracle::Corners with_edge(const Vec3d& p0, const Vec3d& p1) { return {{p0, p1, {40, 40, p1.z}}}; }

/// The feature of the face on which the corner p of a triangle above it stands; nothing when it does not touch.
std::optional<Feature> feature_under(const Vec3d& p) {
  const PairClassification result = contact_with({{p, {p.x + 1, p.y, 3}, {p.x, p.y + 1, 4}}});
  if (result.contact == PairContact::None) return std::nullopt;
  REQUIRE(result.incidences.size() == 1);
  CHECK(result.incidences[0].on_b == corner(0));
  return result.incidences[0].on_a;
}

}  // namespace

TEST_CASE("Fig. 8: a segment whose ends lie on opposite sides goes through the face") {
  const PairClassification result = contact_with(with_edge({2, 2, 0}, {2, 2, 4}));
  CHECK(result.contact == PairContact::Touching);
  REQUIRE(result.incidences.size() == 2);
  CHECK(std::count(result.incidences.begin(), result.incidences.end(), Incidence{inside, edge(0)}) == 1);
}

TEST_CASE("Fig. 8: a segment with both ends on one side does not go through, however near they are") {
  CHECK(contact_with({{{2, 2, up(1)}, {2, 2, 4}, {40, 40, 4}}}).contact == PairContact::None);
  CHECK(contact_with({{{2, 2, -4}, {2, 2, down(1)}, {40, 40, -4}}}).contact == PairContact::None);
}

TEST_CASE("Fig. 8: one ulp of the end decides between passing by, touching and going through") {
  const auto lifted = [](double z) { return contact_with({{{2, 2, z}, {2, 2, 4}, {3, 2, 4}}}); };
  CHECK(lifted(up(1)).contact == PairContact::None);
  CHECK(lifted(1).incidences == std::vector<Incidence>{{inside, corner(0)}});
  CHECK(lifted(down(1)).incidences.size() == 2);
  for (const Incidence& i : lifted(down(1)).incidences) CHECK((i.on_a == inside && i.on_b.kind == Feature::Kind::Edge));
}

TEST_CASE("Fig. 8: the point of the segment is the correctly rounded one") {
  // The edge from (0, 0, 0) to (3, 7, 11) of a tetrahedron meets z = 5 at t = 5/11.
  const SurfaceMesh spike = tetrahedron({0, 0, 0}, {3, 7, 11}, {1, 0, -1}, {0, 1, -1});
  const BooleanResult result = evaluate(Operation::Union, {spike, box({-9, -9, 2}, {9, 9, 5})});
  const Vec3d expected =
      oracle::nearest_double(oracle::RationalPoint{oracle::Rational(15, 11), oracle::Rational(35, 11), oracle::Rational(5)});
  CHECK(std::count(result.mesh.points.begin(), result.mesh.points.end(), expected) == 1);
}

TEST_CASE("Fig. 9: a point lies on a corner, on an edge or inside, and one ulp beside it elsewhere") {
  CHECK(feature_under({1, 1, 1}) == corner(0));
  CHECK(feature_under({5, 1, 1}) == corner(1));
  CHECK(feature_under({1, 5, 1}) == corner(2));
  CHECK(feature_under({3, 1, 1}) == edge(0));
  CHECK(feature_under({3, 3, 1}) == edge(1));
  CHECK(feature_under({1, 3, 1}) == edge(2));
  CHECK(feature_under({2, 2, 1}) == inside);
}

TEST_CASE("Fig. 9: moving a point by one ulp changes exactly the pattern that should change") {
  CHECK(feature_under({up(1), 1, 1}) == edge(0));
  CHECK(feature_under({1, up(1), 1}) == edge(2));
  CHECK(feature_under({up(1), up(1), 1}) == inside);
  CHECK(feature_under({down(1), 1, 1}) == std::nullopt);
  CHECK(feature_under({3, up(1), 1}) == inside);
  CHECK(feature_under({3, down(1), 1}) == std::nullopt);
  CHECK(feature_under({3, down(3), 1}) == inside);
  CHECK(feature_under({3, up(3), 1}) == std::nullopt);
  CHECK(feature_under({2, 2, up(1)}) == std::nullopt);
}

TEST_CASE("Figs. 8 and 9: the five kinds of contact by name") {
  const auto only = [](const PairClassification& result) {
    REQUIRE(result.incidences.size() == 1);
    return result.incidences[0];
  };
  CHECK(only(contact_with({{{5, 1, 1}, {6, 1, 3}, {5, 0, 3}}})) == Incidence{corner(1), corner(0)});  // V-V
  CHECK(only(contact_with({{{3, 1, 1}, {3, 1, 3}, {4, 0, 3}}})) == Incidence{edge(0), corner(0)});    // V-E
  CHECK(only(contact_with({{{2, 2, 1}, {3, 2, 3}, {2, 3, 3}}})) == Incidence{inside, corner(0)});     // V-F
  CHECK(only(contact_with({{{3, 0, 0}, {3, 2, 2}, {3, -9, 9}}})) == Incidence{edge(0), edge(0)});     // E-E
  const PairClassification through = contact_with({{{2, 2, 0}, {2, 2, 4}, {2.5, 2, 4}}});             // E-F, twice
  REQUIRE(through.incidences.size() == 2);
  for (const Incidence& i : through.incidences) CHECK((i.on_a == inside && i.on_b.kind == Feature::Kind::Edge));
}
