// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a result says of places its coordinates could not be proven at.
#include "mortise/boolean/exact_places.h"

#include <algorithm>
#include <set>

#include "mortise/boolean/keep_faces.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/self_crossing_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// Makes the point that some points define.
Vec3d nearest_of(std::span<const Vec3d> definition) {
  PointSet set;
  std::vector<PointId> p;
  for (const Vec3d& point : definition) p.push_back(set.add_input(point));
  if (p.size() == 1) return set.nearest(p[0]);
  if (p.size() == 5) return set.nearest(set.add_line_plane({p[0], p[1]}, {p[2], p[3], p[4]}));
  if (p.size() == 9) return set.nearest(set.add_three_planes({p[0], p[1], p[2]}, {p[3], p[4], p[5]}, {p[6], p[7], p[8]}));
  REQUIRE(p.size() == 4);
  const Vec3d normal = cross(definition[1] - definition[0], definition[3] - definition[2]);
  const Axis axis = normal.x != 0 ? Axis::X : normal.y != 0 ? Axis::Y : Axis::Z;
  return set.nearest(set.add_line_line({p[0], p[1]}, {p[2], p[3]}, axis));
}

/// Are the places those of the corners of failed faces, and is each vertex its place, in the coordinates of the result?
void check_places(const BooleanResult& result, Coordinates coordinates) {
  const Certificate& certificate = result.report.certificate;
  const ExactPlaces& places = certificate.exact_places;
  std::set<std::uint32_t> corners;
  for (const std::uint32_t f : certificate.failed_faces) {
    for (const VertexId v : result.mesh.triangles.at(f)) corners.insert(v.value);
  }
  REQUIRE(places.vertices == std::vector<std::uint32_t>(corners.begin(), corners.end()));
  REQUIRE(places.begin.size() == places.vertices.size() + 1);
  for (std::size_t i = 0; i < places.vertices.size(); ++i) {
    const Vec3d nearest = nearest_of(std::span(places.points).subspan(places.begin[i], places.begin[i + 1] - places.begin[i]));
    CHECK(result.mesh.points[places.vertices[i]] == (coordinates == Coordinates::Float32 ? nearest_float32(nearest) : nearest));
  }
}

std::size_t made_places(const BooleanResult& result) {
  const std::vector<std::uint32_t>& begin = result.report.certificate.exact_places.begin;
  std::size_t made = 0;
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) made += begin[i + 1] - begin[i] > 1 ? 1 : 0;
  return made;
}

/// Connected, pushed through itself in one place, which calls about other places do not look for.
SurfaceMesh crossed_torus() {
  SurfaceMesh torus = make_torus(3, 1, 24, 12);
  for (Vec3d& p : torus.points) {
    if (p.x > 3.9) p.x -= 3;
  }
  return torus;
}

/// Two balls that overlap, far from the origin.
std::vector<SurfaceMesh> balls_at(double x, std::uint32_t levels) {
  const SurfaceMesh ball = moved(make_icosphere(1, levels), {x, 0, 0});
  return {ball, transform(ball, compose(rotation(Axis::X, 1), translation({0.5, 0.3, 0.2})))};
}

BooleanOptions in_float32() {
  BooleanOptions options;
  options.coordinates = Coordinates::Float32;
  return options;
}

BooleanOptions absolute() {
  BooleanOptions options;
  options.certify = CertificateLevel::Absolute;
  return options;
}

}  // namespace

TEST_CASE("coordinates too coarse for a mesh come with the places they stand for", "[exact_places]") {
  const BooleanResult result = evaluate_boolean(Operation::Union, pointers_to(balls_at(1e8, 5)), in_float32());
  CHECK(result.report.certificate.status == CertificateStatus::Uncertified);
  CHECK(made_places(result) > 0);
  check_places(result, Coordinates::Float32);
}

TEST_CASE("a repair that there is no room for leaves the result uncertified", "[exact_places]") {
  BooleanOptions options = in_float32();
  options.contact_memory = 1U << 20U;
  const BooleanResult result = evaluate_boolean(Operation::Union, pointers_to(balls_at(1e7, 3)), options);
  CHECK(result.report.certificate.status == CertificateStatus::Uncertified);
  REQUIRE(!result.report.notes.empty());
  CHECK(result.report.notes.back().find("too much memory") != std::string::npos);
  CHECK(!result.mesh.triangles.empty());
  check_places(result, Coordinates::Float32);
}

TEST_CASE("a certified result has no places to tell", "[exact_places]") {
  const std::vector<SurfaceMesh> scene{make_icosphere(1, 3), moved(make_icosphere(1, 3), {0.5, 0.3, 0.2})};
  const BooleanResult result = evaluate_boolean(Operation::Union, pointers_to(scene));
  CHECK(result.report.certificate.exact_places.vertices.empty());
  check_places(result, Coordinates::Float64);
}

TEST_CASE("failed faces and their places follow the faces that are kept", "[exact_places][keep_faces]") {
  const std::vector<SurfaceMesh> scene{crossed_torus(), box({-4.5, -0.5, -0.5}, {-3.5, 0.5, 2})};
  std::size_t failed = 0;
  for (unsigned mask = 1; mask < 64; mask *= 2) {
    const BooleanResult piece = keep_faces(static_cast<KeepMask>(mask), pointers_to(scene), absolute());
    check_places(piece, Coordinates::Float64);
    failed += piece.report.certificate.failed_faces.size();
  }
  const BooleanResult all = keep_faces(63, pointers_to(scene), absolute());
  CHECK(failed == all.report.certificate.failed_faces.size());
  CHECK(failed > 0);
}

TEST_CASE("failed faces and their places follow what sheets leave", "[exact_places][sheets]") {
  const SurfaceMesh torus = crossed_torus();
  for (const double x : {-2.5, -2.0, -1.5}) {
    const SurfaceMesh sheet = transform(make_grid_sheet(20, 20, 1, 1), compose(rotation(Axis::Y, 90), translation({x, -10, 10})));
    const BooleanResult result = evaluate_boolean(Operation::Subtract, pointers_to(std::vector<SurfaceMesh>{torus, sheet}), absolute());
    std::set<std::uint32_t> crossing;
    for (const oracle::MeetingPair& pair : oracle::self_crossings(result.mesh)) crossing.insert({pair.face_a, pair.face_b});
    const std::vector<std::uint32_t>& failed = result.report.certificate.failed_faces;
    CHECK(std::includes(failed.begin(), failed.end(), crossing.begin(), crossing.end()));
    CHECK(!failed.empty());
    check_places(result, Coordinates::Float64);
  }
}
