// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every shape has the promised counts, is closed and outward, meets itself nowhere, and has the same bits everywhere.
#include "mortise/mesh/shapes.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mortise/base/bits.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"

namespace mortise {
namespace {

constexpr double pi = 0x1.921fb54442d18p+1;
const std::vector<Vec2d> l_outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

struct Expected {
  std::string name;
  SurfaceMesh mesh;
  std::size_t vertices, triangles;
  std::int64_t euler;
  double volume;  ///< of the polyhedron
};

/// Area of a regular polygon over that of its circle.
double polygon_share(double corners) { return std::sin(2 * pi / corners) * corners / (2 * pi); }

std::vector<Expected> solids() {
  const double icosahedron = 10 * (3 + std::sqrt(5.0)) / 3 / std::pow(std::sqrt(10 + 2 * std::sqrt(5.0)), 3) * 8;
  return {
      {"box", make_box({1, 2, 3}, {2, 4, 6}), 8, 12, 2, 6},
      {"octahedron", make_sphere(1, 4, 2), 6, 8, 2, 4.0 / 3},
      {"cylinder", make_cylinder(2, 5, 7), 16, 28, 2, 20 * pi * polygon_share(7)},
      {"cone", make_cone(2, 3, 9), 11, 18, 2, 4 * pi * polygon_share(9)},
      {"icosahedron", make_icosphere(1, 0), 12, 20, 2, icosahedron},
      {"torus", make_torus(3, 1, 16, 8), 128, 256, 0, 6 * pi * pi * polygon_share(16) * polygon_share(8)},
      {"prism", extrude(l_outline, 2), 12, 20, 2, 6},
      {"revolved box with a corner on the axis", revolve(std::vector<Vec2d>{{0, 2}, {0, 1}, {0, 0}, {1, 0}, {1, 2}}, 8), 18, 32, 2,
       2 * pi * polygon_share(8)},
      {"revolved ring", revolve(std::vector<Vec2d>{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, 12), 48, 96, 0, 3 * pi * polygon_share(12)},
  };
}

ErrorCode code_of(const std::function<void()>& call) {
  const auto error = test::error_of(call);
  REQUIRE(error);
  return error->code;
}

void add_bits(std::uint64_t& hash, const SurfaceMesh& mesh) {
  const auto add = [&hash](std::uint64_t bits) { hash = (hash ^ bits) * 0x100000001b3U; };
  for (const Vec3d& p : mesh.points) {
    for (const double x : {p.x, p.y, p.z}) add(cast_bits<std::uint64_t>(x));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) add(v.value);
  }
}

}  // namespace

TEST_CASE("Solids have the promised counts, are closed and enclose their volume", "[mesh][shapes]") {
  for (const Expected& expected : solids()) {
    INFO(expected.name);
    CHECK(expected.mesh.points.size() == expected.vertices);
    CHECK(expected.mesh.triangles.size() == expected.triangles);
    CHECK(test::is_balanced(expected.mesh));
    CHECK(test::euler_characteristic(expected.mesh) == expected.euler);
    CHECK(std::fabs(test::exactly_summed_volume(expected.mesh) - expected.volume) < 1e-13 * expected.volume);
    CHECK(weld(expected.mesh).mesh.points.size() == expected.vertices);
  }
}

TEST_CASE("No shape meets itself", "[mesh][shapes]") {
  for (const Expected& expected : solids()) {
    INFO(expected.name);
    CHECK(oracle::self_crossings(expected.mesh).empty());
    CHECK(oracle::faces_without_area(expected.mesh).empty());
  }
  CHECK(oracle::self_crossings(make_sphere(1, 24, 12)).empty());
  CHECK(oracle::self_crossings(make_icosphere(3, 3)).empty());
  CHECK(oracle::self_crossings(make_grid_sheet(2, 1, 8, 4)).empty());
}

TEST_CASE("Spheres have the promised counts and their points lie on them", "[mesh][shapes]") {
  const SurfaceMesh sphere = make_sphere(2, 10, 6);
  CHECK(sphere.points.size() == 10 * 5 + 2);
  CHECK(sphere.triangles.size() == 2 * 10 * 5);
  const SurfaceMesh icosphere = make_icosphere(2, 3);
  CHECK(icosphere.points.size() == 642);
  CHECK(icosphere.triangles.size() == 1280);
  CHECK(test::is_balanced(icosphere));
  for (const SurfaceMesh& mesh : {sphere, icosphere}) {
    for (const Vec3d& p : mesh.points) CHECK(std::fabs(std::sqrt(dot(p, p)) - 2) < 1e-15);
  }
}

TEST_CASE("A sphere is symmetric bit for bit", "[mesh][shapes]") {
  const SurfaceMesh sphere = make_sphere(1, 8, 4);
  SurfaceMesh mirrored = sphere;
  for (Vec3d& p : mirrored.points) p = {p.y, p.x, -p.z};
  CHECK(weld(test::joined({sphere, mirrored})).mesh.points.size() == sphere.points.size());
}

TEST_CASE("A grid sheet is open, faces up and has its area", "[mesh][shapes]") {
  const SurfaceMesh sheet = make_grid_sheet(3, 2, 3, 4);
  CHECK(sheet.points.size() == 20);
  CHECK(sheet.triangles.size() == 24);
  CHECK_FALSE(test::is_balanced(sheet));
  CHECK(test::euler_characteristic(sheet) == 1);
  CHECK(sheet.points.back() == Vec3d{3, 2, 0});
  for (const Triangle& t : sheet.triangles) {
    const Vec3d& a = sheet.points[t[0].index()];
    CHECK(cross(sheet.points[t[1].index()] - a, sheet.points[t[2].index()] - a).z > 0);
  }
}

TEST_CASE("An outline may turn either way", "[mesh][shapes]") {
  const std::vector<Vec2d> clockwise(l_outline.rbegin(), l_outline.rend());
  CHECK(test::exactly_summed_volume(extrude(clockwise, 1)) == 3);
  const std::vector<Vec2d> profile{{1, 1}, {2, 1}, {2, 0}, {1, 0}};
  CHECK(test::exactly_summed_volume(revolve(profile, 4)) == 6);
}

TEST_CASE("A profile that touches the axis in one corner gives a pinch, still closed", "[mesh][shapes]") {
  const SurfaceMesh pinched = revolve(std::vector<Vec2d>{{0, 1}, {1, 0}, {1, 2}}, 8);
  CHECK(pinched.points.size() == 17);
  CHECK(test::is_balanced(pinched));
  CHECK(test::euler_characteristic(pinched) == 1);
}

TEST_CASE("Sizes and counts without meaning are refused", "[mesh][shapes]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Vec2d> bow_tie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const std::vector<Vec2d> straight{{0, 0}, {1, 0}, {2, 0}};
  const std::vector<std::function<void()>> calls{
      [] {
        (void)make_box({0, 0, 0}, {1, 0, 1});
      },
      [] {
        (void)make_box({0, 0, 0}, {1, infinity, 1});
      },
      [] { (void)make_sphere(0, 8, 4); },
      [] { (void)make_sphere(-1, 8, 4); },
      [] { (void)make_sphere(1, 2, 4); },
      [] { (void)make_sphere(1, 8, 1); },
      [] { (void)make_sphere(1, 0xffffffffU, 0xffffffffU); },
      [] { (void)make_icosphere(std::nan(""), 1); },
      [] { (void)make_icosphere(1, 13); },
      [] { (void)make_cylinder(1, 0, 8); },
      [] { (void)make_cylinder(1, 1, 2); },
      [] { (void)make_cone(infinity, 1, 8); },
      [] { (void)make_torus(1, 1, 8, 8); },
      [] { (void)make_torus(1e308, 0.9e308, 8, 8); },
      [] { (void)make_torus(2, 1, 8, 2); },
      [] { (void)make_grid_sheet(1, 1, 0, 1); },
      [&] { (void)extrude(bow_tie, 1); },
      [&] { (void)extrude(straight, 1); },
      [] { (void)extrude(l_outline, -1); },
      [] {
        (void)extrude(std::vector<Vec2d>{{0, 0}, {1, 0}}, 1);
      },
      [] {
        (void)extrude(std::vector<Vec2d>{{0, 0}, {1, 0}, {infinity, 1}}, 1);
      },
      [] {
        (void)revolve(std::vector<Vec2d>{{-1, 0}, {1, 0}, {1, 1}}, 8);
      },
      [] { (void)revolve(l_outline, 2); },
  };
  for (std::size_t i = 0; i < calls.size(); ++i) {
    INFO("call " << i);
    CHECK(code_of(calls[i]) == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("The bits of all shapes are the same on every machine", "[mesh][shapes]") {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Expected& expected : solids()) add_bits(hash, expected.mesh);
  add_bits(hash, make_icosphere(0.7, 4));
  add_bits(hash, make_sphere(1.3, 37, 23));
  add_bits(hash, make_grid_sheet(0.1, 0.3, 7, 11));
  CHECK(hash == 0x96a28dec75b8eaa2U);  // as built by GCC 12 for x86-64
}

}  // namespace mortise
