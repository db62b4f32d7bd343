// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Radii of faces and edges against those of the shapes they are made from, and sizes that follow.
#include "mortise/size/curvature_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/base/error.h"
#include "mortise/brep/build_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/shapes.h"
#include "mortise/size/face_curvature.h"
#include "mortise/size/sizing_proxy.h"
#include "support/catch.h"
#include "support/random_source.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double pi = std::numbers::pi;

/// A mesh with its model. Stays where it is: the view refers to it.
struct Modelled {
  explicit Modelled(SurfaceMesh m, const BrepRules& rules = {})
      : mesh(std::move(m)),
        model(build_brep(mesh, rules)),
        view(view_of(mesh, model)),
        normals(measure_normals(mesh, build_topology(mesh))) {}
  Modelled(const Modelled&) = delete;
  Modelled& operator=(const Modelled&) = delete;

  [[nodiscard]] std::vector<double> curvatures() const { return measure_curvatures(view, normals); }
  [[nodiscard]] std::vector<SizeSource> sources(const CurvatureRules& rules) const { return sources_of_curvature(view, rules, normals); }

  SurfaceMesh mesh;
  ClassifiedBrep model;
  ModelView view;
  FaceNormals normals;
};

bool is_upright(const Modelled& m, std::size_t t) { return std::fabs(m.normals.normals[t].z) < 0.5; }

/// The largest |1 - r k| of triangles for which `counts` holds.
template <class Counts>
double worst_error(const Modelled& m, double radius, Counts counts) {
  const std::vector<double> curvatures = m.curvatures();
  double worst = 0;
  for (std::size_t t = 0; t < curvatures.size(); ++t) {
    if (counts(t)) worst = std::max(worst, std::fabs(1 - radius * curvatures[t]));
  }
  return worst;
}

/// A triangle cut in three at a point inside it, its corners b and c by u and v; planes stay.
void cut_triangle(SurfaceMesh& mesh, std::size_t t, double u, double v) {
  const Triangle old = mesh.triangles[t];
  const Vec3d a = mesh.points[old[0].index()], b = mesh.points[old[1].index()], c = mesh.points[old[2].index()];
  const VertexId p(mesh.points.size());
  mesh.points.push_back(a + u * (b - a) + v * (c - a));
  mesh.triangles[t] = {old[0], old[1], p};
  mesh.triangles.push_back({old[1], old[2], p});
  mesh.triangles.push_back({old[2], old[0], p});
}

}  // namespace

TEST_CASE("a cylinder of 48 segments has the curvature of its circle, its caps have none", "[size]") {
  const Modelled m(make_cylinder(2.5, 7, 48));
  CHECK(worst_error(m, 2.5, [&](std::size_t t) { return is_upright(m, t); }) < 1e-12);
  const std::vector<double> curvatures = m.curvatures();
  for (std::size_t t = 0; t < curvatures.size(); ++t) {
    if (!is_upright(m, t)) CHECK(curvatures[t] < 1e-12);
  }
}

TEST_CASE("a sphere of 64 segments has the curvature of its radius within 3 %", "[size]") {
  const Modelled around_poles(make_sphere(3, 64, 32)), even(make_icosphere(3, 4));
  const double worst = worst_error(around_poles, 3, [](std::size_t) { return true; });
  const double worst_even = worst_error(even, 3, [](std::size_t) { return true; });
  CAPTURE(worst, worst_even);
  CHECK(worst < 0.03);
  CHECK(worst_even < 0.06);
}

TEST_CASE("a torus has the curvature of its smaller circle", "[size]") {
  const Modelled m(make_torus(3, 0.5, 96, 48));
  CHECK(worst_error(m, 0.5, [](std::size_t) { return true; }) < 0.01);
}

TEST_CASE("a cone has the curvature across its generators, in the middle of each facet", "[size]") {
  // Half angle 45 degrees, cut off between 1.7 and 2 from the axis: the normal radius there is sqrt(2) times as long.
  const Modelled m(revolve(std::vector<Vec2d>{{2, 0}, {1.9, 0.1}, {1.8, 0.2}, {1.7, 0.3}, {0, 0.3}, {0, 0}}, 96));
  const auto is_cone = [&](std::size_t t) { return std::fabs(m.normals.normals[t].z) < 0.8; };
  CHECK(worst_error(m, 1.85 * std::sqrt(2.), is_cone) < 0.01);
}

TEST_CASE("curvature does not depend on size and place", "[size]") {
  const Modelled m(make_torus(3, 0.5, 24, 16));
  for (const double scale : {1e-6, 1e6}) {
    SurfaceMesh moved = m.mesh;
    for (Vec3d& p : moved.points) p = scale * (Vec3d{p.y, p.z, p.x} + Vec3d{7, 1, -3});
    const Modelled other(std::move(moved));
    const std::vector<double> curvatures = m.curvatures(), others = other.curvatures();
    for (std::size_t t = 0; t < curvatures.size(); ++t) CHECK(others[t] * scale == Approx(curvatures[t]).epsilon(1e-7));
  }
}

TEST_CASE("facets cut into many triangles keep their curvature", "[size]") {
  RandomSource random(3);
  SurfaceMesh mesh = make_cylinder(1, 1, 24);
  for (int k = 0; k < 400; ++k)
    cut_triangle(mesh, random.below(mesh.triangles.size()), random.between(0.1, 0.45), random.between(0.1, 0.45));
  const Modelled m(std::move(mesh));
  CHECK(worst_error(m, 1, [&](std::size_t t) { return is_upright(m, t); }) < 1e-9);
}

