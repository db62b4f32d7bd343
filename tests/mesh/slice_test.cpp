// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sections through faces, edges and vertices, of nested and touching bodies; areas that add up to volumes.
#include "mortise/mesh/slice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

Section at_height(const SurfaceMesh& mesh, double z) { return slice(mesh, {{0, 0, 1}, z}); }

/// Volume by the rule of Simpson over equal layers: exact for areas that are of degree three between cuts.
double integrate(const SurfaceMesh& mesh, double low, double high, int layers) {
  const double step = (high - low) / layers;
  double sum = 0;
  for (int i = 0; i < layers; ++i) {
    const double z = low + step * i;
    sum += at_height(mesh, std::nextafter(z, high)).area + 4 * at_height(mesh, z + step / 2).area + at_height(mesh, z + step).area;
  }
  return sum * step / 6;
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

TEST_CASE("A box has its section at every height from above its bottom up to its top", "[mesh][slice]") {
  const SurfaceMesh box = test::box({0, 0, 0}, {2, 3, 4});
  for (const double z : {0x1p-1000, 1.0, 0.1, 4.0}) {
    const Section section = at_height(box, z);
    REQUIRE(section.polygons.size() == 1);
    CHECK(section.area == 6);
    for (const Vec3d& p : section.polygons[0]) CHECK(p.z == z);
  }
  CHECK(at_height(box, 0).polygons.empty());
  CHECK(at_height(box, 5).polygons.empty());
  CHECK(slice(box, {{0, 0, -1}, 0}).area == 6);
  CHECK(slice(box, {{0, 0, -1}, -4}).polygons.empty());
}

TEST_CASE("A polygon has the inside on its left seen from the front", "[mesh][slice]") {
  const SurfaceMesh hollow = test::joined({test::box({0, 0, 0}, {4, 4, 4}), test::inside_out(test::box({1, 1, 1}, {3, 3, 3}))});
  for (const Plane& plane : {Plane{{0, 0, 2}, 4}, Plane{{0, 0, -2}, -4}, Plane{{-3, 0, 0}, -6}, Plane{{0, 5, 0}, 10}}) {
    const Section section = slice(hollow, plane);
    CHECK(section.areas == std::vector<double>{16, -4});
    CHECK(section.area == 12);
  }
}

TEST_CASE("Sections through vertices and edges are whole", "[mesh][slice]") {
  const SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  const Section diagonal = slice(box, {{1, -1, 0}, 0});  // through two edges and the diagonals of two sides or across them
  REQUIRE(diagonal.polygons.size() == 1);
  CHECK(diagonal.area == Approx(std::sqrt(2.0)).epsilon(1e-15));
  const Section triangle = slice(box, {{1, 1, 1}, 1});  // through three vertices
  CHECK(triangle.area == Approx(std::sqrt(3.0) / 2).epsilon(1e-15));
  const Section hexagon = slice(box, {{2, 2, 2}, 3});
  CHECK(hexagon.area == Approx(std::sqrt(27.0) / 4).epsilon(1e-15));
  const Section ball = at_height(test::octahedron({0, 0, 0}, 2), 0);  // through four vertices
  CHECK(ball.area == 8);
  CHECK(ball.polygons[0].size() == 4);
}

TEST_CASE("A plane that touches a vertex, an edge or a side from outside cuts nothing", "[mesh][slice]") {
  const SurfaceMesh octahedron = test::octahedron({0, 0, 0}, 2);
  CHECK(at_height(octahedron, 2).polygons.empty());
  CHECK(at_height(octahedron, -2).polygons.empty());
  CHECK(slice(octahedron, {{1, 1, 0}, 2}).polygons.empty());
  CHECK(slice(octahedron, {{-1, -1, 0}, -2}).polygons.empty());
  CHECK(slice(octahedron, {{-1, -1, 0}, 2}).polygons.empty());
  // a step: at the height of the lower top the section is that below it
  const SurfaceMesh step = extrude(std::vector<Vec2d>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
  CHECK(slice(step, {{0, 1, 0}, 1}).area == 2);
  CHECK(slice(step, {{0, -1, 0}, -1}).area == 1);
}

TEST_CASE("The sections of a torus", "[mesh][slice]") {
  const SurfaceMesh torus = make_torus(3, 1, 48, 24);
  CHECK(sorted(slice(torus, {{0, 0, 1}, 0}).areas).front() < 0);  // a ring: an outline and a hole
  CHECK(slice(torus, {{0, 0, 1}, 0}).polygons.size() == 2);
  const Section across = slice(torus, {{1, 0, 0}, 0});  // two discs, of 24 corners
  REQUIRE(across.polygons.size() == 2);
  const double disc = 12 * std::sin(3.14159265358979323846 / 12);
  CHECK(across.area == Approx(2 * disc).epsilon(1e-12));
  CHECK(slice(torus, {{1, 0, 0}, 2.5}).polygons.size() == 1);
  CHECK(integrate(torus, -1, 1, 400) == Approx(enclosed_volume(torus)).epsilon(2e-5));
}

TEST_CASE("The areas of the sections of a sphere add up to its volume", "[mesh][slice]") {
  const SurfaceMesh sphere = make_sphere(1, 24, 12);
  const SurfaceMesh tilted = transform(make_icosphere(1, 3), compose(rotation(Axis::X, 33), rotation(Axis::Y, 21)));
  CHECK(integrate(sphere, -1, 1, 400) == Approx(enclosed_volume(sphere)).epsilon(1e-5));
  CHECK(integrate(tilted, -1, 1, 200) == Approx(enclosed_volume(tilted)).epsilon(1e-5));
}

TEST_CASE("Bodies that touch along an edge or in a vertex keep their own polygons", "[mesh][slice]") {
  const SurfaceMesh along = weld(test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})})).mesh;
  CHECK(at_height(along, 0.5).areas == std::vector<double>{1, 1});
  CHECK(at_height(along, 1).areas == std::vector<double>{1, 1});
  CHECK(sorted(slice(along, {{1, -1, 0}, 0}).areas) == std::vector<double>{std::sqrt(2.0), std::sqrt(2.0)});
}

