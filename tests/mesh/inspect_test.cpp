// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a report says about small meshes whose answers are known.
#include "mortise/mesh/inspect.h"

#include <limits>

#include "mortise/mesh/shapes.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {

TEST_CASE("A box is closed, oriented, manifold, of genus 0", "[mesh][inspect]") {
  const MeshReport report = inspect(test::box({1, 2, 3}, {2, 4, 6}));
  CHECK(report.vertices == 8);
  CHECK(report.triangles == 12);
  CHECK((report.closed && report.oriented && report.manifold));
  CHECK(report.components == 1);
  CHECK(report.shells == 1);
  CHECK(report.genus == 0);
  CHECK(report.volume == 6);
  CHECK(report.area == 22);
  CHECK(report.bbox.hi == Vec3d{2, 4, 6});
  CHECK(report.max_angle_deg == 90);
  CHECK(report.self_intersections == 0);
  CHECK(report.duplicate_faces == 0);
}

TEST_CASE("Without pairs only what comes from comparing them is left out", "[mesh][inspect]") {
  const SurfaceMesh crossing = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({0.5, 0.25, 0.125}, {2, 2, 2})});
  const MeshReport full = inspect(crossing), brief = inspect_without_pairs(crossing);
  CHECK(full.self_intersections > 0);
  CHECK(brief.self_intersections == 0);
  CHECK(brief.volume == full.volume);
  CHECK(brief.genus == full.genus);
  CHECK(brief.components == full.components);
  CHECK(brief.max_angle_deg == full.max_angle_deg);
  CHECK(brief.triangles == 24);
}

TEST_CASE("A sheet is open, without genus and volume", "[mesh][inspect]") {
  const MeshReport report = inspect(make_grid_sheet(2, 3, 2, 3));
  CHECK_FALSE(report.closed);
  CHECK((report.oriented && report.manifold));
  CHECK(report.boundary_edges == 10);
  CHECK_FALSE(report.genus);
  CHECK_FALSE(report.volume);
  CHECK(report.area == 6);
}

TEST_CASE("Boxes that share an edge are closed but not manifold: one component, two shells", "[mesh][inspect]") {
  const MeshReport report = inspect(weld(test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})})).mesh);
  CHECK(report.closed);
  CHECK_FALSE(report.manifold);
  CHECK(report.non_manifold_edges == 1);
  CHECK(report.non_manifold_vertices == 0);
  CHECK(report.components == 1);
  CHECK(report.shells == 2);
  CHECK(report.genus == 0);
  CHECK(report.volume == 2);
  CHECK(report.self_intersections == 0);
}

TEST_CASE("A pinched vertex alone makes a mesh non-manifold", "[mesh][inspect]") {
  const MeshReport report = inspect(weld(test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 1}, {2, 2, 2})})).mesh);
  CHECK(report.closed);
  CHECK_FALSE(report.manifold);
  CHECK(report.non_manifold_edges == 0);
  CHECK(report.non_manifold_vertices == 1);
  CHECK(report.shells == 2);
}

TEST_CASE("Faults are counted: flipped, duplicate and degenerate faces, crossings", "[mesh][inspect]") {
  SurfaceMesh flipped = test::box({0, 0, 0}, {1, 1, 1});
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  const MeshReport flipped_report = inspect(flipped);
  CHECK_FALSE(flipped_report.closed);
  CHECK_FALSE(flipped_report.oriented);
  CHECK(flipped_report.boundary_edges == 0);

  SurfaceMesh spoiled = test::box({0, 0, 0}, {1, 1, 1});
  const Triangle t = spoiled.triangles[0];
  spoiled.triangles.push_back({t[1], t[2], t[0]});
  spoiled.triangles.push_back({t[0], t[2], t[1]});
  spoiled.triangles.push_back({t[0], t[0], t[1]});
  const MeshReport spoiled_report = inspect(spoiled);
  CHECK(spoiled_report.duplicate_faces == 2);
  CHECK(spoiled_report.degenerate_faces == 1);
  CHECK(spoiled_report.overlapping_pairs == 3);
  CHECK(spoiled_report.min_angle_deg == 0);
  CHECK(spoiled_report.closed);

  const MeshReport crossing = inspect(test::joined({test::box({0, 0, 0}, {2, 2, 2}), test::box({0.5, 0.5, 1}, {1, 1, 3})}));
  CHECK(crossing.crossing_pairs > 0);
  CHECK(crossing.self_intersections == crossing.crossing_pairs + crossing.touching_pairs + crossing.overlapping_pairs);
  CHECK(crossing.components == 2);
}

TEST_CASE("An empty mesh is closed and measures nothing", "[mesh][inspect]") {
  const MeshReport report = inspect(SurfaceMesh{});
  CHECK((report.closed && report.oriented && report.manifold));
  CHECK(report.genus == 0);
  CHECK(report.volume == 0);
  CHECK(report.bbox.is_empty());
}

TEST_CASE("A mesh validate refuses is not described", "[mesh][inspect]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.points[0].x = std::numeric_limits<double>::quiet_NaN();
  const auto error = test::error_of([&] { (void)inspect(box); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotFinite);
}

}  // namespace mortise
