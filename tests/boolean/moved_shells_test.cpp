// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The exact sense of shells against the volume of their doubles.
#include "mortise/boolean/moved_shells.h"

#include <algorithm>
#include <array>
#include <set>

#include "boolean/evaluation.h"
#include "mortise/base/union_find.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/grid_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

FaceId first_of_shell(const SurfaceMesh& mesh, FaceId f) {
  UnionFind joined(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    joined.join(t[0].value, t[1].value);
    joined.join(t[1].value, t[2].value);
  }
  const auto shell_of = [&](const Triangle& t) { return joined.find(t[0].value); };
  const std::uint32_t shell = shell_of(mesh.triangles[f.index()]);
  const auto first = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) { return shell_of(t) == shell; });
  return FaceId(static_cast<std::size_t>(first - mesh.triangles.begin()));
}

/// The first triangle of each shell, as if all vertices but `still` had moved, any distance.
std::vector<FaceId> turned_shells(const MergedScene& scene, const std::vector<std::size_t>& still = {}) {
  std::vector<std::uint8_t> is_moved(scene.merged.mesh.points.size(), 1);
  for (const std::size_t v : still) is_moved[v] = 0;
  std::vector<FaceId> shells = find_turned_shells(scene.faces, scene.facets, scene.merged, is_moved, 100);
  for (FaceId& f : shells) f = first_of_shell(scene.merged.mesh, f);
  return shells;
}

void mirror(SurfaceMesh& mesh, std::size_t from = 0) {
  for (std::size_t v = from; v < mesh.points.size(); ++v) mesh.points[v].x = -mesh.points[v].x;
}

}  // namespace

TEST_CASE("a shell keeps its sense as it is, and loses it in the mirror") {
  MergedScene scene(Operation::Union, {unit});
  CHECK(turned_shells(scene).empty());
  mirror(scene.merged.mesh);
  CHECK(turned_shells(scene) == std::vector<FaceId>{FaceId(0)});
}

TEST_CASE("a shell with a vertex that did not move is judged, one without a vertex that moved is not") {
  MergedScene scene(Operation::Union, {unit});
  mirror(scene.merged.mesh);
  CHECK(turned_shells(scene, {3}) == std::vector<FaceId>{FaceId(0)});
  CHECK(turned_shells(scene, {0, 1, 2, 3, 4, 5, 6, 7}).empty());
}

TEST_CASE("a shell is judged only where it is as thin as its surface may have moved") {
  MergedScene scene(Operation::Union, {unit});
  mirror(scene.merged.mesh);
  const std::vector<std::uint8_t> is_moved(8, 1);
  CHECK(find_turned_shells(scene.faces, scene.facets, scene.merged, is_moved, 0.01).empty());
  CHECK(find_turned_shells(scene.faces, scene.facets, scene.merged, is_moved, 1).size() == 1);
}

TEST_CASE("each shell is judged by itself") {
  MergedScene scene(Operation::Union, {unit, moved(unit, {5, 0, 0})});
  mirror(scene.merged.mesh, 8);
  CHECK(turned_shells(scene) == std::vector<FaceId>{FaceId(12)});
  CHECK(turned_shells(scene, {0}) == std::vector<FaceId>{FaceId(12)});
  CHECK(turned_shells(scene, {8, 9, 10, 11, 12, 13, 14, 15}).empty());
}

TEST_CASE("a shell is named by its triangle at the lowest place, whatever the numbers") {
  const SurfaceMesh other = moved(unit, {0.5, 0.5, 0.5});
  for (const std::vector<SurfaceMesh>& operands : {std::vector{unit, other}, std::vector{other, unit}}) {
    MergedScene scene(Operation::Union, operands);
    mirror(scene.merged.mesh);
    const std::vector<std::uint8_t> is_moved(scene.merged.mesh.points.size(), 1);
    const std::vector<FaceId> named = find_turned_shells(scene.faces, scene.facets, scene.merged, is_moved, 100);
    REQUIRE(named.size() == 1);
    std::set<std::array<double, 3>> corners;
    for (const VertexId v : scene.merged.mesh.triangles[named[0].index()]) {
      const Vec3d& p = scene.merged.mesh.points[v.index()];
      corners.insert({p.x, p.y, p.z});
    }
    CHECK(corners.count({-1.5, 0.5, 0.5}) == 1);
    CHECK(corners.count({-1.5, 0.5, 1.5}) == 1);
  }
}

TEST_CASE("the wall of a cavity faces inwards, and is turned when it does no more") {
  MergedScene scene(Operation::Subtract, {box({-2, -2, -2}, {3, 3, 3}), unit});
  CHECK(turned_shells(scene).empty());
  mirror(scene.merged.mesh, 8);
  CHECK(turned_shells(scene) == std::vector<FaceId>{FaceId(12)});
}

TEST_CASE("a shell whose doubles enclose nothing is turned") {
  MergedScene scene(Operation::Union, {unit});
  for (Vec3d& p : scene.merged.mesh.points) p.z = 0;
  CHECK(turned_shells(scene) == std::vector<FaceId>{FaceId(0)});
}

TEST_CASE("shells of triangles connected through a vertex are one") {
  MergedScene scene(Operation::Union, {joined({unit, moved(unit, {1, 1, 1})})});
  CHECK(turned_shells(scene).empty());
  mirror(scene.merged.mesh);
  CHECK(turned_shells(scene).size() == 1);
}

TEST_CASE("the regions of a partition that hang together keep their sense, or lose it, together") {
  for (const SurfaceMesh& other : {moved(unit, {1, 0, 0}), moved(unit, {0.5, 0.5, 0.5}), box({0.25, 0.25, 0}, {0.5, 0.5, 0.5})}) {
    MergedScene scene(Operation::Partition, {unit, other});
    CHECK(turned_shells(scene).empty());
    mirror(scene.merged.mesh);
    CHECK(turned_shells(scene) == std::vector<FaceId>{FaceId(0)});
  }
}

TEST_CASE("regions inside a region keep their sense, or lose it") {
  MergedScene scene(Operation::Partition, {box({-5, -5, -5}, {6, 6, 6}), unit, moved(unit, {1, 0, 0})});
  CHECK(turned_shells(scene).empty());
  mirror(scene.merged.mesh, 8);
  CHECK(turned_shells(scene) == std::vector<FaceId>{FaceId(12)});
}

TEST_CASE("a region of a partition without volume in doubles is turned") {
  MergedScene scene(Operation::Partition, {unit, box({1, 0, 0}, {2, 1, 1})});
  for (Vec3d& p : scene.merged.mesh.points) p.x = std::min(p.x, 1.0);
  CHECK(turned_shells(scene).size() == 1);
}

TEST_CASE("shells of results of random solids have their sense, whichever way they lie") {
  constexpr std::uint32_t seed = 3;
  INFO("seed " << seed);
  GridSolids random(seed);
  std::size_t shells = 0;
  for (std::size_t i = 0, n = scaled_count(150, 10000); i < n; ++i) {
    INFO("case " << i);
    const std::array operations{Operation::Union, Operation::Intersect, Operation::Subtract, Operation::Partition};
    MergedScene scene(operations[static_cast<std::size_t>(random.below(4))], {random.solid(3), random.solid(3)});
    CHECK(turned_shells(scene).empty());
    mirror(scene.merged.mesh);
    shells += turned_shells(scene).size();
    CHECK((turned_shells(scene).empty() == scene.merged.mesh.triangles.empty()));
  }
  CHECK(shells > scaled_count(150, 10000) / 2);
}