TEST_CASE("Cavities that touch along an edge leave the area between them out", "[mesh][slice]") {
  const SurfaceMesh block = weld(test::joined({test::box({0, 0, 0}, {4, 4, 4}), test::inside_out(test::box({1, 1, 1}, {2, 2, 3})),
                                               test::inside_out(test::box({2, 2, 1}, {3, 3, 3}))}))
                                .mesh;
  for (const double z : {1.5, 2.0, 3.0}) CHECK(at_height(block, z).area == 14);
  CHECK(at_height(block, 1).area == 16);
  CHECK(slice(block, {{1, -1, 0}, 0}).area == Approx((16 - 4) * std::sqrt(2.0)).epsilon(1e-15));
}

TEST_CASE("A soup is welded, faces that repeat a vertex do not count", "[mesh][slice]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.triangles.push_back({VertexId(0), VertexId(0), VertexId(7)});
  box.points.push_back(box.points[3]);
  for (VertexId& v : box.triangles[0]) v = v == VertexId(3) ? VertexId(8) : v;
  CHECK(at_height(box, 0.5).area == 1);
  CHECK(slice({}, {}).polygons.empty());
}

TEST_CASE("What cannot be sliced is refused by name", "[mesh][slice]") {
  const auto code_of = [](const SurfaceMesh& mesh, const Plane& plane) {
    const auto error = test::error_of([&] { (void)slice(mesh, plane); });
    REQUIRE(error);
    return error->code;
  };
  const SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  SurfaceMesh open = box;
  open.triangles.pop_back();
  CHECK(code_of(open, {}) == ErrorCode::NotClosed);
  SurfaceMesh twisted = box;
  std::swap(twisted.triangles[0][0], twisted.triangles[0][1]);
  CHECK(code_of(twisted, {}) == ErrorCode::NotOriented);
  CHECK(code_of(box, {{0, 0, 0}, 0}) == ErrorCode::InvalidArgument);
  CHECK(code_of(box, {{0, 0, 1}, std::numeric_limits<double>::infinity()}) == ErrorCode::InvalidArgument);
  CHECK(code_of(box, {{std::numeric_limits<double>::quiet_NaN(), 0, 1}, 0}) == ErrorCode::InvalidArgument);
}

TEST_CASE("The water planes of a real hull add up to its volume", "[mesh][slice]") {
  if (test::is_data_missing()) return;
  const SurfaceMesh hull = test::read_data("ship/dtc_hull.ply");
  const Box3 box = bounding_box(hull);
  CHECK(integrate(hull, box.lo.z, box.hi.z, 200) == Approx(enclosed_volume(hull)).epsilon(1e-3));  // flat parts lie between layers
}

}  // namespace mortise
