// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Many operands in one call: grids of boxes, sponges by differences, and pencils of planes through one line.
#include <algorithm>

#include "mortise/mesh/extrude_to.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// n x n x n boxes of one size, one unit apart.
std::vector<SurfaceMesh> grid_of_boxes(int n, double side, bool every_second = false) {
  std::vector<SurfaceMesh> boxes;
  for (int i = 0; i < n * n * n; ++i) {
    const int x = i % n, y = i / n % n, z = i / (n * n);
    if (every_second && (x + y + z) % 2 != 0) continue;
    const Vec3d lo{1.0 * x, 1.0 * y, 1.0 * z};
    boxes.push_back(i % 3 == 0 ? box_other_diagonals(lo, lo + Vec3d{side, side, side}) : box(lo, lo + Vec3d{side, side, side}));
  }
  return boxes;
}

/// A cube of side 3^level, and the bars along the three axes that leave a Menger sponge of it.
std::vector<SurfaceMesh> sponge_operands(int level, double overhang) {
  const double side = level == 1 ? 3 : 9;
  std::vector<SurfaceMesh> operands{box({0, 0, 0}, {side, side, side})};
  for (double width = side / 3; width >= 1; width /= 3) {
    for (double u = width; u < side; u += 3 * width) {
      for (double v = width; v < side; v += 3 * width) {
        const SurfaceMesh along_z = box({u, v, -overhang}, {u + width, v + width, side + overhang});
        operands.insert(operands.end(), {along_z, with_axes_turned(along_z), with_axes_turned(with_axes_turned(along_z))});
      }
    }
  }
  return operands;
}

/// Twenty points on a convex curve, opposite ones exactly opposite: the lines through opposite ones all pass the origin.
std::array<double, 2> curve_point(std::size_t i) {
  constexpr double half[10][2] = {{12, 0}, {11, 4}, {10, 7}, {8, 9}, {4, 11}, {0, 12}, {-4, 11}, {-8, 9}, {-10, 7}, {-11, 4}};
  const double sign = i / 10 % 2 == 0 ? 1 : -1;
  return {sign * half[i % 10][0], sign * half[i % 10][1]};
}

/// Twice the area between the rays to curve points i and i + 1.
double twice_sector_area(std::size_t i) {
  const auto p = curve_point(i), q = curve_point(i + 1);
  return p[0] * q[1] - p[1] * q[0];
}

/// What lies left of the line through curve points i and i + 10: sectors i .. i + 9.
SurfaceMesh half_disc(std::size_t i, double height) {
  std::vector<std::array<double, 2>> polygon;
  for (std::size_t k = 0; k <= 10; ++k) polygon.push_back(curve_point(i + k));
  return prism(polygon, -height, height);
}

std::vector<SurfaceMesh> half_discs(double height_step) {
  std::vector<SurfaceMesh> discs;
  for (std::size_t i = 0; i < 10; ++i) discs.push_back(half_disc(i, 1 + height_step * static_cast<double>(i)));
  return discs;
}

/// Volume of all sectors from first to last, each twice as high as `height_of(sector)`.
template <class Height>
double sector_volume(std::size_t first, std::size_t last, const Height& height_of) {
  double volume = 0;
  for (std::size_t s = first; s <= last; ++s) volume += twice_sector_area(s) * height_of(s);
  return volume;
}

void check_faultless(const std::vector<SurfaceMesh>& operands, const BooleanResult& result) {
  CHECK(faults_of(pointers_to(operands), result) == "");
}

}  // namespace

TEST_CASE("6^3 touching boxes unite to one box, and have nothing in common") {
  const std::vector<SurfaceMesh> boxes = grid_of_boxes(6, 1);
  const BooleanResult result = evaluate(Operation::Union, boxes);
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 216 && shape.area == 216));
  CHECK((shape.shells == 1 && shape.genus == 0 && shape.pinched_edges == 0));
  CHECK(result.mesh.triangles.size() == 6 * 36 * 2);
  check_faultless(boxes, result);
  CHECK(evaluate(Operation::Intersect, boxes).mesh.triangles.empty());
}

TEST_CASE("subtracting 215 touching boxes from one leaves it") {
  const BooleanResult result = evaluate(Operation::Subtract, grid_of_boxes(6, 1));
  CHECK((shape_of(result.mesh).volume == 1 && shape_of(result.mesh).area == 6));
}

