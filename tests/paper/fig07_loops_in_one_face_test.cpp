// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paper 4, Fig. 7: one large face in two chains, or in one chain twice: found without walking along chains.
#include <algorithm>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A plate 200 wide under z = 0 whose top is two triangles that meet along x = 1.5.
const SurfaceMesh plate = prism({{1.5, -100}, {100, 0}, {1.5, 100}, {-100, 0}}, -10, 0);

/// Turns corners and reverses or rotates the order of faces.
SurfaceMesh reordered(SurfaceMesh mesh, std::size_t order) {
  auto& faces = mesh.triangles;
  if (order % 2 == 1) std::reverse(faces.begin(), faces.end());
  std::rotate(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(order % faces.size()), faces.end());
  for (std::size_t f = 0; f < faces.size(); ++f)
    std::rotate(faces[f].begin(), faces[f].begin() + static_cast<std::ptrdiff_t>((f + order) % 3), faces[f].end());
  return mesh;
}

bool has_edge(const SurfaceMesh& mesh, std::size_t face, const Vec3d& p, const Vec3d& q) {
  const oracle::Corners c = oracle::corners_of(mesh, face);
  return std::count(c.begin(), c.end(), p) == 1 && std::count(c.begin(), c.end(), q) == 1;
}

/// Facets of an operand at an edge of the graph.
std::size_t facets_on_edge(const BooleanResult& result, std::uint32_t operand, const std::array<std::uint32_t, 2>& edge) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (result.provenance.source_operand[f] != operand) continue;
    if (has_edge(result.mesh, f, result.graph.points[edge[0]], result.graph.points[edge[1]])) ++count;
  }
  return count;
}

void check_loops(const SurfaceMesh& through, std::uint32_t loops) {
  std::vector<std::array<double, 3>> points;
  for (std::size_t order = 0; order < 12; ++order) {
    INFO("order " << order);
    const BooleanResult result = evaluate(Operation::Union, {reordered(plate, order), reordered(through, 7 * order)});
    CHECK((result.graph.closed_loops == loops && result.graph.open_chains == 0));
    CHECK(faults_of_mesh(result) == "");
    // The same edges on both sides: each is in one facet of the plate and one of the other that stay.
    for (const auto& edge : result.graph.edges) {
      CHECK(facets_on_edge(result, 0, edge) == 1);
      CHECK(facets_on_edge(result, 1, edge) == 1);
    }
    if (order == 0) points = sorted_points(result.mesh);
    CHECK(sorted_points(result.mesh) == points);
  }
}

}  // namespace

TEST_CASE("Fig. 7a: one large face in two chains makes two closed loops, the same on both sides, for every order of faces") {
  check_loops(joined({octahedron({20, 5, 0.25}, 1), octahedron({23, -4, -0.25}, 1)}), 2);
}

TEST_CASE("Fig. 7b: one large face in one chain twice makes one closed loop") {
  // A clasp: its two arms reach over x = 1.5 into the right triangle, the bar that joins them is over the left one.
  const SurfaceMesh clasp =
      evaluate(Operation::Union, {box({0, 0, -1}, {1, 6, 1}), box({0.5, 0, -1}, {4, 1, 1}), box({0.5, 5, -1}, {4, 6, 1})}).mesh;
  CHECK(exact_volume(clasp) == 2 * (6 + 3 + 3));
  check_loops(clasp, 1);
}

TEST_CASE("Fig. 7c: chains on both sides of the large operand do not disturb one another") {
  check_loops(joined({octahedron({20, 5, 0.25}, 1), octahedron({20, 5, -10.25}, 1), octahedron({-20, 5, 0.125}, 2)}), 3);
}
