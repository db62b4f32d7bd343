// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Marks of meshes small enough to work them out by hand, and of a remeshed result.
#include "mortise/remesh/quality_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mortise/base/error.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/remesh/deviation.h"
#include "mortise/remesh/quality_table.h"
#include "mortise/remesh/remesh.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const double root_of_3 = std::sqrt(3.0);

ClassifiedBrep model_of(const SurfaceMesh& mesh) {
  BrepRules rules;
  rules.seams = Seams::None;
  return build_brep(mesh, rules);
}

QualityReport quality_of(const SurfaceMesh& mesh, double size) {
  return measure_quality(mesh, model_of(mesh), SizingProxy({}, {.global = size}));
}

// Two equilateral triangles of edge 1: a rhombus of angles 60 and 120.
SurfaceMesh rhombus() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, root_of_3 / 2, 0}, {1.5, root_of_3 / 2, 0}}, {{0, 1, 2}, {1, 3, 2}});
}

SurfaceMesh lifted(SurfaceMesh mesh, double z) {
  for (Vec3d& p : mesh.points) p.z += z;
  return mesh;
}

// The unit cube, every side of n by n cells.
SurfaceMesh cube_of_cells(std::uint32_t n) {
  std::vector<SurfaceMesh> sides;
  const SurfaceMesh sheet = make_grid_sheet(1, 1, n, n);
  for (int k = 0; k < 3; ++k) {
    SurfaceMesh top = lifted(sheet, 1), bottom = inside_out(sheet);
    for (int turn = 0; turn < k; ++turn) {
      top = with_axes_turned(top);
      bottom = with_axes_turned(bottom);
    }
    sides.insert(sides.end(), {top, bottom});
  }
  const SurfaceMesh soup = joined(sides);
  SurfaceMesh cube;
  for (const Triangle& t : soup.triangles) {
    Triangle& corners = cube.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& p = soup.points[t[k].index()];
      const auto at = std::find(cube.points.begin(), cube.points.end(), p);
      corners[k] = VertexId(static_cast<std::size_t>(at - cube.points.begin()));
      if (at == cube.points.end()) cube.points.push_back(p);
    }
  }
  return cube;
}

std::size_t count_of(const std::array<std::size_t, 13>& valences) {
  return std::accumulate(valences.begin(), valences.end(), std::size_t{0});
}

}  // namespace

TEST_CASE("two equilateral triangles of the size have the best marks there are", "[remesh]") {
  const QualityReport q = quality_of(rhombus(), 1);
  CHECK(q.all.count == 2);
  CHECK(q.free.count == 2);
  CHECK(q.all.least_angle_deg == Approx(60));
  CHECK(q.all.greatest_angle_deg == Approx(60));
  CHECK(q.all.median_angle_deg == Approx(60));
  CHECK(q.all.below_30 == 0);
  CHECK(q.all.least_radius_ratio == Approx(1));
  CHECK(q.all.mean_edge_ratio == Approx(1));
  CHECK(q.all.greatest_growth == Approx(1));
  CHECK(q.edges.count == 5);
  CHECK(q.edges.mean == Approx(1));
  CHECK(q.edges.in_band == 1);
  CHECK(q.edges.bins[4] == 5);
  CHECK(count_of(q.valences) == 0);
  CHECK(q.folds == 0);
}

TEST_CASE("a sliver has the marks of its sides 3, 4 and 6.9", "[remesh]") {
  // Corners (0, 0), (6.9, 0) and the apex at x = (9 - 16 + 47.61) / 13.8 over the longest side; sides 3 and 4 at the apex.
  const double x = (9 - 16 + 47.61) / 13.8, y = std::sqrt(9 - x * x);
  const SurfaceMesh sliver = make_mesh({{0, 0, 0}, {6.9, 0, 0}, {x, y, 0}}, {{0, 1, 2}});
  const QualityReport q = quality_of(sliver, 5);
  const double s = 13.9 / 2, area = std::sqrt(s * (s - 3) * (s - 4) * (s - 6.9)), pi = std::acos(-1.0);
  CHECK(q.all.least_angle_deg == Approx(std::asin(2 * area / (4 * 6.9)) * 180 / pi));
  CHECK(q.all.greatest_angle_deg == Approx(180 - std::asin(2 * area / 12) * 180 / pi));
  CHECK(q.all.below_30 == 1);
  CHECK(q.all.above_115 == 1);
  CHECK(q.all.least_radius_ratio == Approx(2 * (area / s) / (3 * 4 * 6.9 / (4 * area))));
  CHECK(q.all.greatest_edge_ratio == Approx(2.3));
  CHECK(q.edges.least == Approx(0.6));
  CHECK(q.edges.greatest == Approx(1.38));
  CHECK(q.edges.mean == Approx(13.9 / 15));
  CHECK(q.edges.in_band == Approx(2.0 / 3));
  CHECK(q.edges.bins == std::array<std::size_t, 9>{0, 1, 0, 1, 0, 0, 1, 0, 0});
  CHECK(q.free.count == 0);
  CHECK(q.obstacles.short_edges == 0);  // the sides of 3 and 4 turn by 20 degrees only: one model edge
  CHECK(q.obstacles.sharp_corners == 2);
  CHECK(q.free_edges.count == 0);
}

