// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Regions of closed meshes: bodies, cavities, bodies in cavities, touching bodies.
#include "mortise/mesh/find_regions.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

std::vector<double> volumes_of(const MeshRegions& regions) {
  std::vector<double> volumes;
  for (const MeshRegion& r : regions.regions) volumes.push_back(r.volume);
  return volumes;
}

}  // namespace

TEST_CASE("a mesh without triangles has no region", "[find_regions]") { CHECK(find_regions(SurfaceMesh()).regions.empty()); }

TEST_CASE("a body and its cavities are one region", "[find_regions]") {
  const MeshRegions found =
      find_regions(joined({box({0, 0, 0}, {8, 8, 8}), inside_out(box({1, 1, 1}, {3, 3, 3})), inside_out(box({5, 5, 5}, {6, 6, 6}))}));
  REQUIRE(volumes_of(found) == std::vector<double>{512 - 8 - 1});
  CHECK(found.regions[0].area == 6 * 64 + 6 * 4 + 6 * 1);
  CHECK(found.region_of_face == std::vector<std::uint32_t>(36, 0));
}

TEST_CASE("a body in a cavity is a region of its own, and its cavity belongs to it", "[find_regions]") {
  const MeshRegions found =
      find_regions(joined({inside_out(box({1, 1, 1}, {9, 9, 9})), box({0, 0, 0}, {10, 10, 10}), box({2, 2, 2}, {6, 6, 6}),
                           inside_out(box({3, 3, 3}, {4, 4, 4})), box({20, 0, 0}, {21, 1, 1})}));
  REQUIRE(volumes_of(found) == std::vector<double>{1000 - 512, 64 - 1, 1});
  CHECK(found.region_of_face[0] == 0);
  CHECK(found.region_of_face[12] == 0);
  CHECK(found.region_of_face[24] == 1);
  CHECK(found.region_of_face[36] == 1);
  CHECK(found.region_of_face[48] == 2);
}

TEST_CASE("bodies that share an edge or a corner are two regions", "[find_regions]") {
  const SurfaceMesh along_edge = evaluate(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}).mesh;
  CHECK(along_edge.points.size() == 14);
  CHECK(volumes_of(find_regions(along_edge)) == std::vector<double>{1, 1});
  const SurfaceMesh at_corner = evaluate(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})}).mesh;
  CHECK(at_corner.points.size() == 15);
  CHECK(volumes_of(find_regions(at_corner)) == std::vector<double>{1, 1});
}

TEST_CASE("cavities that share an edge leave one region", "[find_regions]") {
  const SurfaceMesh mesh =
      evaluate(Operation::Subtract, {box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 3}), box({2, 2, 1}, {3, 3, 3})}).mesh;
  CHECK(volumes_of(find_regions(mesh)) == std::vector<double>{64 - 4});
}

TEST_CASE("a cavity that touches its body from inside belongs to it", "[find_regions]") {
  // The corner of the octahedron lies in the side of the box.
  const SurfaceMesh mesh = evaluate(Operation::Subtract, {box({0, 0, 0}, {8, 8, 8}), octahedron({4, 4, 2}, 2)}).mesh;
  const MeshRegions found = find_regions(mesh);
  REQUIRE(found.regions.size() == 1);
  CHECK(found.regions[0].volume == Approx(512 - 4.0 / 3 * 8).epsilon(1e-14));
}
