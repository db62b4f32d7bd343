// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Regions of results and who covers them; categories of facets.
#include "mortise/boolean/result_regions.h"

#include <map>

#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Operands = std::vector<std::uint32_t>;

std::map<FacetCategory, double> area_by_category(const BooleanResult& result) {
  std::map<FacetCategory, double> area;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const Triangle& t = result.mesh.triangles[f];
    const Vec3d& p = result.mesh.points[t[0].index()];
    const Vec3d n = cross(result.mesh.points[t[1].index()] - p, result.mesh.points[t[2].index()] - p);
    area[result.provenance.category[f]] += std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) / 2;  // axis-aligned faces
  }
  return area;
}

}  // namespace

TEST_CASE("a difference is covered by its first operand only", "[result_regions]") {
  const BooleanResult result = evaluate(Operation::Subtract, {box({0, 0, 0}, {6, 2, 2}), box({2, -1, -1}, {4, 3, 3})});
  const ResultRegions found = find_result_regions(result);
  REQUIRE(found.regions.size() == 2);
  for (const ResultRegion& r : found.regions) {
    CHECK(r.operands == Operands{0});
    CHECK(r.volume == 8);
    CHECK(r.area == 24);
  }
  const auto area = area_by_category(result);
  CHECK(area == std::map<FacetCategory, double>{{FacetCategory::Outside, 40}, {FacetCategory::Inside, 8}});
}

TEST_CASE("a union names the operands that cover each region from inside", "[result_regions]") {
  const BooleanResult result =
      evaluate(Operation::Union, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}), box({10, 0, 0}, {11, 1, 1})});
  const ResultRegions found = find_result_regions(result);
  REQUIRE(found.regions.size() == 2);
  CHECK(found.regions[0].operands == Operands{0, 1});
  CHECK(found.regions[0].volume == 15);
  CHECK(found.regions[1].operands == Operands{2});
  CHECK(area_by_category(result) == std::map<FacetCategory, double>{{FacetCategory::Outside, 42 + 6}});
}

TEST_CASE("an intersection is covered by all operands", "[result_regions]") {
  const BooleanResult result =
      evaluate(Operation::Intersect, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}), box({0, 0, 0}, {9, 9, 9})});
  const ResultRegions found = find_result_regions(result);
  REQUIRE(found.regions.size() == 1);
  CHECK(found.regions[0].operands == Operands{0, 1, 2});
  CHECK(found.regions[0].volume == 1);
  CHECK(area_by_category(result) == std::map<FacetCategory, double>{{FacetCategory::Inside, 6}});
}

TEST_CASE("coincident faces are named by their sense", "[result_regions]") {
  const SurfaceMesh a = box({0, 0, 0}, {2, 2, 2});
  const SurfaceMesh flush = box({0, 0, 0}, {1, 1, 1});
  const SurfaceMesh beside = box({2, 0, 0}, {3, 2, 2});
  CHECK(area_by_category(evaluate(Operation::Union, {a, flush})) ==
        std::map<FacetCategory, double>{{FacetCategory::Outside, 21}, {FacetCategory::OnSame, 3}});
  CHECK(area_by_category(evaluate(Operation::Subtract, {a, beside})) ==
        std::map<FacetCategory, double>{{FacetCategory::Outside, 20}, {FacetCategory::OnOpposite, 4}});
}