TEST_CASE("half squares on a cube have angles of 45 and 90 degrees and six edges inside its sides", "[remesh]") {
  const SurfaceMesh cube = cube_of_cells(4);
  const QualityReport q = quality_of(cube, 0.25);
  CHECK(q.all.count == 192);
  CHECK(q.all.least_angle_deg == Approx(45));
  CHECK(q.all.greatest_angle_deg == Approx(90));
  CHECK(q.all.mean_radius_ratio == Approx(2 * (std::sqrt(2.0) - 1)));
  CHECK(q.all.greatest_edge_ratio == Approx(std::sqrt(2.0)));
  CHECK(q.all.greatest_growth == Approx(1));
  CHECK(q.edges.count == 288);
  CHECK(q.edges.mean == Approx((2 + std::sqrt(2.0)) / 3));
  CHECK(q.edges.greatest_growth == Approx(1));
  CHECK(count_of(q.valences) == 54);
  CHECK(q.valences[6] + q.valences[8] + q.valences[4] == 54);
  CHECK(q.free.count == 192);
  CHECK(q.obstacles.close_features == 0);
}

TEST_CASE("valences are those of vertices inside faces", "[remesh]") {
  // A fan of five about the middle of a pentagon.
  SurfaceMesh fan;
  fan.points = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {0, -2, 0}};
  for (std::size_t k = 1; k <= 5; ++k) fan.triangles.push_back({VertexId(0), VertexId(k), VertexId(k % 5 + 1)});
  const QualityReport q = quality_of(fan, 2);
  CHECK(q.valences[5] == 1);
  CHECK(count_of(q.valences) == 1);
}

TEST_CASE("growth is told across edges and along model edges", "[remesh]") {
  // Right triangles with legs 1 and 1, 2 and 1: areas 1/2 and 1; the bottom goes on from 1 to 2.
  const SurfaceMesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}});
  const QualityReport q = quality_of(mesh, 1);
  CHECK(q.all.greatest_growth == Approx(std::sqrt(2.0)));
  CHECK(q.edges.greatest_growth == Approx(2));
}

TEST_CASE("lengths in sizes that vary are integrals along the edge", "[remesh]") {
  // Sizes 1 + x / 2 from a point at the origin: the integral from 0 to 1 is 2 ln 1.5 = 0.81093; by Simpson (1 + 3.2 + 2 / 3) / 6.
  const SurfaceMesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}}, {{0, 1, 2}});
  const SizingProxy sizes(std::vector{point_source({0, 0, 0}, 1, 1.5)}, {.global = 100});
  const QualityReport q = measure_quality(mesh, model_of(mesh), sizes);
  CHECK(q.edges.least <= (1 + 3.2 + 2.0 / 3) / 6 + 1e-12);
  CHECK(q.edges.greatest < 1);
  CHECK(std::fabs(q.edges.greatest - 2 * std::log(1.5)) < 0.03);
}

TEST_CASE("folds are edges inside faces where a triangle lies on its neighbour", "[remesh]") {
  SurfaceMesh folded = make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.9, 0}}, {{0, 1, 2}, {1, 0, 3}});
  BrepRules rules;
  rules.features.face_angle_deg = 180;
  const ClassifiedBrep model = build_brep(folded, rules);
  CHECK(measure_quality(folded, model, SizingProxy({}, {.global = 1})).folds == 1);
  folded.points[3].y = -0.9;
  CHECK(measure_quality(folded, model, SizingProxy({}, {.global = 1})).folds == 0);
}

