// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every small scene, every operation: exact volumes, made points, provenance, order of operands.
#include <algorithm>

#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/self_crossing_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation all_operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference};

template <class Check>
void for_each_result(const Check& check) {
  for (const Scene& scene : small_scenes()) {
    for (const Operation operation : all_operations) {
      INFO(scene.name << ", " << operation_name(operation));
      check(scene, operation, evaluate(operation, scene.operands));
    }
  }
}

std::vector<Vec3d> input_points(const Scene& scene) {
  std::vector<Vec3d> points;
  for (const SurfaceMesh& operand : scene.operands) points.insert(points.end(), operand.points.begin(), operand.points.end());
  return points;
}

}  // namespace

TEST_CASE("results of the small scenes are closed, oriented, certified, and their provenance is right") {
  for_each_result(
      [](const Scene& scene, Operation, const BooleanResult& result) { CHECK(faults_of(pointers_to(scene.operands), result) == ""); });
}

TEST_CASE("results of the small scenes have no face through another") {
  for_each_result([](const Scene&, Operation, const BooleanResult& result) { CHECK(oracle::self_crossings(result.mesh).empty()); });
}

TEST_CASE("volumes of the small scenes before rounding equal the oracle's exactly") {
  for_each_result([](const Scene& scene, Operation operation, const BooleanResult& result) {
    const auto operands = pointers_to(scene.operands);
    CHECK(oracle::volume(result.mesh, exact_positions(operands, result)) == oracle::boolean_volume(operation, operands));
  });
}

TEST_CASE("volumes of the small scenes after rounding equal the oracle's but for the displacement") {
  for_each_result([](const Scene& scene, Operation operation, const BooleanResult& result) {
    const auto operands = pointers_to(scene.operands);
    double volumes = 0, coordinate = 0;
    for (const SurfaceMesh* operand : operands) {
      volumes += exact_volume(*operand);
      coordinate = std::max(coordinate, largest_coordinate(*operand));
    }
    const Shape shape = shape_of(result.mesh);
    const double expected = oracle::nearest_double(oracle::boolean_volume(operation, operands));
    CHECK(std::abs(shape.volume - expected) <= identity_tolerance(volumes, shape.area, result.report, coordinate));
  });
}

TEST_CASE("every made vertex of the small scenes is the oracle's correctly rounded point, bit for bit") {
  std::size_t made = 0;
  for (const Scene& scene : small_scenes()) {
    const std::vector<oracle::MadePoint> points = oracle::made_points(pointers_to(scene.operands));
    for (const Operation operation : all_operations) {
      INFO(scene.name << ", " << operation_name(operation));
      const BooleanResult result = evaluate(operation, scene.operands);
      for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
        if (result.provenance.vertex_source[v] != Provenance::none) continue;
        ++made;
        const Vec3d& p = result.mesh.points[v];
        INFO("vertex " << v << " at " << p.x << ", " << p.y << ", " << p.z);
        CHECK(std::any_of(points.begin(), points.end(), [&](const oracle::MadePoint& m) { return m.rounded == p; }));
      }
    }
  }
  CHECK(made > 300);
}

TEST_CASE("a made vertex never lies where an input vertex is") {
  for_each_result([](const Scene& scene, Operation, const BooleanResult& result) {
    const std::vector<Vec3d> inputs = input_points(scene);
    for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
      if (result.provenance.vertex_source[v] != Provenance::none) continue;
      CHECK(std::find(inputs.begin(), inputs.end(), result.mesh.points[v]) == inputs.end());
    }
  });
}

TEST_CASE("facets run against their source exactly where a subtracted operand gave them") {
  for_each_result([](const Scene&, Operation operation, const BooleanResult& result) {
    if (operation == Operation::SymmetricDifference) return;
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
      const bool subtracted = operation == Operation::Subtract && result.provenance.source_operand[f] != 0;
      CHECK((result.provenance.flipped[f] != 0) == subtracted);
    }
  });
}

TEST_CASE("union and intersection do not depend on the order of the operands") {
  for (const Scene& scene : small_scenes()) {
    for (const Operation operation : {Operation::Union, Operation::Intersect}) {
      INFO(scene.name << ", " << operation_name(operation));
      const BooleanResult forward = evaluate(operation, scene.operands);
      const BooleanResult backward = evaluate(operation, {scene.operands.rbegin(), scene.operands.rend()});
      CHECK(forward.mesh.triangles.size() == backward.mesh.triangles.size());
      CHECK(sorted_points(forward.mesh) == sorted_points(backward.mesh));
      CHECK(forward.graph.edges.size() == backward.graph.edges.size());
      CHECK(forward.graph.closed_loops == backward.graph.closed_loops);
      CHECK(forward.report.contact.points == backward.report.contact.points);
    }
  }
}

TEST_CASE("operands are subtracted in any order") {
  for (const Scene& scene : small_scenes()) {
    if (scene.operands.size() < 3) continue;
    INFO(scene.name);
    const BooleanResult forward = evaluate(Operation::Subtract, scene.operands);
    const BooleanResult backward = evaluate(Operation::Subtract, {scene.operands[0], scene.operands[2], scene.operands[1]});
    CHECK(forward.mesh.triangles.size() == backward.mesh.triangles.size());
    CHECK(sorted_points(forward.mesh) == sorted_points(backward.mesh));
  }
}

TEST_CASE("the same call gives the same bits again, and leaves its operands as they were") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const std::vector<SurfaceMesh> before = scene.operands;
    const BooleanResult first = evaluate(Operation::Union, scene.operands), second = evaluate(Operation::Union, scene.operands);
    CHECK(first.mesh.points == second.mesh.points);
    CHECK(first.mesh.triangles == second.mesh.triangles);
    for (std::size_t k = 0; k < before.size(); ++k) {
      CHECK(before[k].points == scene.operands[k].points);
      CHECK(before[k].triangles == scene.operands[k].triangles);
    }
  }
}

TEST_CASE("an empty operand is the neutral element") {
  const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1}), nothing;
  CHECK(exact_volume(evaluate(Operation::Union, {unit, nothing}).mesh) == 1);
  CHECK(exact_volume(evaluate(Operation::Subtract, {unit, nothing}).mesh) == 1);
  CHECK(evaluate(Operation::Intersect, {unit, nothing}).mesh.triangles.empty());
  CHECK(evaluate(Operation::Subtract, {nothing, unit}).mesh.triangles.empty());
}
