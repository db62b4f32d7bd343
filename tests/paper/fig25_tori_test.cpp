// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 25: eight tori united and partitioned in one call, and in seven calls.
#include <algorithm>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/partition_checks.h"
#include "support/scene_list.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

std::vector<SurfaceMesh> eight_tori() {
  std::vector<SurfaceMesh> tori;
  for (const ListedScene& scene : listed_scenes()) {
    if (scene.name != "Fig. 25 eight tori") continue;
    for (const std::string& text : scene.operands) tori.push_back(load_operand(text));
  }
  return tori;
}

struct Totals {
  double volume = 0, area = 0;
  std::size_t regions = 0;
};

Totals totals_of(const BooleanResult& result) {
  const ResultRegions regions = find_result_regions(result);
  Totals totals{0, shape_of(result.mesh).area, regions.regions.size()};
  for (const ResultRegion& r : regions.regions) totals.volume += r.volume;
  return totals;
}

/// One torus after the other, each partitioned with the regions of all before it.
BooleanResult chained(const std::vector<SurfaceMesh>& tori) {
  BooleanResult result = evaluate(Operation::Partition, {tori[0]});
  for (std::size_t i = 1; i < tori.size(); ++i) {
    const ResultRegions regions = find_result_regions(result);
    std::vector<SurfaceMesh> parts{tori[i]};
    for (std::uint32_t r = 0; r < regions.regions.size(); ++r) parts.push_back(region_mesh(result, regions, r));
    result = evaluate(Operation::Partition, parts);
    CHECK(faults_of_partition(result) == "");
  }
  return result;
}

/// The same with the partition as it is, one operand with walls.
BooleanResult chained_with_walls(const std::vector<SurfaceMesh>& tori) {
  BooleanResult result = evaluate(Operation::Partition, {tori[0]});
  for (std::size_t i = 1; i < tori.size(); ++i) result = evaluate(Operation::Partition, {tori[i], result.mesh});
  return result;
}

}  // namespace

TEST_CASE("Fig. 25: eight tori have the same regions in one partition and in seven, in any order", "[paper][scenario]") {
  if (is_data_missing()) return;
  std::vector<SurfaceMesh> tori = eight_tori();
  REQUIRE(tori.size() == 8);
  const BooleanResult at_once = evaluate(Operation::Partition, tori);
  CHECK(faults_of_partition(at_once) == "");
  const Totals totals = totals_of(at_once);
  // Each torus meets its two neighbours in one piece each, no three meet, and what is left of a torus stays in one piece.
  CHECK(totals.regions == 16);
  CHECK(totals.volume == Approx(13.2696560214).epsilon(1e-9));
  double area = 0;
  for (const SurfaceMesh& torus : tori) area += shape_of(torus).area;
  CHECK(totals.area == Approx(area).epsilon(1e-12));
  if (is_reduced_run()) return;
  std::rotate(tori.begin(), tori.begin() + 3, tori.end());
  std::swap(tori[1], tori[6]);
  for (const Totals& one_by_one : {totals_of(chained(tori)), totals_of(chained_with_walls(tori))}) {
    CHECK(one_by_one.regions == totals.regions);
    CHECK(one_by_one.volume == Approx(totals.volume).epsilon(1e-9));
    CHECK(one_by_one.area == Approx(totals.area).epsilon(1e-9));
  }
}

namespace {

/// The union of the tori one after the other, in this order.
BooleanResult united_in_turn(const std::vector<SurfaceMesh>& tori, const std::vector<std::size_t>& order) {
  BooleanResult result = evaluate(Operation::Union, {tori[order[0]]});
  for (std::size_t i = 1; i < order.size(); ++i) {
    result = evaluate(Operation::Union, {result.mesh, tori[order[i]]});
    CHECK(faults_of_mesh(result) == "");
  }
  return result;
}

}  // namespace

TEST_CASE("Fig. 25: eight tori have the same volume, area and genus in one union and in seven, in any order", "[paper][scenario]") {
  if (is_data_missing()) return;
  const std::vector<SurfaceMesh> tori = eight_tori();
  REQUIRE(tori.size() == 8);
  const BooleanResult at_once = evaluate(Operation::Union, tori);
  CHECK(faults_of_mesh(at_once) == "");
  const Shape expected = shape_of(at_once.mesh);
  CHECK(expected.genus == 9);  // 1 and 8 c with c = 1 piece of overlap between neighbours
  CHECK(expected.volume == Approx(13.2696560214).epsilon(1e-9));
  const std::vector<std::vector<std::size_t>> orders{
      {0, 1, 2, 3, 4, 5, 6, 7}, {7, 6, 5, 4, 3, 2, 1, 0}, {0, 4, 2, 6, 1, 5, 3, 7}, {3, 0, 7, 2, 5, 1, 6, 4}};
  for (const std::vector<std::size_t>& order : orders) {
    const Shape shape = shape_of(united_in_turn(tori, order).mesh);
    CHECK(shape.genus == expected.genus);
    CHECK(shape.volume == Approx(expected.volume).epsilon(1e-12));
    CHECK(shape.area == Approx(expected.area).epsilon(1e-12));
    if (is_reduced_run()) return;
  }
}
