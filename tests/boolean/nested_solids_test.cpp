// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Shells inside shells: cavities, parts within parts, and crossing parts that meet nothing of what is round them.
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh cube(double lo, double hi) { return box({lo, lo, lo}, {hi, hi, hi}); }

/// The cube from `lo` to `hi` without the cube one unit further in.
SurfaceMesh hollow_cube(double lo, double hi) { return joined({cube(lo, hi), inside_out(cube(lo + 1, hi - 1))}); }

BooleanResult checked(Operation operation, const std::vector<SurfaceMesh>& operands) {
  BooleanResult result = evaluate(operation, operands);
  CHECK(faults_of(pointers_to(operands), result) == "");
  return result;
}

}  // namespace

TEST_CASE("a box inside a box vanishes in the union and becomes a cavity by subtraction") {
  const std::vector<SurfaceMesh> boxes{cube(0, 3), cube(1, 2)};
  CHECK(sorted_points(checked(Operation::Union, boxes).mesh) == sorted_points(boxes[0]));
  CHECK(sorted_points(checked(Operation::Intersect, boxes).mesh) == sorted_points(boxes[1]));
  const Shape shape = shape_of(checked(Operation::Subtract, boxes).mesh);
  CHECK((shape.volume == 26 && shape.area == 60 && shape.shells == 2 && shape.genus == 0));
  CHECK(checked(Operation::Subtract, {boxes[1], boxes[0]}).mesh.triangles.empty());
}

TEST_CASE("a box in the cavity of another shell stays a part of its own") {
  const std::vector<SurfaceMesh> solids{hollow_cube(0, 9), cube(3, 5)};
  const Shape all = shape_of(checked(Operation::Union, solids).mesh);
  CHECK((all.volume == 729 - 343 + 8 && all.shells == 3));
  CHECK(checked(Operation::Intersect, solids).mesh.triangles.empty());
  CHECK(shape_of(checked(Operation::Subtract, solids).mesh).volume == 729 - 343);
}

TEST_CASE("a box that fills a cavity closes it") {
  const Shape shape = shape_of(checked(Operation::Union, {hollow_cube(0, 9), cube(1, 8)}).mesh);
  CHECK((shape.volume == 729 && shape.area == 486 && shape.shells == 1));
}

TEST_CASE("ten hollow cubes inside one another unite to ten walls") {
  std::vector<SurfaceMesh> shells;
  double volume = 0;
  for (int k = 0; k < 10; ++k) {
    const double lo = 2 * k, hi = 41 - 2 * k, side = hi - lo;
    shells.push_back(hollow_cube(lo, hi));
    volume += side * side * side - (side - 2) * (side - 2) * (side - 2);
  }
  const Shape all = shape_of(checked(Operation::Union, shells).mesh);
  CHECK((all.volume == volume && all.shells == 20));
  // The same walls as one operand, in any order, less a bar through all of them.
  const Shape cut = shape_of(checked(Operation::Subtract, {joined(shells), box({20, 20, -1}, {21, 21, 42})}).mesh);
  CHECK(cut.volume == volume - 20);
}

TEST_CASE("two crossing parts inside a third are gone in the union") {
  const std::vector<SurfaceMesh> parts{cube(0, 9), cube(1, 4), box({3, 3, 3}, {6, 5, 5})};
  CHECK(sorted_points(checked(Operation::Union, parts).mesh) == sorted_points(parts[0]));
  CHECK(sorted_points(checked(Operation::Union, {parts[2], parts[0], parts[1]}).mesh) == sorted_points(parts[0]));
  // 27 + 12 - 1 is what the two cover.
  CHECK(exact_volume(checked(Operation::Subtract, parts).mesh) == 729 - 38);
  CHECK(exact_volume(checked(Operation::Intersect, parts).mesh) == 1);
}

TEST_CASE("two crossing parts inside the cavity of a third stay") {
  const std::vector<SurfaceMesh> parts{hollow_cube(0, 9), cube(2, 4), box({3, 3, 3}, {6, 5, 5})};
  CHECK(exact_volume(checked(Operation::Union, parts).mesh) == 729 - 343 + 8 + 12 - 1);
  CHECK(exact_volume(checked(Operation::Subtract, parts).mesh) == 729 - 343);
  CHECK(checked(Operation::Intersect, parts).mesh.triangles.empty());
}

TEST_CASE("parts of one operand inside and outside another are told apart") {
  const SurfaceMesh parts = joined({cube(1, 2), cube(20, 21), cube(3, 4), box({8, 1, 1}, {12, 2, 2})});
  const std::vector<SurfaceMesh> solids{cube(0, 10), parts};
  CHECK(exact_volume(checked(Operation::Union, solids).mesh) == 1000 + 1 + 2);
  CHECK(exact_volume(checked(Operation::Intersect, solids).mesh) == 1 + 1 + 2);
  CHECK(exact_volume(checked(Operation::Subtract, solids).mesh) == 1000 - 4);
  CHECK(exact_volume(checked(Operation::Subtract, {parts, cube(0, 10)}).mesh) == 1 + 2);
}

TEST_CASE("a corner touching the inside of a cavity is a contact and changes nothing") {
  const std::vector<SurfaceMesh> solids{hollow_cube(0, 9), tetrahedron({1, 4, 4}, {3, 3, 3}, {3, 5, 3}, {3, 4, 5})};
  const BooleanResult all = checked(Operation::Union, solids);
  CHECK(all.report.contact.points == 1);
  // The tetrahedron has base 2 x 2 / 2 and height 2.
  CHECK(exact_volume(all.mesh) == Approx(729 - 343 + 4.0 / 3).epsilon(1e-15));
}

TEST_CASE("several parts that touch in one vertex are all kept") {
  const SurfaceMesh below = tetrahedron({0, 0, 0}, {-1, -1, -2}, {1, -1, -2}, {0, 1, -2}),
                    above = tetrahedron({0, 0, 0}, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  const SurfaceMesh left = tetrahedron({0, 0, 0}, {-2, -1, -1}, {-2, 1, -1}, {-2, 0, 1}),
                    right = tetrahedron({0, 0, 0}, {2, -1, -1}, {2, 1, -1}, {2, 0, 1});
  const BooleanResult all = checked(Operation::Union, {below, above, left, right});
  CHECK(all.mesh.triangles.size() == 16);
  CHECK(all.mesh.points.size() == 13);
  CHECK(shape_of(all.mesh).shells == 4);
}
