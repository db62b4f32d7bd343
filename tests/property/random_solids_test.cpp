// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random small solids on a coarse grid, where most contacts are degenerate: exact volumes, order, exact motions and scales.
#include <algorithm>
#include <cmath>

#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation all_operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference};

/// Runs check(solids, random) for many seeds; a failure names the seed.
template <class Check>
void for_random_solids(std::size_t full, std::size_t long_count, std::size_t operands, const Check& check) {
  for (std::size_t seed = 1; seed <= scaled_count(full, long_count); ++seed) {
    INFO("seed " << seed << ", " << operands << " operands");
    RandomSolids random(seed * 1000 + operands);
    check(random.next(operands), random);
  }
}

void check_against_oracle(const std::vector<SurfaceMesh>& solids) {
  const auto operands = pointers_to(solids);
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, solids);
    CHECK(faults_of(operands, result) == "");
    CHECK(oracle::self_crossings(result.mesh).empty());
    CHECK(oracle::volume(result.mesh, exact_positions(operands, result)) == oracle::boolean_volume(operation, operands));
  }
}

template <class Map>
std::vector<SurfaceMesh> each(std::vector<SurfaceMesh> meshes, const Map& map) {
  for (SurfaceMesh& mesh : meshes) mesh = map(std::move(mesh));
  return meshes;
}

/// The map of the result and the result of the maps have the same points, faces and graph.
template <class Map>
void check_commutes(const std::vector<SurfaceMesh>& solids, const Map& map) {
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult before = evaluate(operation, solids), after = evaluate(operation, each(solids, map));
    CHECK(sorted_points(map(before.mesh)) == sorted_points(after.mesh));
    CHECK(before.mesh.triangles.size() == after.mesh.triangles.size());
    CHECK(before.graph.edges.size() == after.graph.edges.size());
    CHECK(before.graph.closed_loops == after.graph.closed_loops);
    CHECK(before.graph.open_chains == after.graph.open_chains);
  }
}

}  // namespace

TEST_CASE("pairs of random solids have exactly the oracle's volumes and no fault") {
  for_random_solids(1000, 20000, 2, [](const auto& solids, RandomSolids&) { check_against_oracle(solids); });
}

TEST_CASE("three and four random solids have exactly the oracle's volumes and no fault") {
  for_random_solids(200, 4000, 3, [](const auto& solids, RandomSolids&) { check_against_oracle(solids); });
  for_random_solids(20, 400, 4, [](const auto& solids, RandomSolids&) { check_against_oracle(solids); });
}

TEST_CASE("made vertices of pairs of random solids are the oracle's points") {
  for_random_solids(60, 2000, 2, [](const auto& solids, RandomSolids&) {
    const std::vector<oracle::MadePoint> points = oracle::made_points(pointers_to(solids));
    const BooleanResult result = evaluate(Operation::Union, solids);
    for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
      if (result.provenance.vertex_source[v] != Provenance::none) continue;
      CHECK(std::any_of(points.begin(), points.end(), [&](const auto& made) { return made.rounded == result.mesh.points[v]; }));
    }
  });
}

TEST_CASE("results of many random solids keep the rules of inclusion and exclusion with one solid more") {
  // V(all or x) + V(all and x) = V(all) + V(x), where `all` is a result that was rounded: its faces are nearly coplanar with those of x.
  const auto check = [](const BooleanResult& result) { CHECK(faults_of_mesh(result) == ""); };
  for_random_solids(30, 1000, 8, [&](const auto& solids, RandomSolids& random) {
    const SurfaceMesh all = evaluate(Operation::Union, solids).mesh, more = random.next();
    const BooleanResult either = evaluate(Operation::Union, {all, more}), both = evaluate(Operation::Intersect, {all, more});
    check(either);
    check(both);
    const double sum = exact_volume(all) + exact_volume(more);
    CHECK(exact_volume(either.mesh) + exact_volume(both.mesh) == Approx(sum).epsilon(1e-12));
  });
}

TEST_CASE("the order of random operands does not change the result") {
  for_random_solids(60, 2000, 5, [](auto solids, RandomSolids& random) {
    const BooleanResult all = evaluate(Operation::Union, solids), rest = evaluate(Operation::Subtract, solids);
    std::vector<SurfaceMesh> others(solids.begin() + 1, solids.end());
    random.shuffle(others);
    others.insert(others.begin(), solids[0]);
    const BooleanResult same_rest = evaluate(Operation::Subtract, others);
    random.shuffle(solids);
    const BooleanResult same_all = evaluate(Operation::Union, solids);
    CHECK(sorted_points(all.mesh) == sorted_points(same_all.mesh));
    CHECK(all.mesh.triangles.size() == same_all.mesh.triangles.size());
    CHECK(sorted_points(rest.mesh) == sorted_points(same_rest.mesh));
    CHECK(rest.mesh.triangles.size() == same_rest.mesh.triangles.size());
  });
}

TEST_CASE("the numbering of faces and vertices does not change the result") {
  for_random_solids(60, 2000, 3, [](const auto& solids, RandomSolids& random) {
    std::vector<SurfaceMesh> shuffled;
    for (const SurfaceMesh& solid : solids) shuffled.push_back(renumbered(solid, random));
    for (const Operation operation : all_operations) {
      const BooleanResult one = evaluate(operation, solids), other = evaluate(operation, shuffled);
      CHECK(sorted_points(one.mesh) == sorted_points(other.mesh));
      CHECK(one.mesh.triangles.size() == other.mesh.triangles.size());
      CHECK(one.graph.edges.size() == other.graph.edges.size());
    }
  });
}

TEST_CASE("quarter turns turn the result, bit for bit") {
  for_random_solids(40, 1000, 3, [](const auto& solids, RandomSolids&) {
    check_commutes(solids, [](SurfaceMesh mesh) { return quarter_turned(std::move(mesh)); });
    check_commutes(solids, [](SurfaceMesh mesh) { return with_axes_turned(std::move(mesh)); });
  });
}

TEST_CASE("scales by 2^300 and 2^-300 scale the result, bit for bit") {
  for (const int exponent : {300, -300}) {
    for_random_solids(40, 1000, 3, [&](const auto& solids, RandomSolids&) {
      check_commutes(solids, [&](SurfaceMesh mesh) { return scaled(std::move(mesh), std::ldexp(1.0, exponent)); });
    });
  }
}

TEST_CASE("a far translation keeps every count, exactly") {
  // The made points round otherwise; what meets what stays the same.
  for_random_solids(40, 1000, 3, [](const auto& solids, RandomSolids&) {
    const auto far = each(solids, [](SurfaceMesh mesh) { return moved(std::move(mesh), {0x1p20, -0x1p20, 0x1p19}); });
    for (const Operation operation : all_operations) {
      const BooleanResult here = evaluate(operation, solids), there = evaluate(operation, far);
      CHECK(here.mesh.triangles.size() == there.mesh.triangles.size());
      CHECK(here.mesh.points.size() == there.mesh.points.size());
      CHECK(here.graph.edges.size() == there.graph.edges.size());
      CHECK(oracle::volume(there.mesh, exact_positions(pointers_to(far), there)) == oracle::boolean_volume(operation, pointers_to(solids)));
    }
  });
}
