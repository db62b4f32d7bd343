// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Stacks of triangles on the same corners in a partition.
#include "mortise/boolean/join_coincident.h"

#include "support/catch.h"

using namespace mortise;

namespace {

/// Triangles over three vertices: the way it runs, the spaces in front of and behind it.
struct Layer {
  bool is_even;
  std::uint32_t front, back;
};

MergedMesh stack_of(const std::vector<Layer>& layers) {
  MergedMesh merged;
  merged.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Provenance& p = merged.provenance;
  const VertexId a(std::size_t{0}), b(std::size_t{1}), c(std::size_t{2});
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    merged.mesh.triangles.push_back(layers[i].is_even ? Triangle{b, c, a} : Triangle{b, a, c});
    p.covering_front.push_back(layers[i].front);
    p.covering.push_back(layers[i].back);
    p.flipped.push_back(0);
    p.category.push_back(FacetCategory::Outside);
    p.source_operand.push_back(i);
    p.source_face.push_back(10 + i);
    p.other_source_begin.push_back(0);
  }
  p.other_source_begin.push_back(0);
  p.covering_sets = {{}, {0}, {1}, {2}};
  p.keeps_regions_apart = true;
  return merged;
}

using Remains = std::vector<std::uint8_t>;

Remains join(MergedMesh& merged) {
  const OperandFaces faces;
  const Facets facets;
  merged.facet_of_triangle.resize(merged.mesh.triangles.size());  // all the same
  return join_coincident(FacetOrder(faces, facets), merged);
}

}  // namespace

TEST_CASE("a triangle that stands for two has the facet that comes first in space, whichever has the lower number", "[join_coincident]") {
  OperandFaces faces;
  Facets facets;
  const PointId a = faces.points.add_input({0, 0, 0}), b = faces.points.add_input({1, 0, 0}), c = faces.points.add_input({0, 1, 0});
  const PointId above = faces.points.add_input({0, 1, 0x1p-50});
  facets.corners.push_back({a, b, above});
  facets.corners.push_back({a, b, c});
  for (const std::size_t first : {0U, 1U}) {
    MergedMesh merged = stack_of({{true, 0, 1}, {false, 2, 1}});
    merged.facet_of_triangle.push_back({FacetId(first), false, FacetCategory::Outside, RegionId()});
    merged.facet_of_triangle.push_back({FacetId(1 - first), true, FacetCategory::Outside, RegionId()});
    CHECK(join_coincident(FacetOrder(faces, facets), merged) == Remains{1, 0});
    CHECK(merged.facet_of_triangle[0].facet == FacetId(1U));
    CHECK_FALSE(merged.facet_of_triangle[0].is_flipped);  // triangle 1 runs against its facet and against triangle 0
  }
}

TEST_CASE("two triangles that bound a vanished region become one, with both sources", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {true, 1, 2}});
  CHECK(join(merged) == Remains{1, 0});
  CHECK(merged.provenance.covering_front[0] == 0);
  CHECK(merged.provenance.covering[0] == 2);
  CHECK(merged.provenance.other_source_begin == std::vector<std::uint32_t>{0, 1, 1});
  CHECK(merged.provenance.other_source_operand == std::vector<std::uint32_t>{1});
  CHECK(merged.provenance.other_source_face == std::vector<std::uint32_t>{11});
  CHECK(merged.provenance.other_source_flipped == std::vector<std::uint8_t>{0});
}

TEST_CASE("the spaces are taken on the side where they are, however the triangles run and are ordered", "[join_coincident]") {
  MergedMesh turned = stack_of({{false, 2, 1}, {true, 0, 1}});
  CHECK(join(turned) == Remains{1, 0});
  CHECK(turned.provenance.covering_front[0] == 2);
  CHECK(turned.provenance.covering[0] == 0);
  MergedMesh three = stack_of({{true, 1, 2}, {true, 2, 3}, {false, 1, 0}});
  CHECK(join(three) == Remains{1, 0, 0});
  CHECK(three.provenance.covering_front[0] == 0);
  CHECK(three.provenance.covering[0] == 3);
}

TEST_CASE("a source that runs the other way is flipped", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {false, 2, 1}});
  CHECK(join(merged) == Remains{1, 0});
  CHECK(merged.provenance.flipped[0] == 0);
  CHECK(merged.provenance.other_source_flipped == std::vector<std::uint8_t>{1});
}

TEST_CASE("triangles with the same space on their far sides go", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {false, 0, 1}});
  CHECK(join(merged) == Remains{0, 0});
}

