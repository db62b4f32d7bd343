// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Half-spaces as tetrahedra, and as operands of every operation.
#include "mortise/mesh/half_space.h"

#include <cmath>
#include <limits>

#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/slice.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

BooleanResult cut(Operation operation, const SurfaceMesh& mesh, const Plane& plane, bool plane_first = false) {
  const SurfaceMesh half = make_half_space(plane, bounding_box(mesh));
  BooleanOptions options;
  options.half_spaces = {plane_first ? std::size_t{0} : std::size_t{1}};
  const std::vector<const SurfaceMesh*> operands = plane_first ? std::vector{&half, &mesh} : std::vector{&mesh, &half};
  return evaluate_boolean(operation, operands, options);
}

}  // namespace

TEST_CASE("a half-space keeps what lies behind the plane, and takes it away", "[half_space]") {
  for (const Vec3d& normal : {Vec3d{0, 0, 1}, Vec3d{0, 2, 0}, Vec3d{0.5, 0, 0}}) {
    const double size = normal.x + normal.y + normal.z;
    CHECK(enclosed_volume(cut(Operation::Intersect, unit, {normal, 0.25 * size}).mesh) == 0.25);
    CHECK(enclosed_volume(cut(Operation::Subtract, unit, {normal, 0.25 * size}).mesh) == 0.75);
    CHECK(enclosed_volume(cut(Operation::Intersect, unit, {-1 * normal, -0.25 * size}).mesh) == 0.75);
    CHECK(enclosed_volume(cut(Operation::Intersect, unit, {normal, 0.25 * size}, true).mesh) == 0.25);
  }
  CHECK(enclosed_volume(cut(Operation::Intersect, unit, {{1, 1, 1}, 1}).mesh) == Approx(1.0 / 6).epsilon(1e-15));
  CHECK(enclosed_volume(cut(Operation::Intersect, unit, {{1, -1, 0}, 0}).mesh) == 0.5);
}

TEST_CASE("planes beside the mesh and on its faces keep all or nothing", "[half_space]") {
  for (const double z : {1.0, 2.0, 1e6}) {
    CHECK(enclosed_volume(cut(Operation::Intersect, unit, {{0, 0, 1}, z}).mesh) == 1);
    CHECK(cut(Operation::Subtract, unit, {{0, 0, 1}, z}).mesh.triangles.empty());
  }
  for (const double z : {0.0, -2.0, -1e6}) {
    CHECK(cut(Operation::Intersect, unit, {{0, 0, 1}, z}).mesh.triangles.empty());
    CHECK(enclosed_volume(cut(Operation::Subtract, unit, {{0, 0, 1}, z}).mesh) == 1);
  }
}

TEST_CASE("any direction and place: parts add up, and the cut has the area of the section", "[half_space]") {
  const SurfaceMesh torus = make_torus(3, 1, 40, 20);
  const double volume = enclosed_volume(torus), area = surface_area(torus);
  for (int i = 0; i < 12; ++i) {
    const Plane plane{{std::sqrt(1.0 + i) - 2, std::sqrt(3.0 + 5 * i) - 4, std::sqrt(2.0 + 3 * i) - 3.1}, 0.3 * i - 1};
    const BooleanResult behind = cut(Operation::Intersect, torus, plane), before = cut(Operation::Subtract, torus, plane);
    CHECK(behind.report.certificate.status == CertificateStatus::Certified);
    CHECK(enclosed_volume(behind.mesh) + enclosed_volume(before.mesh) == Approx(volume).epsilon(1e-12));
    const double section = slice(torus, plane).area;
    CHECK(surface_area(behind.mesh) + surface_area(before.mesh) == Approx(area + 2 * section).epsilon(1e-12));
    const ResultRegions regions = find_result_regions(cut(Operation::Partition, torus, plane));
    CHECK(regions.is_closed);
    CHECK(regions.total_volume() == Approx(volume).epsilon(1e-12));
    CHECK(regions.regions.size() == find_result_regions(behind).regions.size() + find_result_regions(before).regions.size());
  }
}

TEST_CASE("a result that would reach to infinity is refused", "[half_space]") {
  const Plane middle{{0, 0, 1}, 0.5};
  for (const Operation operation : {Operation::Union, Operation::SymmetricDifference}) {
    const auto error = error_of([&] { (void)cut(operation, unit, middle); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::InvalidArgument);
    CHECK(error->message.find("infinity") != std::string::npos);
  }
  CHECK(error_of([&] { (void)cut(Operation::Subtract, unit, middle, true); }));
  const SurfaceMesh half = make_half_space(middle, bounding_box(unit));
  const std::vector<const SurfaceMesh*> operands{&unit, &half};
  BooleanOptions options;
  options.half_spaces = {1};
  CHECK(enclosed_volume(evaluate_expression("a & !b", operands, options).mesh) == 0.5);
}

TEST_CASE("planes that are none, and nothing to cut", "[half_space]") {
  const auto code_of = [](const Plane& plane, const Box3& bounds) {
    const auto error = error_of([&] { (void)make_half_space(plane, bounds); });
    return error ? error->code : ErrorCode::InternalError;
  };
  CHECK(code_of({{0, 0, 0}, 1}, bounding_box(unit)) == ErrorCode::InvalidArgument);
  CHECK(code_of({{0, 0, std::numeric_limits<double>::quiet_NaN()}, 1}, bounding_box(unit)) == ErrorCode::InvalidArgument);
  CHECK(code_of({{0, 0, 1}, 1}, Box3{}) == ErrorCode::InvalidArgument);
}
