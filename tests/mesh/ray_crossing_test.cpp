// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Windings by rays that start on corners, edges and in planes of what they count.
#include "mortise/mesh/ray_crossing.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

int winding(const SurfaceMesh& mesh, const RayStart& start) {
  int sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += winding_step(mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()], start);
  }
  return sum;
}

}  // namespace

TEST_CASE("a ray in general position counts inside once", "[ray_crossing]") {
  const SurfaceMesh mesh = box({0, 0, 0}, {4, 4, 4});
  CHECK(winding(mesh, {{1, 2, 1}, {1.5, 2, 1}, {1, 2.5, 1}}) == 1);
  CHECK(winding(mesh, {{5, 2, 1}, {5.5, 2, 1}, {5, 2.5, 1}}) == 0);
  CHECK(winding(inside_out(mesh), {{1, 2, 1}, {1.5, 2, 1}, {1, 2.5, 1}}) == -1);
}

TEST_CASE("a ray along faces, edges and through corners counts once", "[ray_crossing]") {
  const SurfaceMesh mesh = box({0, 0, 0}, {4, 4, 4});
  // Beyond the box, at the height of its sides, edges and corners: a step into or out of the shadow decides.
  for (const double y : {0.0, 2.0, 4.0}) {
    for (const double z : {0.0, 2.0, 4.0}) {
      CAPTURE(y, z);
      CHECK(winding(mesh, {{9, y, z}, {9, 2, 2}, {9, 2, 3}}) == 0);
      CHECK(winding(mesh, {{2, y, z}, {2, 2, 2}, {2, 2, 3}}) == 1);
      CHECK(winding(mesh, {{-1, y, z}, {-1, 2, 2}, {-1, 2, 3}}) == 0);
    }
  }
}

TEST_CASE("a ray that starts next to a corner knows on which side it starts", "[ray_crossing]") {
  const SurfaceMesh mesh = box({0, 0, 0}, {4, 4, 4});
  for (const double x : {0.0, 4.0}) {
    for (const double y : {0.0, 4.0}) {
      for (const double z : {0.0, 4.0}) {
        CAPTURE(x, y, z);
        const Vec3d corner{x, y, z};
        CHECK(winding(mesh, {corner, {2, 2, 2}, {2, 2, 3}}) == 1);
        CHECK(winding(mesh, {corner, {2 * x - 2, 2, 2}, {2 * x - 2, 2, 3}}) == 0);
        CHECK(winding(mesh, {corner, {2, 2 * y - 2, 2}, {2, 2 * y - 2, 3}}) == 0);
        CHECK(winding(mesh, {corner, {2, 2, 2 * z - 2}, {3, 2, 2 * z - 2}}) == 0);
      }
    }
  }
}

TEST_CASE("a ray that starts next to an edge goes by its third point", "[ray_crossing]") {
  const SurfaceMesh mesh = box({0, 0, 0}, {4, 4, 4});
  CHECK(winding(mesh, {{4, 4, 1}, {4, 4, 3}, {3, 3, 2}}) == 1);
  CHECK(winding(mesh, {{4, 4, 1}, {4, 4, 3}, {5, 3, 2}}) == 0);
  CHECK(winding(mesh, {{4, 4, 1}, {4, 4, 3}, {3, 5, 2}}) == 0);
  CHECK(winding(mesh, {{0, 0, 1}, {0, 0, 3}, {1, 1, 2}}) == 1);
  CHECK(winding(mesh, {{0, 0, 1}, {0, 0, 3}, {-1, 1, 2}}) == 0);
}
