// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Solids that nearly touch: with a tolerance they are glued, and no vertex moves farther than that.
#include "mortise/boolean/share_within_tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/base/error.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/extrude_to.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/partition_checks.h"
#include "support/random_source.h"
#include "support/scene_list.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

BooleanResult evaluate_within(double tolerance, Operation operation, const std::vector<SurfaceMesh>& operands) {
  BooleanOptions options;
  options.tolerance = tolerance;
  return evaluate_boolean(operation, pointers_to(operands), options);
}

bool is_certified(const BooleanResult& result) { return result.report.certificate.status == CertificateStatus::Certified; }

AffineMap random_turn(RandomSource& random) {
  const AffineMap about_y = rotation(Axis::Y, random.between(0, 360)), about_x = rotation(Axis::X, random.between(0, 360));
  return compose(about_x, about_y);
}

/// Eight unit cubes in a block, turned together, each a little off its place and split along either diagonals.
std::vector<SurfaceMesh> loose_block(RandomSource& random, double gap) {
  const AffineMap pose = random_turn(random);
  std::vector<SurfaceMesh> cubes;
  for (int i = 0; i < 8; ++i) {
    const Vec3d lo{static_cast<double>(i % 2), static_cast<double>(i / 2 % 2), static_cast<double>(i / 4)}, hi = lo + Vec3d{1, 1, 1};
    const SurfaceMesh cube = transform(random.once_in(2) ? box(lo, hi) : box_other_diagonals(lo, hi), pose);
    cubes.push_back(moved(cube, random.point(-gap, gap)));
  }
  return cubes;
}

/// The unit cube with a grid of cells on its lower and its upper face.
SurfaceMesh cube_of_cells(std::uint32_t cells) { return extrude_to(make_grid_sheet(1, 1, cells, cells), 1); }

/// Towers of boxes whose edges cross and whose corners lie in faces of their neighbours.
std::vector<SurfaceMesh> loose_bricks(RandomSource& random, double gap) {
  const AffineMap pose = random_turn(random);
  std::vector<SurfaceMesh> bricks;
  for (int i = 0; i < 4; ++i) {
    const double x = i % 2, y = 0.25 * (i % 2), z = i / 2;
    const SurfaceMesh brick = moved(box({0, 0, 0}, {1, 1, z == 0 ? 1 : random.between(0.3, 1)}), {x, y, z});
    bricks.push_back(moved(transform(brick, pose), random.point(-gap, gap)));
  }
  return bricks;
}

/// The distance of vertices of a result from where their operands had them, measured.
double largest_move(const std::vector<SurfaceMesh>& given, const SharedOperands& shared) {
  double largest = 0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const ImprintedOperand& operand = shared.operands[k];
    for (std::size_t v = 0; v < operand.mesh.points.size(); ++v) {
      if (operand.source_vertex[v] == Provenance::none) continue;
      largest = std::max(largest, length(operand.mesh.points[v] - given[k].points[operand.source_vertex[v]]));
    }
  }
  return largest;
}

std::vector<SurfaceMesh> operands_of(const char* scene_name) {
  std::vector<SurfaceMesh> operands;
  for (const ListedScene& scene : listed_scenes()) {
    if (scene.name != scene_name) continue;
    for (const std::string& text : scene.operands) operands.push_back(load_operand(text));
  }
  return operands;
}

}  // namespace

