// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paper 6.1, Fig. 15: at an edge of the intersection graph the sign of a box product says which face of BREP1 is outside BREP2.
#include <algorithm>

#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// Box product of the source face (F4) of the one facet of operand 1 at a graph edge, and the opposite vertex (V4) of the one
/// facet of operand 0 there: +1 when that facet (F2) is in front of F4, -1 behind.
int box_product(const BooleanResult& result, const SurfaceMesh& brep2, const std::array<std::uint32_t, 2>& edge) {
  const Vec3d &v2 = result.graph.points[edge[0]], &v3 = result.graph.points[edge[1]];
  std::optional<Vec3d> opposite;
  std::optional<oracle::Corners> f4;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const oracle::Corners c = oracle::corners_of(result.mesh, f);
    if (std::count(c.begin(), c.end(), v2) + std::count(c.begin(), c.end(), v3) != 2) continue;
    if (result.provenance.source_operand[f] == 0) {
      opposite = *std::find_if(c.begin(), c.end(), [&](const Vec3d& p) { return p != v2 && p != v3; });
    } else {
      f4 = oracle::corners_of(brep2, result.provenance.source_face[f]);
    }
  }
  REQUIRE((opposite && f4));
  return oracle::orient3d(oracle::exact((*f4)[0]), oracle::exact((*f4)[1]), oracle::exact((*f4)[2]), oracle::exact(*opposite));
}

/// A bar through a side of a box: all points of the graph are representable, the box is convex.
const SurfaceMesh brep1 = prism({{0, 0}, {4, 0}, {4, 1}, {0, 1}}, 0, 1);
const SurfaceMesh brep2 = box_other_diagonals({2, -3, -2}, {7, 5, 6});

}  // namespace

TEST_CASE("Fig. 15: faces of BREP1 that the union keeps have a positive box product, those of the intersection a negative one") {
  const std::vector<SurfaceMesh> breps{brep1, brep2};
  const BooleanResult all = evaluate(Operation::Union, breps), both = evaluate(Operation::Intersect, breps);
  REQUIRE(all.graph.edges.size() >= 8);  // the square of the bar, and the diagonals of its sides
  CHECK(all.graph.closed_loops == 1);
  for (const auto& edge : all.graph.edges) CHECK(box_product(all, brep2, edge) > 0);
  for (const auto& edge : both.graph.edges) CHECK(box_product(both, brep2, edge) < 0);
}

TEST_CASE("Fig. 15: the tags of facets are 10 and 20 in the union, 11 and 21 in the intersection, 10 and 21 in the difference") {
  const std::vector<SurfaceMesh> breps{brep1, brep2};
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract}) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, breps);
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
      const bool first = result.provenance.source_operand[f] == 0;
      const bool is_inside = operation == Operation::Intersect || (operation == Operation::Subtract && !first);
      CHECK(result.provenance.category[f] == (is_inside ? FacetCategory::Inside : FacetCategory::Outside));
    }
  }
}

TEST_CASE("Fig. 15: the walk is carried over the whole surface: every facet is on the side its middle says") {
  const std::vector<SurfaceMesh> breps{octahedron({0, 0, 0}, 2), octahedron({1, 0.5, 0.25}, 2)};
  const BooleanResult all = evaluate(Operation::Union, breps), both = evaluate(Operation::Intersect, breps);
  const auto middle_winding = [&](const BooleanResult& result, std::size_t f) {
    const auto positions = exact_positions(pointers_to(breps), result);
    oracle::RationalPoint middle;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const VertexId v : result.mesh.triangles[f]) middle[i] += positions[v.index()][i] / 3;
    }
    return oracle::winding_number(breps[1 - result.provenance.source_operand[f]], middle);
  };
  for (std::size_t f = 0; f < all.mesh.triangles.size(); ++f) CHECK(middle_winding(all, f) == 0);
  for (std::size_t f = 0; f < both.mesh.triangles.size(); ++f) CHECK(middle_winding(both, f) == 1);
}
