// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Open surfaces as operands, alone and with solids: trimmed, joined, dividing; walls of a result in the next call.
#include <algorithm>
#include <iterator>

#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/split_parts.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/partition_checks.h"
#include "support/self_crossing_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

// A rectangle in the plane z, facing up.
SurfaceMesh plate(double x0, double y0, double x1, double y1, double z) {
  return make_mesh({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, {{0, 1, 2}, {0, 2, 3}});
}

double area_of(Operation operation, const std::vector<SurfaceMesh>& operands) { return surface_area(evaluate(operation, operands).mesh); }

std::vector<double> region_volumes(const BooleanResult& result) {
  std::vector<double> volumes;
  for (const ResultRegion& r : find_result_regions(result).regions) volumes.push_back(r.volume);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

std::size_t wall_count(const SurfaceMesh& mesh) { return static_cast<std::size_t>(std::count(mesh.walls.begin(), mesh.walls.end(), 1)); }

bool faces_up(const SurfaceMesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const Vec3d& a = mesh.points[t[0].index()];
    return cross(mesh.points[t[1].index()] - a, mesh.points[t[2].index()] - a).z > 0;
  });
}

}  // namespace

TEST_CASE("a sheet is trimmed by a solid: the part inside, the part outside", "[sheets]") {
  const SurfaceMesh sheet = plate(-1, -1, 2, 2, 0.5);
  for (const bool sheet_first : {true, false}) {
    const BooleanResult inside =
        evaluate(Operation::Intersect, sheet_first ? std::vector<SurfaceMesh>{sheet, unit} : std::vector<SurfaceMesh>{unit, sheet});
    CHECK(surface_area(inside.mesh) == 1);
    CHECK(faces_up(inside.mesh));
    CHECK(wall_count(inside.mesh) == inside.mesh.triangles.size());
    CHECK(inside.report.certificate.status == CertificateStatus::Certified);
  }
  const BooleanResult outside = evaluate(Operation::Subtract, {sheet, unit});
  CHECK(surface_area(outside.mesh) == 8);
  CHECK(faces_up(outside.mesh));
  const BooleanResult both = evaluate(Operation::Union, {unit, sheet});
  CHECK(surface_area(both.mesh) == 6 + 8);
  CHECK(region_volumes(both) == std::vector<double>{1});
  CHECK(area_of(Operation::SymmetricDifference, {sheet, unit}) == 6 + 8);
}

TEST_CASE("one triangle and a tetrahedron it pierces: the part inside, the part outside, the same vertices", "[sheets]") {
  const SurfaceMesh tet = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  const SurfaceMesh triangle = make_mesh({{-1, 1, 1}, {5, 1, 1}, {1, 1, 5}}, {{0, 1, 2}});
  const BooleanResult inside = evaluate(Operation::Intersect, {tet, triangle});
  const BooleanResult outside = evaluate(Operation::Subtract, {triangle, tet});
  CHECK(surface_area(inside.mesh) + surface_area(outside.mesh) == Approx(surface_area(triangle)).epsilon(1e-15));
  for (const BooleanResult* result : {&inside, &outside}) {
    for (const BooleanResult* other : {&inside, &outside}) {
      for (const Vec3d& p : result->graph.points) {
        CHECK(std::find(other->mesh.points.begin(), other->mesh.points.end(), p) != other->mesh.points.end());
      }
    }
  }
}

TEST_CASE("what lies on a solid is part of it", "[sheets]") {
  const SurfaceMesh on_top = plate(0.25, 0.25, 0.75, 0.75, 1), against = inside_out(on_top);
  for (const SurfaceMesh& sheet : {on_top, against}) {
    const BooleanResult common = evaluate(Operation::Intersect, {unit, sheet});
    CHECK(surface_area(common.mesh) == 0.25);
    CHECK(faces_up(common.mesh) == faces_up(sheet));
    CHECK(evaluate(Operation::Subtract, {sheet, unit}).mesh.triangles.empty());
    const BooleanResult both = evaluate(Operation::Union, {sheet, unit});
    CHECK(surface_area(both.mesh) == 6);
    CHECK(both.mesh.walls.empty());
    CHECK(both.graph.closed_loops == 1);
  }
  const BooleanResult common = evaluate(Operation::Intersect, {unit, on_top});
  CHECK(std::all_of(common.provenance.category.begin(), common.provenance.category.end(),
                    [](FacetCategory c) { return c == FacetCategory::OnSame; }));
}

