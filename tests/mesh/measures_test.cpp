// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Measures hold far from the origin, at every scale and for faces without area.
#include "mortise/mesh/measures.h"

#include <array>
#include <cmath>
#include <limits>

#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One triangle as a mesh.
SurfaceMesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return test::make_mesh({a, b, c}, {{0, 1, 2}}); }

}  // namespace

TEST_CASE("A box has its volume and area exactly", "[mesh][measures]") {
  const SurfaceMesh box = test::box({1, 2, 3}, {2, 4, 6});
  CHECK(enclosed_volume(box) == 6);
  CHECK(surface_area(box) == 22);
  CHECK(enclosed_volume(test::inside_out(box)) == -6);
  CHECK(bounding_box(box).lo == Vec3d{1, 2, 3});
  CHECK(bounding_box(box).hi == Vec3d{2, 4, 6});
}

TEST_CASE("The volume of a needle has its exact sign, and is as accurate as any", "[mesh][measures]") {
  // Points on a line, but for the rounding of their coordinates: the volume is below what double-double can tell from zero.
  const Vec3d a{0.1, 0.2, 0.3}, b{1.1, 0.7, 0.9};
  for (int i = 1; i < 20; ++i) {
    const SurfaceMesh needle = test::tetrahedron(a, a + (i / 47.0) * (b - a), a + (i / 21.0) * (b - a), b);
    const double exact = oracle::nearest_double(oracle::volume(needle));
    CHECK(std::fabs(exact) < 1e-31);
    CHECK(std::fabs(enclosed_volume(needle) - exact) <= 0x1p-50 * std::fabs(exact));
    CHECK(enclosed_volume(test::joined({needle, test::inside_out(needle)})) == 0);
  }
}

TEST_CASE("The volume is that of the exact sum, also in map coordinates", "[mesh][measures]") {
  const SurfaceMesh near = make_torus(3, 1, 24, 16);
  const SurfaceMesh far = transform(near, translation({581311.37, 4785270.91, 937.3}));
  for (const SurfaceMesh& mesh : {near, far}) {
    const double exact = test::exactly_summed_volume(mesh);
    CHECK(std::fabs(enclosed_volume(mesh) - exact) <= 0x1p-52 * exact);
  }
  CHECK(std::fabs(surface_area(far) - surface_area(near)) < 1e-8);
}

TEST_CASE("Powers of two scale every measure exactly", "[mesh][measures]") {
  const SurfaceMesh torus = make_torus(3, 1, 24, 16);
  for (const int power : {-300, -1, 300}) {
    const double factor = std::ldexp(1.0, power);
    const SurfaceMesh scaled = test::scaled(torus, factor);
    CHECK(enclosed_volume(scaled) == std::ldexp(enclosed_volume(torus), 3 * power));
    CHECK(surface_area(scaled) == std::ldexp(surface_area(torus), 2 * power));
    CHECK(measure_faces(scaled).angles.min_deg == measure_faces(torus).angles.min_deg);
    CHECK(measure_faces(scaled).angles.max_deg == measure_faces(torus).angles.max_deg);
  }
}

TEST_CASE("What does not fit a double is infinite or zero, never NaN", "[mesh][measures]") {
  const SurfaceMesh huge = test::box({-1.7e308, -1.7e308, -1.7e308}, {1.7e308, 1.7e308, 1.7e308});
  CHECK(enclosed_volume(huge) == infinity);
  CHECK(surface_area(huge) == infinity);
  CHECK(measure_faces(huge).angles.min_deg == 45);
  CHECK(measure_faces(huge).angles.max_deg == 90);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const SurfaceMesh tiny = test::box({0, 0, 0}, {least, least, least});
  CHECK(enclosed_volume(tiny) == 0);
  CHECK(surface_area(tiny) == 0);
  CHECK(measure_faces(tiny).angles.min_deg == 45);
  CHECK(measure_faces(tiny).angles.max_deg == 90);
}

TEST_CASE("Bodies and faces of extreme proportions keep their measure", "[mesh][measures]") {
  const SurfaceMesh both = test::joined({test::box({0, 0, 0}, {1e200, 1, 1}), test::box({5, 5, 5}, {5 + 0x1p-40, 6, 6})});
  CHECK(enclosed_volume(both) == 1e200);
  CHECK(surface_area(both) == 4e200);
}

TEST_CASE("Angles of known triangles", "[mesh][measures]") {
  const double root3 = std::sqrt(3.0);
  const auto halves = triangle_angles_deg({0, 0, 0}, {1, 0, 0}, {0, root3, 0});
  CHECK(halves[0] == 90);
  CHECK(std::fabs(halves[1] - 60) < 1e-13);
  CHECK(std::fabs(halves[2] - 30) < 1e-13);
  const auto obtuse = triangle_angles_deg({0, 0, 0}, {1, 0, 0}, {-1, 1, 0});
  CHECK(obtuse[0] == 135);
  CHECK(triangle_area({0, 0, 0}, {1, 0, 0}, {-1, 1, 0}) == 0.5);
}

TEST_CASE("Slivers keep relative accuracy", "[mesh][measures]") {
  // height 1e-12 over a base of 1, far from the origin: the angle is 1e-12 / 0.5 radians
  const double height = 0x1p-40;
  const auto angles = triangle_angles_deg({1e3, 0, 0}, {1e3 + 1, 0, 0}, {1e3 + 0.5, height, 0});
  const double expected = 2 * height * 180 / 0x1.921fb54442d18p+1;
  CHECK(std::fabs(angles[0] / expected - 1) < 1e-12);
  CHECK(triangle_area({1e3, 0, 0}, {1e3 + 1, 0, 0}, {1e3 + 0.5, height, 0}) == height / 2);
}

TEST_CASE("Faces without area have angles of 0 and 180", "[mesh][measures]") {
  const AngleRange straight = measure_faces(triangle({0, 0, 0}, {1, 1, 1}, {3, 3, 3})).angles;
  CHECK(straight.min_deg == 0);
  CHECK(straight.max_deg == 180);
  const AngleRange point = measure_faces(triangle({2, 2, 2}, {2, 2, 2}, {2, 2, 2})).angles;
  CHECK(point.min_deg == 0);
  CHECK(point.max_deg == 0);
  CHECK(surface_area(triangle({0, 0, 0}, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.3})) == 0);
}

TEST_CASE("A mesh without faces measures nothing", "[mesh][measures]") {
  SurfaceMesh points;
  points.points = {{1, 2, 3}};
  CHECK(enclosed_volume(points) == 0);
  CHECK(surface_area(points) == 0);
  CHECK(bounding_box(points).is_empty());
  CHECK(measure_faces(points).angles.max_deg == 0);
}

}  // namespace mortise
