// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Copies turned so little that rounding folds their intersection: what comes of them after the last repair.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/equal_bits.h"
#include "support/imprint_checks.h"
#include "support/mesh_checks.h"
#include "support/partition_checks.h"
#include "support/random_source.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh labelled(SurfaceMesh mesh, const char* name) {
  mesh.label_names = {"none", name};
  mesh.face_labels.assign(mesh.triangles.size(), 1);
  return mesh;
}

AffineMap random_pose(RandomSource& random) {
  const double y = random.between(0, 360), x = random.between(0, 360);
  return compose(rotation(Axis::X, x), rotation(Axis::Y, y));
}

std::vector<SurfaceMesh> ring_and_copy(std::uint64_t seed) {
  RandomSource random(seed);
  const AffineMap pose = random_pose(random);
  const SurfaceMesh ring = transform(make_torus(1, 0.375, 12, 8), pose);
  const double radians = std::pow(10.0, -10 - static_cast<int>(random.below(6)));
  return {labelled(ring, "ring"), labelled(transform(ring, rotation(Axis::Z, trig::to_degrees(radians))), "copy")};
}

bool is_certified(const BooleanResult& result) { return result.report.certificate.status == CertificateStatus::Certified; }
bool is_snapped(const BooleanResult& result) { return result.report.certificate.snap_rounds > 0; }

/// Calls check(solids) for scenes whose symmetric difference has to be snapped; these are most.
template <class Check>
void for_snapped_scenes(std::size_t count, Check check) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 4 * count; ++seed) {
    const std::vector<SurfaceMesh> solids = ring_and_copy(seed);
    if (found == count || !is_snapped(evaluate(Operation::SymmetricDifference, solids))) continue;
    INFO("seed " << seed);
    ++found;
    check(solids);
  }
  CHECK(found == count);
}

double slack_of(const BooleanResult& result) {
  return identity_tolerance(exact_volume(result.mesh), surface_area(result.mesh), result.report, largest_coordinate(result.mesh));
}

SurfaceMesh scaled_by_power(SurfaceMesh mesh, int exponent) {
  for (Vec3d& p : mesh.points) p = std::ldexp(1.0, exponent) * p;
  return mesh;
}

}  // namespace

TEST_CASE("what rounding folded beyond merging is certified after snapping, and knows where it comes from", "[snapping]") {
  for_snapped_scenes(scaled_count(12, 400), [](const std::vector<SurfaceMesh>& solids) {
    const auto operands = pointers_to(solids);
    for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference}) {
      INFO(operation_name(operation));
      const BooleanResult result = evaluate(operation, solids);
      CHECK(faults_of(operands, result, Repairs::Allowed) == "");
      CHECK(oracle::self_crossings(result.mesh).empty());
      CHECK(oracle::faces_without_area(result.mesh).empty());
      for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
        const bool is_of_ring = result.mesh.label_names[result.mesh.face_labels[f]] == "ring";
        CHECK(is_of_ring == (result.provenance.source_operand[f] == 0));
      }
    }
  });
}

TEST_CASE("snapped results enclose what the operands do", "[snapping]") {
  for_snapped_scenes(scaled_count(12, 400), [](const std::vector<SurfaceMesh>& solids) {
    const BooleanResult either = evaluate(Operation::Union, solids), both = evaluate(Operation::Intersect, solids),
                        one = evaluate(Operation::SymmetricDifference, solids), parts = evaluate(Operation::Partition, solids);
    const double sum = exact_volume(solids[0]) + exact_volume(solids[1]);
    const double whole = exact_volume(either.mesh), common = exact_volume(both.mesh);
    CHECK(std::abs(whole + common - sum) <= slack_of(either) + slack_of(both));
    CHECK(std::abs(whole - common - exact_volume(one.mesh)) <= slack_of(either) + slack_of(both) + slack_of(one));
    CHECK(faults_of_partition(parts) == "");
    CHECK(std::abs(find_result_regions(parts).total_volume() - whole) <= slack_of(either) + slack_of(parts));
  });
}

TEST_CASE("snapped imprints share numbers, and every operand stays closed by itself", "[snapping]") {
  std::size_t snapped = 0;
  for_snapped_scenes(scaled_count(12, 400), [&](const std::vector<SurfaceMesh>& solids) {
    const ImprintResult result = imprint(pointers_to(solids));
    CHECK(is_certified(result.whole));
    CHECK(faults_of_numbering(pointers_to(solids), result) == "");
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(is_balanced(result.operands[k].mesh));
      CHECK(std::abs(exact_volume(result.operands[k].mesh) - exact_volume(solids[k])) <= slack_of(result.whole));
    }
    snapped += is_snapped(result.whole) ? 1 : 0;
  });
  CHECK(snapped > 0);
}

