// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Partitions: regions and who covers them, volumes by the oracle, internal faces once.
#include <algorithm>

#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/partition_checks.h"
#include "support/random_solids.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Operands = std::vector<std::uint32_t>;

BooleanResult partition_of(const std::vector<SurfaceMesh>& operands) { return evaluate(Operation::Partition, operands); }

std::vector<std::pair<Operands, double>> covered_volumes(const BooleanResult& result) {
  std::vector<std::pair<Operands, double>> volumes;
  for (const ResultRegion& r : find_result_regions(result).regions) volumes.emplace_back(r.operands, r.volume);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

using Volumes = std::vector<std::pair<Operands, double>>;

void check_against_oracle(const std::vector<SurfaceMesh>& solids) {
  const auto operands = pointers_to(solids);
  const BooleanResult result = partition_of(solids);
  CHECK(faults_of_partition(result) == "");
  CHECK(faults_of_provenance(operands, result, Repairs::None) == "");
  // Two parts of one operand that touch far from the other operand stay as they are.
  const bool is_clean = std::all_of(solids.begin(), solids.end(), [](const SurfaceMesh& m) { return oracle::self_crossings(m).empty(); });
  if (is_clean) CHECK(oracle::self_crossings(result.mesh).empty());
  CHECK(exact_volumes(operands, result) == expected_volumes(operands));
}

}  // namespace

TEST_CASE("regions of the small scenes have exactly the oracle's volumes for every set of operands", "[partition]") {
  for (const Scene& scene : small_scenes()) {
    if (scene.operands.size() > 4) continue;
    INFO(scene.name);
    check_against_oracle(scene.operands);
  }
}

TEST_CASE("regions of random solids have exactly the oracle's volumes for every set of operands", "[partition]") {
  for (std::size_t seed = 1; seed <= scaled_count(300, 6000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    check_against_oracle(random.next(seed % 10 == 0 ? 4 : seed % 3 == 0 ? 3 : 2));
  }
}

TEST_CASE("regions of random solids with cavities and several parts have exactly the oracle's volumes", "[partition]") {
  for (std::size_t seed = 1; seed <= scaled_count(100, 2000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    check_against_oracle({random.next_of_all_kinds(), random.next_of_all_kinds()});
  }
}

TEST_CASE("two cubes that share a face have that face once, with both sources and both regions", "[partition]") {
  const BooleanResult result = partition(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}));
  CHECK(faults_of_partition(result) == "");
  CHECK(covered_volumes(result) == Volumes{{{0}, 1}, {{1}, 1}});
  CHECK(fan_sizes(result.mesh)[3] == 4);
  CHECK(shape_of(result.mesh).area == 11);
  const ResultRegions regions = find_result_regions(result);
  std::size_t shared = 0;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const auto& begin = result.provenance.other_source_begin;
    const bool has_two_sources = begin[f] != begin[f + 1];
    CHECK(has_two_sources == (regions.region_in_front[f] != ResultRegions::none));
    if (!has_two_sources) continue;
    ++shared;
    CHECK(result.provenance.category[f] == FacetCategory::OnOpposite);
    CHECK(regions.region_of_facet[f] != regions.region_in_front[f]);
  }
  CHECK(result.mesh.triangles.size() == 20 + shared);
}

TEST_CASE("three spheres that overlap are seven regions", "[partition]") {
  const SurfaceMesh ball = make_icosphere(1, 3);
  const std::vector<SurfaceMesh> balls{ball, transform(ball, translation({0.75, 0.1, 0.05})),
                                       transform(ball, translation({0.3, 0.7, 0.2}))};
  const BooleanResult result = partition_of(balls);
  CHECK(faults_of_partition(result) == "");
  const auto volumes = covered_volumes(result);
  REQUIRE(volumes.size() == 7);
  double sum = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    sum += volumes[i].second;
    for (std::size_t j = 0; j < i; ++j) CHECK(volumes[i].first != volumes[j].first);
  }
  CHECK(sum == Approx(exact_volume(evaluate(Operation::Union, balls).mesh)).epsilon(1e-12));
  CHECK(euler_with_regions(result) == 1);
}

TEST_CASE("a cube in a cavity is a region, the gap round it is none", "[partition]") {
  const SurfaceMesh hollow = joined({box({0, 0, 0}, {6, 6, 6}), inside_out(box({1, 1, 1}, {5, 5, 5}))});
  const BooleanResult loose = partition_of({hollow, box({2, 2, 2}, {3, 3, 3})});
  CHECK(faults_of_partition(loose) == "");
  CHECK(covered_volumes(loose) == Volumes{{{0}, 152}, {{1}, 1}});
  const BooleanResult tight = partition_of({hollow, box({1, 1, 1}, {5, 5, 5})});
  CHECK(faults_of_partition(tight) == "");
  CHECK(covered_volumes(tight) == Volumes{{{0}, 152}, {{1}, 64}});
  CHECK(tight.mesh.triangles.size() >= 24);
}

