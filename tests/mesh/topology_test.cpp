// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Edges, components, pinches and genus on meshes small enough to count by hand.
#include "mortise/mesh/topology.h"

#include <algorithm>

#include "mortise/mesh/shapes.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

std::optional<std::int64_t> genus(const SurfaceMesh& mesh) { return genus_of(mesh, build_topology(mesh)); }

/// Unit boxes at these corners as one mesh with shared vertices; faces between two of them stay, twice.
SurfaceMesh welded_boxes(const std::vector<Vec3d>& corners) {
  std::vector<SurfaceMesh> boxes;
  for (const Vec3d& corner : corners) boxes.push_back(test::box(corner, corner + Vec3d{1, 1, 1}));
  return weld(test::joined(boxes)).mesh;
}

}  // namespace

TEST_CASE("Edges are sorted and know the half-edges that use them", "[mesh][topology]") {
  /*  3---2
      | / |
      0---1  */
  const SurfaceMesh square = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const MeshTopology topology = build_topology(square);
  const std::vector<std::array<VertexId, 2>> expected{{VertexId(0), VertexId(1)},
                                                      {VertexId(0), VertexId(2)},
                                                      {VertexId(0), VertexId(3)},
                                                      {VertexId(1), VertexId(2)},
                                                      {VertexId(2), VertexId(3)}};
  CHECK(topology.edges == expected);
  const auto diagonal = topology.uses_of(MeshEdgeId(1));
  CHECK(std::vector<HalfEdge>(diagonal.begin(), diagonal.end()) == std::vector<HalfEdge>{2, 3});
  CHECK(topology.edge_of[0] == MeshEdgeId(0));
  CHECK(topology.edge_of[3] == MeshEdgeId(1));
  CHECK(balance_of(square, topology, MeshEdgeId(1)) == 0);
  CHECK(balance_of(square, topology, MeshEdgeId(2)) == -1);
  CHECK(find_boundary_edges(topology).size() == 4);
  CHECK(find_unbalanced_edges(square, topology).size() == 4);
  CHECK(find_inconsistent_edges(square, topology).empty());
}

TEST_CASE("Two faces that run the same way along an edge are inconsistent", "[mesh][topology]") {
  const SurfaceMesh square = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}});
  CHECK(find_inconsistent_edges(square, build_topology(square)) == std::vector<MeshEdgeId>{MeshEdgeId(1)});
}

TEST_CASE("A face that repeats a vertex has no edge there and does not change any balance", "[mesh][topology]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.triangles.push_back({VertexId(0), VertexId(0), VertexId(5)});
  const MeshTopology topology = build_topology(box);
  CHECK_FALSE(topology.edge_of[3 * 12].is_valid());
  CHECK(topology.edge_of[3 * 12 + 1].is_valid());
  CHECK(find_unbalanced_edges(box, topology).empty());
  CHECK(genus(box) == 0);
}

TEST_CASE("Components by vertex and by edge differ where bodies touch at a corner", "[mesh][topology]") {
  const SurfaceMesh corner = welded_boxes({{0, 0, 0}, {1, 1, 1}, {5, 5, 5}});
  CHECK(connect_by_vertices(corner).count == 2);
  const FaceComponents by_edges = connect_by_edges(corner, build_topology(corner));
  CHECK(by_edges.count == 3);
  CHECK(by_edges.component_of[0] == 0);
  CHECK(by_edges.component_of[12] == 1);
  CHECK(by_edges.component_of[35] == 2);
}

TEST_CASE("Boxes that touch at a corner come apart into two shells of genus 0", "[mesh][topology]") {
  const SurfaceMesh corner = welded_boxes({{0, 0, 0}, {1, 1, 1}});
  const MeshTopology topology = build_topology(corner);
  CHECK(find_non_manifold_edges(topology).empty());
  REQUIRE(find_non_manifold_vertices(corner, topology).size() == 1);
  const SplitPinches split = split_pinches(corner, topology);
  CHECK(split.mesh.points.size() == 16);
  CHECK(split.shells.count == 2);
  CHECK(std::is_sorted(split.source.begin(), split.source.end()));
  CHECK(test::euler_characteristic(split.mesh) == 4);
  CHECK(genus(corner) == 0);
}