TEST_CASE("2,000 boxes in one union", "[large]") {
  std::vector<SurfaceMesh> boxes;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d lo{static_cast<double>(i % 20), static_cast<double>(i / 20 % 10), static_cast<double>(i / 200)};
    boxes.push_back(box(lo, lo + Vec3d{1, 1, 1}));
  }
  const BooleanResult touching = evaluate(Operation::Union, boxes);
  CHECK((shape_of(touching.mesh).volume == 2000 && shape_of(touching.mesh).shells == 1));
  CHECK(shape_of(touching.mesh).area == 2 * (200 + 200 + 100));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    boxes[i] = moved(boxes[i], {0.25 * static_cast<double>(i % 7), 0.125 * static_cast<double>(i % 5), 0});
  const BooleanResult overlapping = evaluate(Operation::Union, boxes);
  CHECK(faults_of_mesh(overlapping) == "");
  CHECK(overlapping.report.certificate.status == CertificateStatus::Certified);
}

TEST_CASE("1,000 spheres taken from a block in one call", "[large]") {
  const SurfaceMesh sphere = make_icosphere(0.375, 2);
  std::vector<SurfaceMesh> operands{box({0, 0, 0}, {10, 10, 10})};
  for (int i = 0; i < 1000; ++i) {
    operands.push_back(moved(sphere, {0.5 + i % 10, 0.5 + i / 10 % 10, 0.5 + i / 100}));
  }
  const BooleanResult result = evaluate(Operation::Subtract, operands);
  CHECK(shape_of(result.mesh).shells == 1001);
  CHECK(shape_of(result.mesh).volume == Approx(1000 - 1000 * shape_of(sphere).volume).epsilon(1e-12));
  CHECK(result.report.certificate.status == CertificateStatus::Certified);
}

TEST_CASE("two flush decks of a hundred thousand triangles each share one overlay", "[large]") {
  const auto deck = [](double z) { return extrude_to(make_grid_sheet(1, 1, 220, 220), z); };
  SurfaceMesh upper = deck(1);
  for (Vec3d& p : upper.points) p = {0.5 + 0.48 * (p.x - 0.5) - 0.36 * (p.y - 0.5), 0.5 + 0.36 * (p.x - 0.5) + 0.48 * (p.y - 0.5), p.z};
  const SurfaceMesh lower = deck(-1);
  const double contact = enclosed_volume(upper);  // the upper deck is one high
  const BooleanResult result = evaluate(Operation::Union, {lower, upper});
  CHECK(enclosed_volume(result.mesh) == Approx(1 + contact).epsilon(1e-12));
  CHECK(result.report.contact.area == Approx(contact).epsilon(1e-12));
  CHECK(result.report.certificate.status == CertificateStatus::Certified);
}

TEST_CASE("6^3 overlapping boxes unite to one box of side 6.5") {
  const std::vector<SurfaceMesh> boxes = grid_of_boxes(6, 1.5);
  const BooleanResult result = evaluate(Operation::Union, boxes);
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 274.625 && shape.area == 253.5));
  CHECK((shape.shells == 1 && shape.genus == 0 && shape.pinched_edges == 0));
  check_faultless(boxes, result);
  const BooleanResult rest = evaluate(Operation::Subtract, boxes);
  CHECK((shape_of(rest.mesh).volume == 1 && shape_of(rest.mesh).area == 6));
  check_faultless(boxes, rest);
  CHECK(oracle::volume(result.mesh, exact_positions(pointers_to(boxes), result)) == oracle::Rational(2197, 8));
}

TEST_CASE("3^3 boxes of side 3 have one box of side 1 in common") {
  const std::vector<SurfaceMesh> boxes = grid_of_boxes(3, 3);
  const BooleanResult result = evaluate(Operation::Intersect, boxes);
  CHECK((shape_of(result.mesh).volume == 1 && shape_of(result.mesh).area == 6));
  check_faultless(boxes, result);
}

TEST_CASE("every second box of a grid touches its neighbours along edges only") {
  const std::vector<SurfaceMesh> boxes = grid_of_boxes(6, 1, true);
  const BooleanResult result = evaluate(Operation::Union, boxes);
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 108 && shape.area == 648));
  CHECK(result.mesh.triangles.size() == 108 * 12);
  CHECK(result.report.contact.area == 0);
  check_faultless(boxes, result);
}

