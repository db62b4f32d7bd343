// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Features smaller than the sizes wanted ask for sizes that fit them; what is no small feature does not.
#include "mortise/size/small_features.h"

#include <cmath>
#include <utility>

#include "mortise/brep/build_brep.h"
#include "mortise/mesh/shapes.h"
#include "mortise/remesh/quality_report.h"
#include "mortise/remesh/remesh.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

BrepRules without_seams() {
  BrepRules rules;
  rules.seams = Seams::None;
  return rules;
}

struct Modelled {
  explicit Modelled(SurfaceMesh given)
      : mesh(std::move(given)), normals(measure_normals(mesh, build_topology(mesh))), model(build_brep(mesh, without_seams(), normals)) {}
  SurfaceMesh mesh;
  FaceNormals normals;
  ClassifiedBrep model;
};

SmallFeatures find(const Modelled& m, double size, const SmallFeatureRules& rules = {}) {
  return find_small_features(m.mesh, m.model, SizingProxy({}, {size, 0}), rules);
}

SurfaceMesh extruded(const std::vector<Vec2d>& outline) { return extrude(outline, 4); }

}  // namespace

TEST_CASE("a cube of edges as long as the size has no small features, one of half the size has twelve short edges", "[size]") {
  const Modelled cube(box({0, 0, 0}, {1, 1, 1}));
  CHECK(find(cube, 1).sources.empty());
  CHECK(find(cube, 1.4).sources.empty());
  const SmallFeatures half = find(cube, 2);
  CHECK(half.short_edges == 12);
  for (const SizeSource& source : half.sources) CHECK(source.strengths[0] == 1);
}

TEST_CASE("both sides of a strip ask for equilateral triangles as high as it is wide all along, and its short edges for their length",
          "[size]") {
  const Modelled plate(box({0, 0, 0}, {10, 10, 0.1}));
  const SmallFeatures found = find(plate, 1);
  CHECK(found.short_edges == 4);
  const SizingProxy sizes = SizingProxy({}, {1, 0}).with(found.sources);
  for (double x = 0; x <= 10; x += 0.25) {
    for (const double z : {0.0, 0.1}) CHECK(sizes.size_at({x, 0, z}) <= 0.2 / std::sqrt(3.0) + 1e-12);
  }
  CHECK(sizes.size_at({5, 5, 0}) == 1);
}

TEST_CASE("edges that meet at a small angle ask for nothing towards their corner", "[size]") {
  // 5.7 degrees at the first corner.
  const Modelled wedge(extruded({{0, 0}, {10, 0}, {10, 1}}));
  const SmallFeatures found = find(wedge, 0.5);
  CHECK(found.sources.empty());
}

TEST_CASE("a slot through a plate is no part of its faces: only its ends are small", "[size]") {
  const SurfaceMesh plate = box({0, 0, 0}, {10, 10, 2}), slot = box({2, 5, -1}, {8, 5.1, 3});
  const Modelled slotted(evaluate(Operation::Subtract, {plate, slot}).mesh);
  const SmallFeatures found = find(slotted, 1);
  CHECK(found.short_edges == 4);
  const SizingProxy sizes = SizingProxy({}, {1, 0}).with(found.sources);
  CHECK(sizes.size_at({5, 5, 2}) > 0.5);
  CHECK(sizes.size_at({2, 5, 1}) <= 0.2 / std::sqrt(3.0) + 1e-12);  // the narrow walls at its ends
}

TEST_CASE("a hole close to an edge asks for the gap on both", "[size]") {
  const SurfaceMesh plate = box({0, 0, 0}, {10, 10, 2}), drill = moved(make_cylinder(1, 4, 32), {5, 1.2, -1});
  const Modelled drilled(evaluate(Operation::Subtract, {plate, drill}).mesh);
  const SizingProxy sizes = SizingProxy({}, {1, 0}).with(find(drilled, 1).sources);
  CHECK(sizes.size_at({5, 0, 2}) < 0.25);
  CHECK(sizes.size_at({5, 0.2, 2}) < 0.25);
  CHECK(sizes.size_at({5, 9, 2}) == 1);
}

TEST_CASE("features below the least are left as they are", "[size]") {
  const Modelled plate(box({0, 0, 0}, {10, 10, 0.1}));
  CHECK(find(plate, 1, {.least = 0.2}).sources.empty());
  CHECK_THROWS_AS(find(plate, 1, {.least = -1}), Error);
  CHECK_THROWS_AS(find(plate, 1, {.least = std::nan("")}), Error);
}

TEST_CASE("with sizes for small features all triangles of a thin plate with holes are good ones", "[size][remesh]") {
  const SurfaceMesh plate = box({0, 0, 0}, {10, 10, 0.3}), drill = moved(make_cylinder(0.2, 4, 24), {5, 0.7, -1});
  const Modelled drilled(evaluate(Operation::Subtract, {plate, drill}).mesh);
  const SizingProxy wanted({}, {1, 0});
  const SizingProxy sizes = wanted.with(find_small_features(drilled.mesh, drilled.model, wanted).sources);
  const RemeshResult result = remesh(drilled.mesh, drilled.model, drilled.normals, sizes);
  const TriangleMarks marks = measure_quality(result.mesh, {drilled.model.brep, result.classification}, sizes).all;
  CHECK(marks.below_30 == 0);
  CHECK(marks.least_angle_deg > 30);
}
