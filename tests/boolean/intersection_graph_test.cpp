// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Loops, open chains, isolated points and junctions of the graph in which operands meet, and the measure of their contact.
#include "mortise/boolean/intersection_graph.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "boolean/evaluation.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

struct GraphedScene : Evaluation {
  explicit GraphedScene(std::vector<SurfaceMesh> meshes, const std::vector<std::size_t>& self = {})
      : Evaluation(std::move(meshes), self),
        graph(build_intersection_graph(faces, map, facets, categories.patches)),
        contact(measure_contact(faces, facets, graph)) {}
  const IntersectionGraph graph;
  const ContactMeasure contact;
};

/// Which rule of a graph does not hold; empty when all do.
std::string fault_of(const IntersectionGraph& graph) {
  std::vector<std::size_t> degree(graph.points.size(), 0);
  for (const auto& [p, q] : graph.edges) {
    if (p >= q || q >= graph.points.size()) return "edge out of order";
    ++degree[p];
    ++degree[q];
  }
  if (!std::is_sorted(graph.edges.begin(), graph.edges.end())) return "edges not sorted";
  if (graph.chains.size() != graph.closed_loops + graph.open_chains) return "wrong number of chains";
  std::multiset<std::array<std::uint32_t, 2>> walked;
  for (std::size_t c = 0; c < graph.chains.size(); ++c) {
    const auto& chain = graph.chains[c];
    if (chain.size() < 2) return "chain without an edge";
    if ((chain.front() == chain.back()) != (c < graph.closed_loops)) return "loop and chain mixed up";
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) walked.insert({std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1])});
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      if (degree[chain[i]] != 2) return "chain through a junction or an end";
    }
    if (c >= graph.closed_loops && (degree[chain.front()] == 2 || degree[chain.back()] == 2)) return "chain that ends too early";
  }
  return walked == std::multiset<std::array<std::uint32_t, 2>>(graph.edges.begin(), graph.edges.end()) ? "" : "chains are not the edges";
}

struct Counts {
  std::size_t loops, chains, isolated;

  bool operator==(const Counts&) const = default;
};

Counts counts_of(const GraphedScene& scene) {
  CHECK(fault_of(scene.graph) == "");
  return {scene.graph.closed_loops, scene.graph.open_chains, static_cast<std::size_t>(scene.contact.points)};
}

/// A prism over two triangles that share a corner: their common edge goes up from z = -2 to 2.
SurfaceMesh bow_tie_prism() { return joined({prism({{{0, 0}, {2, -1}, {2, 1}}}, -2, 2), prism({{{0, 0}, {-2, 1}, {-2, -1}}}, -2, 2)}); }

double diagonal(double a, double b) { return std::sqrt(a * a + b * b); }

}  // namespace

TEST_CASE("graphs of the small scenes are chains of all their edges") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    CHECK(fault_of(GraphedScene(scene.operands).graph) == "");
  }
}

TEST_CASE("the example of the paper: a chain of edges, and a point without (Fig. 3)") {
  // One face through another gives a chain; the tip of a third part touches it in a point.
  const SurfaceMesh plate = make_mesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}});
  const SurfaceMesh other =
      joined({make_mesh({{1, 1, 1}, {4, 1, 1}, {2, 1, -1}}, {{0, 1, 2}}), make_mesh({{2, 4, 0}, {1, 4, 2}, {3, 4, 2}}, {{0, 1, 2}})});
  const GraphedScene scene({plate, other});
  CHECK(counts_of(scene) == Counts{0, 1, 1});
  CHECK(scene.graph.points.size() == 3);
}

TEST_CASE("a corner of a box in a box is one loop") {
  const GraphedScene scene({unit, moved(unit, {0.5, 0.5, 0.5})});
  CHECK(counts_of(scene) == Counts{1, 0, 0});
  CHECK(std::abs(scene.contact.length - 3) < 1e-12);  // six edges of half a unit
  CHECK(scene.contact.area == 0);
}

TEST_CASE("a bar through a box is two loops") {
  const GraphedScene scene({unit, box({0.25, 0.25, -1}, {0.75, 0.75, 2})});
  CHECK(counts_of(scene) == Counts{2, 0, 0});
  CHECK(scene.contact.length == 4);
}

TEST_CASE("a common face is a loop round it, with its area") {
  const GraphedScene scene({unit, moved(unit, {1, 0, 0})});
  CHECK(counts_of(scene) == Counts{1, 0, 0});
  CHECK((scene.contact.length == 4 && scene.contact.area == 1 && scene.contact.points == 0));
  // The diagonal inside the common face is no edge of the graph.
  CHECK(scene.graph.edges.size() == 4);
}

TEST_CASE("everything in common has no border, and the whole area") {
  const GraphedScene scene({unit, unit});
  CHECK(counts_of(scene) == Counts{0, 0, 0});
  CHECK(scene.graph.points.empty());
  CHECK(scene.contact.area == 6);
}

