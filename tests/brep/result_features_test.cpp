// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Edges of results on the intersection graph, against the graph the operation gave.
#include "mortise/brep/result_features.h"

#include <cmath>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/geom/length.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

double length_of(const SurfaceMesh& mesh, const std::vector<std::array<VertexId, 2>>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += length(mesh.points[b.index()] - mesh.points[a.index()]);
  return sum;
}

}  // namespace

TEST_CASE("the edges of a result where operands meet are those of the graph, for random solids", "[brep]") {
  const std::size_t pairs = scaled_count(80, 2000);
  std::size_t compared = 0;
  for (std::size_t seed = 1; seed <= pairs; ++seed) {
    INFO("seed " << seed);
    const std::vector<SurfaceMesh> solids = RandomSolids(seed).next(2);
    for (const Operation operation : {Operation::Union, Operation::Partition}) {
      const BooleanResult result = evaluate_boolean(operation, pointers_to(solids));
      if (result.report.certificate.repair_displacement != 0) continue;
      const double expected = result.report.contact.length,
                   found = length_of(result.mesh, find_graph_edges(result.mesh, result.provenance));
      CHECK(found <= expected + 1e-12 * (1 + expected));
      if (operation == Operation::Partition) CHECK(found >= expected - 1e-12 * (1 + expected));
      compared += expected > 0 ? 1 : 0;
    }
  }
  CHECK(compared * 5 >= pairs);
}

TEST_CASE("faces that join smoothly are parted at the graph, or by their operands, when asked to", "[brep]") {
  // Two boxes side by side: six faces, four of them made of both.
  const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
  const BooleanResult result = evaluate_boolean(Operation::Union, pointers_to(boxes));
  CHECK(build_brep(result.mesh).brep.faces.size() == 6);
  BrepRules at_graph;
  at_graph.features.user_edges = find_graph_edges(result.mesh, result.provenance);
  CHECK(at_graph.features.user_edges.size() == 4);
  CHECK(build_brep(result.mesh, at_graph).brep.faces.size() == 10);
  BrepRules by_operand;
  by_operand.features.groups = group_by_operands(result.provenance);
  CHECK(build_brep(result.mesh, by_operand).brep.faces.size() == 10);
  CHECK_THROWS_AS(find_graph_edges(result.mesh, {}), Error);
}