TEST_CASE("Boxes that touch along an edge come apart, whatever their place round it", "[mesh][topology]") {
  for (const Vec3d& other : {Vec3d{1, 1, 0}, Vec3d{1, -1, 0}, Vec3d{-1, 0, 1}, Vec3d{0, 1, 1}, Vec3d{0, -1, -1}}) {
    const SurfaceMesh edge = welded_boxes({{0, 0, 0}, other});
    const MeshTopology topology = build_topology(edge);
    CHECK(find_non_manifold_edges(topology).size() == 1);
    CHECK(find_non_manifold_vertices(edge, topology).empty());
    const SplitPinches split = split_pinches(edge, topology);
    CHECK(split.shells.count == 2);
    CHECK(split.mesh.points.size() == 16);
    CHECK(test::is_balanced(split.mesh));
    CHECK(find_non_manifold_edges(build_topology(split.mesh)).empty());
    CHECK(genus(edge) == 0);
  }
}

TEST_CASE("Wedges round one edge are paired by the inside between them", "[mesh][topology]") {
  // three tetrahedra on the edge from (0,0,0) to (0,0,1), in three sectors
  const Vec3d low{0, 0, 0};
  const Vec3d high{0, 0, 1};
  const SurfaceMesh wedges =
      weld(test::joined({test::tetrahedron(low, high, {1, 0, 0}, {1, 1, 0}), test::tetrahedron(low, high, {-1, 1, 0}, {-1, 0, 0}),
                         test::tetrahedron(low, high, {-1, -3, 0}, {1, -2, 0})}))
          .mesh;
  const MeshTopology topology = build_topology(wedges);
  REQUIRE(find_non_manifold_edges(topology).size() == 1);
  const SplitPinches split = split_pinches(wedges, topology);
  CHECK(split.shells.count == 3);
  for (std::size_t f = 0; f < 12; ++f) CHECK(split.shells.component_of[f] == f / 4);
  CHECK(genus(wedges) == 0);
}

TEST_CASE("Coincident walls of touching boxes are paired, so that each keeps its own", "[mesh][topology]") {
  const SurfaceMesh wall = welded_boxes({{0, 0, 0}, {1, 0, 0}});
  CHECK(find_unbalanced_edges(wall, build_topology(wall)).empty());
  const SplitPinches split = split_pinches(wall, build_topology(wall));
  CHECK(find_non_manifold_edges(build_topology(split.mesh)).empty());
  CHECK(test::is_balanced(split.mesh));
}

TEST_CASE("Genus adds over shells and is nothing when open", "[mesh][topology]") {
  const SurfaceMesh torus = make_torus(3, 1, 12, 8);
  CHECK(genus(torus) == 1);
  CHECK(genus(test::joined({torus, test::moved(torus, {10, 0, 0}), test::box({0, 0, 20}, {1, 1, 21})})) == 2);
  SurfaceMesh open = torus;
  open.triangles.pop_back();
  CHECK_FALSE(genus(open));
  CHECK(genus(SurfaceMesh{}) == 0);
}

TEST_CASE("A ring of boxes joined at edges only is shells, not a hole", "[mesh][topology]") {
  /* seen along z   # . #      the four boxes touch the middle one at edges
                    . # .
                    # . #  */
  const SurfaceMesh cross = welded_boxes({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {2, 2, 0}});
  const MeshTopology topology = build_topology(cross);
  CHECK(find_non_manifold_edges(topology).size() == 4);
  CHECK(split_pinches(cross, topology).shells.count == 5);
  CHECK(genus(cross) == 0);
}

TEST_CASE("An open book of three sheets stays joined in pairs at most", "[mesh][topology]") {
  const SurfaceMesh book = test::make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const SplitPinches split = split_pinches(book, build_topology(book));
  CHECK(split.shells.count == 2);
  CHECK(find_non_manifold_edges(build_topology(split.mesh)).empty());
}

}  // namespace mortise
