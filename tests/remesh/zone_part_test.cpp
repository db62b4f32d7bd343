// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a zone may change is cut out of its model and put back: nothing else changes.
#include "mortise/remesh/zone_part.h"

#include <algorithm>
#include <cmath>

#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/remesh/edit_mesh.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_source.h"
#include "support/remesh_scenes.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;
using Catch::Detail::Approx;

namespace {

/// Solids, seams, sheets, walls, edges with four triangles, closed model edges.
std::vector<ModelScene> scenes() {
  BrepRules seamed;
  seamed.seams = Seams::Disc;
  std::vector<ModelScene> all;
  all.push_back(scene_of(Operation::Union, crossing_cylinders(24)));
  all.push_back(scene_of(make_torus(1, 0.4, 24, 12), seamed));
  all.push_back(scene_of(Operation::Partition, ball_ring_and_corner_sheet()));
  all.push_back(scene_of(Operation::Subtract, plate_and_drills()));
  return all;
}

/// Triangles with a corner in a random ball; sometimes some more.
std::vector<std::uint8_t> random_zone(const SurfaceMesh& mesh, RandomSource& random) {
  const Vec3d middle = mesh.points[random.below(mesh.points.size())];
  const double radius = random.between(0.05, 1.2);
  const bool has_more = random.once_in(3);
  std::vector<std::uint8_t> zone;
  for (const Triangle& t : mesh.triangles) {
    const bool is_near = std::any_of(t.begin(), t.end(), [&](VertexId v) {
      const Vec3d way = mesh.points[v.index()] - middle;
      return dot(way, way) < radius * radius;
    });
    const bool is_more = has_more && random.once_in(20);
    zone.push_back(is_near || is_more ? 1 : 0);
  }
  return zone;
}

/// The part as it is.
ChangedPart unchanged(const ZonePart& part) {
  ChangedPart same{part.mesh, part.model.classification, {}, {}};
  for (std::size_t v = 0; v < part.mesh.points.size(); ++v) same.new_vertex.emplace_back(v);
  return same;
}

}  // namespace

TEST_CASE("what is cut out and put back is the model that was there", "[remesh]") {
  const std::vector<ModelScene> all = scenes();
  for (std::size_t seed = 1; seed <= scaled_count(200, 10000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const ModelScene& scene = all[seed % all.size()];
    const std::vector<std::uint8_t> zone = random_zone(scene.mesh, random);
    const ZonePart part = cut_out(scene.mesh, scene.model, scene.normals, zone);
    CHECK(std::count(part.zone.begin(), part.zone.end(), std::uint8_t{1}) == std::count(zone.begin(), zone.end(), std::uint8_t{1}));
    EditMesh(part.mesh, part.model).check();
    const PutBack whole = put_back(part, unchanged(part), scene.mesh, scene.model);
    const std::vector<std::uint8_t> none(scene.mesh.triangles.size(), 0);
    CHECK(whole.mesh.triangles.size() == scene.mesh.triangles.size());
    CHECK(count_lost(scene.mesh, none, whole.mesh) == 0);
    CHECK(find_faults(whole.mesh, {scene.model.brep, whole.classification}).empty());
  }
}

TEST_CASE("random zones are remeshed, and all else stays byte for byte", "[remesh]") {
  const std::vector<ModelScene> all = scenes();
  for (std::size_t seed = 1; seed <= scaled_count(60, 3000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const ModelScene& scene = all[seed % all.size()];
    RemeshRules rules;
    rules.zone = random_zone(scene.mesh, random);
    const SizingProxy sizes({}, {.global = random.between(0.05, 0.3)});
    const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, rules);
    const ClassifiedBrep after = model_after(scene, result);
    CHECK(count_lost(scene.mesh, rules.zone, result.mesh) == 0);
    CHECK(find_faults(result.mesh, after).empty());
    EditMesh(result.mesh, after).check();
    CHECK(result.new_crossings.empty());
    CHECK(is_balanced(result.mesh) == is_balanced(scene.mesh));
    CHECK(surface_area(result.mesh) == Approx(surface_area(scene.mesh)).epsilon(0.1));
    for (const FaceId t : result.kept) CHECK(rules.zone[t.index()] == 1);
    CHECK(result.sources.size() == result.mesh.triangles.size());
  }
}

TEST_CASE("an empty zone changes nothing", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(24));
  RemeshRules rules;
  rules.zone.assign(scene.mesh.triangles.size(), 0);
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, SizingProxy({}, {.global = 0.1}), rules);
  CHECK(count_lost(scene.mesh, rules.zone, result.mesh) == 0);
  CHECK(result.mesh.triangles.size() == scene.mesh.triangles.size());
  CHECK(find_faults(result.mesh, model_after(scene, result)).empty());
}
