// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Simplified results: counts known beforehand, the same solid as without, and nothing changed away from the contact.
#include "mortise/boolean/simplify.h"

#include <algorithm>
#include <map>

#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/mesh/inspect.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/partition_checks.h"
#include "support/random_solids.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr std::array levels{Simplify::Cut, Simplify::Coplanar};
constexpr std::array operations{Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference};

BooleanResult simplified(Simplify level, Operation operation, const std::vector<SurfaceMesh>& operands) {
  BooleanOptions options;
  options.simplify = level;
  return evaluate_boolean(operation, pointers_to(operands), options);
}

struct Counts {
  std::size_t vertices, triangles;

  bool operator==(const Counts&) const = default;
};

Counts counts_of(const BooleanResult& result) { return {result.mesh.points.size(), result.mesh.triangles.size()}; }

/// Triangles of one shell of this genus on so many vertices.
std::size_t triangles_on(std::size_t vertices, std::size_t genus) { return 2 * vertices + 4 * genus - 4; }

void check_same_solid(const BooleanResult& result, const BooleanResult& whole, double volume_tolerance) {
  CHECK(result.report.certificate.status == CertificateStatus::Certified);
  CHECK(is_balanced(result.mesh));
  const MeshReport found = inspect_without_pairs(result.mesh), expected = inspect_without_pairs(whole.mesh);
  CHECK(found.triangles <= expected.triangles);
  CHECK(found.shells == expected.shells);
  CHECK(found.genus == expected.genus);
  CHECK(std::abs(*found.volume - *expected.volume) <= volume_tolerance);
}

}  // namespace

TEST_CASE("two cubes that share a face become one box of 12 triangles", "[simplify]") {
  const std::vector<SurfaceMesh> side_by_side{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
  CHECK(counts_of(simplified(Simplify::Off, Operation::Union, side_by_side)) == Counts{12, 20});
  CHECK(counts_of(simplified(Simplify::Cut, Operation::Union, side_by_side)) == Counts{12, 20});
  const BooleanResult one = simplified(Simplify::Coplanar, Operation::Union, side_by_side);
  CHECK(counts_of(one) == Counts{8, 12});
  CHECK(exact_volume(one.mesh) == 2);
  CHECK(one.report.contact.area == 1);
  // Their faces are in the lists of sources: a long side has four triangles of each cube.
  std::size_t sources = 0;
  for (std::size_t t = 0; t < 12; ++t) {
    sources = std::max<std::size_t>(sources, 1 + one.provenance.other_source_begin[t + 1] - one.provenance.other_source_begin[t]);
  }
  CHECK(sources == 4);
}

TEST_CASE("the cut goes from inside faces, what the operands had stays", "[simplify]") {
  // Flush on four sides: the faces of the first are whole again, those of the second keep their part.
  const std::vector<SurfaceMesh> flush{box({0, 0, 0}, {1, 1, 1}), box({0.5, 0, 0}, {1.5, 1, 1})};
  CHECK(counts_of(simplified(Simplify::Off, Operation::Union, flush)) == Counts{24, 44});
  CHECK(counts_of(simplified(Simplify::Cut, Operation::Union, flush)) == Counts{16, 28});
  CHECK(counts_of(simplified(Simplify::Coplanar, Operation::Union, flush)) == Counts{8, 12});
  // A box that only touches, in the middle of a face, and is taken away: what it cut there goes.
  const SurfaceMesh block = box({0, 0, 0}, {4, 4, 1}), beside = box({1, 1, 1}, {2, 2, 2});
  for (const Simplify level : levels) {
    const BooleanResult same = simplified(level, Operation::Subtract, {block, beside});
    CHECK(counts_of(same) == Counts{8, 12});
    CHECK(sorted_points(same.mesh) == sorted_points(block));
  }
}

TEST_CASE("1,000 touching cubes in a block become 12 triangles", "[simplify]") {
  std::vector<SurfaceMesh> cubes;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d lo{static_cast<double>(i % 10), static_cast<double>(i / 10 % 10), static_cast<double>(i / 100)};
    cubes.push_back(box(lo, lo + Vec3d{1, 1, 1}));
  }
  const BooleanResult block = simplified(Simplify::Coplanar, Operation::Union, cubes);
  CHECK(counts_of(block) == Counts{8, 12});
  CHECK(exact_volume(block.mesh) == 1000);
}