TEST_CASE("a block of cubes that nearly touch is one solid of eight regions, conforming", "[tolerance]") {
  for (std::size_t seed = 1; seed <= scaled_count(100, 5000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const double tolerance = std::pow(10.0, -3 - static_cast<int>(random.below(10)));
    const std::vector<SurfaceMesh> cubes = loose_block(random, tolerance / 8);
    const SharedOperands shared = share_within_tolerance(pointers_to(cubes), tolerance);
    CHECK(largest_move(cubes, shared) <= tolerance);
    CHECK(shared.report.largest_move == largest_move(cubes, shared));
    CHECK(shared.report.unresolved.empty());
    for (const ImprintedOperand& operand : shared.operands) CHECK(is_balanced(operand.mesh));

    const BooleanResult all = evaluate_within(tolerance, Operation::Union, cubes);
    CHECK(is_certified(all));
    CHECK(oracle::self_crossings(all.mesh).empty());
    CHECK(std::abs(exact_volume(all.mesh) - 8) <= 24 * 2 * tolerance + 1e-12);
    const Shape shape = shape_of(all.mesh);
    CHECK(shape.shells == 1);
    CHECK(shape.genus == 0);
    CHECK(find_result_regions(all).regions.size() == 1);

    const BooleanResult parts = evaluate_within(tolerance, Operation::Partition, cubes);
    CHECK(is_certified(parts));
    CHECK(faults_of_partition(parts) == "");
    CHECK(find_result_regions(parts).regions.size() == 8);
    CHECK(evaluate_within(tolerance, Operation::Intersect, cubes).mesh.triangles.empty());
  }
}

TEST_CASE("bricks that nearly touch with edges across and corners in faces are glued", "[tolerance]") {
  for (std::size_t seed = 1; seed <= scaled_count(100, 5000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const double tolerance = std::pow(10.0, -4 - static_cast<int>(random.below(9)));
    const std::vector<SurfaceMesh> bricks = loose_bricks(random, tolerance / 8);
    const BooleanResult parts = evaluate_within(tolerance, Operation::Partition, bricks);
    CHECK(is_certified(parts));
    CHECK(parts.report.tolerance.made_vertices > 0);
    CHECK(parts.report.tolerance.unresolved.empty());
    CHECK(faults_of_partition(parts) == "");
    CHECK(oracle::self_crossings(parts.mesh).empty());
    CHECK(find_result_regions(parts).regions.size() == 4);
    const BooleanResult all = evaluate_within(tolerance, Operation::Union, bricks);
    CHECK(find_result_regions(all).regions.size() == 1);
    CHECK(std::abs(exact_volume(all.mesh) - find_result_regions(parts).total_volume()) <= 1e-12);
  }
}

TEST_CASE("what lies on one large face is shared with it", "[tolerance]") {
  constexpr std::uint32_t cells = 60;
  RandomSource random(5);
  SurfaceMesh bumpy = cube_of_cells(cells);
  for (Vec3d& p : bumpy.points) p = p + random.point(-1e-9, 1e-9);
  const std::vector<SurfaceMesh> operands{box({-1, -1, -1}, {2, 2, 0}), bumpy};
  const BooleanResult parts = evaluate_within(1e-7, Operation::Partition, operands);
  CHECK(is_certified(parts));
  CHECK(parts.report.tolerance.unresolved.empty());
  CHECK(faults_of_partition(parts) == "");
  CHECK(find_result_regions(parts).regions.size() == 2);
  CHECK(parts.report.contact.area == Approx(1).epsilon(1e-6));
  CHECK(evaluate_within(1e-7, Operation::Intersect, operands).mesh.triangles.empty());
}

TEST_CASE("a tolerance of any size leaves meshes that are closed, and lists what did not fit", "[tolerance]") {
  for (std::size_t seed = 1; seed <= scaled_count(60, 3000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const SurfaceMesh sphere = make_icosphere(1, 3), turned = transform(sphere, random_turn(random));
    const double tolerance = std::pow(2.0, -random.between(0, 16));
    const std::vector<SurfaceMesh> operands{sphere, moved(turned, random.point(-0.5, 0.5))};
    const SharedOperands shared = share_within_tolerance(pointers_to(operands), tolerance);
    CHECK(largest_move(operands, shared) <= tolerance);
    for (const ImprintedOperand& operand : shared.operands) CHECK(is_balanced(operand.mesh));
    const BooleanResult result = evaluate_within(tolerance, Operation::Union, operands);
    CHECK(is_balanced(result.mesh));
    CHECK(is_certified(result));
  }
}

TEST_CASE("what a tolerance leaves nothing of is named", "[tolerance]") {
  const BooleanResult result = evaluate_within(1e-3, Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({0, 0, 1}, {1, 1, 1.0001})});
  CHECK(exact_volume(result.mesh) == 1);
  CHECK(result.report.tolerance.collapsed.size() == 8);
  for (const OperandFace& face : result.report.tolerance.collapsed) CHECK(face.operand == 1);
  CHECK(result.report.notes == std::vector<std::string>{"operand 1 is thinner than the tolerance and vanished"});
}

TEST_CASE("a part that sharing turns inside out is thinner than the tolerance and vanishes; one that was inside out is refused",
          "[tolerance]") {
  std::vector<SurfaceMesh> boxes{make_box({0, 0, 0}, {1, 3, 3}), make_box({1, 4, 0}, {4, 6, 3})};
  // With these diagonals four triangles of the second are left, and they run the other way.
  constexpr std::array<std::array<std::uint32_t, 3>, 12> corners{
      {{2, 3, 1}, {2, 1, 0}, {5, 7, 6}, {5, 6, 4}, {1, 5, 4}, {1, 4, 0}, {6, 7, 3}, {6, 3, 2}, {4, 6, 2}, {4, 2, 0}, {3, 7, 5}, {3, 5, 1}}};
  for (std::size_t f = 0; f < corners.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) boxes[1].triangles[f][k] = VertexId(corners[f][k]);
  }
  const BooleanResult result = evaluate_within(3.16, Operation::Union, boxes);
  CHECK(result.mesh.triangles.empty());
  CHECK(result.report.notes == std::vector<std::string>{"operand 0 is thinner than the tolerance and vanished",
                                                        "operand 1 is thinner than the tolerance and vanished"});
  SurfaceMesh turned = make_box({0, 0, 0}, {8, 8, 8});
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  const std::vector<SurfaceMesh> given{boxes[0], turned};
  try {
    (void)evaluate_within(1e-3, Operation::Union, given);
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::InsideOut);
    CHECK(error.operand == 1);
    CHECK(error.ids.size() == turned.triangles.size());
  }
}

