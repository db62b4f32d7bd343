// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 23: the union of two cylinders as it is cut, remeshed in layers round the cut, by sizes that grow from it, and all over.
#include <algorithm>
#include <cmath>

#include "mortise/brep/result_features.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/size/graph_sources.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double growth = 1.2;

/// A cylinder standing on z = 0 with rings of facets.
SurfaceMesh ringed_cylinder(double radius, double height, std::uint32_t around, std::uint32_t rings) {
  std::vector<Vec2d> profile{{0, 0}};
  for (std::uint32_t k = 0; k <= rings; ++k) profile.push_back({radius, height * k / rings});
  profile.push_back({0, height});
  return revolve(profile, around);
}

/// As crossing_cylinders(48), of short facets.
std::vector<SurfaceMesh> fine_cylinders() {
  std::vector<SurfaceMesh> both{ringed_cylinder(1, 4, 48, 40), ringed_cylinder(0.6, 4, 48, 50)};
  for (Vec3d& p : both[1].points) p = {p.z - 2, p.x + 0.02, p.y + 2.013};
  return both;
}

struct Cut {
  ModelScene scene;
  std::vector<std::array<VertexId, 2>> graph;
};

Cut cut_of(const std::vector<SurfaceMesh>& operands) {
  const BooleanResult united = evaluate(Operation::Union, operands);
  return {scene_of(united, operands), find_graph_edges(united.mesh, united.provenance)};
}

/// The same model and solid, nothing folded, nothing crossing.
void check_solid(const ModelScene& scene, const RemeshResult& result, const QualityReport& q) {
  CHECK(find_faults(result.mesh, model_after(scene, result)).empty());
  CHECK(is_balanced(result.mesh));
  CHECK(euler_characteristic(result.mesh) == 2);
  CHECK(count_crossings(result.mesh) == 0);
  CHECK(q.folds == 0);
}

}  // namespace

TEST_CASE("Fig. 23a: the cut leaves triangles of hundredths of a degree", "[paper][remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(48));
  CHECK(measure_faces(scene.mesh).angles.min_deg < 0.02);
  CHECK(measure_faces(scene.mesh).angles.max_deg > 175);
}

TEST_CASE("Fig. 23b: layers round the cut get good triangles, all others stay byte for byte", "[paper][remesh]") {
  const Cut cut = cut_of(fine_cylinders());
  const SizingProxy sizes({}, {.global = 0.1});
  RemeshRules rules;
  rules.zone = layers_round(cut.scene.mesh, cut.graph, 4);
  const RemeshResult result = remesh(cut.scene.mesh, cut.scene.model, cut.scene.normals, sizes, rules);
  check_solid(cut.scene, result, measure_quality(result.mesh, model_after(cut.scene, result), sizes));
  CHECK(result.kept.empty());
  CHECK(std::count(rules.zone.begin(), rules.zone.end(), std::uint8_t{0}) > 4000);
  CHECK(count_lost(cut.scene.mesh, rules.zone, result.mesh) == 0);
  const SurfaceMesh changed = part_away_from(cut.scene.mesh, rules.zone, result.mesh);
  CHECK(changed.triangles.size() > 1000);
  CHECK(measure_faces(cut.scene.mesh).angles.min_deg < 0.1);
  CHECK(measure_faces(changed).angles.min_deg > 34);
  CHECK(measure_faces(changed).angles.max_deg < 110);
}

TEST_CASE("Fig. 23c: sizes grow from the cut by no more than they should", "[paper][remesh]") {
  const Cut cut = cut_of(crossing_cylinders(48));
  const SizingProxy sizes(sources_of_graph(cut.scene.mesh.points, cut.graph, growth), {.global = 0.2});
  const RemeshResult result = remesh(cut.scene.mesh, cut.scene.model, cut.scene.normals, sizes);
  const QualityReport q = measure_quality(result.mesh, model_after(cut.scene, result), sizes);
  check_solid(cut.scene, result, q);
  CHECK(q.free.count == q.all.count);
  CHECK(q.free.least_angle_deg > 34);
  CHECK(q.edges.in_band > 0.985);
  CHECK(std::fabs(q.edges.mean - 1) < 0.03);
  CHECK(q.edges.greatest_growth < growth * 1.05);
  // A triangle may be a fifth longer than its size, and its neighbour a fifth shorter.
  const std::vector<double> growths = growths_of(result.mesh);
  CHECK(growths[growths.size() * 97 / 100] < growth * 1.05);
  CHECK(growths.back() < 1.7);
  CHECK(deviation_after(cut.scene, result, sizes).curves_to_reference.in_sizes < 1e-3);
}

TEST_CASE("Fig. 23d: all over, triangles are of one size and have no small angle", "[paper][remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(48));
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
  const QualityReport q = measure_quality(result.mesh, model_after(scene, result), sizes);
  check_solid(scene, result, q);
  CHECK(q.free.count == q.all.count);
  CHECK(q.free.least_angle_deg > 34);
  CHECK(q.free.greatest_angle_deg < 105);
  CHECK(q.all.mean_radius_ratio > 0.964);
  CHECK(q.edges.in_band > 0.995);
  CHECK(std::fabs(q.edges.mean - 1) < 0.02);
  const Deviation d = deviation_after(scene, result, sizes);
  CHECK(d.curves_to_reference.in_sizes < 1e-3);
  CHECK(d.to_reference.in_sizes < 0.05);
  CHECK(d.from_reference.in_sizes < 0.05);
}