TEST_CASE("snapping depends on neither the order of operands nor powers of two", "[snapping]") {
  for_snapped_scenes(scaled_count(12, 400), [](const std::vector<SurfaceMesh>& solids) {
    const BooleanResult result = evaluate(Operation::SymmetricDifference, solids);
    const BooleanResult backwards = evaluate(Operation::SymmetricDifference, {solids[1], solids[0]});
    CHECK(sorted_points(backwards.mesh) == sorted_points(result.mesh));
    CHECK(backwards.mesh.triangles.size() == result.mesh.triangles.size());
    for (const int exponent : {-200, 100}) {
      const std::vector<SurfaceMesh> far{scaled_by_power(solids[0], exponent), scaled_by_power(solids[1], exponent)};
      const BooleanResult scaled_result = evaluate(Operation::SymmetricDifference, far);
      CHECK(sorted_points(scaled_result.mesh) == sorted_points(scaled_by_power(result.mesh, exponent)));
      CHECK(scaled_result.mesh.triangles == result.mesh.triangles);
      CHECK(scaled_result.report.certificate.moved_input_vertices == result.report.certificate.moved_input_vertices);
    }
  });
}

TEST_CASE("vertex data of snapped results stays that of the operands", "[snapping]") {
  for_snapped_scenes(scaled_count(4, 100), [](std::vector<SurfaceMesh> solids) {
    for (SurfaceMesh& mesh : solids) {
      DataChannel height{"height", 1, DataKind::Value, {}};
      for (const Vec3d& p : mesh.points) height.values.push_back(p.z);
      mesh.vertex_data.push_back(height);
    }
    const BooleanResult result = evaluate(Operation::SymmetricDifference, solids);
    REQUIRE(is_snapped(result));
    const std::vector<double>& values = result.mesh.corner_data.at(0).values;
    const double moved = 4 * result.report.certificate.largest_displacement;  // slopes seen along an axis
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double z = result.mesh.points[result.mesh.triangles[f][i].index()].z;
        CHECK(std::abs(values[3 * f + i] - z) <= moved);
      }
    }
  });
}

TEST_CASE("a vertex of snapped operands has the bits of its source, the sign of a zero too", "[snapping]") {
  // Three copies of an octahedron; the first two meet in a point that rounds to a vertex of the second but for the sign of a zero.
  constexpr double below = 0x1p-2 - 0x1p-55, above = 0x1p-2 + 0x1p-54, tiny = 3.552195457048878e-17;
  SurfaceMesh first, second, third;
  first.points = {{0.5, 0, 0.25}, {0.25, 0.25, 0.25}, {0, 0, 0.25}, {0.25, -0.25, 0.25}, {0.25, 0, 0.5}, {0.25, 0, 0}};
  second.points = {{0.5, -0.0, below},     {0.25, below, below},    {0, -0.0, below},
                   {above, -below, above}, {0.25, -0.0, 2 * below}, {above, 0, 0}};
  third.points = {{0.5, 0, 0.24999999999999992}, {above, 0.25, below},  {tiny, 0, 0.25},
                  {above, -0.25, below},         {above, 0, 2 * below}, {0.25, 0, -tiny}};
  for (SurfaceMesh* mesh : {&first, &second, &third}) {
    mesh->triangles.clear();
    for (std::size_t i = 0; i < 4; ++i) mesh->triangles.push_back({VertexId(i), VertexId((i + 1) % 4), VertexId(4)});
    for (std::size_t i = 0; i < 4; ++i) mesh->triangles.push_back({VertexId((i + 1) % 4), VertexId(i), VertexId(5)});
  }
  const std::vector<SurfaceMesh> solids{first, second, third};
  const BooleanResult result = evaluate(Operation::Union, solids);
  REQUIRE(is_snapped(result));
  std::size_t negative_zeros = 0;
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    const std::uint32_t k = result.provenance.vertex_operand[v];
    if (k == Provenance::none) continue;
    const Vec3d &p = result.mesh.points[v], &source = solids[k].points[result.provenance.vertex_source[v]];
    CHECK(have_equal_bits(p, source));
    negative_zeros += source.y == 0 && std::signbit(source.y) ? 1 : 0;
  }
  CHECK(negative_zeros > 0);
}

TEST_CASE("a sheet next to a face of a solid is cut, and certified, after snapping", "[snapping]") {
  std::size_t snapped = 0;
  const std::size_t enough = scaled_count(10, 250);
  for (std::uint64_t seed = 1; snapped < enough && seed <= 10000; ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const AffineMap pose = random_pose(random);
    const SurfaceMesh sheet = transform(make_grid_sheet(3, 3, 5, 5), pose);
    const SurfaceMesh solid = transform(make_torus(1, 0.375, 12, 8), compose(pose, rotation(Axis::X, 1e-14)));
    for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Partition}) {
      const BooleanResult result = evaluate(operation, {solid, sheet});
      CHECK(is_certified(result));
      CHECK(oracle::self_crossings(result.mesh).empty());
      snapped += is_snapped(result) ? 1 : 0;
    }
  }
  CHECK(snapped >= enough);
}

TEST_CASE("snapping can be cancelled", "[snapping]") {
  for_snapped_scenes(1, [](const std::vector<SurfaceMesh>& solids) {
    BooleanOptions options;
    std::size_t reports = 0;
    options.progress = [&](std::string_view stage, double) { return stage != "repair_by_snapping" || ++reports < 3; };
    const auto error = error_of([&] { (void)symmetric_difference(solids[0], solids[1], options); });
    REQUIRE(error.has_value());
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(reports == 3);
  });
}
