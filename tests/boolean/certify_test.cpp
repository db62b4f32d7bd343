// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The certificate says yes to results as they are, and no to results folded, pinched, twisted and turned inside out by hand.
#include "mortise/boolean/certify.h"

#include <algorithm>
#include <map>
#include <set>

#include "boolean/evaluation.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/exact_points.h"
#include "support/grid_solids.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
const SurfaceMesh slanted = tetrahedron({0.3, 0.2, -0.5}, {1.7, 0.3, 0.4}, {0.2, 1.6, 0.5}, {0.4, 0.3, 1.9});

CertifiedMesh certify_scene(const MergedScene& scene) { return certify(scene.faces, scene.facets, scene.merged, {}); }

bool is_moved(const MergedScene& scene, VertexId v) {
  return !scene.faces.points.is_representable(scene.merged.point_of_vertex[v.index()]);
}

std::vector<VertexId> moved_vertices(const MergedScene& scene) {
  std::vector<VertexId> moved;
  for (std::size_t v = 0; v < scene.merged.mesh.points.size(); ++v) {
    if (is_moved(scene, VertexId(v))) moved.push_back(VertexId(v));
  }
  return moved;
}

std::size_t moved_triangles(const MergedScene& scene) {
  const auto& triangles = scene.merged.mesh.triangles;
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return is_moved(scene, t[0]) || is_moved(scene, t[1]) || is_moved(scene, t[2]);
  }));
}

/// A refusal that hangs together: its faces are those of its pairs.
void check_uncertified(const CertifiedMesh& certified) {
  CHECK(certified.certificate.status == CertificateStatus::Uncertified);
  std::set<std::uint32_t> faces;
  for (const FailedPair& f : certified.failed) faces.insert({f.a.value, f.b.value});
  CHECK(!faces.empty());
  CHECK(certified.certificate.failed_faces == std::vector<std::uint32_t>(faces.begin(), faces.end()));
}

bool has_failed(const CertifiedMesh& certified, std::size_t face) {
  const auto& failed = certified.certificate.failed_faces;
  return std::find(failed.begin(), failed.end(), face) != failed.end();
}

/// Two boxes that share the edge x = y = 1, cut off by a slanted face: four triangles round an edge with a made end.
MergedScene pinched_edge() {
  return {Operation::Intersect,
          {joined({unit, moved(unit, {1, 1, 0})}), tetrahedron({-20, -20, -5}, {30, -20, -5}, {-20, 30, -5}, {1.1, 1.2, 0.7})}};
}

/// The edges of so many triangles with at least one end that was rounded.
std::vector<std::array<VertexId, 2>> edges_with(const MergedScene& scene, int triangles) {
  std::map<std::array<VertexId, 2>, int> count;
  for (const Triangle& t : scene.merged.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++count[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  }
  std::vector<std::array<VertexId, 2>> edges;
  for (const auto& [edge, n] : count) {
    if (n == triangles && (is_moved(scene, edge[0]) || is_moved(scene, edge[1]))) edges.push_back(edge);
  }
  return edges;
}

/// The first such edge of four triangles.
std::array<VertexId, 2> crowded_edge(const MergedScene& scene) {
  const auto edges = edges_with(scene, 4);
  return edges.empty() ? std::array<VertexId, 2>{} : edges.front();
}

}  // namespace

TEST_CASE("a result whose vertices all are their exact points needs no test") {
  const MergedScene scene(Operation::Union, {unit, moved(unit, {0.5, 0.5, 0.5})});
  const CertifiedMesh certified = certify_scene(scene);
  CHECK(certified.certificate.status == CertificateStatus::Certified);
  CHECK((certified.certificate.triangles_tested == 0 && certified.certificate.pairs_tested == 0));
  CHECK(certified.certificate.largest_displacement == 0);
  CHECK((certified.failed.empty() && certified.certificate.failed_faces.empty()));
}

TEST_CASE("triangles with a rounded vertex are tested against all they meet") {
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract}) {
    const MergedScene scene(operation, {unit, slanted});
    REQUIRE(!moved_vertices(scene).empty());
    const CertifiedMesh certified = certify_scene(scene);
    CHECK(certified.certificate.status == CertificateStatus::Certified);
    CHECK(certified.certificate.triangles_tested == moved_triangles(scene));
    CHECK(certified.certificate.pairs_tested >= certified.certificate.triangles_tested);
    CHECK(certified.certificate.inherited_pairs == 0);
  }
}