TEST_CASE("a chain of 50 drills through a plate leaves nothing but the plate and the holes", "[simplify]") {
  constexpr std::size_t sides = 16;
  SurfaceMesh plate = box({0, 0, 0}, {10, 5, 1}), rough = plate;
  for (std::size_t k = 1; k <= 50; ++k) {
    const Vec3d at{0.6 + 0.97 * static_cast<double>((k - 1) % 10), 0.55 + 0.93 * static_cast<double>((k - 1) / 10), -1};
    const SurfaceMesh drill = moved(make_cylinder(0.3, 3, sides), at);
    const BooleanResult drilled = simplified(Simplify::Coplanar, Operation::Subtract, {plate, drill});
    const std::size_t vertices = 8 + 2 * sides * k;
    REQUIRE(counts_of(drilled) == Counts{vertices, triangles_on(vertices, k)});
    REQUIRE(drilled.report.certificate.status == CertificateStatus::Certified);
    plate = drilled.mesh;
    rough = evaluate(Operation::Subtract, {rough, drill}).mesh;
  }
  CHECK(oracle::self_crossings(plate).empty());
  CHECK(*inspect_without_pairs(plate).genus == 50);
  CHECK(exact_volume(plate) == Approx(exact_volume(rough)).epsilon(1e-14));
  CHECK(surface_area(plate) == Approx(surface_area(rough)).epsilon(1e-14));
  CHECK(rough.triangles.size() > 6 * plate.triangles.size());
}

