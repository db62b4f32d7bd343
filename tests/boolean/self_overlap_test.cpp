// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operands that overlap or touch themselves: what they cover counts once, wherever the others meet them.
#include <algorithm>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/self_crossing_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh cube(double lo, double hi) { return box({lo, lo, lo}, {hi, hi, hi}); }

const std::vector<SurfaceMesh> two_cubes{cube(0, 4), cube(2, 6)};
const SurfaceMesh overlapping = joined(two_cubes);  // covers 64 + 64 - 8 = 120

double volume_of(Operation operation, const std::vector<SurfaceMesh>& parts) {
  return oracle::nearest_double(oracle::boolean_volume(operation, pointers_to(parts)));
}

BooleanResult checked(Operation operation, const std::vector<SurfaceMesh>& operands) {
  BooleanResult result = evaluate(operation, operands);
  CHECK(faults_of(pointers_to(operands), result) == "");
  CHECK(oracle::self_crossings(result.mesh).empty());
  return result;
}

bool is_reported(const BooleanResult& result, std::uint32_t operand) {
  const auto& operands = result.report.self_contacts;
  return std::find(operands.begin(), operands.end(), operand) != operands.end();
}

}  // namespace

TEST_CASE("one operand that overlaps itself unites to what it covers") {
  const BooleanResult result = checked(Operation::Union, {overlapping});
  CHECK(exact_volume(result.mesh) == 120);
  CHECK(is_reported(result, 0));
}

TEST_CASE("a clean operand alone comes back as it was") {
  const BooleanResult result = checked(Operation::Union, {cube(0, 1)});
  CHECK(result.mesh.points == cube(0, 1).points);
  CHECK(result.mesh.triangles == cube(0, 1).triangles);
  CHECK(result.report.self_contacts.empty());
}

TEST_CASE("an operand that overlaps itself is right when another crosses the overlap") {
  const SurfaceMesh bar = box({1, 3, 3}, {5, 3.5, 9});
  const BooleanResult all = checked(Operation::Union, {overlapping, bar});
  CHECK(exact_volume(all.mesh) == volume_of(Operation::Union, {two_cubes[0], two_cubes[1], bar}));
  CHECK(is_reported(all, 0));
  CHECK(!is_reported(all, 1));
  CHECK(exact_volume(checked(Operation::Subtract, {bar, overlapping}).mesh) ==
        volume_of(Operation::Subtract, {bar, two_cubes[0], two_cubes[1]}));
  const double common = exact_volume(bar) + 120 - exact_volume(all.mesh);
  CHECK(exact_volume(checked(Operation::Intersect, {overlapping, bar}).mesh) == common);
  CHECK(exact_volume(checked(Operation::Subtract, {overlapping, bar}).mesh) == 120 - common);
}

TEST_CASE("an operand that overlaps itself is right when another crosses it elsewhere") {
  const SurfaceMesh bar = box({-1, 0.5, 0.5}, {1, 1, 1});
  CHECK(exact_volume(checked(Operation::Union, {overlapping, bar}).mesh) == 120.25);
  CHECK(exact_volume(checked(Operation::Subtract, {overlapping, bar}).mesh) == 119.75);
}

TEST_CASE("an operand that overlaps itself is right when nothing touches it") {
  CHECK(exact_volume(checked(Operation::Union, {overlapping, cube(10, 11)}).mesh) == 121);
  CHECK(exact_volume(checked(Operation::Subtract, {overlapping, cube(10, 11)}).mesh) == 120);
  CHECK(exact_volume(checked(Operation::Subtract, {cube(-1, 7), overlapping}).mesh) == 512 - 120);
}

TEST_CASE("a part inside another part of its operand is covered twice and counts once") {
  const SurfaceMesh nested = joined({cube(0, 3), cube(1, 2)});
  CHECK(exact_volume(checked(Operation::Union, {nested}).mesh) == 27);
  CHECK(exact_volume(checked(Operation::Union, {nested, cube(10, 11)}).mesh) == 28);
  CHECK(exact_volume(checked(Operation::Union, {nested, cube(2, 4)}).mesh) == 27 + 8 - 1);
  CHECK(exact_volume(checked(Operation::Subtract, {nested, box({1.25, 1.25, -1}, {1.75, 1.75, 9})}).mesh) == 27 - 0.75);
}