TEST_CASE("the displacement bounds the distance of every vertex to its exact point, and is not far above it") {
  const MergedScene scene(Operation::Union, {unit, slanted});
  const std::vector<oracle::RationalPoint> exact = exact_points(scene);
  const double bound = certify_scene(scene).certificate.largest_displacement;
  for (std::size_t v = 0; v < scene.merged.mesh.points.size(); ++v) {
    const oracle::RationalPoint& p = exact[scene.merged.point_of_vertex[v].index()];
    const oracle::RationalPoint q = oracle::exact(scene.merged.mesh.points[v]);
    oracle::Rational distance2 = 0;
    for (std::size_t i = 0; i < 3; ++i) distance2 += (p[i] - q[i]) * (p[i] - q[i]);
    CHECK(distance2 <= oracle::exact(bound) * oracle::exact(bound));
  }
  CHECK((bound > 0 && bound < 4e-16));  // coordinates below 1.7
}

TEST_CASE("a displacement by repair counts as well") {
  MergedScene scene(Operation::Union, {unit, slanted});
  const double rounding = certify_scene(scene).certificate.largest_displacement;
  scene.merged.repair_displacement = 0.25;
  CHECK(rounding > 0);
  CHECK(certify_scene(scene).certificate.largest_displacement == 0.25 + rounding);
}

TEST_CASE("a vertex that is not at its point counts as rounded") {
  MergedScene scene(Operation::Union, {unit, moved(unit, {0.5, 0.5, 0.5})});
  CHECK(certify_scene(scene).certificate.triangles_tested == 0);
  scene.merged.mesh.points[0].x += 0.125;
  const Certificate certificate = certify_scene(scene).certificate;
  CHECK(certificate.triangles_tested > 0);
  CHECK(certificate.largest_displacement >= 0.125);
}

TEST_CASE("a vertex pushed through the other side of the mesh is found, at each vertex") {
  const MergedScene good(Operation::Union, {unit, slanted});
  for (const VertexId v : moved_vertices(good)) {
    MergedScene scene(Operation::Union, {unit, slanted});
    Vec3d& p = scene.merged.mesh.points[v.index()];
    p = 4.0 * Vec3d{0.5, 0.45, 0.55} - 3.0 * p;  // through a point inside, and out again
    check_uncertified(certify_scene(scene));
  }
}

TEST_CASE("two vertices on one double are found") {
  MergedScene scene(Operation::Union, {unit, slanted});
  auto& mesh = scene.merged.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    if (!is_moved(scene, c[0]) || !is_moved(scene, c[1])) continue;
    mesh.points[c[0].index()] = mesh.points[c[1].index()];
    const CertifiedMesh certified = certify_scene(scene);
    check_uncertified(certified);
    CHECK(has_failed(certified, t));
    return;
  }
  FAIL("no triangle with two rounded vertices");
}

TEST_CASE("a triangle flattened to a line is found") {
  MergedScene scene(Operation::Union, {unit, slanted});
  auto& mesh = scene.merged.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    if (!is_moved(scene, c[0]) || mesh.points[c[1].index()] == mesh.points[c[2].index()]) continue;
    mesh.points[c[0].index()] = {0.5, 0.5, 0.5};
    mesh.points[c[1].index()] = {0.25, 0.25, 0.25};
    mesh.points[c[2].index()] = {0.75, 0.75, 0.75};
    const CertifiedMesh certified = certify_scene(scene);
    check_uncertified(certified);
    CHECK(has_failed(certified, t));
    return;
  }
  FAIL("no triangle with a rounded vertex");
}

