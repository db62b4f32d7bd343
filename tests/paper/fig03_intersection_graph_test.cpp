// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paper 2.2, Fig. 3: an intersection graph of one chain v1, v2, v3 and one isolated vertex v4; 4.3: a contact in a vertex only.
#include <algorithm>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Vec3d v1{1, 1, 0}, v2{3, 2, 0}, v3{5, 1, 0}, v4{2, 6, 0};

/// BREP A: its top is one triangle in z = 0.
const SurfaceMesh plate = prism({{0, 0}, {12, 0}, {0, 12}}, -2, 0);

/// A tetrahedron that stands on the edge from p to q.
SurfaceMesh standing_on_edge(const Vec3d& p, const Vec3d& q) { return tetrahedron(p, q, {p.x, p.y - 0.5, 2}, {q.x, q.y + 0.5, 3}); }

/// A tetrahedron that stands on its corner p.
SurfaceMesh standing_on_corner(const Vec3d& p) { return tetrahedron(p, p + Vec3d{-1, -1, 2}, p + Vec3d{1, -1, 2}, p + Vec3d{0, 1, 2}); }

std::vector<std::array<double, 3>> positions(const IntersectionGraph& graph, const std::vector<std::uint32_t>& chain) {
  std::vector<std::array<double, 3>> points;
  for (const std::uint32_t i : chain) points.push_back({graph.points[i].x, graph.points[i].y, graph.points[i].z});
  return points;
}

/// Facets of a source face that have a corner at this point.
std::size_t facets_at(const BooleanResult& result, std::uint32_t operand, std::uint32_t face, const Vec3d& point) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (result.provenance.source_operand[f] != operand || result.provenance.source_face[f] != face) continue;
    const oracle::Corners corners = oracle::corners_of(result.mesh, f);
    count += static_cast<std::size_t>(std::count(corners.begin(), corners.end(), point));
  }
  return count;
}

constexpr std::uint32_t top_face = 1;  // prism() writes bottom and top of a triangle first

}  // namespace

TEST_CASE("Fig. 3: a chain of two edges and an isolated vertex are one graph") {
  const SurfaceMesh standing = joined({standing_on_edge(v1, v2), standing_on_edge(v2, v3), standing_on_corner(v4)});
  for (const bool swapped : {false, true}) {
    const BooleanResult result = evaluate(Operation::Union, swapped ? std::vector{standing, plate} : std::vector{plate, standing});
    const IntersectionGraph& graph = result.graph;
    CHECK(graph.points.size() == 4);
    CHECK(graph.edges.size() == 2);
    REQUIRE((graph.open_chains == 1 && graph.closed_loops == 0 && graph.chains.size() == 1));
    auto chain = positions(graph, graph.chains[0]);
    if (chain.front() != std::array{v1.x, v1.y, v1.z}) std::reverse(chain.begin(), chain.end());
    CHECK(chain == std::vector<std::array<double, 3>>{{1, 1, 0}, {3, 2, 0}, {5, 1, 0}});
    CHECK(std::count(graph.points.begin(), graph.points.end(), v4) == 1);
    CHECK(result.report.contact.points == 1);
    CHECK(faults_of_mesh(result) == "");
  }
}

TEST_CASE("Fig. 3: the face of A is split along the chain and at the isolated vertex") {
  const SurfaceMesh standing = joined({standing_on_edge(v1, v2), standing_on_edge(v2, v3), standing_on_corner(v4)});
  const BooleanResult result = evaluate(Operation::Union, {plate, standing});
  // Four points inside a triangle make 1 + 2 * 4 facets of it.
  const auto& faces = result.provenance.source_face;
  std::size_t facets = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) facets += result.provenance.source_operand[f] == 0 && faces[f] == top_face ? 1 : 0;
  CHECK(facets == 9);
  for (const Vec3d& v : {v1, v2, v3, v4}) CHECK(facets_at(result, 0, top_face, v) >= 3);
}

TEST_CASE("4.3: a segment that touches in one vertex gives a graph of one vertex and no edge, and both sides are split there") {
  const SurfaceMesh standing = standing_on_corner(v4);
  const BooleanResult result = evaluate(Operation::Union, {plate, standing});
  CHECK(result.graph.points == std::vector<Vec3d>{v4});
  CHECK((result.graph.edges.empty() && result.graph.chains.empty()));
  CHECK(facets_at(result, 0, top_face, v4) == 3);
  // The vertex is one, shared by both sides.
  CHECK(result.mesh.points.size() == plate.points.size() + standing.points.size());
  CHECK(std::count(result.mesh.points.begin(), result.mesh.points.end(), v4) == 1);
}

TEST_CASE("4.3: an edge that touches an edge in one point splits both edges there") {
  const SurfaceMesh across = tetrahedron({6, -1, -1}, {6, 1, 1}, {5, -4, 4}, {7, -4, 4});
  // Its first edge passes through (6, 0, 0), in the middle of the edge from (0, 0, 0) to (12, 0, 0) of the plate.
  const BooleanResult result = evaluate(Operation::Union, {plate, across});
  CHECK(result.graph.points == std::vector<Vec3d>{{6, 0, 0}});
  CHECK(result.graph.edges.empty());
  CHECK(result.mesh.points.size() == plate.points.size() + across.points.size() + 1);
  CHECK(result.mesh.triangles.size() == plate.triangles.size() + across.triangles.size() + 4);
  CHECK(faults_of_mesh(result) == "");
}
