// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Real meshes that are open, with solids: a terrain and buildings, tyres on a floor, an open hull, the paper's Fig. 26.
#include <map>

#include "mortise/boolean/imprint.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/extrude_to.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/partition_checks.h"
#include "support/self_crossing_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh at(const SurfaceMesh& mesh, const Vec3d& offset) { return transform(mesh, translation(offset)); }

void check_certified(const BooleanResult& result) { CHECK(result.report.certificate.status == CertificateStatus::Certified); }

std::size_t part_count(const SurfaceMesh& mesh) { return connect_by_edges(mesh, build_topology(mesh)).count; }

}  // namespace

TEST_CASE("buildings on a terrain leave one closed loop each", "[scenario][sheets]") {
  if (is_data_missing()) return;
  const SurfaceMesh terrain = read_data("terrain/turbine_site_terrain.off");
  const SurfaceMesh buildings = at(read_data("terrain/buildings_clean.obj"), {581951, 4786170, 939.5});
  const BooleanResult inside = evaluate(Operation::Intersect, {terrain, buildings});
  const BooleanResult outside = evaluate(Operation::Subtract, {terrain, buildings});
  const BooleanResult all = evaluate(Operation::Partition, {terrain, buildings});
  for (const BooleanResult* result : {&inside, &outside, &all}) {
    check_certified(*result);
    CHECK(result->graph.closed_loops == 17);
    CHECK(result->graph.open_chains == 0);
  }
  CHECK(part_count(inside.mesh) == 17);
  CHECK(surface_area(inside.mesh) + surface_area(outside.mesh) == Approx(surface_area(terrain)).epsilon(1e-12));
  CHECK(surface_area(all.mesh) == Approx(surface_area(terrain) + surface_area(buildings)).epsilon(1e-12));
  const ResultRegions regions = find_result_regions(all);
  CHECK(regions.regions.size() == 34);  // each building above and below the ground
  CHECK(regions.total_volume() == Approx(enclosed_volume(buildings)).epsilon(1e-9));
}

TEST_CASE("the terrain as a solid down to a plane, with the buildings", "[scenario][sheets]") {
  if (is_data_missing()) return;
  const SurfaceMesh ground = extrude_to(read_data("terrain/turbine_site_terrain.off"), 900);
  const SurfaceMesh buildings = at(read_data("terrain/buildings_clean.obj"), {581951, 4786170, 939.5});
  CHECK(enclosed_volume(ground) == Approx(65646133.3333).epsilon(1e-11));
  const auto check = [&](Operation operation, const std::vector<SurfaceMesh>& operands, double volume) {
    const BooleanResult result = evaluate(operation, operands);
    check_certified(result);
    CHECK(enclosed_volume(result.mesh) == Approx(volume).epsilon(1e-9));
    return find_result_regions(result).regions.size();
  };
  CHECK(check(Operation::Union, {ground, buildings}, 65800020.0522) == 1);
  CHECK(check(Operation::Intersect, {ground, buildings}, 9532.4499258) == 17);
  CHECK(check(Operation::Subtract, {ground, buildings}, 65636600.8834) == 1);
  CHECK(check(Operation::Subtract, {buildings, ground}, 153886.71886) == 17);
}