TEST_CASE("a vertex moved over the opposite edge of its triangles fails exactly where the oracle sees a crossing") {
  std::size_t crossing = 0, fine = 0;
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract}) {
    MergedScene scene(operation, {unit, slanted});
    auto& mesh = scene.merged.mesh;
    for (const VertexId v : moved_vertices(scene)) {
      for (const Triangle& c : mesh.triangles) {
        const auto at = std::find(c.begin(), c.end(), v);
        if (at == c.end()) continue;
        const auto i = static_cast<std::size_t>(at - c.begin());
        const Vec3d before = mesh.points[v.index()];
        const Vec3d middle = 0.5 * (mesh.points[c[(i + 1) % 3].index()] + mesh.points[c[(i + 2) % 3].index()]);
        mesh.points[v.index()] = 1.25 * middle - 0.25 * before;
        const bool is_fine = oracle::self_crossings(mesh).empty() && oracle::faces_without_area(mesh).empty();
        const CertifiedMesh certified = certify_scene(scene);
        CHECK((certified.certificate.status == CertificateStatus::Certified) == is_fine);
        ++(is_fine ? fine : crossing);
        mesh.points[v.index()] = before;
      }
    }
  }
  CHECK((fine > 5 && crossing > 20));
}

TEST_CASE("triangles without a rounded vertex are not tested, whatever is wrong with them") {
  MergedScene scene(Operation::Union, {unit, moved(slanted, {10, 0, 0}), moved(unit, {0.5, 0.5, 0.5})});
  scene.merged.mesh.triangles[0][1] = scene.merged.mesh.triangles[0][0];
  CHECK(certify_scene(scene).certificate.status == CertificateStatus::Certified);
  std::fill(scene.merged.is_repaired.begin(), scene.merged.is_repaired.end(), std::uint8_t{1});
  const CertifiedMesh repaired = certify_scene(scene);
  CHECK(repaired.certificate.triangles_tested == scene.merged.mesh.triangles.size());
  check_uncertified(repaired);
}

TEST_CASE("the order round an edge of four triangles must be the exact one") {
  MergedScene scene = pinched_edge();
  const auto edge = crowded_edge(scene);
  REQUIRE(edge[0].is_valid());
  CHECK(certify_scene(scene).certificate.status == CertificateStatus::Certified);
  // The mirror image in the plane x = y through the edge crosses nothing, but goes round the other way.
  for (Vec3d& p : scene.merged.mesh.points) std::swap(p.x, p.y);
  const CertifiedMesh mirrored = certify_scene(scene);
  check_uncertified(mirrored);
  std::vector<FailedPair> pairs = mirrored.failed;
  std::erase_if(pairs, [](const FailedPair& pair) { return pair.a == pair.b; });  // the shell is turned as well
  CHECK(pairs.size() == 6);                                                       // every pair of the four
  for (const FailedPair& pair : pairs) {
    for (const FaceId f : {pair.a, pair.b}) {
      const Triangle& t = scene.merged.mesh.triangles[f.index()];
      for (const VertexId v : edge) CHECK(std::count(t.begin(), t.end(), v) == 1);
    }
  }
}

TEST_CASE("round an edge that a repair made, inside and outside must alternate") {
  MergedScene scene = pinched_edge();
  const auto edge = crowded_edge(scene);
  REQUIRE(edge[0].is_valid());
  // The end of the edge stands for another point now: the exact order says nothing.
  for (std::size_t v = 0; v < scene.merged.mesh.points.size(); ++v) {
    if (VertexId(v) != edge[1] && is_moved(scene, VertexId(v)))
      scene.merged.point_of_vertex[edge[1].index()] = scene.merged.point_of_vertex[v];
  }
  CHECK(certify_scene(scene).certificate.status == CertificateStatus::Certified);
  std::vector<Triangle*> around;
  for (Triangle& t : scene.merged.mesh.triangles) {
    if (std::count(t.begin(), t.end(), edge[0]) + std::count(t.begin(), t.end(), edge[1]) == 2) around.push_back(&t);
  }
  REQUIRE(around.size() == 4);
  std::swap((*around[0])[1], (*around[0])[2]);
  check_uncertified(certify_scene(scene));
}

