// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Welding merges equal positions and nothing else.
#include "mortise/mesh/weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {

TEST_CASE("Equal positions become one vertex, in order of first appearance", "[mesh][weld]") {
  const SurfaceMesh soup = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const WeldedMesh welded = weld(soup);
  CHECK(test::has_same_bits(welded.mesh, test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}})));
  const std::vector<VertexId> expected{VertexId(0), VertexId(1), VertexId(2), VertexId(1), VertexId(3), VertexId(2)};
  CHECK(welded.new_vertex == expected);
  const std::vector<VertexId> first{VertexId(0), VertexId(1), VertexId(2), VertexId(4)};
  CHECK(welded.old_vertex == first);
}

TEST_CASE("-0 equals +0 and the first one's bits are kept", "[mesh][weld]") {
  const WeldedMesh welded = weld(test::make_mesh({{-0.0, 0, 1}, {0.0, -0.0, 1}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 3}, {1, 2, 3}}));
  REQUIRE(welded.mesh.points.size() == 3);
  CHECK(std::signbit(welded.mesh.points[0].x));
  CHECK_FALSE(std::signbit(welded.mesh.points[0].y));
}

TEST_CASE("Neighbouring doubles stay apart", "[mesh][weld]") {
  const double next = std::nextafter(1.0, 2.0);
  CHECK(weld(test::make_mesh({{1, 1, 1}, {next, 1, 1}, {1, 1, next}}, {{0, 1, 2}})).mesh.points.size() == 3);
}

TEST_CASE("Faces keep order and labels, those that fall together too, and unused vertices stay", "[mesh][weld]") {
  SurfaceMesh mesh = test::make_mesh({{0, 0, 0}, {0, 0, 0}, {5, 5, 5}, {1, 0, 0}}, {{0, 1, 3}, {0, 3, 1}});
  mesh.face_labels = {1, 0};
  mesh.label_names = {"a", "b"};
  const WeldedMesh welded = weld(mesh);
  CHECK(welded.mesh.triangles == std::vector<Triangle>{{VertexId(0), VertexId(0), VertexId(2)}, {VertexId(0), VertexId(2), VertexId(0)}});
  CHECK(welded.mesh.face_labels == mesh.face_labels);
  CHECK(welded.mesh.label_names == mesh.label_names);
  CHECK(welded.mesh.points[1] == Vec3d{5, 5, 5});
}

TEST_CASE("Random points agree with a sorted map", "[mesh][weld]") {
  const unsigned seed = 5;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  SurfaceMesh mesh;
  for (int i = 0; i < 5000; ++i) {
    const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() % 9) - 4, static_cast<int>(random() % 3) * 100); };
    mesh.points.push_back({coordinate(), coordinate(), coordinate()});
  }
  const WeldedMesh welded = weld(mesh);
  std::map<std::tuple<double, double, double>, VertexId> known;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3d& p = mesh.points[v];
    const auto [entry, is_new] = known.try_emplace({p.x, p.y, p.z}, VertexId(known.size()));
    REQUIRE(welded.new_vertex[v] == entry->second);
  }
  CHECK(welded.mesh.points.size() == known.size());
}

TEST_CASE("An empty mesh stays empty", "[mesh][weld]") { CHECK(weld(SurfaceMesh{}).mesh.points.empty()); }

}  // namespace mortise
