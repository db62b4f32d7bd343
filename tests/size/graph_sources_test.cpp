// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Chains of intersection graphs, each with its own spacing.
#include "mortise/size/graph_sources.h"

#include "mortise/base/error.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/result_features.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_source.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Edges = std::vector<std::array<VertexId, 2>>;

Edges edges_of(std::initializer_list<std::array<std::size_t, 2>> pairs) {
  Edges edges;
  for (const auto& [a, b] : pairs) edges.push_back({VertexId(a), VertexId(b)});
  return edges;
}

std::vector<double> sizes_of(const std::vector<SizeSource>& sources) {
  std::vector<double> sizes;
  for (const SizeSource& s : sources) sizes.push_back(s.strengths[0]);
  return sizes;
}

}  // namespace

TEST_CASE("every chain has its own spacing, between vertices where not two edges meet", "[size]") {
  // Three chains meet at vertex 0: edges of length 1 and 3; one of length 5; a loop of 1, 1 and 4 that comes back.
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {-5, 0, 0}, {0, 1, 0}, {0, 1, 1}, {9, 9, 9}};
  mesh.points[5] = {0, 2, 0};
  const Edges edges = edges_of({{0, 1}, {1, 2}, {3, 0}, {0, 4}, {4, 5}, {5, 0}});
  const std::vector<SizeSource> sources = sources_of_graph(mesh.points, edges, 1.5);
  // By ends: 01, 03, 04, 05, 12, 45; the loop is (1 + 1 + 2) / 3 long on average.
  CHECK(sizes_of(sources) == std::vector<double>{2, 5, 4. / 3, 4. / 3, 2, 4. / 3});
  CHECK(sources[1].corners[0] == mesh.points[0]);
  CHECK(sources[1].corners[1] == mesh.points[3]);
  for (const SizeSource& s : sources) CHECK((s.corner_count == 2 && s.order == StrengthOrder::Constant && s.growth == 1.5));
}

TEST_CASE("sources of a graph do not depend on the order or sense of its edges, or on repeated ones", "[size]") {
  const BooleanResult result = evaluate_boolean(
      Operation::Union, pointers_to({make_box({0, 0, 0}, {2, 2, 2}), make_icosphere(1, 3), make_box({1, -1, -1}, {3, 3, 0.3})}));
  Edges edges = find_graph_edges(result.mesh, result.provenance);
  REQUIRE(edges.size() > 40);
  const std::vector<SizeSource> sources = sources_of_graph(result.mesh.points, edges, 1.2);
  RandomSource random(7);
  for (int round = 0; round < 5; ++round) {
    random.shuffle(edges);
    for (auto& [a, b] : edges) {
      if (random.once_in(2)) std::swap(a, b);
    }
    edges.push_back(edges[random.below(edges.size())]);
    const std::vector<SizeSource> again = sources_of_graph(result.mesh.points, edges, 1.2);
    REQUIRE(again.size() == sources.size());
    CHECK(sizes_of(again) == sizes_of(sources));
    for (std::size_t i = 0; i < sources.size(); ++i) CHECK(again[i].corners == sources[i].corners);
  }
}

TEST_CASE("where two boxes meet, all six edges of the loop have the spacing of a regular hexagon", "[size]") {
  // Six edges of length 1 (Fig. 2).
  const BooleanResult result =
      evaluate_boolean(Operation::Union, pointers_to({make_box({0, 0, 0}, {2, 2, 2}), make_box({1, 1, 1}, {3, 3, 3})}));
  const Edges edges = find_graph_edges(result.mesh, result.provenance);
  double length = 0;
  for (const SizeSource& s : sources_of_graph(result.mesh.points, edges, 1.2)) {
    CHECK(s.strengths[0] == Approx(6. / static_cast<double>(edges.size())).epsilon(1e-15));
    length += s.strengths[0];
  }
  CHECK(length == Approx(6));
}

TEST_CASE("a graph may be empty or without length, but not of points that are not there", "[size]") {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 0}};
  CHECK(sources_of_graph(mesh.points, {}, 1.2).empty());
  CHECK(sources_of_graph(mesh.points, edges_of({{0, 1}}), 1.2).empty());
  try {
    (void)sources_of_graph(mesh.points, edges_of({{0, 1}, {2, 0}}), 1.2);
    FAIL("taken");
  } catch (const Error& error) {
    CHECK(error.message == "an edge ends at a point that is not there");
    CHECK(error.id_kind == IdKind::VertexPairs);
    CHECK(error.ids == std::vector<std::uint32_t>{2, 0});
  }
}
