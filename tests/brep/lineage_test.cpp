// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where entities come from, on results whose entities are known.
#include "mortise/brep/lineage.h"

#include <set>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/models.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr EntityDimension vertex = EntityDimension::Vertex, edge = EntityDimension::Edge, face = EntityDimension::Face,
                          region = EntityDimension::Region;

std::size_t count_results(const ResultModel& m, std::uint32_t operand, EntityDimension dimension) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < entity_count(m.operands[operand].model.brep, dimension); ++i) {
    count += m.lineage.results_of({operand, {dimension, i}}).size();
  }
  return count;
}

}  // namespace

TEST_CASE("entities far from the other operand come from themselves", "[brep][lineage]") {
  const ResultModel m(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {6, 1, 1})});
  for (std::uint32_t k = 0; k < 2; ++k) {
    CHECK(count_results(m, k, vertex) == 8);
    CHECK(count_results(m, k, edge) == 12);
    CHECK(count_results(m, k, face) == 6);
    CHECK(count_results(m, k, region) == 1);
  }
  for (const LineageLink& l : m.lineage.by_result) {
    CHECK(measure(m.result, l.result) == (l.result.dimension == vertex ? 0 : 1));
    CHECK(l.measure == 1);
  }
}

TEST_CASE("two boxes that overlap at a corner: what is left, what is cut, what is new", "[brep][lineage]") {
  const ResultModel m(Operation::Union, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  CHECK(count_results(m, 0, vertex) == 7);
  CHECK(count_results(m, 0, face) == 6);
  CHECK(count_results(m, 0, edge) == 12);
  CHECK(m.lineage.sources_of({region, 1}).size() == 2);
  std::size_t new_vertices = 0, new_edges = 0;
  for (std::uint32_t v = 0; v < m.model.brep.vertex_count; ++v) new_vertices += m.lineage.sources_of({vertex, v}).empty() ? 1 : 0;
  for (std::uint32_t e = 0; e < m.model.brep.edges.size(); ++e) new_edges += m.lineage.sources_of({edge, e}).empty() ? 1 : 0;
  CHECK(new_vertices == 6);
  CHECK(new_edges == 6);
  double area = 0, length = 0;
  for (const LineageLink& l : m.lineage.by_result) {
    area += l.result.dimension == face ? l.measure : 0;
    length += l.result.dimension == edge ? l.measure : 0;
  }
  CHECK(area == 42);
  CHECK(length == 2 * (12 * 2 - 3));
}

TEST_CASE("regions of a partition come from the regions that contain them", "[brep][lineage]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2})});
  REQUIRE(m.model.brep.region_count == 3);
  std::multiset<std::pair<double, std::size_t>> found;  // volume, sources
  for (std::uint32_t r = 1; r < 3; ++r) found.emplace(measure(m.result, {region, r}), m.lineage.sources_of({region, r}).size());
  CHECK(found == std::multiset<std::pair<double, std::size_t>>{{1, 2}, {63, 1}});
}

TEST_CASE("what an operation leaves hollow comes from no region", "[brep][lineage]") {
  const ResultModel hollow(Operation::Subtract, {box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2})});
  REQUIRE(hollow.model.brep.region_count == 3);
  REQUIRE(count_results(hollow, 0, region) == 1);
  CHECK(measure(hollow.result, hollow.lineage.results_of({0, {region, 1}})[0].result) == 63);
  CHECK(count_results(hollow, 1, region) == 0);
  const ResultModel either(Operation::SymmetricDifference, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  for (std::uint32_t k = 0; k < 2; ++k) {
    REQUIRE(count_results(either, k, region) == 1);
    CHECK(measure(either.result, either.lineage.results_of({k, {region, 1}})[0].result) == 7);
  }
}

TEST_CASE("of an operand in several pieces the one round a region is its source", "[brep][lineage]") {
  const SurfaceMesh two = joined({box({0, 0, 0}, {4, 4, 4}), box({5, 0, 0}, {9, 4, 4})});
  const ResultModel m(Operation::Intersect, {box({6, 1, 1}, {7, 2, 2}), two});
  REQUIRE(m.model.brep.region_count == 2);
  const auto sources = m.lineage.sources_of({region, 1});
  REQUIRE(sources.size() == 2);
  CHECK(sources[1].source == OperandEntity{1, {region, 2}});
}

TEST_CASE("coincident faces, edges and vertices come from both operands", "[brep][lineage]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  std::size_t common[3] = {0, 0, 0};
  for (const EntityDimension dimension : {vertex, edge, face}) {
    for (std::uint32_t i = 0; i < entity_count(m.model.brep, dimension); ++i) {
      common[static_cast<std::size_t>(dimension)] += m.lineage.sources_of({dimension, i}).size() == 2 ? 1 : 0;
    }
  }
  CHECK(common[0] == 4);
  CHECK(common[1] == 4);
  CHECK(common[2] >= 1);
}

TEST_CASE("areas in common add up to those of the result's faces, for random solids", "[brep][lineage]") {
  for (std::size_t seed = 1; seed <= scaled_count(30, 500); ++seed) {
    INFO("seed " << seed);
    for (const Operation operation : {Operation::Union, Operation::Subtract, Operation::Partition}) {
      const ResultModel m(operation, RandomSolids(seed).next(2));
      for (std::uint32_t f = 0; f < m.model.brep.faces.size(); ++f) {
        double first = 0;
        for (const LineageLink& l : m.lineage.sources_of({face, f})) first += l.source.operand == 0 ? l.measure : 0;
        double second = 0;
        for (const LineageLink& l : m.lineage.sources_of({face, f})) second += l.source.operand == 1 ? l.measure : 0;
        const double area = measure(m.result, {face, f});
        CHECK(std::max(first, second) <= area * (1 + 1e-12));
        CHECK(first + second >= area * (1 - 1e-12));
      }
    }
  }
}

TEST_CASE("a void of a result comes from nothing, though operands filled it", "[brep][lineage]") {
  const ResultModel m(Operation::Subtract, {box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2})});
  REQUIRE(m.model.brep.region_count == 3);
  CHECK(m.lineage.sources_of({region, 1}).size() == 1);
  CHECK(m.lineage.sources_of({region, 2}).empty());
  CHECK(m.lineage.results_of({1, {region, 1}}).empty());
}
