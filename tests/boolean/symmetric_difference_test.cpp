// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What lies in an odd number of operands: volumes exactly, facets turned inwards, real meshes.
#include <algorithm>
#include <cmath>

#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/random_solids.h"
#include "support/scene_list.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

oracle::Rational exact_volume_of(Operation operation, const std::vector<SurfaceMesh>& solids) {
  const BooleanResult result = evaluate(operation, solids);
  return oracle::volume(result.mesh, exact_positions(pointers_to(solids), result));
}

}  // namespace

TEST_CASE("a symmetric difference is the union less the intersection, exactly") {
  for (std::size_t seed = 1; seed <= scaled_count(200, 4000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(2);
    const BooleanResult odd = evaluate(Operation::SymmetricDifference, solids);
    CHECK(faults_of(pointers_to(solids), odd) == "");
    CHECK(oracle::volume(odd.mesh, exact_positions(pointers_to(solids), odd)) ==
          exact_volume_of(Operation::Union, solids) - exact_volume_of(Operation::Intersect, solids));
  }
}

TEST_CASE("of two operands, the facets inside the other are turned over by a symmetric difference") {
  const BooleanResult odd = symmetric_difference(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
  CHECK(exact_volume(odd.mesh) == 14);
  for (std::size_t f = 0; f < odd.mesh.triangles.size(); ++f) {
    CHECK((odd.provenance.flipped[f] != 0) == (odd.provenance.category[f] == FacetCategory::Inside));
  }
}

TEST_CASE("a solid and itself have no symmetric difference, and three times itself has itself") {
  const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
  CHECK(symmetric_difference(unit, unit).mesh.triangles.empty());
  CHECK(exact_volume(evaluate(Operation::SymmetricDifference, {unit, unit, unit}).mesh) == 1);
}

TEST_CASE("symmetric differences of real meshes are unions less intersections", "[scenario]") {
  if (is_data_missing()) return;
  for (const ListedScene& scene : listed_scenes()) {
    if (!scene.needs_data || scene.operands.size() != 2 || !scene.has_figures) continue;
    const SurfaceMesh a = load_operand(scene.operands[0]), b = load_operand(scene.operands[1]);
    if (a.triangles.size() + b.triangles.size() > (is_reduced_run() ? 5000U : 200000U)) continue;
    INFO(scene.name);
    const BooleanResult odd = symmetric_difference(a, b);
    CHECK(faults_of_mesh(odd) == "");
    const double expected = exact_volume(unite(a, b).mesh) - exact_volume(intersect(a, b).mesh);
    const Shape shape = shape_of(odd.mesh);
    const double coordinate = std::max(largest_coordinate(a), largest_coordinate(b));
    CHECK(std::abs(shape.volume - expected) <=
          3 * identity_tolerance(exact_volume(a) + exact_volume(b), shape.area, odd.report, coordinate));
  }
}