TEST_CASE("an operand that sharing folds onto itself is listed, and its contacts with itself are resolved", "[tolerance]") {
  const SurfaceMesh wedge = make_mesh({{1, 0, 2}, {1, 2, 1}, {1, 3, 2}, {4, 0, 2}, {4, 2, 1}, {4, 3, 2}},
                                      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
  // Its arm, from x = 3 on, is thinner than the tolerance: the upper side goes into the lower one.
  const SurfaceMesh angle = make_mesh(
      {{0, 0, 0}, {0, 0, 4}, {3, 0, 4}, {3, 0, 1}, {6, 0, 1}, {6, 0, 0}, {0, 3, 0}, {0, 3, 4}, {3, 3, 4}, {3, 3, 1}, {6, 3, 1}, {6, 3, 0}},
      {{0, 2, 1}, {3, 5, 4}, {0, 3, 2}, {3, 0, 5}, {6, 7, 8},  {9, 10, 11}, {6, 8, 9},  {9, 11, 6},  {0, 1, 7}, {0, 7, 6},
       {1, 2, 8}, {1, 8, 7}, {2, 3, 9}, {2, 9, 8}, {3, 4, 10}, {3, 10, 9},  {4, 5, 11}, {4, 11, 10}, {5, 0, 6}, {5, 6, 11}});
  for (const Vec3d& place : {Vec3d{0, 0, 0}, Vec3d{-312350, 398228, -295010}}) {
    const std::vector<SurfaceMesh> operands{moved(wedge, place), moved(angle, place)};
    const SharedOperands shared = share_within_tolerance(pointers_to(operands), 1.52);
    CHECK(!oracle::self_crossings(shared.operands[1].mesh).empty());
    CHECK(shared.folded == std::vector<std::uint32_t>{1});
    CHECK(shared.report.unresolved == std::vector<OperandFace>{{1, 14}, {1, 15}, {1, 19}});
    for (const Operation operation : {Operation::Union, Operation::Partition}) {
      const BooleanResult result = evaluate_within(1.52, operation, operands);
      CHECK(is_certified(result));
      CHECK(result.report.certificate.inherited_pairs == 0);
      CHECK(is_balanced(result.mesh));
      CHECK(oracle::self_crossings(result.mesh).empty());
    }
  }
}

TEST_CASE("no tolerance changes nothing; with one sources are those of the operands as given", "[tolerance]") {
  RandomSource random(3);
  const std::vector<SurfaceMesh> cubes = loose_block(random, 1e-7);
  const BooleanResult off = evaluate_within(0, Operation::Union, cubes), plain = evaluate(Operation::Union, cubes);
  CHECK(off.mesh.points == plain.mesh.points);
  CHECK(off.mesh.triangles == plain.mesh.triangles);
  const BooleanResult result = evaluate_within(1e-6, Operation::Union, cubes);
  const Provenance& p = result.provenance;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    if (p.vertex_operand[v] == Provenance::none) continue;
    ++kept;
    CHECK(result.mesh.points[v] == cubes[p.vertex_operand[v]].points[p.vertex_source[v]]);
  }
  CHECK(kept > 0);
  CHECK(!result.report.certificate.moved_input_vertices.empty());
  for (const OperandVertex& v : result.report.certificate.moved_input_vertices) CHECK(v.vertex < cubes[v.operand].points.size());
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const SurfaceMesh& operand = cubes[p.source_operand[f]];
    const Triangle &t = result.mesh.triangles[f], &s = operand.triangles[p.source_face[f]];
    const auto normal = [](const SurfaceMesh& mesh, const Triangle& c) {
      return cross(mesh.points[c[1].index()] - mesh.points[c[0].index()], mesh.points[c[2].index()] - mesh.points[c[0].index()]);
    };
    const Vec3d n = normal(result.mesh, t), m = normal(operand, s);
    CHECK(dot(n, m) > 0.999 * length(n) * length(m));
  }
}

