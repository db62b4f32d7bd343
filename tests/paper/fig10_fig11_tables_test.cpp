// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paper 4.1 and 4.2, Figs. 10 and 11: faces F1 and F2 of BREP1 with the common edge E67, face F3 of BREP2 with the edges E52 and
// E50, points 1, 2 and 3: the raw record, the face pairs, and the face intersection map. Fig. 12: the edges after the splits.
#include <algorithm>
#include <set>

#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

// F1 and F2 meet in the edge E67 from (4, 0, 0) to (4, 0, 8). F3 lies in z = 4; with x + y = 4 in F1 and x - y = 4 in F2 it meets them
// along two segments that join in E67. Its third edge, at y = 1, is the only one that passes through F1 and F2.
const SurfaceMesh brep1 = make_mesh({{4, 0, 0}, {4, 0, 8}, {0, 4, 4}, {8, 4, 4}}, {{0, 1, 2}, {1, 0, 3}});
const SurfaceMesh brep2_bent = make_mesh({{4, -9, 4}, {7, 1, 4}, {4, 1.5, 4}, {1, 1, 4}}, {{0, 1, 2}, {0, 2, 3}});
const SurfaceMesh brep2 = make_mesh({{1, 1, 4}, {4, -9, 4}, {7, 1, 4}}, {{0, 1, 2}});

constexpr Vec3d p1{3, 1, 4}, p2{5, 1, 4}, p3{4, 0, 4};

struct Fig11 {
  Arrangement scene{{brep1, brep2}};
  SourceId f1 = scene.face(0, 0), f2 = scene.face(0, 1), f3 = scene.face(1, 0);
  PointId one = scene.point_at(p1), two = scene.point_at(p2), three = scene.point_at(p3);
};

/// Incidences of a pair of faces as kinds: edge number (or none for the inside) on both.
std::vector<Incidence> incidences(const Fig11& fig, SourceId a, SourceId b) {
  for (const Contact& contact : fig.scene.contacts.contacts) {
    if (contact.face_a != a || contact.face_b != b) continue;
    const auto span = fig.scene.contacts.incidences_of(contact);
    return {span.begin(), span.end()};
  }
  return {};
}

bool contains(const std::vector<Incidence>& list, const Incidence& incidence) {
  return std::find(list.begin(), list.end(), incidence) != list.end();
}

std::set<std::array<PointId, 2>> row(const Fig11& fig, SourceId face) {
  std::set<std::array<PointId, 2>> pairs;
  for (const Segment& s : fig.scene.map.segments_of(fig.scene.overlays.of_face(face)))
    pairs.insert({std::min(s.p, s.q), std::max(s.p, s.q)});
  return pairs;
}

std::array<PointId, 2> pair_of(PointId a, PointId b) { return {std::min(a, b), std::max(a, b)}; }

/// Facets of a face that have both points as corners.
std::size_t facets_with_edge(const Fig11& fig, SourceId face, PointId a, PointId b) {
  std::size_t count = 0;
  for (const FacetId f : fig.scene.facets_of(face)) {
    const PlanePoints& c = fig.scene.facets.corners[f];
    if (std::count(c.begin(), c.end(), a) == 1 && std::count(c.begin(), c.end(), b) == 1) ++count;
  }
  return count;
}

constexpr Feature inside{Feature::Kind::Inside, 0};
constexpr Feature edge(std::uint8_t i) { return {Feature::Kind::Edge, i}; }

}  // namespace

TEST_CASE("Fig. 10e, 11b: every point is recorded with the edge of one side and the face of the other") {
  const Fig11 fig;
  const std::vector<Incidence> f1_f3 = incidences(fig, fig.f1, fig.f3), f2_f3 = incidences(fig, fig.f2, fig.f3);
  // The two rows of each pair: F3's edge in the face (points 1, 2), and E67, which is edge 0 of F1 and of F2, in F3 (point 3).
  CHECK(f1_f3.size() == 2);
  CHECK(contains(f1_f3, {inside, edge(2)}));
  CHECK(contains(f1_f3, {edge(0), inside}));
  CHECK(f2_f3.size() == 2);
  CHECK(contains(f2_f3, {inside, edge(2)}));
  CHECK(contains(f2_f3, {edge(0), inside}));
}