TEST_CASE("triangles without height spoil no curvature", "[size]") {
  for (const double height : {1e-3, 1e-5, 1e-7, 1e-9, 1e-13}) {
    SurfaceMesh mesh = make_cylinder(1, 2, 48);
    for (std::size_t t = 0, count = mesh.triangles.size(); t < count; ++t) cut_triangle(mesh, t, 0.3, height);
    const Modelled m(std::move(mesh));
    INFO("height " << height);
    CHECK(worst_error(m, 1, [&](std::size_t t) { return is_upright(m, t); }) < 1e-3);
    for (const SizeSource& s : m.sources({.segments_per_turn = 12})) CHECK(s.strengths[0] > (height < 1e-6 ? 0.4 : 0.35));
  }
}

TEST_CASE("nothing is averaged across model edges, seams excepted", "[size]") {
  // Creases of 90 degrees all round; as one face the corners would be round.
  const Modelled box(make_box({0, 0, 0}, {1, 1, 1}));
  for (const double k : box.curvatures()) CHECK(k == 0);
  BrepRules one_face;
  one_face.features.face_angle_deg = 180;
  const Modelled round(make_box({0, 0, 0}, {1, 1, 1}), one_face);
  for (const double k : round.curvatures()) CHECK(k > 1);
  BrepRules without_seams;
  without_seams.seams = Seams::None;
  CHECK(Modelled(make_cylinder(1, 2, 48)).curvatures() == Modelled(make_cylinder(1, 2, 48), without_seams).curvatures());
}

TEST_CASE("vertices along straight pieces of a model edge do not change its radius", "[size]") {
  // A prism over 24 corners of a circle, three points on every other side.
  std::vector<Vec2d> outline;
  for (int k = 0; k < 24; ++k) {
    const Vec2d a{std::cos(k * pi / 12), std::sin(k * pi / 12)}, b{std::cos((k + 1) * pi / 12), std::sin((k + 1) * pi / 12)};
    outline.push_back(a);
    for (const double t : {0.01, 0.5, 0.7}) {
      if (k % 2 == 0) outline.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  const Modelled m(extrude(outline, 1));
  const std::vector<SizeSource> sources = m.sources({.segments_per_turn = 12});
  CHECK(std::count_if(sources.begin(), sources.end(), [](const SizeSource& s) { return s.corner_count == 2; }) == 2 * 60);
  for (const SizeSource& s : sources) CHECK(s.strengths[0] == Approx(pi / 6).epsilon(1e-6));
}

TEST_CASE("sizes follow from chord errors and numbers of segments", "[size]") {
  // Of a circle of radius 5: the chord of length 6 is 1 from it, the equilateral triangle inside the circle of radius 3 as well.
  CHECK(segment_size_for(5, {.chord_error = 1}) == 6);
  CHECK(triangle_size_for(5, {.chord_error = 1}) == Approx(3 * std::sqrt(3.)).epsilon(1e-15));
  CHECK(segment_size_for(5, {.chord_error = 9}) == 10);
  CHECK(triangle_size_for(5, {.chord_error = 9}) == Approx(5 * std::sqrt(3.)).epsilon(1e-15));
  CHECK(segment_size_for(2, {.segments_per_turn = 16}) == Approx(pi / 4).epsilon(1e-15));
  CHECK(triangle_size_for(2, {.segments_per_turn = 16}) == Approx(pi / 4).epsilon(1e-15));
  CHECK(segment_size_for(5, {.chord_error = 1, .segments_per_turn = 20}) == Approx(pi / 2).epsilon(1e-15));
  CHECK(segment_size_for(5, {.chord_error = 1, .smallest = 7}) == 7);
}

TEST_CASE("a cylinder gives triangles for its side and segments for its circles, none for caps and seams", "[size]") {
  const Modelled m(make_cylinder(2, 5, 48));
  const std::vector<SizeSource> sources = m.sources({.segments_per_turn = 16, .growth = 1.5});
  const auto triangle_count = std::count_if(sources.begin(), sources.end(), [](const SizeSource& s) { return s.corner_count == 3; });
  CHECK(triangle_count == 96);
  CHECK(sources.size() == 96 + 2 * 48);
  for (const SizeSource& s : sources) {
    CHECK(s.strengths[0] == Approx(pi / 4).epsilon(1e-12));
    CHECK(s.growth == 1.5);
    if (s.corner_count == 2) CHECK(s.corners[0].z == s.corners[1].z);
  }
  const SizingProxy proxy(sources, {.global = 10});
  CHECK(proxy.size_at({0, 0, 2.5}) == Approx(pi / 4 + 2 * std::cos(pi / 48) * 0.5).epsilon(1e-12));
}

TEST_CASE("what asks for more than the mesh is long, or than wanted, gives no source", "[size]") {
  CHECK(Modelled(make_box({0, 0, 0}, {1, 2, 3})).sources({.chord_error = 0.01}).empty());
  const Modelled ball(make_icosphere(1, 3));
  CHECK(!ball.sources({.segments_per_turn = 12}).empty());
  CHECK(ball.sources({.segments_per_turn = 12, .largest = 0.4}).empty());
  CHECK(ball.sources({.segments_per_turn = 1}).empty());
}

TEST_CASE("curvature rules that mean nothing are refused", "[size]") {
  const Modelled box(make_box({0, 0, 0}, {1, 1, 1}));
  for (const CurvatureRules& rules : {CurvatureRules{},
                                      {.chord_error = 0},
                                      {.segments_per_turn = -3},
                                      {.chord_error = std::numeric_limits<double>::quiet_NaN()},
                                      {.chord_error = 1, .smallest = -1},
                                      {.chord_error = 1, .largest = 0}})
    CHECK_THROWS_AS(box.sources(rules), Error);
  CHECK_THROWS_AS(sources_of_curvature(box.view, {.chord_error = 1}, {}), Error);
}