TEST_CASE("round an edge of a partition that a repair made, every space must have one set of operands") {
  // Two boxes side by side, cut off by a slanted face: three triangles round an edge with a made end.
  MergedScene scene(Operation::Partition,
                    {unit, moved(unit, {1, 0, 0}), tetrahedron({-20, -20, -5}, {30, -20, -5}, {-20, 30, -5}, {1.1, 1.2, 0.7})});
  const auto fans = edges_with(scene, 3);
  REQUIRE(!fans.empty());
  for (const auto& edge : fans) {
    const auto points = scene.merged.point_of_vertex;
    for (std::size_t v = 0; v < points.size(); ++v) {
      const VertexId other(v);
      if (other != edge[0] && other != edge[1] && is_moved(scene, other))
        scene.merged.point_of_vertex[edge[is_moved(scene, edge[0]) ? 0 : 1].index()] = points[v];
    }
    CHECK(certify_scene(scene).certificate.status == CertificateStatus::Certified);
    for (std::size_t t = 0; t < scene.merged.mesh.triangles.size(); ++t) {
      const Triangle& c = scene.merged.mesh.triangles[t];
      if (std::count(c.begin(), c.end(), edge[0]) + std::count(c.begin(), c.end(), edge[1]) != 2) continue;
      std::swap(scene.merged.provenance.covering[t], scene.merged.provenance.covering_front[t]);
      check_uncertified(certify_scene(scene));
      std::swap(scene.merged.provenance.covering[t], scene.merged.provenance.covering_front[t]);
    }
    scene.merged.point_of_vertex = points;
  }
}

TEST_CASE("a shell that rounding turned inside out is found") {
  // Two tetrahedra cut all corners off each other: every vertex is made.
  const SurfaceMesh one = tetrahedron({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1});
  const SurfaceMesh other = tetrahedron({-1.13, -1.07, -1.11}, {-1.05, 1.12, 1.09}, {1.08, -1.1, 1.06}, {1.14, 1.04, -1.12});
  MergedScene scene(Operation::Intersect, {one, other});
  REQUIRE(!scene.merged.mesh.triangles.empty());
  REQUIRE(moved_vertices(scene).size() == scene.merged.mesh.points.size());
  CHECK(certify_scene(scene).certificate.status == CertificateStatus::Certified);
  for (Vec3d& p : scene.merged.mesh.points) p = -1.0 * p;
  const CertifiedMesh mirrored = certify_scene(scene);
  check_uncertified(mirrored);
  CHECK(mirrored.certificate.failed_faces.size() == 1);
}

TEST_CASE("crossings that an operand brought along are counted, not failed") {
  // The star's walls cross each other; a slanted cut through one of its tips makes rounded vertices on two of them.
  const SurfaceMesh cut = tetrahedron({-3, 8.3, -3}, {3, 8.7, -3}, {0.1, 8.1, 9}, {0.2, 15, 0.3});
  const MergedScene scene(Operation::Subtract, {pentagram_prism(0, 2), cut});
  REQUIRE(scene.categories.doubtful.empty());
  REQUIRE(!moved_vertices(scene).empty());
  const CertifiedMesh certified = certify_scene(scene);
  CHECK(certified.certificate.status == CertificateStatus::Certified);
  CHECK(certified.certificate.inherited_pairs > 0);
}

TEST_CASE("results of random solids are certified, and no more once a vertex was moved so that they cross themselves") {
  constexpr std::uint32_t seed = 21;
  INFO("seed " << seed);
  GridSolids random(seed);
  std::size_t crossing = 0;
  for (std::size_t i = 0, n = scaled_count(60, 4000); i < n; ++i) {
    INFO("case " << i);
    const auto operation = static_cast<Operation>(random.below(3));
    MergedScene scene(operation, {random.tetrahedron(5), random.tetrahedron(5)});
    CHECK(certify_scene(scene).certificate.status == CertificateStatus::Certified);
    const std::vector<VertexId> moved = moved_vertices(scene);
    if (moved.empty()) continue;
    scene.merged.mesh.points[moved.front().index()] = {50, 50, 50};
    if (oracle::self_crossings(scene.merged.mesh).empty()) continue;
    ++crossing;
    CHECK(certify_scene(scene).certificate.status == CertificateStatus::Uncertified);
  }
  CHECK(crossing > 0);
}

TEST_CASE("certifying can be cancelled at every report") {
  const MergedScene scene(Operation::Union, {unit, slanted});
  int calls = 0;
  const auto run = [&](const ProgressCallback& progress) {
    return certify(scene.faces, scene.facets, scene.merged, progress).failed.size();
  };
  CHECK(run([&](std::string_view stage, double) { return ++calls, stage == "certify"; }) == 0);
  REQUIRE(calls > 0);
  for (int n = 1; n <= calls; ++n) {
    int left = n;
    const auto error = error_of([&] { (void)run([&](std::string_view, double) { return --left > 0; }); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(error->stage == "certify");
  }
}
