// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// validate names what is wrong.
#include "mortise/mesh/validate.h"

#include <limits>

#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

Error error_for(const SurfaceMesh& mesh) {
  const auto error = test::error_of([&] { validate(mesh); });
  REQUIRE(error);
  return *error;
}

}  // namespace

TEST_CASE("Good and empty meshes pass", "[mesh][validate]") {
  CHECK_NOTHROW(validate(SurfaceMesh{}));
  SurfaceMesh box = test::box({-1e308, 0, 0}, {1e308, 1, 0x1p-1074});
  box.face_labels.assign(12, 1);
  box.label_names = {"a", "b"};
  CHECK_NOTHROW(validate(box));
}

TEST_CASE("Coordinates that are not finite are named by vertex", "[mesh][validate]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.points[3].y = std::numeric_limits<double>::quiet_NaN();
  box.points[6].z = -std::numeric_limits<double>::infinity();
  const Error error = error_for(box);
  CHECK(error.code == ErrorCode::NotFinite);
  CHECK(error.stage == "validate");
  CHECK(error.id_kind == IdKind::Vertices);
  CHECK(error.ids == std::vector<std::uint32_t>{3, 6});
}

TEST_CASE("Indices out of range are named by face", "[mesh][validate]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.triangles[5][1] = VertexId(8);
  box.triangles[7][2] = VertexId();
  const Error error = error_for(box);
  CHECK(error.code == ErrorCode::BadIndex);
  CHECK(error.id_kind == IdKind::Faces);
  CHECK(error.ids == std::vector<std::uint32_t>{5, 7});
}

TEST_CASE("Labels are one per face and have names", "[mesh][validate]") {
  SurfaceMesh box = test::box({0, 0, 0}, {1, 1, 1});
  box.label_names = {"only"};
  box.face_labels.assign(11, 0);
  CHECK(error_for(box).code == ErrorCode::InvalidArgument);
  box.face_labels.assign(12, 0);
  box.face_labels[4] = 1;
  const Error error = error_for(box);
  CHECK(error.code == ErrorCode::InvalidArgument);
  CHECK(error.ids == std::vector<std::uint32_t>{4});
}

}  // namespace mortise
