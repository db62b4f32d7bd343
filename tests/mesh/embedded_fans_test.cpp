// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Embedded fans: what is marked must hold for every pair of faces round the vertex; what is not a closed fan is not marked.
#include "mortise/mesh/embedded_fans.h"

#include <algorithm>

#include "mortise/base/trig.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_source.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

std::vector<std::uint8_t> marks_of(const SurfaceMesh& mesh) { return find_embedded_fans(mesh, build_topology(mesh)); }

std::size_t marked(const SurfaceMesh& mesh) {
  const std::vector<std::uint8_t> marks = marks_of(mesh);
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

/// Two apexes over a polygon that goes round `turns` times.
SurfaceMesh bipyramid(std::size_t sides, std::size_t turns) {
  std::vector<Vec3d> points{{0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<std::size_t, 3>> faces;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 360.0 * static_cast<double>(i * turns) / static_cast<double>(sides);
    points.push_back({trig::cos_deg(angle), trig::sin_deg(angle), 0});
    const std::size_t a = 2 + i, b = 2 + (i + 1) % sides;
    faces.push_back({0, a, b});
    faces.push_back({1, b, a});
  }
  return make_mesh(points, faces);
}

void check_marks(const SurfaceMesh& mesh) {
  const std::vector<std::uint8_t> marks = marks_of(mesh);
  std::vector<std::vector<FaceId>> faces_of(mesh.points.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const VertexId v : mesh.triangles[f]) faces_of[v.index()].push_back(FaceId(f));
  }
  for (std::size_t v = 0; v < marks.size(); ++v) {
    if (marks[v] == 0) continue;
    for (const FaceId f : faces_of[v]) {
      for (const FaceId g : faces_of[v]) {
        if (f < g) CHECK(classify_meeting(mesh, f, g) == PairMeeting::Apart);
      }
    }
  }
}

}  // namespace

TEST_CASE("fans of smooth closed surfaces are marked, those of corners, borders and pinches are not") {
  const SurfaceMesh sphere = make_icosphere(1, 4);
  CHECK(marked(sphere) == sphere.points.size());
  CHECK(marked(make_torus(3, 1, 48, 24)) == 48 * 24);
  CHECK(marked(make_box({0, 0, 0}, {1, 1, 1})) == 0);
  CHECK(marked(make_grid_sheet(4, 4, 4, 4)) == 3 * 3);  // not the border
  CHECK(marked(joined({sphere, sphere})) == 2 * sphere.points.size());
  CHECK(marked({}) == 0);
}

TEST_CASE("a fan that goes round its vertex twice is not marked") {
  CHECK(marks_of(bipyramid(7, 1))[0] == 1);
  CHECK(marks_of(bipyramid(7, 1))[1] == 1);
  CHECK(marks_of(bipyramid(7, 2))[0] == 0);
  CHECK(marks_of(bipyramid(7, 3))[1] == 0);
  SurfaceMesh two = joined({bipyramid(7, 1), bipyramid(5, 1)});  // two fans that share an apex
  for (Triangle& t : two.triangles) std::replace(t.begin(), t.end(), VertexId(std::size_t{9}), VertexId(std::size_t{0}));
  CHECK(marks_of(two)[0] == 0);
  CHECK(marks_of(two)[1] == 1);
}

TEST_CASE("faces round a marked vertex of a crumpled surface do not cross") {
  std::size_t marks = 0;
  for (std::size_t seed = 1; seed <= scaled_count(200, 4000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    SurfaceMesh mesh = random.once_in(2) ? make_icosphere(1, 2) : make_torus(1, 0.5, 12, 8);
    const double noise = random.octaves(-5, 0);
    for (Vec3d& p : mesh.points) p = p + random.point(-noise, noise);
    if (random.once_in(4)) {  // coordinates that are often equal
      for (Vec3d& p : mesh.points) p = {std::floor(4 * p.x), std::floor(4 * p.y), std::floor(4 * p.z)};
    }
    check_marks(mesh);
    marks += marked(mesh);
  }
  CHECK(marks > scaled_count(200, 4000) * 20);
}
