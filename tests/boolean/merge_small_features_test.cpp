// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Chamfers, slots, webs and layers thinner than a length go; what is larger stays where it was.
#include "mortise/boolean/merge_small_features.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/base/error.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/transform.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_checks.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/random_source.h"
#include "support/remesh_scenes.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;
using Catch::Detail::Approx;

namespace {

constexpr double thin = 1e-3, least = 1e-2;

MergedFeatures merged_of(const ModelScene& scene, double length = least) { return merge_small_features(scene.mesh, scene.model, length); }

/// It is a mesh of its own that a model can be made of, and says what went.
ModelScene checked(const ModelScene& scene, const MergedFeatures& merged) {
  CHECK(merged.unresolved.empty());
  CHECK(merged.largest_move <= least);
  CHECK(merged.sources.size() == merged.mesh.triangles.size());
  CHECK(count_crossings(merged.mesh) == 0);
  std::vector<std::uint8_t> is_named(scene.mesh.triangles.size(), 0);
  for (const FaceId t : merged.sources) is_named[t.index()] = 1;
  for (const FaceId t : merged.gone) CHECK(is_named[t.index()]++ == 0);
  CHECK(std::count(is_named.begin(), is_named.end(), std::uint8_t{0}) == 0);
  const ModelScene after = scene_of(merged.mesh);
  CHECK(find_faults(after.mesh, after.model).empty());
  return after;
}

void check_box(const ModelScene& scene, double volume) {
  CHECK(is_balanced(scene.mesh));
  CHECK(scene.model.brep.faces.size() == 6);
  CHECK(scene.model.brep.edges.size() == 12);
  CHECK(scene.model.brep.vertex_count == 8);
  CHECK(exact_volume(scene.mesh) == Approx(volume).epsilon(2 * least));
}

}  // namespace

TEST_CASE("a narrow chamfer becomes an edge", "[merge_features]") {
  const ModelScene scene = scene_of(prism({{0, 0}, {2, 0}, {2, 1 - thin}, {2 - thin, 1}, {0, 1}}, 0, 1));
  CHECK(scene.model.brep.faces.size() == 7);
  check_box(checked(scene, merged_of(scene)), 2);
  const MergedFeatures none = merged_of(scene, thin / 10);
  CHECK(none.gone.empty());
  CHECK(none.moved_vertices == 0);
  CHECK(count_lost(scene.mesh, std::vector<std::uint8_t>(scene.mesh.triangles.size(), 0), none.mesh) == 0);
}

TEST_CASE("a narrow slot closes", "[merge_features]") {
  const ModelScene scene = scene_of(Operation::Subtract, {box({0, 0, 0}, {2, 1, 1}), box({1, -1, 0.5}, {1 + thin, 2, 2})});
  CHECK(scene.model.brep.faces.size() > 6);
  check_box(checked(scene, merged_of(scene)), 2);
}

TEST_CASE("of two blocks with a thin web between them the blocks are left", "[merge_features]") {
  const ModelScene scene =
      scene_of(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({1, 0.25, 0.5}, {2, 0.75, 0.5 + thin}), box({2, 0, 0}, {3, 1, 1})});
  const ModelScene after = checked(scene, merged_of(scene));
  CHECK(after.model.brep.region_count == 3);
  CHECK(exact_volume(after.mesh) == Approx(2).epsilon(1e-2));
}

TEST_CASE("a thin layer between two regions becomes the wall between them", "[merge_features]") {
  const ModelScene scene =
      scene_of(Operation::Partition, {box({0, 0, 0}, {1, 1, 1}), box({0, 0, 1}, {1, 1, 1 + thin}), box({0, 0, 1 + thin}, {1, 1, 2})});
  CHECK(scene.model.brep.region_count == 4);
  const ModelScene after = checked(scene, merged_of(scene));
  CHECK(after.model.brep.region_count == 3);
  CHECK(surface_area(after.mesh) == Approx(11).epsilon(1e-2));
}

TEST_CASE("two sheets close to each other become one", "[merge_features]") {
  const SurfaceMesh one = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const ModelScene scene = scene_of(joined({one, moved(inside_out(one), {0, 0, thin})}));
  CHECK(scene.model.brep.faces.size() == 2);
  const ModelScene after = checked(scene, merged_of(scene));
  CHECK(after.model.brep.faces.size() == 1);
  CHECK(after.mesh.triangles.size() == 2);
}

TEST_CASE("turned blocks keep their balance whatever is merged", "[merge_features]") {
  for (std::size_t seed = 1; seed <= scaled_count(200, 5000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    std::vector<SurfaceMesh> boxes;
    for (int k = 0; k < 3; ++k) {
      const Vec3d lo = random.point(-1, 0), hi = random.point(0.1, 1);
      const double angle = random.between(0, 90);
      boxes.push_back(transform(box(lo, hi), rotation(Axis::Z, angle)));
    }
    const ModelScene scene = scene_of(Operation::Union, boxes);
    const double length = random.between(0.001, 0.2);
    const MergedFeatures merged = merged_of(scene, length);
    CHECK(is_balanced(merged.mesh));
    CHECK(merged.largest_move <= length);
    if (merged.unresolved.empty()) CHECK(count_crossings(merged.mesh) == 0);
  }
}

TEST_CASE("lengths that are none are refused", "[merge_features]") {
  const ModelScene scene = scene_of(box({0, 0, 0}, {1, 1, 1}));
  for (const double length : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    CHECK_THROWS_AS(merged_of(scene, length), Error);
}

TEST_CASE("without the short edges of a CAD part remeshing leaves fewer small angles", "[merge_features][remesh]") {
  if (is_data_missing()) return;
  const ModelScene scene = scene_of(weld(read_data("cad/px4_omniquad_base.stl")).mesh);
  const double h = std::sqrt(surface_area(scene.mesh) * 2.31 / 20000);
  const SizingProxy sizes({}, {.global = h});
  const MergedFeatures merged = merged_of(scene, h / 4);
  const ModelScene after = scene_of(merged.mesh);
  CHECK(is_balanced(after.mesh));
  CHECK(exact_volume(after.mesh) == Approx(exact_volume(scene.mesh)).epsilon(0.02));
  const auto count_small = [&](const ModelScene& s) {
    const RemeshResult result = remesh(s.mesh, s.model, s.normals, sizes);
    return measure_quality(result.mesh, model_after(s, result), sizes).all.below_30;
  };
  CHECK(2 * count_small(after) < count_small(scene));
}
