// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models of real meshes: their counts, and that every shell has the characteristic of its triangles.
#include "mortise/brep/build_brep.h"
#include "mortise/brep/model_queries.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/repair.h"
#include "mortise/mesh/weld.h"
#include "support/catch.h"
#include "support/data.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct RealModel {
  const char* file;
  std::size_t vertices, edges, faces, regions, voids, loops, mesh_edges;  // regions without the outside
};

const RealModel real_models[] = {
    {"cad/fandisk.off", 25, 35, 12, 1, 0, 12, 710},
    {"cad/flange.stl", 40, 69, 28, 1, 0, 33, 882},
    {"cad/thingi10k_472042_boiler.stl", 26, 39, 15, 1, 0, 19, 1827},
    {"cad/mixer_stirrer.obj", 138, 211, 80, 1, 0, 85, 1271},
    {"cad/cht_bottomAir.stl", 20, 33, 13, 1, 0, 13, 253},
    {"car/drivaer_front_wheels.ply", 2426, 1298, 26, 2, 0, 1180, 12729},
    {"car/drivaer_body.ply", 5025, 2812, 147, 11, 7, 2509, 8974},
    {"ship/dtc_hull.ply", 22, 13, 3, 1, 0, 13, 845},
    {"ship/stack_funnel.obj", 2, 3, 3, 1, 0, 3, 373},
    {"aircraft/cape_bullet.obj", 2, 3, 3, 1, 0, 3, 147},
    {"nasty/gc_moebius.obj", 2, 3, 1, 0, 0, 1, 116},
    {"nasty/of_mixer_baffles.stl", 8, 8, 2, 0, 0, 2, 16},
    {"nasty/three_cubes.stl", 24, 36, 18, 3, 0, 18, 36},
};

SurfaceMesh usable(const char* file) {
  RepairSteps steps;
  steps.drop_degenerate = true;
  steps.drop_duplicates = true;
  return repair(weld(read_data(file)).mesh, steps).mesh;
}

std::size_t count_voids(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  std::size_t voids = 0;
  for (const std::uint8_t is_void : find_voids(mesh, model)) voids += is_void;
  return voids;
}

}  // namespace

TEST_CASE("real meshes have sound models, with these counts", "[brep][data]") {
  if (is_data_missing()) return;
  for (const RealModel& expected : real_models) {
    INFO(expected.file);
    const SurfaceMesh mesh = usable(expected.file);
    for (const Seams seams : {Seams::None, Seams::Disc}) {
      BrepRules rules;
      rules.seams = seams;
      CHECK(find_faults(mesh, build_brep(mesh, rules)) == std::vector<std::string>());
    }
    const ClassifiedBrep model = build_brep(mesh);
    const Brep& brep = model.brep;
    CHECK(find_faults(mesh, model) == std::vector<std::string>());
    const std::size_t mesh_edges = model.classification.path.items.size() - model.classification.path.size();
    CHECK(brep.vertex_count == expected.vertices);
    CHECK(brep.edges.size() == expected.edges);
    CHECK(brep.faces.size() == expected.faces);
    CHECK(brep.region_count - 1 == expected.regions);
    CHECK(count_voids(mesh, model) == expected.voids);
    CHECK(brep.loops.size() == expected.loops);
    CHECK(mesh_edges == expected.mesh_edges);
  }
}