TEST_CASE("Fig. 11c: a point on an edge belongs to all faces round that edge") {
  const Fig11 fig;
  CHECK(fig.scene.contacts.contacts.size() == 2);
  REQUIRE((fig.one.is_valid() && fig.two.is_valid() && fig.three.is_valid()));
  CHECK(fig.scene.map.contact_points.size() == 3);
}

TEST_CASE("Fig. 11e: the face intersection map: F1 {(1,3)}, F2 {(3,2)}, F3 {(1,3),(3,2)}") {
  const Fig11 fig;
  CHECK(row(fig, fig.f1) == std::set{pair_of(fig.one, fig.three)});
  CHECK(row(fig, fig.f2) == std::set{pair_of(fig.three, fig.two)});
  CHECK(row(fig, fig.f3) == std::set{pair_of(fig.one, fig.three), pair_of(fig.three, fig.two)});
}

TEST_CASE("Fig. 11f: the pairs of one face join to a chain") {
  const Fig11 fig;
  std::multiset<PointId> ends;
  for (const auto& pair : row(fig, fig.f3)) ends.insert(pair.begin(), pair.end());
  CHECK((ends.count(fig.one) == 1 && ends.count(fig.two) == 1 && ends.count(fig.three) == 2));
}

TEST_CASE("Fig. 12: after the splits the edges of both sides match one to one") {
  const Fig11 fig;
  // F3 keeps facets on both sides of each segment; a segment that ends on E67 has facets of one face of BREP1 on both sides.
  CHECK(facets_with_edge(fig, fig.f3, fig.one, fig.three) == 2);
  CHECK(facets_with_edge(fig, fig.f1, fig.one, fig.three) == 2);
  CHECK(facets_with_edge(fig, fig.f3, fig.three, fig.two) == 2);
  CHECK(facets_with_edge(fig, fig.f2, fig.three, fig.two) == 2);
  CHECK(facets_with_edge(fig, fig.f1, fig.three, fig.two) == 0);
  CHECK(faults_of_facets(fig.scene) == "");
}

TEST_CASE("Fig. 12: the edge E67 is split at the same point in both of its faces") {
  const Fig11 fig;
  const PointId six = fig.scene.point_at({4, 0, 0}), seven = fig.scene.point_at({4, 0, 8});
  for (const SourceId face : {fig.f1, fig.f2}) {
    CHECK(facets_with_edge(fig, face, six, fig.three) == 1);
    CHECK(facets_with_edge(fig, face, fig.three, seven) == 1);
    CHECK(facets_with_edge(fig, face, six, seven) == 0);
  }
}

TEST_CASE("Fig. 12: a face whose neighbour is split along their edge is split there too") {
  // F3 as two faces with the common edge from (4, -9, 4) to (4, 1.5, 4): point 3 now lies on it.
  const Arrangement scene({brep1, brep2_bent});
  const PointId three = scene.point_at(p3), foot = scene.point_at({4, -9, 4}), tip = scene.point_at({4, 1.5, 4});
  for (const std::size_t f : {0U, 1U}) {
    std::size_t below = 0, above = 0, whole = 0;
    for (const FacetId facet : scene.facets_of(scene.face(1, f))) {
      const PlanePoints& c = scene.facets.corners[facet];
      const auto has = [&](PointId p) { return std::count(c.begin(), c.end(), p) == 1; };
      below += has(foot) && has(three) ? 1 : 0;
      above += has(three) && has(tip) ? 1 : 0;
      whole += has(foot) && has(tip) ? 1 : 0;
    }
    CHECK((below == 1 && above == 1 && whole == 0));
  }
  CHECK(faults_of_facets(scene) == "");
}