TEST_CASE("a common edge is an open chain, a common corner an isolated point") {
  const GraphedScene edge({unit, moved(unit, {1, 1, 0})});
  CHECK(counts_of(edge) == Counts{0, 1, 0});
  CHECK(edge.contact.length == 1);
  const GraphedScene corner({unit, moved(unit, {1, 1, 1})});
  CHECK(counts_of(corner) == Counts{0, 0, 1});
  CHECK((corner.graph.points == std::vector<Vec3d>{{1, 1, 1}} && corner.contact.length == 0));
}

TEST_CASE("contacts apart from each other are counted apart") {
  const SurfaceMesh corners = joined({moved(unit, {1, 1, 1}), moved(unit, {-1, -1, -1})});
  CHECK(counts_of(GraphedScene({unit, corners})) == Counts{0, 0, 2});
  const SurfaceMesh edges = joined({moved(unit, {1, 1, 0}), moved(unit, {-1, -1, 0})});
  CHECK(counts_of(GraphedScene({unit, edges})) == Counts{0, 2, 0});
}

TEST_CASE("a figure of eight is two loops through one junction") {
  const GraphedScene scene({bow_tie_prism(), box({-9, -9, -1}, {9, 9, 1})});
  // In each of the planes z = -1 and z = 1 two triangles that share a corner.
  CHECK(counts_of(scene) == Counts{4, 0, 0});
  std::vector<std::size_t> degree(scene.graph.points.size(), 0);
  for (const auto& edge : scene.graph.edges) {
    for (const std::uint32_t p : edge) ++degree[p];
  }
  CHECK(std::count(degree.begin(), degree.end(), 4U) == 2);
  for (const auto& chain : scene.graph.chains)
    CHECK((scene.graph.points[chain.front()].x == 0 && scene.graph.points[chain.front()].y == 0));
  CHECK(std::abs(scene.contact.length - 4 * (2 + 2 * diagonal(2, 1))) < 1e-12);
}

TEST_CASE("chains that meet in a junction end there") {
  // Three plates in one edge of the box: it stands on their common corner line... each plate gives a chain of its own.
  const SurfaceMesh plates =
      make_mesh({{0.5, 0.5, 1}, {0.9, 0.5, 1}, {0.1, 0.7, 1}, {0.2, 0.1, 1}, {0.5, 0.5, 2}}, {{0, 1, 4}, {0, 2, 4}, {0, 3, 4}});
  const GraphedScene scene({unit, plates});
  CHECK(counts_of(scene) == Counts{0, 3, 0});
}

TEST_CASE("lines of two pairs of operands are one graph") {
  // Three boxes round an edge: the common faces of the first with each other one share that edge.
  const GraphedScene scene({unit, moved(unit, {1, 0, 0}), moved(unit, {0, 1, 0})});
  CHECK(fault_of(scene.graph) == "");
  CHECK(scene.contact.area == 2);
  // Two squares with one common edge.
  CHECK(scene.contact.length == 7);
  CHECK((scene.graph.closed_loops == 0 && scene.graph.open_chains == 3));
}

TEST_CASE("what an operand has with itself is not in the graph") {
  const SurfaceMesh crossing = joined({unit, moved(unit, {0.5, 0.5, 0.5})});
  const GraphedScene alone({crossing}, {0});
  CHECK(counts_of(alone) == Counts{0, 0, 0});
  CHECK((alone.graph.points.empty() && alone.graph.edges.empty()));
  const SurfaceMesh pinched = joined({unit, moved(unit, {1, 1, 0})});
  CHECK(GraphedScene({pinched, moved(unit, {7, 0, 0})}).graph.points.empty());
}

TEST_CASE("operands apart, and one inside another, have no graph") {
  for (const Vec3d& offset : {Vec3d{3, 0, 0}, Vec3d{0.25, 0.25, 0.25}}) {
    const GraphedScene scene({unit, moved(scaled(unit, 0.5), offset)});
    CHECK(counts_of(scene) == Counts{0, 0, 0});
    CHECK((scene.contact.length == 0 && scene.contact.area == 0));
  }
}

TEST_CASE("the graph is the same for every order of operands, up to numbers") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const GraphedScene forward(scene.operands), backward({scene.operands.rbegin(), scene.operands.rend()});
    const auto edges = [](const IntersectionGraph& g) {
      std::set<std::set<std::array<double, 3>>> result;
      const auto position = [&](std::uint32_t p) { return std::array<double, 3>{g.points[p].x, g.points[p].y, g.points[p].z}; };
      for (const auto& e : g.edges) result.insert({position(e[0]), position(e[1])});
      return result;
    };
    CHECK(edges(forward.graph) == edges(backward.graph));
    CHECK(forward.graph.points.size() == backward.graph.points.size());
    CHECK(forward.graph.closed_loops == backward.graph.closed_loops);
    CHECK(forward.graph.open_chains == backward.graph.open_chains);
    CHECK(forward.contact.points == backward.contact.points);
  }
}

TEST_CASE("a torus through a plate is a loop inside a loop, each of the torus' sections") {
  const GraphedScene scene({box({-3, -3, -1}, {3, 3, 0.0625}), make_torus(1, 0.25, 24, 12)});
  CHECK(counts_of(scene) == Counts{2, 0, 0});
}
