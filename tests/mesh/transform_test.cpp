// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Affine maps: exact where they can be, outward stays outward, errors for maps without a meaning.
#include "mortise/mesh/transform.h"

#include <cmath>
#include <limits>

#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ErrorCode code_of(const AffineMap& map) {
  const auto error = test::error_of([&] { (void)transform(test::box({0, 0, 0}, {1, 1, 1}), map); });
  REQUIRE(error);
  return error->code;
}

}  // namespace

TEST_CASE("The identity keeps every bit", "[mesh][transform]") {
  SurfaceMesh mesh = test::box({-0.0, 1e-310, -1e308}, {1, 0.1, 1e308});
  CHECK(test::has_same_bits(transform(mesh, AffineMap{}), mesh));
}

TEST_CASE("Quarter turns are exact and counterclockwise", "[mesh][transform]") {
  const Vec3d p{0.1, 0.2, 0.3};
  CHECK(apply(rotation(Axis::Z, 90), p) == Vec3d{-0.2, 0.1, 0.3});
  CHECK(apply(rotation(Axis::X, 90), p) == Vec3d{0.1, -0.3, 0.2});
  CHECK(apply(rotation(Axis::Y, 90), p) == Vec3d{0.3, 0.2, -0.1});
  CHECK(apply(rotation(Axis::Z, 180), p) == Vec3d{-0.1, -0.2, 0.3});
  CHECK(apply(rotation(Axis::Z, -270), p) == apply(rotation(Axis::Z, 90), p));
  CHECK(apply(rotation(Axis::X, 720), p) == p);
}

TEST_CASE("A map composed of steps does the first step first", "[mesh][transform]") {
  const AffineMap map = compose(compose(scaling({2, 2, 2}), translation({1, 0, 0})), rotation(Axis::Z, 90));
  CHECK(apply(map, {3, 4, 5}) == Vec3d{-8, 7, 10});
}

TEST_CASE("Maps by powers of two are exact at the ends of the range", "[mesh][transform]") {
  CHECK(apply(scaling({0x1p-1000, 0x1p1000, 1}), {0x1.8p1000, 0x1.8p-1000, 0x1p-1074}) == Vec3d{1.5, 1.5, 0x1p-1074});
}

TEST_CASE("A mirrored solid is still oriented outwards", "[mesh][transform]") {
  const SurfaceMesh box = test::box({1, 2, 3}, {2, 4, 6});
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    const SurfaceMesh image = transform(box, mirroring(axis));
    CHECK(test::exactly_summed_volume(image) == 6);
    CHECK(test::is_balanced(image));
  }
  CHECK(test::exactly_summed_volume(transform(box, scaling({-2, 1, 1}))) == 12);
  CHECK(test::exactly_summed_volume(transform(box, compose(mirroring(Axis::X), mirroring(Axis::Y)))) == 6);
}

TEST_CASE("Labels and faces are kept", "[mesh][transform]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.face_labels.assign(12, 0);
  box.label_names = {"side"};
  const SurfaceMesh image = transform(box, rotation(Axis::X, 30));
  CHECK(image.face_labels == box.face_labels);
  CHECK(image.label_names == box.label_names);
  CHECK(image.triangles == box.triangles);
}

TEST_CASE("A map without an inverse or with entries that are no numbers is refused", "[mesh][transform]") {
  CHECK(code_of(scaling({1, 0, 1})) == ErrorCode::InvalidArgument);
  CHECK(code_of(scaling({1, infinity, 1})) == ErrorCode::InvalidArgument);
  CHECK(code_of(translation({std::nan(""), 0, 0})) == ErrorCode::InvalidArgument);
  CHECK(code_of(rotation(Axis::X, infinity)) == ErrorCode::InvalidArgument);
}

TEST_CASE("An image beyond the range of doubles names its vertices", "[mesh][transform]") {
  const SurfaceMesh mesh = test::make_mesh({{0, 0, 0}, {1e200, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto error = test::error_of([&] { (void)transform(mesh, scaling({1e200, 1, 1})); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::OutOfRange);
  CHECK(error->id_kind == IdKind::Vertices);
  CHECK(error->ids == std::vector<std::uint32_t>{1});
}

}  // namespace mortise
