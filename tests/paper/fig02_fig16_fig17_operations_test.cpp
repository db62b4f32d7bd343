// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Figs. 2, 16 and 17: every operation on two boxes and on two crossing cylinders, by volume, area, regions and fans of edges.
#include <algorithm>
#include <cmath>

#include "mortise/boolean/keep_faces.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/partition_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};

/// Two cylinders of length 4 that cross at right angles.
std::vector<SurfaceMesh> cylinders(double radius_a, double radius_b, std::uint32_t segments) {
  const AffineMap centred = translation({0, 0, -2});
  return {transform(make_cylinder(radius_a, 4, segments), centred),
          transform(transform(make_cylinder(radius_b, 4, segments), centred), rotation(Axis::Y, 90))};
}

double volume_of(Operation operation, const std::vector<SurfaceMesh>& operands) { return exact_volume(evaluate(operation, operands).mesh); }

double length_of(const IntersectionGraph& graph) {
  double sum = 0;
  for (const auto& [p, q] : graph.edges) {
    const Vec3d d = graph.points[q] - graph.points[p];
    sum += std::sqrt(dot(d, d));
  }
  return sum;
}

}  // namespace

TEST_CASE("Fig. 2: union, difference and intersection of two boxes have the volumes, areas and Euler characteristic of arithmetic",
          "[paper]") {
  const std::vector<std::tuple<Operation, double, double>> expected{
      {Operation::Union, 15, 42}, {Operation::Subtract, 7, 24}, {Operation::Intersect, 1, 6}, {Operation::SymmetricDifference, 14, 48}};
  for (const auto& [operation, volume, area] : expected) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, boxes);
    CHECK(exact_volume(result.mesh) == volume);
    CHECK(shape_of(result.mesh).area == area);
    if (operation != Operation::SymmetricDifference) CHECK(euler_characteristic(result.mesh) == 2);
  }
}

TEST_CASE("Fig. 2: the non-regular union has three regions, area 48, and four facets at every edge of the loop", "[paper]") {
  const BooleanResult result = evaluate(Operation::Partition, boxes);
  CHECK(faults_of_partition(result) == "");
  std::vector<double> volumes;
  for (const ResultRegion& r : find_result_regions(result).regions) volumes.push_back(r.volume);
  std::sort(volumes.begin(), volumes.end());
  CHECK(volumes == std::vector<double>{1, 7, 7});
  CHECK(shape_of(result.mesh).area == 48);
  CHECK(euler_with_regions(result) == 1);
  CHECK(length_of(result.graph) == 6);
  CHECK(result.graph.closed_loops == 1);
  const auto fans = fan_sizes(result.mesh);
  CHECK(fans.size() == 2);
  CHECK(fans.at(4) == result.graph.edges.size());
}

TEST_CASE("Fig. 16: deleting by tags gives the operations", "[paper]") {
  const auto kept = [](const std::vector<std::string>& names) {
    return shape_of(keep_faces(keep_mask(names), pointers_to(boxes)).mesh).area;
  };
  CHECK(kept({"10", "20"}) == 42);              // union: 11 and 21 deleted
  CHECK(kept({"11", "21"}) == 6);               // intersection: 10 and 20 deleted
  CHECK(kept({"10", "21"}) == 24);              // A - B: 11 and 20 deleted
  CHECK(kept({"20", "11"}) == 24);              // B - A: 10 and 21 deleted
  CHECK(kept({"10", "11", "20", "21"}) == 48);  // imprint and partition: none deleted
}

TEST_CASE("Fig. 17: volumes of all operations on crossing cylinders add up, and come to those of smooth ones", "[paper]") {
  for (const std::uint32_t segments : {48U, 180U}) {
    INFO(segments << " segments");
    const std::vector<SurfaceMesh> pair = cylinders(1, 0.6, segments);
    const double a = exact_volume(pair[0]), b = exact_volume(pair[1]);
    const double all = volume_of(Operation::Union, pair), common = volume_of(Operation::Intersect, pair);
    CHECK(std::abs(a + b - all - common) <= 1e-12 * (a + b));
    CHECK(std::abs(volume_of(Operation::Subtract, pair) - a + common) <= 1e-12 * a);
    CHECK(std::abs(volume_of(Operation::Subtract, {pair[1], pair[0]}) - b + common) <= 1e-12 * a);
    CHECK(std::abs(volume_of(Operation::SymmetricDifference, pair) - all + common) <= 1e-12 * (a + b));
    CHECK(all == Approx(14.93530142).epsilon(8.0 / (segments * segments)));
    CHECK(common == Approx(2.15496262).epsilon(12.0 / (segments * segments)));
  }
}

TEST_CASE("Fig. 17: the non-regular union of crossing cylinders has the area of both and four regions", "[paper]") {
  for (const std::uint32_t segments : {48U, 180U}) {
    INFO(segments << " segments");
    const std::vector<SurfaceMesh> pair = cylinders(1, 0.6, segments);
    const BooleanResult result = evaluate(Operation::Partition, pair);
    CHECK(faults_of_partition(result) == "");
    double sum = 0;
    std::vector<std::vector<std::uint32_t>> covering;
    for (const ResultRegion& r : find_result_regions(result).regions) {
      sum += r.volume;
      covering.push_back(r.operands);
    }
    std::sort(covering.begin(), covering.end());
    CHECK(covering == std::vector<std::vector<std::uint32_t>>{{0}, {0, 1}, {1}, {1}});  // the thick one stays whole round the bore
    CHECK(sum == Approx(volume_of(Operation::Union, pair)).epsilon(1e-12));
    CHECK(shape_of(result.mesh).area == Approx(shape_of(pair[0]).area + shape_of(pair[1]).area).epsilon(1e-12));
    CHECK(fan_sizes(result.mesh).at(4) == result.graph.edges.size());
    CHECK(euler_with_regions(result) == 0);  // a ball with a bore through it is a ring
  }
}

TEST_CASE("Fig. 17: equal cylinders share sixteen thirds of a cube of the radius", "[paper]") {
  const std::vector<SurfaceMesh> pair = cylinders(1, 1, 180);
  CHECK(volume_of(Operation::Intersect, pair) == Approx(16.0 / 3).epsilon(12.0 / (180 * 180)));
  const BooleanResult result = evaluate(Operation::Partition, pair);
  CHECK(faults_of_partition(result) == "");
  CHECK(find_result_regions(result).regions.size() == 5);
}