TEST_CASE("a sheet divides a solid that it separates", "[sheets]") {
  const BooleanResult halves = evaluate(Operation::Partition, {unit, plate(-1, -1, 2, 2, 0.25)});
  CHECK(region_volumes(halves) == std::vector<double>{0.25, 0.75});
  CHECK(surface_area(halves.mesh) == 6 + 9);
  CHECK(fan_sizes(halves.mesh).count(4) == 1);
  const BooleanResult dented = evaluate(Operation::Partition, {unit, plate(-1, -1, 0.5, 2, 0.25)});
  CHECK(region_volumes(dented) == std::vector<double>{1});
  CHECK(find_result_regions(dented).is_closed);
  const BooleanResult within = evaluate(Operation::Partition, {unit, plate(0.25, 0.25, 0.75, 0.75, 0.5)});
  CHECK(region_volumes(within) == std::vector<double>{1});
  CHECK(surface_area(within.mesh) == 6.25);
  using Idle = std::vector<std::uint32_t>;
  CHECK(find_idle_sheets(halves, find_result_regions(halves)) == Idle{});
  for (const BooleanResult* result : {&dented, &within}) CHECK(find_idle_sheets(*result, find_result_regions(*result)) == Idle{1});
}

TEST_CASE("a sheet that separates a solid takes what lies behind it", "[sheets]") {
  const SurfaceMesh up = plate(-1, -1, 2, 2, 0.25), down = inside_out(up);
  const BooleanResult upper = evaluate(Operation::Subtract, {unit, up}), lower = evaluate(Operation::Subtract, {unit, down});
  CHECK(enclosed_volume(upper.mesh) == 0.75);
  CHECK(enclosed_volume(lower.mesh) == 0.25);
  for (const BooleanResult* part : {&upper, &lower}) {
    CHECK(part->mesh.walls.empty());
    CHECK(part->report.notes.empty());
    CHECK(find_unbalanced_edges(part->mesh, build_topology(part->mesh)).empty());
    CHECK(find_result_regions(*part).regions.size() == 1);
  }
  CHECK(enclosed_volume(evaluate(Operation::Subtract, {unit, up, moved(down, {0, 0, 0.5})}).mesh) == 0.5);
  CHECK(evaluate(Operation::Subtract, {unit, up, down}).mesh.triangles.empty());
}

TEST_CASE("what lies in the part behind a sheet goes with it", "[sheets]") {
  const SurfaceMesh hollow =
      joined({box({0, 0, 0}, {4, 4, 4}), inside_out(box({1, 1, 0.5}, {3, 3, 1})), inside_out(box({1, 1, 3}, {2, 2, 3.5}))});
  const SurfaceMesh up = plate(-1, -1, 5, 5, 2);
  const BooleanResult upper = evaluate(Operation::Subtract, {hollow, up}), lower = evaluate(Operation::Subtract, {hollow, inside_out(up)});
  CHECK(enclosed_volume(upper.mesh) == 32 - 0.5);
  CHECK(enclosed_volume(lower.mesh) == 32 - 2);
  CHECK(surface_area(upper.mesh) == 2 * 16 + 4 * 8 + 2 + 4 * 0.5);
  const BooleanResult drilled = evaluate(Operation::Subtract, {hollow, up, box({0.5, 0.5, -1}, {0.75, 0.75, 5})});
  CHECK(enclosed_volume(drilled.mesh) == 32 - 0.5 - 0.125);
}

TEST_CASE("a sheet that ends inside a solid takes nothing, and the report says so", "[sheets]") {
  for (const SurfaceMesh& sheet : {plate(-1, -1, 0.5, 2, 0.25), plate(0.25, 0.25, 0.75, 0.75, 0.5)}) {
    const BooleanResult whole = evaluate(Operation::Subtract, {unit, sheet});
    CHECK(enclosed_volume(whole.mesh) == 1);
    CHECK(surface_area(whole.mesh) == 6);
    REQUIRE(whole.report.notes.size() == 1);
    CHECK(whole.report.notes[0].find("sheet operand 1 ends inside") == 0);
  }
  CHECK(evaluate(Operation::Subtract, {unit, plate(-1, -1, 2, 2, 1)}).report.notes.empty());  // lies on it
}