TEST_CASE("every face twice is the same solid") {
  const SurfaceMesh twice = joined({cube(0, 2), cube(0, 2)});
  const BooleanResult alone = checked(Operation::Union, {twice});
  CHECK(alone.mesh.triangles.size() == 12);
  CHECK(exact_volume(checked(Operation::Union, {twice, cube(1, 3)}).mesh) == 15);
  CHECK(exact_volume(checked(Operation::Subtract, {cube(1, 3), twice}).mesh) == 7);
}

TEST_CASE("a fin without thickness disappears") {
  SurfaceMesh finned = cube(0, 1);
  finned.points.push_back({1, 0.5, 1.5});
  const VertexId tip(8), from(5), to(7);
  finned.triangles.push_back({from, to, tip});
  finned.triangles.push_back({to, from, tip});
  CHECK(checked(Operation::Union, {finned}).mesh.triangles.size() == 12);
  CHECK(exact_volume(checked(Operation::Union, {finned, box({0.5, 0.25, 0.5}, {1.5, 0.75, 2})}).mesh) == 1 + 0.75 - 0.125);
}

TEST_CASE("faces without area are dropped and their points split the edges they lie on") {
  SurfaceMesh mesh = cube(0, 1);
  mesh.points.push_back({0.5, 0, 0});
  mesh.triangles.push_back({VertexId(0), VertexId(8), VertexId(1)});
  mesh.triangles.push_back({VertexId(2), VertexId(2), VertexId(3)});
  mesh.triangles.push_back({VertexId(4), VertexId(5), VertexId(4)});
  CHECK(exact_volume(checked(Operation::Union, {mesh}).mesh) == 1);
  CHECK(exact_volume(checked(Operation::Union, {mesh, cube(0.25, 2)}).mesh) == 1 + 5.359375 - 0.421875);
}

TEST_CASE("an edge split on one side only is a closed solid after edge recovery") {
  SurfaceMesh mesh = cube(0, 1);
  mesh.points.push_back({0.5, 0, 0});
  // The bottom is (0, 2, 3), (0, 3, 1); the second becomes two.
  mesh.triangles.erase(mesh.triangles.begin() + 1);
  mesh.triangles.push_back({VertexId(0), VertexId(3), VertexId(8)});
  mesh.triangles.push_back({VertexId(8), VertexId(3), VertexId(1)});
  CHECK(exact_volume(checked(Operation::Union, {mesh}).mesh) == 1);
  CHECK(exact_volume(checked(Operation::Intersect, {mesh, cube(0.25, 2)}).mesh) == 0.421875);
}

TEST_CASE("unmerged corners are welded") {
  const SurfaceMesh cubes = cube(0, 1);
  SurfaceMesh soup;
  for (std::size_t f = 0; f < 12; ++f) {
    for (const Vec3d& p : oracle::corners_of(cubes, f)) soup.points.push_back(p);
    soup.triangles.push_back({VertexId(3 * f), VertexId(3 * f + 1), VertexId(3 * f + 2)});
  }
  const BooleanResult result = checked(Operation::Union, {soup, cube(0.5, 2)});
  CHECK(exact_volume(result.mesh) == 1 + 3.375 - 0.125);
}

TEST_CASE("three parts of one operand that cross in one place") {
  const std::vector<SurfaceMesh> bars{box({-3, -1, -1}, {3, 1, 1}), box({-1, -3, -1}, {1, 3, 1}), box({-1, -1, -3}, {1, 1, 3})};
  CHECK(exact_volume(checked(Operation::Union, {joined(bars)}).mesh) == 8 + 6 * 8);
  CHECK(exact_volume(checked(Operation::Subtract, {cube(-3, 3), joined(bars)}).mesh) == 216 - 56);
  CHECK(exact_volume(checked(Operation::Subtract, {joined(bars), cube(-1, 1)}).mesh) == 48);
}

TEST_CASE("where the windings of the parts cancel is outside") {
  // A box and an inside-out box that sticks out of it: winding 1, 0 and -1.
  const SurfaceMesh dented = joined({cube(0, 4), inside_out(box({1, 1, 1}, {2, 2, 6}))});
  CHECK(exact_volume(checked(Operation::Union, {dented, cube(10, 11)}).mesh) == 64 - 3 + 1);
}
