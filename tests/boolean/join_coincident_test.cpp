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
    p.source_operand.push_back(i);
    p.source_face.push_back(10 + i);
    p.other_source_begin.push_back(0);
  }
  p.other_source_begin.push_back(0);
  return merged;
}

using Remains = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE("two triangles that bound a vanished region become one, with both sources", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {true, 1, 2}});
  CHECK(join_coincident(merged) == Remains{1, 0});
  CHECK(merged.provenance.covering_front[0] == 0);
  CHECK(merged.provenance.covering[0] == 2);
  CHECK(merged.provenance.other_source_begin == std::vector<std::uint32_t>{0, 1, 1});
  CHECK(merged.provenance.other_source_operand == std::vector<std::uint32_t>{1});
  CHECK(merged.provenance.other_source_face == std::vector<std::uint32_t>{11});
}

TEST_CASE("the spaces are taken on the side where they are, however the triangles run and are ordered", "[join_coincident]") {
  MergedMesh turned = stack_of({{false, 2, 1}, {true, 0, 1}});
  CHECK(join_coincident(turned) == Remains{1, 0});
  CHECK(turned.provenance.covering_front[0] == 2);
  CHECK(turned.provenance.covering[0] == 0);
  MergedMesh three = stack_of({{true, 1, 2}, {true, 2, 3}, {false, 1, 0}});
  CHECK(join_coincident(three) == Remains{1, 0, 0});
  CHECK(three.provenance.covering_front[0] == 0);
  CHECK(three.provenance.covering[0] == 3);
}

TEST_CASE("triangles with the same space on their far sides go", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {false, 0, 1}});
  CHECK(join_coincident(merged) == Remains{0, 0});
}

TEST_CASE("a triangle on its own stays, one with a corner twice goes", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 0, 1}, {true, 0, 1}});
  merged.mesh.triangles[1][0] = merged.mesh.triangles[1][1];
  CHECK(join_coincident(merged) == Remains{1, 0});
  CHECK(merged.provenance.covering[0] == 1);
}

TEST_CASE("a triangle on its own stays with the same operands on both sides", "[join_coincident]") {
  MergedMesh merged = stack_of({{true, 1, 1}});
  CHECK(join_coincident(merged) == Remains{1});
}