TEST_CASE("sheets and sheets", "[sheets]") {
  const SurfaceMesh a = plate(0, 0, 2, 2, 0), b = plate(1, 1, 3, 3, 0);
  CHECK(area_of(Operation::Union, {a, b}) == 7);
  CHECK(area_of(Operation::Intersect, {a, b}) == 1);
  CHECK(area_of(Operation::Subtract, {a, b}) == 3);
  CHECK(area_of(Operation::SymmetricDifference, {a, b}) == 6);
  CHECK(area_of(Operation::Partition, {a, b}) == 7);
  const SurfaceMesh upright = with_axes_turned(plate(-1, -1, 1, 1, 1));  // in the plane x = 1
  const BooleanResult cross = evaluate(Operation::Union, {a, upright});
  CHECK(surface_area(cross.mesh) == 8);
  CHECK(fan_sizes(cross.mesh).count(4) == 1);
  CHECK(evaluate(Operation::Intersect, {a, upright}).mesh.triangles.empty());
}

TEST_CASE("open operands are named, with their open edges; refused where solids are required", "[sheets]") {
  const SurfaceMesh sheet = plate(-1, -1, 2, 2, 0.5);
  const BooleanResult result = evaluate(Operation::Union, {unit, sheet});
  REQUIRE(result.report.sheets.size() == 1);
  CHECK(result.report.sheets[0].operand == 1);
  CHECK(result.report.sheets[0].open_edges.size() == 8);
  BooleanOptions options;
  options.require_solids = true;
  const auto operands = std::vector<const SurfaceMesh*>{&unit, &sheet};
  const auto error = error_of([&] { (void)evaluate_boolean(Operation::Union, operands, options); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotClosed);
}

TEST_CASE("a partition partitioned again is the same", "[sheets][partition]") {
  const SurfaceMesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3}), sheet = plate(-1, -1, 4, 4, 0.5);
  const BooleanResult once = evaluate(Operation::Partition, {a, b, sheet});
  const BooleanResult twice = evaluate(Operation::Partition, {once.mesh});
  CHECK(twice.mesh.triangles.size() == once.mesh.triangles.size());
  CHECK(twice.mesh.points == once.mesh.points);
  CHECK(region_volumes(twice) == region_volumes(once));
  CHECK(twice.mesh.walls.size() == once.mesh.walls.size());
  CHECK(wall_count(twice.mesh) == wall_count(once.mesh));
}

TEST_CASE("results with several regions are operands", "[sheets][partition]") {
  const SurfaceMesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3}), c = box({1, 0, 0}, {4, 1.5, 1.5});
  const BooleanResult ab = evaluate(Operation::Partition, {a, b});
  const BooleanResult chained = evaluate(Operation::Partition, {ab.mesh, c});
  const BooleanResult at_once = evaluate(Operation::Partition, {a, b, c});
  CHECK(region_volumes(chained) == region_volumes(at_once));
  CHECK(surface_area(chained.mesh) == Approx(surface_area(at_once.mesh)).epsilon(1e-15));
  CHECK(fan_sizes(chained.mesh).size() == fan_sizes(at_once.mesh).size());
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract}) {
    const BooleanResult with_walls = evaluate(operation, {ab.mesh, c});
    const BooleanResult without = evaluate(operation, {evaluate(Operation::Union, {a, b}).mesh, c});
    CHECK(with_walls.mesh.walls.empty());
    CHECK(enclosed_volume(with_walls.mesh) == enclosed_volume(without.mesh));
    CHECK(find_boundary_edges(build_topology(with_walls.mesh)).empty());
  }
}

TEST_CASE("sheets and solids are imprinted on one another", "[sheets][imprint]") {
  const SurfaceMesh sheet = plate(-1, -1, 2, 2, 0.5);
  const ImprintResult result = imprint(sheet, unit);
  const ImprintedOperand &floor = result.operands[0], &solid = result.operands[1];
  CHECK(surface_area(floor.mesh) == 9);
  CHECK(faces_up(floor.mesh));
  CHECK(enclosed_volume(solid.mesh) == 1);
  CHECK(find_unbalanced_edges(solid.mesh, build_topology(solid.mesh)).empty());
  std::vector<std::uint32_t> shared;
  std::set_intersection(floor.vertex_ids.begin(), floor.vertex_ids.end(), solid.vertex_ids.begin(), solid.vertex_ids.end(),
                        std::back_inserter(shared));
  CHECK(shared.size() == result.whole.graph.points.size());
  const ImprintResult again = imprint(floor.mesh, solid.mesh);
  for (const std::size_t k : {0U, 1U}) CHECK(again.operands[k].mesh.triangles.size() == result.operands[k].mesh.triangles.size());
  const BooleanResult halves = evaluate(Operation::Partition, {unit, plate(0, 0, 1, 1, 0.25)});
  CHECK(wall_count(imprint(halves.mesh, with_axes_turned(sheet)).operands[0].mesh) > wall_count(halves.mesh));
}