TEST_CASE("triangles near a sharp corner are not free, others are", "[remesh]") {
  // A right triangle of legs 10 and 4: 21.8, 68.2 and 90 degrees.
  const SurfaceMesh wedge = make_mesh({{0, 0, 0}, {10, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  const ClassifiedBrep coarse = model_of(wedge);
  const SizingProxy sizes({}, {.global = 0.5});
  const RemeshResult fine = remesh(wedge, coarse, measure_normals(wedge, build_topology(wedge)), sizes);
  const QualityReport q = measure_quality(fine.mesh, {coarse.brep, fine.classification}, sizes);
  CHECK(q.obstacles.sharp_corners == 1);
  CHECK(q.obstacles.close_features > 0);
  CHECK(q.obstacles.short_edges == 0);
  CHECK(q.free.count > 0);
  // The sides are closer than the size up to 0.5 / tan 21.8 = 1.25 from the tip, and what is not free ends 0.5 later.
  const double near = 0.5 * 0.4 * (1.75 + 0.5) * (1.75 + 0.5);
  CHECK(static_cast<double>(q.all.count - q.free.count) < near * 2.31 / 0.25 + 4);
  CHECK(q.free.least_angle_deg > 30);
}

TEST_CASE("features of one face closer than the size keep triangles from being free", "[remesh]") {
  const SurfaceMesh strip = make_grid_sheet(10, 0.9, 10, 1), wide = make_grid_sheet(10, 1.1, 10, 1);
  CHECK(quality_of(strip, 1).free.count == 0);
  CHECK(quality_of(strip, 1).obstacles.close_features > 0);
  CHECK(quality_of(strip, 1).obstacles.short_edges == 0);
  CHECK(quality_of(wide, 1).free.count == 20);
  CHECK(quality_of(wide, 1).obstacles.close_features == 0);
}

TEST_CASE("short and frozen model edges keep triangles within the size from being free", "[remesh]") {
  const SurfaceMesh sheet = make_grid_sheet(8, 8, 8, 8);
  const ClassifiedBrep model = model_of(sheet);
  const SizingProxy sizes({}, {.global = 1});
  REQUIRE(model.brep.edges.size() == 4);
  CHECK(measure_quality(sheet, model, sizes).free.count == 128);
  const QualityReport q = measure_quality(sheet, model, sizes, {1, 0, 0, 0});
  CHECK(q.obstacles.frozen_edges == 1);
  // Vertices of two rows of nine are within 1 of the edge: the triangles of two rows of cells touch them.
  CHECK(q.all.count - q.free.count == 32);
  const SizingProxy huge({}, {.global = 12});
  CHECK(measure_quality(sheet, model, huge).obstacles.short_edges == 4);
}

TEST_CASE("a closed model edge is short when it is below 0.7 of three sizes", "[remesh]") {
  const SurfaceMesh tube = make_cylinder(1, 20, 12);  // rims of 24 sin 15 degrees = 6.21
  CHECK(quality_of(tube, 2.9).obstacles.short_edges == 0);
  CHECK(quality_of(tube, 3).obstacles.short_edges == 2);
}

TEST_CASE("a plane moved along its normal is that far away, both ways", "[remesh]") {
  const SurfaceMesh one = make_grid_sheet(4, 4, 4, 4), other = lifted(make_grid_sheet(4, 4, 7, 3), 0.25);
  const ClassifiedBrep model = model_of(one), model_of_other = model_of(other);
  const SizingProxy sizes({}, {.global = 0.5});
  for (const Matching matching : {Matching::None, Matching::Faces, Matching::Entities}) {
    const Deviation d = measure_deviation(one, model, other, model_of_other, sizes, matching);
    for (const OneWayDistance& way : {d.to_reference, d.from_reference, d.curves_to_reference, d.curves_from_reference}) {
      CHECK(way.greatest == Approx(0.25));
      CHECK(way.in_sizes == Approx(0.5));
    }
    CHECK(d.of_faces.size() == (matching == Matching::None ? 0U : 1U));
  }
}

TEST_CASE("one-sided distances differ where one surface has more than the other", "[remesh]") {
  const SurfaceMesh half = make_grid_sheet(2, 2, 4, 4), whole = make_grid_sheet(5, 2, 10, 4);
  const SizingProxy sizes({}, {.global = 1});
  const Deviation d = measure_deviation(half, model_of(half), whole, model_of(whole), sizes, Matching::Faces);
  CHECK(d.to_reference.greatest < 1e-15);
  CHECK(d.from_reference.greatest == Approx(3));
  CHECK(d.from_reference.at.x == 5);
  CHECK(d.of_faces[0][1] == Approx(3));
  CHECK(d.curves_from_reference.greatest == Approx(3));
  CHECK(d.curves_to_reference.greatest == Approx(1));  // the side across the middle
}

TEST_CASE("model faces are measured against those of their number", "[remesh]") {
  // On a box of height 0.1, a point on the top is 0.1 from the bottom; with the numbers of the faces exchanged that shows.
  const SurfaceMesh flat = make_box({0, 0, 0}, {1, 1, 0.1});
  const ClassifiedBrep model = model_of(flat);
  ClassifiedBrep exchanged = model;
  const auto side_at = [&](double z) {
    for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
      const Triangle& c = flat.triangles[t];
      if (std::all_of(c.begin(), c.end(), [&](VertexId v) { return flat.points[v.index()].z == z; }))
        return model.classification.face_of_triangle[t];
    }
    return ModelFaceId();
  };
  const ModelFaceId bottom = side_at(0), top = side_at(0.1);
  for (ModelFaceId& face : exchanged.classification.face_of_triangle) face = face == top ? bottom : face == bottom ? top : face;
  const SizingProxy sizes({}, {.global = 1});
  CHECK(measure_deviation(flat, exchanged, flat, model, sizes, Matching::None).to_reference.greatest < 1e-15);
  const Deviation d = measure_deviation(flat, exchanged, flat, model, sizes, Matching::Faces);
  CHECK(d.to_reference.greatest == Approx(0.1));
  CHECK(d.of_faces[top.index()][0] == Approx(0.1));
  CHECK(std::count_if(d.of_faces.begin(), d.of_faces.end(), [](const auto& ways) { return ways[0] < 1e-15 && ways[1] < 1e-15; }) == 4);
}

TEST_CASE("a remeshed union has the marks the remesher promises", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(48));
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult fine = remesh(scene.mesh, scene.model, scene.normals, sizes);
  const ClassifiedBrep after = model_after(scene, fine);
  const QualityReport q = measure_quality(fine.mesh, after, sizes);
  CHECK(q.free.count == q.all.count);
  CHECK(q.free.least_angle_deg == measure_faces(fine.mesh).angles.min_deg);
  CHECK(q.all.greatest_angle_deg == measure_faces(fine.mesh).angles.max_deg);
  CHECK(q.free.least_angle_deg > 30);
  CHECK(q.edges.in_band > 0.99);
  CHECK(q.folds == 0);
  CHECK(std::accumulate(q.edges.bins.begin(), q.edges.bins.end(), std::size_t{0}) == q.edges.count);
  const Deviation d = deviation_after(scene, fine, sizes);
  CHECK(d.to_reference.in_sizes < 0.1);
  CHECK(d.from_reference.in_sizes < 0.1);
  CHECK(d.curves_to_reference.in_sizes < 1e-9);
  // Edges as long as the size cut off corners of 8 degrees and more of the curve: half the size times tan 4 degrees.
  CHECK(d.curves_from_reference.in_sizes < 0.05);
  CHECK(measure_quality(scene.mesh, scene.model, sizes).all.least_angle_deg < 0.1);
}

TEST_CASE("a report is a table to read", "[remesh]") {
  const SurfaceMesh mesh = rhombus(), above = lifted(mesh, 0.5);
  const std::string table = quality_table(quality_of(mesh, 1));
  CHECK(table.find("smallest angle, degrees                    60.00       60.00\n") != std::string::npos);
  CHECK(table.find("triangles that are not free                    0      0.00 %\n") != std::string::npos);
  const SizingProxy sizes({}, {.global = 2});
  const std::string distances = deviation_table(measure_deviation(mesh, model_of(mesh), above, model_of(above), sizes, Matching::None));
  CHECK(distances.find("  surface to the reference              0.500000     0.25000\n") != std::string::npos);
}

TEST_CASE("meshes without triangles have empty reports, and what does not match is refused", "[remesh]") {
  const SizingProxy sizes({}, {.global = 1});
  const SurfaceMesh none, cube = box({0, 0, 0}, {1, 1, 1}), sheet = rhombus();
  const QualityReport q = measure_quality(none, model_of(none), sizes);
  CHECK(q.all.count == 0);
  CHECK(q.all.least_radius_ratio == 0);
  CHECK(q.edges.least == 0);
  CHECK(quality_table(q).find("triangles") != std::string::npos);
  CHECK(measure_deviation(none, model_of(none), cube, model_of(cube), sizes, Matching::None).to_reference.greatest == 0);
  CHECK(measure_deviation(none, model_of(none), cube, model_of(cube), sizes, Matching::None).from_reference.greatest ==
        std::numeric_limits<double>::infinity());
  CHECK_THROWS_AS(measure_quality(cube, model_of(sheet), sizes), Error);
  CHECK_THROWS_AS(measure_quality(cube, model_of(cube), sizes, {1}), Error);
  CHECK_THROWS_AS(measure_deviation(cube, model_of(cube), sheet, model_of(sheet), sizes, Matching::Faces), Error);
}