TEST_CASE("a Menger sponge of level 1 has genus 5") {
  for (const double overhang : {0.0, 1.0}) {
    const std::vector<SurfaceMesh> operands = sponge_operands(1, overhang);
    const BooleanResult result = evaluate(Operation::Subtract, operands);
    const Shape shape = shape_of(result.mesh);
    CHECK((shape.volume == 20 && shape.area == 72));
    CHECK((shape.shells == 1 && shape.genus == 5 && shape.pinched_edges == 0));
    check_faultless(operands, result);
  }
}

TEST_CASE("a Menger sponge of level 2 on whole coordinates has volume 400, area 1056 and genus 81") {
  for (const double overhang : {0.0, 1.0}) {
    const std::vector<SurfaceMesh> operands = sponge_operands(2, overhang);
    const BooleanResult result = evaluate(Operation::Subtract, operands);
    const Shape shape = shape_of(result.mesh);
    CHECK((shape.volume == 400 && shape.area == 1056));
    CHECK((shape.shells == 1 && shape.genus == 81 && shape.pinched_edges == 0));
    check_faultless(operands, result);
    CHECK(oracle::volume(result.mesh, exact_positions(pointers_to(operands), result)) == 400);
  }
}

TEST_CASE("the order of the bars does not change the sponge") {
  std::vector<SurfaceMesh> operands = sponge_operands(2, 1);
  const BooleanResult forward = evaluate(Operation::Subtract, operands);
  std::reverse(operands.begin() + 1, operands.end());
  const BooleanResult backward = evaluate(Operation::Subtract, operands);
  CHECK(forward.mesh.triangles.size() == backward.mesh.triangles.size());
  CHECK(sorted_points(forward.mesh) == sorted_points(backward.mesh));
}

TEST_CASE("ten half discs cut by ten planes through one line leave the expected sectors") {
  const std::vector<SurfaceMesh> discs = half_discs(0);
  const auto one = [](std::size_t) { return 1.0; };
  const BooleanResult all = evaluate(Operation::Union, discs), common = evaluate(Operation::Intersect, discs),
                      first = evaluate(Operation::Subtract, discs);
  CHECK(exact_volume(all.mesh) == sector_volume(0, 18, one));
  CHECK(exact_volume(common.mesh) == sector_volume(9, 9, one));
  CHECK(exact_volume(first.mesh) == sector_volume(0, 0, one));
  for (const BooleanResult* result : {&all, &common, &first}) check_faultless(discs, *result);
}

TEST_CASE("ten half discs of different heights leave nine corners on the line their planes share") {
  const std::vector<SurfaceMesh> discs = half_discs(1);
  // Sector s is in the discs i with i <= s <= i + 9; the highest of them is min(s, 9), the lowest max(s - 9, 0).
  const auto highest = [](std::size_t s) { return 1.0 + static_cast<double>(std::min<std::size_t>(s, 9)); };
  const BooleanResult all = evaluate(Operation::Union, discs), common = evaluate(Operation::Intersect, discs);
  CHECK(exact_volume(all.mesh) == sector_volume(0, 18, highest));
  CHECK(exact_volume(common.mesh) == sector_volume(9, 9, [](std::size_t) { return 1.0; }));
  for (const BooleanResult* result : {&all, &common}) check_faultless(discs, *result);
  const auto points = sorted_points(all.mesh);
  for (double z = 1; z <= 9; ++z) CHECK(std::binary_search(points.begin(), points.end(), std::array<double, 3>{0, 0, z}));
}

TEST_CASE("ten wedges round one edge unite without it") {
  std::vector<SurfaceMesh> wedges;
  for (std::size_t i = 0; i < 20; i += 2)
    wedges.push_back(prism({{0, 0}, curve_point(i), curve_point(i + 1), curve_point((i + 2) % 20)}, 0, 1));
  const BooleanResult result = evaluate(Operation::Union, wedges);
  const Shape shape = shape_of(result.mesh);
  CHECK(shape.volume == sector_volume(0, 19, [](std::size_t) { return 0.5; }));
  CHECK((shape.shells == 1 && shape.genus == 0 && shape.pinched_edges == 0));
  check_faultless(wedges, result);
}