TEST_CASE("a component is implanted in an open hull", "[sheets][implant]") {
  const SurfaceMesh deck = plate(-4, -4, 4, 4, 0), gun = box({-1, -1, 0}, {1, 1, 1}), mast = box({-1, -1, -1}, {1, 1, 2});
  for (const SurfaceMesh& component : {gun, mast}) {
    const BooleanResult kept = implant(std::vector{&deck, &component});
    CHECK(surface_area(kept.mesh) == 64 - 4 + surface_area(component));
    CHECK(kept.graph.closed_loops == 1);
    CHECK(find_boundary_edges(build_topology(kept.mesh)).size() >= 4);
    CHECK(region_volumes(kept) == std::vector<double>{enclosed_volume(component)});
    CHECK(oracle::self_crossings(kept.mesh).empty());
  }
}

TEST_CASE("a partition comes apart into its regions", "[sheets][partition]") {
  const SurfaceMesh hollow = joined({box({0, 0, 0}, {4, 4, 4}), inside_out(box({1, 1, 1}, {2, 2, 2}))});
  const BooleanResult result =
      evaluate(Operation::Partition, {hollow, box({3, 3, 3}, {5, 5, 5}), plate(-1, -1, 5, 5, 2.5), plate(6, 6, 7, 7, 0)});
  std::vector<double> volumes;
  for (const MeshPart& part : split_parts(result.mesh, SplitBy::Regions)) {
    CHECK(find_unbalanced_edges(part.mesh, build_topology(part.mesh)).empty());
    volumes.push_back(enclosed_volume(part.mesh));
    for (std::size_t f = 0; f < part.mesh.triangles.size(); ++f) {
      const Triangle &t = part.mesh.triangles[f], &source = result.mesh.triangles[part.source_face[f].index()];
      CHECK(part.source_vertex[t[0].index()] == source[0]);
    }
  }
  std::sort(volumes.begin(), volumes.end());
  CHECK(volumes == region_volumes(result));
  SurfaceMesh torn = result.mesh;
  torn.triangles.erase(torn.triangles.begin());
  torn.walls.erase(torn.walls.begin());
  const auto error = error_of([&] { (void)split_parts(torn, SplitBy::Regions); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotClosed);
}

TEST_CASE("walls travel with the faces of a mesh", "[sheets]") {
  const BooleanResult halves = evaluate(Operation::Partition, {unit, plate(0, 0, 1, 1, 0.5)});
  const std::size_t walls = wall_count(halves.mesh);
  REQUIRE((walls > 0 && walls < halves.mesh.triangles.size()));
  const SurfaceMesh moved_halves = transform(halves.mesh, translation({1, 2, 3}));
  CHECK(wall_count(moved_halves) == walls);
  CHECK(region_volumes(evaluate(Operation::Partition, {moved_halves})) == std::vector<double>{0.5, 0.5});
}

TEST_CASE("sphere, torus and a corner sheet (Fig. 26)", "[sheets][partition][paper]") {
  const SurfaceMesh sphere = make_icosphere(1, 3), torus = moved(make_torus(1, 0.4, 48, 24), {0.7, 0.1, 0.3});
  const SurfaceMesh floor = plate(-1.6, 0.05, 1.6, 2.05, 0.05);
  const SurfaceMesh wall =
      make_mesh({{-1.6, 0.05, 0.05}, {1.6, 0.05, 0.05}, {1.6, 0.05, -1.6}, {-1.6, 0.05, -1.6}}, {{0, 1, 2}, {0, 2, 3}});
  const SurfaceMesh corner = evaluate(Operation::Union, {floor, wall}).mesh;
  const BooleanResult result = evaluate(Operation::Partition, {sphere, torus, corner});
  CHECK(result.report.certificate.status == CertificateStatus::Certified);
  CHECK(surface_area(result.mesh) == Approx(surface_area(sphere) + surface_area(torus) + surface_area(corner)).epsilon(1e-12));
  for (const auto& [size, count] : fan_sizes(result.mesh)) CHECK((size >= 1 && size <= 4 && count > 0));
  double border = 0;
  const MeshTopology topology = build_topology(result.mesh);
  for (const MeshEdgeId e : find_boundary_edges(topology)) {
    const auto& [u, v] = topology.edges[e.index()];
    border += length(result.mesh.points[v.index()] - result.mesh.points[u.index()]);
  }
  CHECK(border == Approx(2 * (3.2 + 2.0 + 1.65)).epsilon(1e-12));
  CHECK(oracle::self_crossings(result.mesh).empty());
}
