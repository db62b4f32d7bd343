// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cases other libraries publish figures for.
#include <cmath>
#include <numbers>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

BooleanResult checked(Operation operation, const std::vector<SurfaceMesh>& operands) {
  BooleanResult result = evaluate(operation, operands);
  CHECK(faults_of(pointers_to(operands), result) == "");
  return result;
}

/// A polygon with corners on the unit circle, symmetric in the last bit; n divisible by 4.
std::vector<std::array<double, 2>> circle(std::size_t n) {
  std::vector<std::array<double, 2>> points(n);
  for (std::size_t i = 0; i <= n / 4; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double c = i == n / 4 ? 0 : std::cos(angle), s = i == 0 ? 0 : std::sin(angle);
    points[i] = {c, s};
    points[n / 2 - i] = {-c, s};
    points[n / 2 + i] = {-c, -s};
    points[(n - i) % n] = {c, -s};
  }
  return points;
}

/// What two equal cylinders over the polygon have in common: in height t both are as wide as the polygon there.
double common_of_crossing_cylinders(const std::vector<std::array<double, 2>>& polygon) {
  double volume = 0;
  for (std::size_t i = 0; i < polygon.size() / 4; ++i) {
    const double low = 2 * polygon[i][0], high = 2 * polygon[i + 1][0];
    volume += (polygon[i + 1][1] - polygon[i][1]) * (low * low + low * high + high * high) / 3;
  }
  return 2 * volume;
}

}  // namespace

TEST_CASE("a unit box less two boxes shifted along its diagonal has volume 0.18 and area 2.76") {
  const Shape shape = shape_of(checked(Operation::Subtract, {unit, moved(unit, {0.3, 0.3, 0}), moved(unit, {-0.3, -0.3, 0})}).mesh);
  CHECK(shape.volume == Approx(0.18).epsilon(1e-14));
  CHECK(shape.area == Approx(2.76).epsilon(1e-14));
}

TEST_CASE("a wall of 6 x 3 x 0.2 less a window of 1 x 1 has volume 3.4") {
  const Shape shape = shape_of(checked(Operation::Subtract, {box({0, 0, 0}, {6, 0.2, 3}), box({2, -1, 1}, {3, 1, 2})}).mesh);
  CHECK(shape.volume == Approx(3.4).epsilon(1e-14));
  CHECK((shape.genus == 1 && shape.shells == 1));
}

TEST_CASE("a window flush with both sides of the wall is the same hole") {
  const Shape shape =
      shape_of(checked(Operation::Subtract, {box({0, 0, 0}, {6, 0.2, 3}), box_other_diagonals({2, 0, 1}, {3, 0.2, 2})}).mesh);
  CHECK(shape.volume == Approx(3.4).epsilon(1e-14));
  CHECK((shape.genus == 1 && shape.shells == 1));
}

TEST_CASE("a unit box less two boxes that share a face leaves half of it") {
  const BooleanResult result = checked(Operation::Subtract, {unit, moved(unit, {0.5, 0.5, 0}), moved(unit, {-0.5, 0.5, 0})});
  CHECK(shape_of(result.mesh).volume == 0.5);
  const BooleanResult other = checked(Operation::Subtract, {unit, moved(unit, {0.5, 0.5, 0}), moved(unit, {0, 0.5, 0})});
  CHECK(shape_of(other.mesh).volume == 0.5);
}

TEST_CASE("two boxes of side 2 have volumes 15, 1 and 7 and areas 42, 6 and 24") {
  const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Shape all = shape_of(checked(Operation::Union, boxes).mesh), common = shape_of(checked(Operation::Intersect, boxes).mesh),
              rest = shape_of(checked(Operation::Subtract, boxes).mesh);
  CHECK((all.volume == 15 && all.area == 42));
  CHECK((common.volume == 1 && common.area == 6));
  CHECK((rest.volume == 7 && rest.area == 24));
}

TEST_CASE("two equal cylinders crossing have the Steinmetz solid in common") {
  std::vector<double> errors;
  for (const std::size_t n : {16U, 32U, 64U}) {
    const auto polygon = circle(n);
    const SurfaceMesh along_x = with_axes_turned(prism(polygon, -2, 2));  // the polygon in (y, z)
    const SurfaceMesh along_y = quarter_turned(along_x);                  // the polygon in (x, z)
    const double volume = exact_volume(checked(Operation::Intersect, {along_x, along_y}).mesh);
    CHECK(volume == Approx(common_of_crossing_cylinders(polygon)).epsilon(1e-13));
    errors.push_back(16.0 / 3 - volume);
  }
  // The polygons converge to the circle with the square of the segment length.
  CHECK(errors[0] / errors[1] == Approx(4).epsilon(0.02));
  CHECK(errors[1] / errors[2] == Approx(4).epsilon(0.02));
}

TEST_CASE("a chain of seven unions is one call and does not depend on its order") {
  std::vector<SurfaceMesh> parts;
  for (int i = 0; i < 8; ++i) parts.push_back(moved(octahedron({0, 0, 0}, 0.7), {0.9 * i, 0.1 * (i % 3), 0.05 * (i % 2)}));
  const BooleanResult forward = checked(Operation::Union, parts);
  const BooleanResult backward = checked(Operation::Union, {parts.rbegin(), parts.rend()});
  CHECK(forward.mesh.triangles.size() == backward.mesh.triangles.size());
  CHECK(sorted_points(forward.mesh) == sorted_points(backward.mesh));
}
