// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Figs. 2f, 14 and 17b: the intersection graph as edges of both operands, one to one, and nothing else changed.
#include <algorithm>
#include <cstring>
#include <map>

#include "mortise/boolean/imprint.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/imprint_checks.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Two cylinders that cross at right angles.
std::vector<SurfaceMesh> crossing_cylinders() {
  const AffineMap centred = translation({0, 0, -2});
  return {transform(make_cylinder(1, 4, 48), centred), transform(transform(make_cylinder(0.6, 4, 48), centred), rotation(Axis::Y, 90))};
}

bool have_equal_bits(const Vec3d& a, const Vec3d& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// The vertex of an operand at a point of the graph, bit by bit.
std::uint32_t vertex_at(const SurfaceMesh& mesh, const Vec3d& p) {
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (have_equal_bits(mesh.points[v], p)) return v;
  }
  return Provenance::none;
}

/// The edges of the graph in the vertices of an operand, as common numbers, sorted; without those it does not have.
std::vector<Edge> graph_edges_of(const ImprintResult& result, std::size_t k) {
  const ImprintedOperand& operand = result.operands[k];
  std::map<Edge, int> faces;
  for (const Triangle& t : operand.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++faces[{std::min(t[i], t[(i + 1) % 3]).value, std::max(t[i], t[(i + 1) % 3]).value}];
  }
  std::vector<Edge> edges;
  for (const auto& [p, q] : result.whole.graph.edges) {
    const std::uint32_t u = vertex_at(operand.mesh, result.whole.graph.points[p]),
                        v = vertex_at(operand.mesh, result.whole.graph.points[q]);
    const auto at = faces.find({std::min(u, v), std::max(u, v)});
    if (at == faces.end() || at->second != 2) continue;
    edges.push_back({std::min(operand.vertex_ids[u], operand.vertex_ids[v]), std::max(operand.vertex_ids[u], operand.vertex_ids[v])});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

TEST_CASE("Fig. 14: the graph has the same edges on both operands, closed, in any order of operands and facets", "[paper]") {
  const std::vector<SurfaceMesh> pair = crossing_cylinders();
  const ImprintResult result = imprint(pair[0], pair[1]);
  const IntersectionGraph& graph = result.whole.graph;
  CHECK(graph.closed_loops == 2);
  CHECK(graph.open_chains == 0);
  const std::vector<Edge> on_a = graph_edges_of(result, 0);
  CHECK(on_a.size() == graph.edges.size());
  CHECK(on_a == graph_edges_of(result, 1));
  CHECK(on_a == shared_edges(result));
  std::map<std::uint32_t, int> degree;
  for (const Edge& e : on_a) ++degree[e[0]], ++degree[e[1]];
  CHECK(std::all_of(degree.begin(), degree.end(), [](const auto& d) { return d.second == 2; }));
  RandomSource random(14);
  for (int round = 0; round < 5; ++round) {
    const SurfaceMesh a = renumbered(pair[0], random), b = renumbered(pair[1], random);
    for (const ImprintResult& other : {imprint(a, b), imprint(b, a)}) {
      CHECK(other.whole.graph.edges.size() == graph.edges.size());
      CHECK(other.whole.graph.closed_loops == 2);
      CHECK(graph_edges_of(other, 0) == graph_edges_of(other, 1));
      CHECK(sorted_points(other.whole.mesh) == sorted_points(result.whole.mesh));
    }
  }
}

TEST_CASE("Fig. 2f: an imprint on a box keeps its volume, area and Euler characteristic", "[paper]") {
  const ImprintResult result = imprint(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
  for (const ImprintedOperand& operand : result.operands) {
    CHECK(exact_volume(operand.mesh) == 8);
    CHECK(shape_of(operand.mesh).area == 24);
    CHECK(euler_characteristic(operand.mesh) == 2);
    CHECK(operand.mesh.points.size() == 8 + 6);  // the corner of the other box is inside
  }
  CHECK(shared_edges(result).size() == 6);
  CHECK(result.whole.mesh.points.size() == 22);
}

TEST_CASE("Fig. 17b: imprinted cylinders have the area and the volume they had", "[paper]") {
  const std::vector<SurfaceMesh> pair = crossing_cylinders();
  const ImprintResult result = imprint(pair[0], pair[1]);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(exact_volume(result.operands[k].mesh) == Approx(exact_volume(pair[k])).epsilon(1e-14));
    CHECK(shape_of(result.operands[k].mesh).area == Approx(shape_of(pair[k]).area).epsilon(1e-14));
    CHECK(is_balanced(result.operands[k].mesh));
  }
  CHECK(shape_of(result.whole.mesh).area == Approx(shape_of(pair[0]).area + shape_of(pair[1]).area).epsilon(1e-14));
}