TEST_CASE("a tolerance is a length, and operands are refused as ever", "[tolerance]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  for (const double wrong : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(error_of([&] { (void)evaluate_within(wrong, Operation::Union, {cube}); })->code == ErrorCode::InvalidArgument);
  }
  SurfaceMesh broken = cube;
  broken.triangles[0][0] = VertexId(99U);
  CHECK(error_of([&] { (void)evaluate_within(1e-9, Operation::Union, {cube, broken}); })->code == ErrorCode::BadIndex);
  CHECK(error_of([&] { (void)evaluate_within(1e-9, Operation::Union, {cube, inside_out(cube)}); })->code == ErrorCode::InsideOut);
}

TEST_CASE("open edges of shared operands are those of the operands as given", "[tolerance]") {
  const SurfaceMesh fine = moved(cube_of_cells(4), {0, 0, 1 + 1e-9});  // its vertices divide the faces of the other
  SurfaceMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  const BooleanResult expected = evaluate(Operation::Partition, {fine, open}),
                      result = evaluate_within(1e-8, Operation::Partition, {fine, open});
  REQUIRE(result.report.sheets.size() == 1);
  CHECK(result.report.sheets[0].operand == 1);
  CHECK(result.report.sheets[0].open_edges == expected.report.sheets[0].open_edges);
  BooleanOptions options;
  options.tolerance = 1e-8;
  options.require_solids = true;
  const std::vector<SurfaceMesh> operands{fine, open};
  const auto error = error_of([&] { (void)evaluate_boolean(Operation::Union, pointers_to(operands), options); });
  CHECK(error->code == ErrorCode::NotClosed);
  CHECK(error->operand == 1);
  CHECK(error->ids == expected.report.sheets[0].open_edges);
}

TEST_CASE("an imprint with a tolerance gives both sides the same triangles", "[tolerance]") {
  const std::vector<SurfaceMesh> operands{cube_of_cells(4), moved(cube_of_cells(3), {1e-9, -1e-9, 1 + 1e-9})};
  BooleanOptions options;
  options.tolerance = 1e-8;
  const ImprintResult result = imprint(pointers_to(operands), options);
  std::vector<std::uint32_t> common;
  const std::vector<std::uint32_t>&a = result.operands[0].facet_ids, &b = result.operands[1].facet_ids;
  for (const std::uint32_t id : a) {
    if (std::find(b.begin(), b.end(), id) != b.end()) common.push_back(id);
  }
  double area = 0;
  for (const std::uint32_t id : common) {
    const Triangle& t = result.whole.mesh.triangles[id];
    const std::vector<Vec3d>& p = result.whole.mesh.points;
    area += triangle_area(p[t[0].index()], p[t[1].index()], p[t[2].index()]);
  }
  CHECK(area == Approx(1).epsilon(1e-6));
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(is_balanced(result.operands[k].mesh));
    CHECK(std::abs(exact_volume(result.operands[k].mesh) - 1) < 1e-7);
  }
}

TEST_CASE("a funnel almost flush with a deck is one that is flush", "[tolerance][scenario]") {
  if (is_data_missing()) return;
  if (is_reduced_run()) return;
  const std::vector<SurfaceMesh> flush = operands_of("Fig. 28 flush on deck"), almost = operands_of("Fig. 28 almost flush");
  REQUIRE(almost.size() == 2);
  for (const Operation operation : {Operation::Union, Operation::Partition}) {
    const BooleanResult expected = evaluate_within(1e-7, operation, flush), result = evaluate_within(1e-7, operation, almost);
    CHECK(is_certified(result));
    CHECK(result.mesh.triangles.size() == expected.mesh.triangles.size());
    CHECK(result.mesh.points.size() == expected.mesh.points.size());
    CHECK(find_result_regions(result).regions.size() == find_result_regions(expected).regions.size());
    CHECK(find_result_regions(result).total_volume() == Approx(2.43715374729).epsilon(1e-10));
    CHECK(result.report.contact.area == Approx(expected.report.contact.area).epsilon(1e-6));
  }
}

TEST_CASE("five solids that fill a box conform with a tolerance", "[tolerance][scenario]") {
  if (is_data_missing()) return;
  const std::vector<SurfaceMesh> solids = operands_of("five solids filling a box");
  REQUIRE(solids.size() == 5);
  const BooleanResult all = evaluate_within(1e-12, Operation::Union, solids), parts = evaluate_within(1e-12, Operation::Partition, solids);
  CHECK(is_certified(all));
  CHECK(is_certified(parts));
  CHECK(surface_area(all.mesh) == Approx(0.088).epsilon(1e-9));
  CHECK(find_result_regions(parts).regions.size() == 5);
  CHECK(faults_of_partition(parts) == "");
  CHECK(find_result_regions(parts).total_volume() == Approx(0.0016).epsilon(1e-9));
  CHECK(2 * 0.0448 == Approx(2 * (surface_area(parts.mesh) - 0.088)).epsilon(1e-6));  // every shared face once
  CHECK(all.report.tolerance.largest_move <= 1e-12);
}
