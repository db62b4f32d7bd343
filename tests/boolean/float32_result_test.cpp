// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Results with float32 coordinates: certified as such, free of crossings by the oracle, and near the results in doubles.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mortise/base/error.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/inspect.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/random_checks.h"
#include "support/scene_list.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

BooleanResult evaluate_in_float32(Operation operation, const std::vector<SurfaceMesh>& operands) {
  BooleanOptions options;
  options.coordinates = Coordinates::Float32;
  return evaluate_boolean(operation, pointers_to(operands), options);
}

bool is_certified(const BooleanResult& result) { return result.report.certificate.status == CertificateStatus::Certified; }

bool is_given_up(const BooleanResult& result) {
  return !is_certified(result) && !result.report.notes.empty() &&
         result.report.notes.back().starts_with("float32 coordinates are too coarse");
}

bool are_float32(const std::vector<Vec3d>& points) {
  for (const Vec3d& p : points) {
    for (std::size_t i = 0; i < 3; ++i) {
      const volatile float stored = static_cast<float>(p[i]);
      if (static_cast<double>(stored) != p[i]) return false;
    }
  }
  return true;
}

struct Tally {
  std::size_t results = 0, repaired = 0, snapped = 0, given_up = 0;

  void add(const BooleanResult& result) {
    const Certificate& certificate = result.report.certificate;
    ++results;
    repaired += certificate.merge_rounds + certificate.swap_rounds + certificate.snap_rounds > 0 ? 1 : 0;
    snapped += certificate.snap_rounds > 0 ? 1 : 0;
    given_up += is_given_up(result) ? 1 : 0;
  }

  void print(const char* family) const {
    std::printf("float32, %-18s %4zu results: %4zu repaired, %3zu of them snapped, %2zu given up\n", family, results, repaired, snapped,
                given_up);
  }
};

// A point of the surface moved by the displacement at most, so the volume did by no more than that times the area.
void check_near(const BooleanResult& exact, const BooleanResult& rounded) {
  const ResultRegions before = find_result_regions(exact), after = find_result_regions(rounded);
  double area_before = 0, area_after = 0;
  for (const ResultRegion& region : before.regions) area_before += region.area;
  for (const ResultRegion& region : after.regions) area_after += region.area;
  const double moved = rounded.report.certificate.largest_displacement + exact.report.certificate.largest_displacement;
  CHECK(std::abs(before.total_volume() - after.total_volume()) <= 2 * std::max(area_before, area_after) * moved);
}

void check(Operation operation, const std::vector<SurfaceMesh>& operands, Tally& tally) {
  INFO(operation_name(operation));
  const BooleanResult exact = evaluate(operation, operands), rounded = evaluate_in_float32(operation, operands);
  tally.add(rounded);
  CHECK(are_float32(rounded.mesh.points));
  if (is_given_up(rounded)) return;
  CHECK(is_certified(rounded));
  const bool is_quick = !is_reduced_run() || rounded.mesh.triangles.size() <= 20000;
  if (is_quick) CHECK((oracle::self_crossings(rounded.mesh).empty() || !oracle::self_crossings(exact.mesh).empty()));
  if (operation != Operation::Partition && exact.report.sheets.empty()) CHECK(is_balanced(rounded.mesh));
  check_near(exact, rounded);
}

}  // namespace

TEST_CASE("the listed scenes have certified float32 results, unless they lie too far out", "[float32][scenario]") {
  Tally tally;
  for (const ListedScene& scene : listed_scenes()) {
    if (scene.needs_data && is_data_missing()) continue;
    INFO(scene.name);
    std::vector<SurfaceMesh> operands;
    std::size_t triangles = 0;
    for (const std::string& text : scene.operands) operands.push_back(load_operand(text));
    for (const SurfaceMesh& operand : operands) triangles += operand.triangles.size();
    if (triangles > (is_reduced_run() ? 2000U : is_long_run() ? 30000U : 10000U)) continue;
    const std::size_t given_up = tally.given_up;
    for (const Operation operation : {Operation::Union, Operation::Subtract, Operation::Partition}) check(operation, operands, tally);
    const bool is_far = scene.name == "icospheres far away" || scene.name == "cubes at 1e9";
    const bool vanishes = scene.name == "tori turned by what rounding makes of it";  // their difference
    CHECK((tally.given_up > given_up) == (is_far || vanishes));
  }
  CHECK(tally.snapped > 0);
  tally.print("listed scenes");
}

TEST_CASE("random solids of ordinary size have certified float32 results", "[float32]") {
  Tally tally;
  for (std::size_t i = 0; i < scaled_count(150, 5000); ++i) {
    INFO("case " << i);
    const RandomCase drawn = make_random_case(7, i);
    double largest = 0;
    for (const SurfaceMesh& operand : drawn.operands) largest = std::max(largest, largest_coordinate(operand));
    if (largest > 1e6 || largest < 1e-6) continue;
    for (const Operation operation : {Operation::Union, Operation::Subtract}) check(operation, drawn.operands, tally);
  }
  CHECK(tally.results > 0);
  tally.print("random solids");
}

TEST_CASE("sources and data of float32 results are those of the operands", "[float32]") {
  const SurfaceMesh ball = make_icosphere(1, 3);
  const std::vector<SurfaceMesh> operands{ball, transform(ball, rotation(Axis::X, 1e-5))};
  const BooleanResult result = evaluate_in_float32(Operation::Union, operands);
  CHECK(is_certified(result));
  const Provenance& p = result.provenance;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    if (p.vertex_operand[v] == Provenance::none) continue;
    ++kept;
    const Vec3d& source = operands[p.vertex_operand[v]].points[p.vertex_source[v]];
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(result.mesh.points[v][i] - source[i]) <= 0x1p-24 * std::abs(source[i]));
  }
  CHECK(kept > 0);
}

TEST_CASE("what no float32 holds is refused; what float32 does not tell apart is not certified", "[float32]") {
  const SurfaceMesh huge = make_box({0, 0, 0}, {1e39, 1, 1}), far = make_box({1e9, 0, 0}, {1e9 + 1, 1, 1});
  CHECK(error_of([&] { (void)evaluate_in_float32(Operation::Union, {huge, huge}); })->code == ErrorCode::OutOfRange);
  const BooleanResult result = evaluate_in_float32(Operation::Union, {far, far});
  CHECK(is_given_up(result));
  CHECK(result.report.certificate.largest_displacement >= 1);
}