TEST_CASE("tyres on a floor leave their footprints (Fig. 30)", "[scenario][sheets][paper]") {
  if (is_data_missing()) return;
  const SurfaceMesh floor = read_data("car/floor_sheet.off");
  const auto check = [&](const std::string& wheels, double area, double length) {
    const SurfaceMesh tyres = read_data("car/" + wheels);
    const BooleanResult footprints = evaluate(Operation::Intersect, {floor, tyres});
    check_certified(footprints);
    CHECK(footprints.graph.closed_loops == 10);
    CHECK(footprints.graph.open_chains == 0);
    CHECK(footprints.report.contact.length == Approx(length).margin(1e-6));
    const BooleanResult rest = evaluate(Operation::Subtract, {floor, tyres});
    CHECK(surface_area(rest.mesh) + surface_area(footprints.mesh) == Approx(surface_area(floor)).epsilon(1e-12));
    CHECK(surface_area(footprints.mesh) == Approx(area).margin(1e-9));
    const ImprintResult imprinted = imprint(floor, tyres);
    check_certified(imprinted.whole);
    CHECK(imprinted.whole.graph.closed_loops == 10);
    CHECK(surface_area(imprinted.operands[0].mesh) == Approx(surface_area(floor)).epsilon(1e-12));
    CHECK(enclosed_volume(imprinted.operands[1].mesh) == Approx(enclosed_volume(tyres)).epsilon(1e-12));
  };
  check("drivaer_front_wheels.ply", 0.019076912, 2.058559);
  check("drivaer_rear_wheels.ply", 0.019148027, 2.073431);
}

TEST_CASE("an open hull with edges of four faces and faces twice, cut by a box", "[scenario][sheets]") {
  if (is_data_missing()) return;
  const SurfaceMesh hull = read_data("ship/wigley_hull.off"), across = box({-0.2, -0.03, -0.05}, {0.3, 0.06, 0.01});
  const BooleanResult alone = evaluate(Operation::Union, {hull});
  const BooleanResult inside = evaluate(Operation::Intersect, {hull, across}), outside = evaluate(Operation::Subtract, {hull, across}),
                      all = evaluate(Operation::Partition, {hull, across});
  for (const BooleanResult* result : {&alone, &inside, &outside, &all}) {
    check_certified(*result);
    CHECK(oracle::self_crossings(result->mesh).empty());
  }
  CHECK(surface_area(inside.mesh) > 0.01);
  CHECK(surface_area(inside.mesh) + surface_area(outside.mesh) == Approx(surface_area(alone.mesh)).epsilon(1e-12));
  CHECK(surface_area(all.mesh) == Approx(surface_area(alone.mesh) + surface_area(across)).epsilon(1e-12));
  CHECK(find_result_regions(all).total_volume() == Approx(enclosed_volume(across)).epsilon(1e-12));
}

TEST_CASE("sphere, torus and corner sheet in one partition (Fig. 26)", "[scenario][sheets][paper]") {
  if (is_data_missing()) return;
  const SurfaceMesh sphere = read_data("primitives/fig26_sphere.off"), torus = read_data("primitives/fig26_torus.off"),
                    sheet = read_data("primitives/fig26_corner_sheet.off");
  const BooleanResult result = evaluate(Operation::Partition, {sphere, torus, sheet});
  check_certified(result);
  CHECK(oracle::self_crossings(result.mesh).empty());
  CHECK(surface_area(result.mesh) == Approx(surface_area(sphere) + surface_area(torus) + surface_area(sheet)).epsilon(1e-12));
  for (const auto& [size, count] : fan_sizes(result.mesh)) CHECK((size >= 1 && size <= 4));
  const auto border = [](const SurfaceMesh& mesh) {
    const MeshTopology topology = build_topology(mesh);
    double sum = 0;
    for (const MeshEdgeId e : find_boundary_edges(topology)) {
      const auto& [u, v] = topology.edges[e.index()];
      sum += length(mesh.points[v.index()] - mesh.points[u.index()]);
    }
    return sum;
  };
  CHECK(border(result.mesh) == Approx(border(sheet)).epsilon(1e-12));
  std::map<std::vector<std::uint32_t>, double> volume;
  const ResultRegions regions = find_result_regions(result);
  for (const ResultRegion& r : regions.regions) volume[r.operands] += r.volume;
  CHECK(regions.regions.size() == 6);  // the sheet cuts through all three pieces
  CHECK(volume[{0, 1}] == Approx(0.605824201819).epsilon(1e-9));
  CHECK(volume[{0}] == Approx(3.55837939443).epsilon(1e-9));
  CHECK(volume[{1}] == Approx(2.00571743264).epsilon(1e-9));
}