TEST_CASE("random solids on a grid are the same solids when they are simplified", "[simplify]") {
  std::size_t fewer = 0;
  for (std::size_t seed = 1; seed <= scaled_count(200, 4000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(2 + seed % 3);
    for (const Operation operation : operations) {
      INFO(operation_name(operation));
      const BooleanResult whole = evaluate(operation, solids);
      for (const Simplify level : levels) {
        const BooleanResult result = simplified(level, operation, solids);
        CHECK(is_balanced(result.mesh));
        CHECK(oracle::self_crossings(result.mesh).size() <= oracle::self_crossings(whole.mesh).size());
        if (level == Simplify::Cut) CHECK(faults_of_provenance(pointers_to(solids), result, Repairs::Allowed) == "");
        CHECK(exact_volume(result.mesh) == Approx(exact_volume(whole.mesh)).margin(1e-13));
        CHECK(surface_area(result.mesh) == Approx(surface_area(whole.mesh)).margin(1e-13));
        CHECK(inspect_without_pairs(result.mesh).genus == inspect_without_pairs(whole.mesh).genus);
        CHECK(result.graph.points == whole.graph.points);
        fewer += result.mesh.triangles.size() < whole.mesh.triangles.size() ? 1 : 0;
      }
    }
  }
  CHECK(fewer > scaled_count(200, 4000) / 2);
}

TEST_CASE("partitions and tags stay what they were", "[simplify]") {
  for (std::size_t seed = 1; seed <= scaled_count(100, 2000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(2 + seed % 2);
    for (const Simplify level : levels) {
      const BooleanResult divided = simplified(level, Operation::Partition, solids);
      CHECK(faults_of_partition(divided) == "");
      std::map<std::vector<std::uint32_t>, double> volumes;
      for (const ResultRegion& r : find_result_regions(divided).regions) volumes[r.operands] += r.volume;
      for (const auto& [operands, volume] : expected_volumes(pointers_to(solids))) {
        CHECK(volumes[operands] == Approx(static_cast<double>(volume)).margin(1e-13));
      }
      BooleanOptions options;
      options.simplify = level;
      const std::array<std::string, 2> tags{"10", "opposite"};
      const double area = surface_area(keep_faces(keep_mask(tags), pointers_to(solids), {}).mesh);
      CHECK(surface_area(keep_faces(keep_mask(tags), pointers_to(solids), options).mesh) == Approx(area).margin(1e-13));
    }
  }
}

TEST_CASE("faces of different labels are not joined", "[simplify]") {
  SurfaceMesh left = box({0, 0, 0}, {1, 1, 1}), right = box({1, 0, 0}, {2, 1, 1});
  left.label_names = {"steel"};
  right.label_names = {"brass"};
  left.face_labels.assign(12, 0);
  right.face_labels.assign(12, 0);
  CHECK(counts_of(simplified(Simplify::Coplanar, Operation::Union, {left, right})) == Counts{12, 20});
  right.label_names = left.label_names;
  const BooleanResult same = simplified(Simplify::Coplanar, Operation::Union, {left, right});
  CHECK(counts_of(same) == Counts{8, 12});
  CHECK(same.mesh.label_names == std::vector<std::string>{"steel"});
}

TEST_CASE("the tip of a cone that touches a face keeps its vertex there", "[simplify]") {
  const SurfaceMesh cone = transform(make_cone(1, 1, 8), compose(rotation(Axis::X, 180), translation({2, 2, 2})));
  const SurfaceMesh floor = box({0, 0, 0}, {4, 4, 1});
  for (const Simplify level : levels) {
    const BooleanResult both = simplified(level, Operation::Union, {floor, cone});
    CHECK(both.report.certificate.status == CertificateStatus::Certified);
    CHECK(counts_of(both) == counts_of(simplified(Simplify::Off, Operation::Union, {floor, cone})));
    CHECK(oracle::self_crossings(both.mesh).empty());
  }
}

TEST_CASE("the only operand of a call is simplified everywhere, others only where they were cut", "[simplify]") {
  const SurfaceMesh sheet = make_grid_sheet(4, 4, 8, 8);
  BooleanOptions options;
  options.simplify = Simplify::Coplanar;
  CHECK(counts_of(resolve(sheet, options)) == Counts{4, 2});
  const SurfaceMesh slab =
      evaluate(Operation::Union, {box({0, 0, 0}, {1, 8, 1}), box({1, 0, 0}, {2, 8, 1}), box({2, 0, 0}, {3, 8, 1})}).mesh;
  CHECK(counts_of(resolve(slab, options)) == Counts{8, 12});
  const BooleanResult far = simplified(Simplify::Coplanar, Operation::Union, {slab, box({7, 7, 7}, {8, 8, 8})});
  CHECK(far.mesh.triangles.size() == slab.triangles.size() + 12);
}

TEST_CASE("untouched facets of a real mesh keep their bits, and the solid is the same", "[simplify][scenario]") {
  if (is_data_missing()) return;
  for (const char* file : {"cad/fandisk.off", "cad/duct.off", "cad/flange.stl", "scans/spot.obj", "primitives/fig27_box_fine.off"}) {
    INFO(file);
    const SurfaceMesh part = read_data(file);
    const Box3 bounds = bounding_box(part);
    const Vec3d size = bounds.hi - bounds.lo;
    const SurfaceMesh cutter = box(bounds.lo + 0.5 * size, bounds.hi + 0.25 * size);
    for (const Operation operation : operations) {
      INFO(operation_name(operation));
      const BooleanResult whole = evaluate(operation, {part, cutter});
      for (const Simplify level : levels) {
        const BooleanResult result = simplified(level, operation, {part, cutter});
        const double tolerance = identity_tolerance(enclosed_volume(part) + enclosed_volume(cutter), surface_area(whole.mesh), whole.report,
                                                    largest_coordinate(whole.mesh));
        check_same_solid(result, whole, tolerance);
      }
    }
    // Whole faces away from the box are there with their own vertices, in their order.
    const BooleanResult result = simplified(Simplify::Coplanar, Operation::Subtract, {part, cutter});
    std::size_t away = 0, same = 0;
    std::map<std::array<std::array<double, 3>, 3>, int> triangles;
    const auto key = [](const SurfaceMesh& mesh, const Triangle& t) {
      std::array<std::array<double, 3>, 3> k;
      for (std::size_t i = 0; i < 3; ++i) k[i] = {mesh.points[t[i].index()].x, mesh.points[t[i].index()].y, mesh.points[t[i].index()].z};
      return k;
    };
    for (const Triangle& t : result.mesh.triangles) ++triangles[key(result.mesh, t)];
    for (const Triangle& t : part.triangles) {
      const bool is_away =
          std::all_of(t.begin(), t.end(), [&](VertexId v) { return part.points[v.index()].x < bounds.lo.x + 0.49 * size.x; });
      if (!is_away) continue;
      ++away;
      same += triangles.count(key(part, t));
    }
    CHECK(away > 10);
    CHECK(same == away);
  }
}

TEST_CASE("an imprint is not simplified", "[simplify]") {
  const SurfaceMesh a = box({0, 0, 0}, {1, 1, 1}), b = box({1, 0, 0}, {2, 1, 1});
  BooleanOptions options;
  options.simplify = Simplify::Cut;
  const auto error = error_of([&] { (void)imprint(a, b, options); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
}
