// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Many results of random operations, and real meshes, remeshed: the model stays sound and the same, whatever the size.
#include <algorithm>
#include <array>
#include <cmath>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/measures.h"
#include "mortise/remesh/remesh.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Remeshed {
  SurfaceMesh before, after;
  std::size_t faults = 0;
};

Remeshed remeshed(SurfaceMesh mesh, const FaceNormals& normals, double size) {
  BrepRules rules;
  rules.seams = Seams::None;
  rules.features.splits_at_labels = false;
  const ClassifiedBrep model = build_brep(mesh, rules, normals);
  RemeshResult result = remesh(mesh, model, normals, SizingProxy({}, {.global = size}));
  const std::size_t faults = find_faults(result.mesh, {model.brep, result.classification}).size();
  return {std::move(mesh), std::move(result.mesh), faults};
}

std::size_t count_below(const SurfaceMesh& mesh, double least_deg) {
  return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const std::array<double, 3> angles =
        triangle_angles_deg(mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()]);
    return *std::min_element(angles.begin(), angles.end()) < least_deg;
  }));
}

struct RealMesh {
  const char* file;
  double least_deg;  ///< no triangle has a smaller angle
};

// Lower ones: where model edges meet at a small angle. With half as many triangles edges of the heater lie closer than the size.
constexpr std::array<RealMesh, 7> real_meshes{{{"cad/flange.stl", 33},
                                               {"aircraft/cape_engine.obj", 31},
                                               {"aircraft/cape_bullet.obj", 33},
                                               {"cad/cht_heater.stl", 33},
                                               {"cad/wecsim_base.stl", 33},
                                               {"cad/furnace_heater.obj", 33},
                                               {"cad/fandisk.off", 20}}};

}  // namespace

TEST_CASE("remeshed results of random operations are meshes of the same sound model", "[remesh]") {
  std::size_t compared = 0;
  constexpr std::array operations{Operation::Union, Operation::Subtract, Operation::Partition, Operation::SymmetricDifference};
  for (std::size_t seed = 1; seed <= scaled_count(100, 2000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    std::vector<SurfaceMesh> solids;
    for (std::size_t k = 0; k < 2; ++k) solids.push_back(random.next_of_all_kinds());
    const Operation operation = operations[random.below(operations.size())];
    const double size = random.octaves(-2, 1);
    const BooleanResult result = evaluate_boolean(operation, pointers_to(solids));
    if (result.mesh.triangles.empty() || !find_self_crossings(result.mesh).empty()) continue;
    std::vector<FaceNormals> normals;
    for (const SurfaceMesh& solid : solids) normals.push_back(measure_normals(solid, build_topology(solid)));
    const Remeshed r = remeshed(result.mesh, source_normals(result.provenance, normals), size);
    CHECK(r.faults == 0);
    CHECK(find_self_crossings(r.after).empty());
    // Creases below 40 degrees are not kept: they are rounded off by as much as the size allows.
    CHECK(surface_area(r.after) == Approx(surface_area(r.before)).epsilon(0.06));
    ++compared;
  }
  CHECK(compared * 2 > scaled_count(100, 2000));
}

TEST_CASE("real meshes keep their models, and all but sharp corners get angles above 30 degrees", "[remesh]") {
  if (is_data_missing()) return;
  for (const RealMesh& real : real_meshes) {
    INFO(real.file);
    const SurfaceMesh mesh = read_data(real.file);
    const double size = std::sqrt(surface_area(mesh) * 2.31 / 8000);
    const Remeshed r = remeshed(mesh, measure_normals(mesh, build_topology(mesh)), size);
    CHECK(r.faults == 0);
    CHECK(find_self_crossings(r.after).empty());
    CHECK(count_below(r.after, real.least_deg) == 0);
    CHECK(count_below(r.after, 30) <= r.after.triangles.size() / 1000);
    CHECK(surface_area(r.after) == Approx(surface_area(r.before)).epsilon(0.01));
    CHECK(std::fabs(enclosed_volume(r.after) / enclosed_volume(r.before) - 1) < 0.01);
  }
}
