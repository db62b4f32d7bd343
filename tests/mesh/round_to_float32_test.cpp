// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What rounding to float32 makes of a mesh, and what is cleaned up after it.
#include "mortise/mesh/round_to_float32.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/mesh/inspect.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

/// The unit cube with a vertex on one side of its top, `dip` below the edge from (0, 0, 1) to (1, 0, 1): two thin faces fill the dip.
SurfaceMesh cube_with_dip(double dip) {
  SurfaceMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  const VertexId left(4), right(5), low(mesh.points.size());
  mesh.points.push_back({0.5, 0, 1 - dip});
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle t = mesh.triangles[f];
      if (t[k] != right || t[(k + 1) % 3] != left || mesh.points[t[(k + 2) % 3].index()].z == 1) continue;
      mesh.triangles[f] = {right, low, t[(k + 2) % 3]};
      mesh.triangles.push_back({low, left, t[(k + 2) % 3]});
      mesh.triangles.push_back({right, left, low});
      return mesh;
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("A mesh of float32 coordinates keeps all its bits", "[mesh][float32]") {
  const SurfaceMesh mesh = test::box({-0.5, 0.25, 1}, {0.1F, 3, 1e30F});
  CHECK(test::has_same_bits(round_to_float32(mesh), mesh));
}

TEST_CASE("Every coordinate goes to the nearest float32", "[mesh][float32]") {
  const SurfaceMesh mesh = round_to_float32(test::box({0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}));
  CHECK(mesh.points[0] == Vec3d{0.1F, 0.2F, 0.3F});
  CHECK(mesh.points[7] == Vec3d{1.1F, 1.2F, 1.3F});
}

TEST_CASE("Faces that lose a corner go, and the mesh stays closed", "[mesh][float32]") {
  // Two corners of each end fall together: the two faces of the side between them go, and one of each end.
  const SurfaceMesh wedge = test::prism({{0, 0}, {1, 0}, {1 + 1e-12, 0}, {0, 1}}, 0, 1);
  const SurfaceMesh rounded = round_to_float32(wedge);
  const MeshReport report = inspect(rounded);
  CHECK(wedge.triangles.size() == 12);
  CHECK(rounded.triangles.size() == 8);
  CHECK(report.closed);
  CHECK(report.self_intersections == 0);
}

TEST_CASE("A face that becomes a line gives its long side another diagonal", "[mesh][float32]") {
  const SurfaceMesh dipped = cube_with_dip(1e-9);
  REQUIRE(inspect(dipped).closed);
  REQUIRE(dipped.triangles.size() == 14);
  const SurfaceMesh rounded = round_to_float32(dipped);
  const MeshReport report = inspect(rounded);
  CHECK(rounded.triangles.size() == 14);
  CHECK(report.closed);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.self_intersections == 0);
  CHECK(report.volume == 1.0);
}

TEST_CASE("Labels follow the faces", "[mesh][float32]") {
  SurfaceMesh wedge = test::prism({{0, 0}, {1, 0}, {1 + 1e-12, 0}, {0, 1}}, 0, 1);
  wedge.label_names = {"end", "side"};
  for (std::size_t f = 0; f < wedge.triangles.size(); ++f) wedge.face_labels.push_back(f < 4 ? 0 : 1);
  const SurfaceMesh rounded = round_to_float32(wedge);
  REQUIRE(rounded.face_labels.size() == rounded.triangles.size());
  CHECK(std::count(rounded.face_labels.begin(), rounded.face_labels.end(), 0U) == 2);
}

TEST_CASE("What no float32 holds is refused by vertex", "[mesh][float32]") {
  const double largest = static_cast<double>(std::numeric_limits<float>::max());
  CHECK_NOTHROW(round_to_float32(test::box({0, 0, 0}, {1, 1, largest})));
  try {
    (void)round_to_float32(test::box({0, 0, 0}, {1, 1, 2 * largest}));
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::OutOfRange);
    CHECK(error.ids == std::vector<std::uint32_t>{4, 5, 6, 7});
  }
}

}  // namespace mortise
