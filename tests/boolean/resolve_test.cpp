// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes that overlap themselves become what they cover: against rays through points, by code that shares nothing with it.
#include "mortise/boolean/resolve.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "boolean/evaluation.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

Vec3d random_point(const Box3& box, std::mt19937_64& random) {
  Vec3d p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = box.lo[i] + std::ldexp(static_cast<double>(random() >> 11), -53) * (box.hi[i] - box.lo[i]);
  return p;
}

/// Is the result 1 where the winding of the mesh is positive, and 0 elsewhere? Returns at how many points it was more than 1.
std::size_t check_windings(const SurfaceMesh& mesh, const SurfaceMesh& result, std::size_t samples) {
  Box3 box;
  for (const Vec3d& p : mesh.points) box.extend(p);
  std::mt19937_64 random(11);
  std::size_t multiple = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const oracle::RationalPoint p = oracle::exact(random_point(box, random));
    const std::optional<int> before = oracle::winding_number(mesh, p), after = oracle::winding_number(result, p);
    if (!before || !after) continue;
    multiple += *before > 1 ? 1 : 0;
    CHECK(*after == (*before > 0 ? 1 : 0));
  }
  return multiple;
}

BooleanResult checked(const SurfaceMesh& mesh) {
  BooleanResult result = resolve(mesh);
  CHECK(faults_of_mesh(result) == "");
  if (result.mesh.triangles.size() < 6000) CHECK(oracle::self_crossings(result.mesh).empty());
  return result;
}

/// A band of square section that winds twice round the z axis and closes through itself: one part that crosses itself.
SurfaceMesh crossing_band() {
  SurfaceMesh band;
  constexpr std::size_t count = 24;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 4 * 3.14159265358979323846 * static_cast<double>(i) / count;
    const double height = std::sin(angle / 2), wide = 2 + 0.5 * std::cos(angle / 2);
    for (const auto& [r, z] : {std::array{0.3, -0.3}, std::array{0.3, 0.3}, std::array{-0.3, 0.3}, std::array{-0.3, -0.3}}) {
      band.points.push_back({(wide + r) * std::cos(angle), (wide + r) * std::sin(angle), 0.25 * height + z});
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = 4 * i + k, b = 4 * i + (k + 1) % 4, c = 4 * ((i + 1) % count) + k, d = 4 * ((i + 1) % count) + (k + 1) % 4;
      band.triangles.push_back({VertexId(a), VertexId(c), VertexId(b)});
      band.triangles.push_back({VertexId(b), VertexId(c), VertexId(d)});
    }
  }
  return exact_volume(band) > 0 ? band : inside_out(band);
}

}  // namespace

TEST_CASE("one connected part that crosses itself is resolved, where a boolean with something far away leaves it", "[resolve]") {
  const SurfaceMesh star = pentagram_prism(0, 1);
  CHECK_FALSE(oracle::self_crossings(star).empty());
  const BooleanResult result = checked(star);
  CHECK(result.report.self_contacts == std::vector<std::uint32_t>{0});
  CHECK(check_windings(star, result.mesh, 200) > 2);
  const BooleanResult united = evaluate(Operation::Union, {star, box({50, 50, 50}, {51, 51, 51})});
  CHECK_FALSE(oracle::self_crossings(united.mesh).empty());
  // What the star covers is its winding-2 middle counted once: the middle is V(star) - V(result).
  CHECK(exact_volume(result.mesh) < exact_volume(star));
  CHECK(resolve(result.mesh).mesh.triangles.size() == result.mesh.triangles.size());
}

TEST_CASE("a band that runs through itself is resolved", "[resolve]") {
  const SurfaceMesh band = crossing_band();
  CHECK_FALSE(oracle::self_crossings(band).empty());
  const BooleanResult result = checked(band);
  CHECK(check_windings(band, result.mesh, 60) > 0);
  CHECK(exact_volume(result.mesh) < exact_volume(band));
}

TEST_CASE("overlapping, nested, doubled and cancelling parts count once or not at all", "[resolve]") {
  const SurfaceMesh a = box({0, 0, 0}, {4, 4, 4});
  CHECK(exact_volume(checked(joined({a, box({2, 2, 2}, {6, 6, 6})})).mesh) == 120);
  CHECK(exact_volume(checked(joined({a, box({1, 1, 1}, {2, 2, 2})})).mesh) == 64);
  CHECK(exact_volume(checked(joined({a, a, a})).mesh) == 64);
  CHECK(exact_volume(checked(joined({a, inside_out(box({1, 1, 1}, {2, 2, 2}))})).mesh) == 63);
  CHECK(exact_volume(checked(joined({a, inside_out(box({1, 1, 1}, {2, 2, 6}))})).mesh) == 61);
}

TEST_CASE("a mesh without crossings comes back as it was", "[resolve]") {
  const SurfaceMesh ball = make_icosphere(1, 3);
  CHECK(has_same_bits(resolve(ball).mesh, ball));
}

TEST_CASE("a mesh that encloses nothing but negative winding, or is open, is refused", "[resolve]") {
  CHECK(error_of([] { (void)resolve(inside_out(box({0, 0, 0}, {1, 1, 1}))); })->code == ErrorCode::InsideOut);
}

TEST_CASE("overlapping meshes found in the wild are resolved", "[resolve][scenario]") {
  if (is_data_missing()) return;
  for (const char* file :
       {"nasty/three_cubes.stl", "nasty/two_spheres.stl", "nasty/sphere_pair_overlap.obj", "nasty/ceasiom_aircraft_soup.stl",
        "nasty/manifold_Generic_Twin_7863_right.obj", "nasty/manifold_openscad-nonmanifold-crash.obj", "nasty/of_buildings_degenerate.obj",
        "aircraft/cape_bullet_box_overlap.obj"}) {
    INFO(file);
    const SurfaceMesh mesh = read_data(file);
    if (is_reduced_run() && mesh.triangles.size() > 5000) continue;
    const BooleanResult result = checked(mesh);
    const std::size_t samples = std::clamp<std::size_t>(scaled_count(12000, 400000) / mesh.triangles.size(), 2, 60);
    (void)check_windings(mesh, result.mesh, samples);
    CHECK(resolve(result.mesh).mesh.triangles.size() == result.mesh.triangles.size());
  }
}