TEST_CASE("a solid in a solid, and deeper, are shells of regions", "[partition]") {
  const BooleanResult nested = partition_of({box({1, 1, 1}, {5, 5, 5}), box({0, 0, 0}, {6, 6, 6}), box({2, 2, 2}, {3, 3, 3})});
  CHECK(faults_of_partition(nested) == "");
  CHECK(covered_volumes(nested) == Volumes{{{0, 1}, 63}, {{0, 1, 2}, 1}, {{1}, 152}});
}

TEST_CASE("parts of one operand that touch in a corner or an edge are regions of their own", "[partition]") {
  const SurfaceMesh corner = joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})});
  const SurfaceMesh edge = joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})});
  for (const SurfaceMesh& pair : {corner, edge}) {
    CHECK(covered_volumes(partition_of({pair})) == Volumes{{{0}, 1}, {{0}, 1}});
    CHECK(covered_volumes(partition_of({pair, box({5, 5, 5}, {6, 6, 6})})) == Volumes{{{0}, 1}, {{0}, 1}, {{1}, 1}});
    const BooleanResult cut = partition_of({pair, box({0, 0, 0}, {2, 2, 0.5})});
    CHECK(faults_of_partition(cut) == "");
  }
}

TEST_CASE("a partition of an operand with itself is the operand, covered twice", "[partition]") {
  const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
  const BooleanResult twice = partition_of({unit, unit});
  CHECK(twice.mesh.triangles.size() == 12);
  CHECK(covered_volumes(twice) == Volumes{{{0, 1}, 1}});
}

TEST_CASE("a partition of the regions of a partition changes nothing, nor does the order of operands", "[partition]") {
  for (std::size_t seed = 1; seed <= scaled_count(60, 1000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    std::vector<SurfaceMesh> solids = random.next(3);
    const BooleanResult once = partition_of(solids);
    std::reverse(solids.begin(), solids.end());
    const BooleanResult reversed = partition_of(solids);
    CHECK(sorted_points(once.mesh) == sorted_points(reversed.mesh));
    CHECK(once.mesh.triangles.size() == reversed.mesh.triangles.size());
    const ResultRegions regions = find_result_regions(once);
    std::vector<SurfaceMesh> parts;
    for (std::uint32_t r = 0; r < regions.regions.size(); ++r) parts.push_back(region_mesh(once, regions, r));
    const BooleanResult again = partition_of(parts);
    CHECK(sorted_points(again.mesh) == sorted_points(once.mesh));
    CHECK(again.mesh.triangles.size() == once.mesh.triangles.size());
    CHECK(find_result_regions(again).regions.size() == parts.size());
  }
}

TEST_CASE("a partition that had to be repaired is certified with closed regions", "[partition]") {
  std::size_t repaired = 0;
  for (std::size_t seed = 1; seed <= scaled_count(300, 5000); ++seed) {
    INFO("seed " << seed);
    const std::vector<SurfaceMesh> solids = slightly_off(RandomSolids(seed).next(2 + seed % 2));
    const BooleanResult result = partition_of(solids);
    const Certificate& certificate = result.report.certificate;
    CHECK(certificate.status == CertificateStatus::Certified);
    if (certificate.repair_displacement == 0) continue;
    ++repaired;
    CHECK(faults_of_partition(result) == "");
    CHECK(oracle::self_crossings(result.mesh).empty());
    const BooleanResult all = evaluate(Operation::Union, solids);
    const double volume = enclosed_volume(all.mesh), coordinate = largest_coordinate(all.mesh);
    const double slack = identity_tolerance(volume, surface_area(result.mesh), result.report, coordinate) +
                         identity_tolerance(volume, surface_area(all.mesh), all.report, coordinate);
    CHECK(std::abs(find_result_regions(result).total_volume() - volume) <= slack);
  }
  CHECK(repaired > scaled_count(300, 5000) / 6);
}

TEST_CASE("five solids that fill a box are closed regions whose exact volumes add up to that of their union", "[partition][scenario]") {
  if (is_data_missing()) return;
  std::vector<SurfaceMesh> solids;
  for (const char* name : {"bottomAir", "leftSolid", "rightSolid", "topAir", "heater"}) {
    solids.push_back(read_data(std::string("cad/cht_") + name + ".stl"));
  }
  const BooleanResult result = partition_of(solids);
  CHECK(faults_of_partition(result) == "");
  const auto operands = pointers_to(solids);
  oracle::Rational sum = 0;
  for (const auto& [covering, volume] : exact_volumes(operands, result)) sum += volume;
  const BooleanResult united = evaluate(Operation::Union, solids);
  CHECK(sum == oracle::volume(united.mesh, exact_positions(operands, united)));
  CHECK(find_result_regions(result).total_volume() == Approx(0.0016).epsilon(1e-9));
}

TEST_CASE("the partition of nothing that has volume is empty", "[partition]") {
  const BooleanResult result = partition_of({SurfaceMesh{}, SurfaceMesh{}});
  CHECK(result.mesh.triangles.empty());
  CHECK(find_result_regions(result).regions.empty());
}