TEST_CASE("a triangle on its own stays, one with a corner twice goes", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {true, 0, 1}});
  merged.mesh.triangles[1][0] = merged.mesh.triangles[1][1];
  CHECK(join(merged) == Remains{1, 0});
  CHECK(merged.provenance.covering[0] == 1);
}

TEST_CASE("sheets stay, on their own and where regions vanish; walls are marked", "[join_coincident][sheets]") {
  MergedMesh alone = stack_of({{true, 1, 1}});
  CHECK(join(alone) == Remains{1});
  MergedMesh two = stack_of({{true, 1, 1}, {false, 1, 1}});
  CHECK(join(two) == Remains{1, 0});
  CHECK(two.mesh.walls == Remains{1, 0});
  MergedMesh on_a_side = stack_of({{true, 0, 0}, {true, 0, 1}});
  CHECK(join(on_a_side) == Remains{1, 0});
  CHECK((on_a_side.provenance.covering_front[0] == 0 && on_a_side.provenance.covering[0] == 1));
  CHECK(on_a_side.mesh.walls.empty());
  MergedMesh between = stack_of({{true, 0, 1}, {true, 1, 2}, {true, 2, 3}});
  CHECK(join(between) == Remains{1, 0, 0});
  CHECK(between.mesh.walls.empty());
  MergedMesh inner = stack_of({{true, 1, 2}, {true, 2, 3}});
  CHECK(join(inner) == Remains{1, 0});
  CHECK(inner.mesh.walls == Remains{1, 0});
}

TEST_CASE("where all sources are kept, faces of different operands stay on one triangle", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {false, 0, 1}});  // a slit between two operands that closed
  merged.keeps_all_sources = true;
  merged.provenance.covering_sets = {{}, {0}};
  CHECK(join(merged) == Remains{1, 0});
  CHECK((merged.provenance.source_operand[0] == 0 && merged.provenance.flipped[0] == 0));
  CHECK(merged.provenance.other_source_operand == std::vector<std::uint32_t>{1});
  CHECK(merged.provenance.other_source_flipped == std::vector<std::uint8_t>{1});
  CHECK(merged.provenance.category[0] == FacetCategory::OnOpposite);
}

TEST_CASE("where all sources are kept, faces of one operand cancel when they run against each other", "[join_coincident]") {
  MergedMesh wedge = stack_of({{true, 0, 1}, {false, 0, 1}});
  wedge.keeps_all_sources = true;
  wedge.provenance.source_operand = {3, 3};
  wedge.provenance.covering_sets = {{}, {3}};
  CHECK(join(wedge) == Remains{0, 0});

  // Operand 0 closes to nothing, operand 2 stays: on the triangle that was its own.
  MergedMesh third = stack_of({{true, 0, 1}, {false, 0, 1}, {true, 0, 2}});
  third.keeps_all_sources = true;
  third.provenance.covering_sets = {{}, {0}, {2}};
  third.provenance.source_operand = {0, 0, 2};
  CHECK(join(third) == Remains{0, 0, 1});
  CHECK((third.provenance.covering_front[2] == 0 && third.provenance.covering[2] == 2));
  CHECK((third.provenance.source_operand[2] == 2 && third.provenance.source_face[2] == 12 && third.provenance.flipped[2] == 0));
  CHECK(third.provenance.other_source_begin == std::vector<std::uint32_t>{0, 0, 0, 0});
  CHECK(third.provenance.category[2] == FacetCategory::Outside);
}

TEST_CASE("where all sources are kept, an operand is behind its faces whatever order rounding laid them in", "[join_coincident]") {
  // Leaving both operands, first the one and first the other: pieces of faces that cross in a hair's breadth.
  MergedMesh merged = stack_of({{true, 2, 3}, {true, 1, 3}});
  merged.keeps_all_sources = true;
  merged.provenance.covering_sets = {{}, {0}, {1}, {0, 1}};
  CHECK(join(merged) == Remains{1, 0});
  CHECK(merged.provenance.covering[0] == 3);
  CHECK(merged.provenance.covering_front[0] == 0);
  CHECK(merged.provenance.category[0] == FacetCategory::OnSame);

  // A third operand is all round them; the set behind is one there was not.
  MergedMesh within = stack_of({{true, 1, 2}, {false, 1, 3}});
  within.keeps_all_sources = true;
  within.provenance.covering_sets = {{}, {7}, {0, 7}, {1, 7}};
  CHECK(join(within) == Remains{1, 0});
  CHECK(within.provenance.covering_sets[within.provenance.covering[0]] == std::vector<std::uint32_t>{0, 7});
  CHECK(within.provenance.covering_sets[within.provenance.covering_front[0]] == std::vector<std::uint32_t>{1, 7});
}
