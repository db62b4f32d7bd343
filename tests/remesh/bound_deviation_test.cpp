// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// No point of a remeshed surface is farther from the given one than the bound, nor the other way round.
#include <algorithm>
#include <cmath>

#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/remesh/beyond_bound.h"
#include "support/catch.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

std::vector<PlaceBeyond> beyond(const SurfaceMesh& mesh, const SurfaceMesh& other, double bound) {
  const std::vector<ModelFaceId> one(mesh.triangles.size(), ModelFaceId(0)), two(other.triangles.size(), ModelFaceId(0));
  return find_beyond({mesh, one}, {other, two}, bound);
}

SurfaceMesh lifted(SurfaceMesh mesh, double z) {
  for (Vec3d& p : mesh.points) p.z += z;
  return mesh;
}

SurfaceMesh one_triangle(double z) { return make_mesh({{0, 0, z}, {3, 0, z}, {0, 3, z}}, {{0, 1, 2}}); }

}  // namespace

TEST_CASE("one large triangle lies on many small ones, and beyond a bound above them", "[remesh]") {
  const SurfaceMesh sheet = lifted(make_grid_sheet(8, 8, 40, 40), 0), middle = one_triangle(0);
  const double least = bounding_box(sheet).lo.x;
  SurfaceMesh triangle = middle;
  for (Vec3d& p : triangle.points) p = p + Vec3d{least + 1.0 / 3, least + 2.0 / 7, 0};
  CHECK(beyond(triangle, sheet, 1e-9).empty());
  CHECK(beyond(lifted(triangle, 0.1), sheet, 0.1001).empty());
  const std::vector<PlaceBeyond> places = beyond(lifted(triangle, 0.1), sheet, 0.0999);
  REQUIRE(places.size() == 1);
  CHECK(places[0].distance == Approx(0.1));
  CHECK(beyond(sheet, triangle, 1e-3).size() > 3000);  // all but those under it
}

TEST_CASE("a needle between the places a few samples look at is found", "[remesh]") {
  // A flat square, and one with a thin spike of height 1 near a corner, away from vertices, middles and centroids of the first.
  const SurfaceMesh flat = make_mesh({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}});
  SurfaceMesh spiked = make_grid_sheet(4, 4, 40, 40);
  const Box3 box = bounding_box(spiked);
  for (Vec3d& p : spiked.points) {
    p = p - box.lo;
    if (std::fabs(p.x - 3.1) < 0.01 && std::fabs(p.y - 0.7) < 0.01) p.z = 1;
  }
  CHECK(beyond(flat, spiked, 0.2).empty());  // it can be reached from the sides of the spike
  const std::vector<PlaceBeyond> places = beyond(spiked, flat, 0.5);
  CHECK(places.size() == 6);
  for (const PlaceBeyond& place : places) CHECK(place.distance > 0.5);
  CHECK(beyond(spiked, flat, 1.0001).empty());
}

TEST_CASE("the same surface in other triangles is within any bound, a face that is not there beyond it", "[remesh]") {
  const SurfaceMesh coarse = make_cylinder(1, 4, 12);
  CHECK(beyond(coarse, coarse, 1e-9).empty());
  const std::vector<ModelFaceId> faces(coarse.triangles.size(), ModelFaceId(0)), others(coarse.triangles.size(), ModelFaceId(1));
  const std::vector<PlaceBeyond> places = find_beyond({coarse, faces}, {coarse, others}, 1);
  REQUIRE(places.size() == coarse.triangles.size());
  CHECK(std::isinf(places[0].distance));
  CHECK_FALSE(places[0].closest.is_valid());
}

TEST_CASE("a bound on the deviation is kept everywhere, by triangles as good as without", "[remesh]") {
  struct Scene {
    SurfaceMesh mesh;
    double size, bound;
  };
  const Scene scenes[] = {
      {make_cylinder(1, 4, 12), 0.5, 0.03}, {make_icosphere(1, 4), 0.3, 0.01}, {make_torus(2, 0.7, 60, 30), 0.25, 0.01}};
  for (const Scene& scene : scenes) {
    const ModelScene given = scene_of(scene.mesh);
    const SizingProxy sizes({}, {.global = scene.size});
    RemeshRules bounded;
    bounded.most_deviation = scene.bound;
    const RemeshResult free = remesh(given.mesh, given.model, given.normals, sizes),
                       result = remesh(given.mesh, given.model, given.normals, sizes, bounded);
    CHECK(free.refinement.empty());
    CHECK_FALSE(result.refinement.empty());
    CHECK(result.kept.empty());
    const auto farthest = [&](const RemeshResult& of) {
      const Deviation d = deviation_after(given, of, sizes);
      return std::max(d.to_reference.greatest, d.from_reference.greatest);
    };
    CHECK(farthest(free) > scene.bound);
    CHECK(farthest(result) <= scene.bound);
    const ClassifiedBrep after = model_after(given, result);
    CHECK(find_faults(result.mesh, after).empty());
    CHECK(count_crossings(result.mesh) == 0);
    CHECK(measure_quality(result.mesh, after, sizes.with(result.refinement)).all.below_30 == 0);
  }
}

TEST_CASE("where smaller triangles do not help, those given stay", "[remesh]") {
  // A sheet with a spike that triangles of the size cannot hold.
  SurfaceMesh spiked = make_grid_sheet(4, 4, 40, 40);
  for (Vec3d& p : spiked.points) p.z = 0;
  spiked.points[41 * 20 + 20].z = 1;
  BrepRules rules = without_seams();
  rules.features.face_angle_deg = 180;
  const ModelScene given = scene_of(spiked, rules);
  REQUIRE(given.model.brep.faces.size() == 1);
  RemeshRules bounded;
  bounded.most_deviation = 0.02;
  const RemeshResult result = remesh(given.mesh, given.model, given.normals, SizingProxy({}, {.global = 0.5}), bounded);
  CHECK(find_faults(result.mesh, model_after(given, result)).empty());
  const FacedMesh now{result.mesh, result.classification.face_of_triangle}, before{spiked, given.model.classification.face_of_triangle};
  CHECK(find_beyond(now, before, 0.02).empty());
  CHECK(find_beyond(before, now, 0.02).empty());
  CHECK(result.mesh.triangles.size() < spiked.triangles.size());
  CHECK(result.kept.size() < spiked.triangles.size());
}

TEST_CASE("a bound that is no length is refused", "[remesh]") {
  const ModelScene ball = scene_of(make_icosphere(1, 2));
  for (const double bound : {0.0, -1.0, std::nan("")}) {
    RemeshRules rules;
    rules.most_deviation = bound;
    CHECK_THROWS_AS(remesh(ball.mesh, ball.model, ball.normals, SizingProxy({}, {.global = 0.5}), rules), Error);
  }
}
