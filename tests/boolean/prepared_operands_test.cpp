// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A call with prepared operands gives what a call with the moved meshes gives, to the last bit, errors included.
#include <cmath>
#include <functional>
#include <limits>
#include <variant>

#include "boolean/evaluation.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/random_maps.h"
#include "support/random_solids.h"
#include "support/same_result.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Outcome = std::variant<ImprintResult, Error>;

Outcome outcome_of(const std::function<ImprintResult()>& call) {
  try {
    return call();
  } catch (const Error& error) {
    return error;
  }
}

/// The operations that differ in what they ask of the stages, in turn.
ImprintResult call_number(std::size_t number, const OperandList& operands, const BooleanOptions& options) {
  switch (number % 7) {
    case 0:
      return {evaluate_boolean(Operation::Union, operands, options), {}};
    case 1:
      return {evaluate_boolean(Operation::Intersect, operands, options), {}};
    case 2:
      return {evaluate_boolean(Operation::Subtract, operands, options), {}};
    case 3:
      return {evaluate_boolean(Operation::Partition, operands, options), {}};
    case 4:
      return {evaluate_expression("a ^ b", operands, options), {}};
    case 5:
      return {keep_faces(63, operands, options), {}};
    default:
      return imprint(operands, options);
  }
}

std::string difference_of(const Outcome& a, const Outcome& b) {
  if (a.index() != b.index()) {
    const Outcome& failed = a.index() == 1 ? a : b;
    return std::string(a.index() == 1 ? "only the first" : "only the second") + " fails: " + std::get<Error>(failed).message;
  }
  if (a.index() == 1) return test::difference_of(std::get<Error>(a), std::get<Error>(b));
  return test::difference_of(std::get<ImprintResult>(a), std::get<ImprintResult>(b));
}

/// transform(), its errors naming the operand.
SurfaceMesh image_of_operand(std::size_t k, const SurfaceMesh& mesh, const AffineMap& place) {
  try {
    return transform(mesh, place);
  } catch (Error& error) {
    throw std::move(error).in_operand(k);
  }
}

/// What differs between the call with prepared operands and the call with their images, a mesh each.
std::string difference_in(std::size_t number, const PreparedOperand& host, const PreparedOperand& part, const AffineMap& place,
                          const BooleanOptions& options) {
  const Outcome prepared = outcome_of([&] { return call_number(number, std::array{Operand(host), Operand(part, place)}, options); });
  const Outcome fresh = outcome_of([&] {
    const SurfaceMesh image = image_of_operand(1, part.mesh(), place);
    return call_number(number, std::array{&host.mesh(), &image}, options);
  });
  return difference_of(prepared, fresh);
}

struct Tally {
  std::size_t poses = 0, different = 0;
  std::string first;

  void add(const std::string& difference, std::size_t number) {
    ++poses;
    if (difference.empty()) return;
    if (different++ == 0) first = "pose " + std::to_string(number) + ": " + difference;
  }
};

double size_of(const SurfaceMesh& mesh) {
  const Box3 box = bounding_box(mesh);
  return box.is_empty() ? 1 : std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z, 0x1p-20});
}

/// Random places of the part beside the host, every operation in turn; the rest of the poses weld points of the part.
Tally tally_poses(const SurfaceMesh& host, const SurfaceMesh& part, std::size_t count, std::uint64_t seed) {
  const PreparedOperand prepared_host(host), prepared_part(part);
  RandomMaps random(seed);
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) {
    const bool welds = i % 8 == 7;
    const AffineMap place = welds ? random.next_that_welds(size_of(part)) : random.next(0.6 * size_of(host));
    BooleanOptions options;
    options.simplify = i % 3 == 0 ? Simplify::Coplanar : Simplify::Off;
    tally.add(difference_in(i, prepared_host, prepared_part, place, options), i);
  }
  return tally;
}

struct NamedPair {
  std::string name;
  SurfaceMesh host, part;
};

SurfaceMesh with_zero_area_faces(SurfaceMesh mesh) {
  const Triangle t = mesh.triangles[0];
  const Vec3d a = mesh.points[t[0].index()], b = mesh.points[t[1].index()];
  const VertexId middle(mesh.points.size());
  mesh.points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
  mesh.triangles[0] = {t[0], middle, t[2]};
  mesh.triangles.push_back({middle, t[1], t[2]});
  mesh.triangles.push_back({t[0], t[1], middle});
  mesh.triangles.push_back({t[0], t[0], t[1]});
  return mesh;
}

SurfaceMesh with_labels_and_data(SurfaceMesh mesh) {
  DataChannel uv{"uv", 2, DataKind::Value, {}}, normal{"normal", 3, DataKind::Normal, {}};
  for (std::size_t i = 0; i < 6 * mesh.triangles.size(); ++i) uv.values.push_back(std::ldexp(static_cast<double>(i * i % 97), -6));
  for (const Vec3d& p : mesh.points) normal.values.insert(normal.values.end(), {p.x, p.y, p.z});
  mesh.corner_data.push_back(uv);
  mesh.vertex_data.push_back(normal);
  mesh.label_names = {"even", "odd"};
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    mesh.face_labels.push_back(f % 2);
    mesh.diagonals.push_back(static_cast<std::uint8_t>(f % 8));
  }
  return mesh;
}

SurfaceMesh twice(const SurfaceMesh& mesh) { return joined({mesh, mesh}); }

SurfaceMesh two_regions() { return partition(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})).mesh; }

/// Everything a mesh may be, each with a plain partner.
std::vector<NamedPair> all_kinds() {
  const SurfaceMesh cube = box({-1, -1, -1}, {1, 1, 1});
  const SurfaceMesh overlapping = joined({cube, box({0, 0, 0}, {2, 2, 2})});
  return {
      {"a box and an octahedron", cube, octahedron({0.25, 0, 0}, 1.5)},
      {"a soup", cube, soup_of(octahedron({0, 0, 0}, 1))},
      {"vertices twice and -0", cube, soup_of(box({-0.0, -0.0, -0.0}, {1, 1, 1}))},
      {"faces without area", cube, with_zero_area_faces(octahedron({0, 0, 0}, 1.25))},
      {"a host with faces without area", with_zero_area_faces(cube), octahedron({0, 0, 0}, 1.25)},
      {"parts that overlap", octahedron({0, 0, 0}, 2), overlapping},
      {"a part in a part", octahedron({0, 0, 0}, 2), joined({cube, inside_out(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}))})},
      {"a sheet", cube, make_grid_sheet(2.5, 1.5, 5, 4)},
      {"a host that is a sheet", make_grid_sheet(3, 3, 6, 6), octahedron({0, 0, 0}, 1)},
      {"a part that crosses itself", scaled(pentagram_prism(-2, 2), 0.2), octahedron({0, 0, 0}, 1)},
      {"a star against a box", cube, scaled(pentagram_prism(-4, 4), 0.125)},
      {"every face twice", cube, twice(octahedron({0, 0, 0}, 1))},
      {"walls", octahedron({1, 1, 1}, 1.5), two_regions()},
      {"inside out", cube, inside_out(octahedron({0, 0, 0}, 1))},
      {"labels, diagonals and data", cube, with_labels_and_data(octahedron({0, 0, 0}, 1.25))},
      {"no faces", cube, make_mesh({{0, 0, 0}}, {})},
      {"a sphere in slivers", cube, transform(make_icosphere(1, 1), scaling({1, 1, 1e-13}))},
  };
}

}  // namespace

TEST_CASE("500 places of a wing at a fuselage give the bits of fresh calls") {
  if (is_data_missing()) return;
  const SurfaceMesh fuselage = read_data("aircraft/ceasiom_fuselage_closed.off"), wing = read_data("aircraft/ceasiom_wing_winglet.stl");
  const Tally tally = tally_poses(fuselage, wing, scaled_count(500, 5000), 31);
  CHECK(tally.poses >= 50);
  CHECK(tally.first == "");
}

TEST_CASE("every kind of operand gives the bits of fresh calls in random places") {
  for (const NamedPair& pair : all_kinds()) {
    INFO(pair.name);
    CHECK(tally_poses(pair.host, pair.part, scaled_count(56, 5000), 7).first == "");
  }
}

TEST_CASE("random solids give the bits of fresh calls in random places") {
  RandomSolids random(5);
  for (std::size_t i = 0; i < scaled_count(60, 2000); ++i) {
    INFO("pair " << i);
    CHECK(tally_poses(random.next_of_all_kinds(), random.next_of_all_kinds(), 8, 100 + i).first == "");
  }
}

TEST_CASE("a prepared operand may be used twice in one call, and beside plain meshes") {
  const PreparedOperand ball(make_icosphere(1, 2));
  const AffineMap aside = translation({0.75, 0.5, 0.25});
  const SurfaceMesh moved_ball = transform(ball.mesh(), aside), bar = box({-3, -0.25, -0.25}, {3, 0.25, 0.25});
  const BooleanResult prepared = evaluate_boolean(Operation::Union, std::array{Operand(ball), Operand(ball, aside), Operand(bar)});
  const BooleanResult fresh = evaluate_boolean(Operation::Union, std::array{&ball.mesh(), &moved_ball, &bar});
  CHECK(test::difference_of(prepared, fresh) == "");
  CHECK(test::difference_of(subtract(ball, bar), subtract(ball.mesh(), bar)) == "");
  CHECK(test::difference_of(resolve(Operand(ball, aside)), resolve(moved_ball)) == "");
  CHECK(test::difference_of(implant(std::array{Operand(bar), Operand(ball, aside)}), implant(std::array{&bar, &moved_ball})) == "");
}

TEST_CASE("a half-space cuts a prepared operand as it cuts the mesh") {
  const PreparedOperand ball(make_icosphere(1, 2));
  RandomMaps random(3);
  for (std::size_t i = 0; i < 20; ++i) {
    const AffineMap place = random.next(1);
    const SurfaceMesh image = transform(ball.mesh(), place);
    const SurfaceMesh behind = make_half_space({{1, 2, 3}, 0.5}, bounding_box(image));
    BooleanOptions options;
    options.half_spaces = {1};
    const Outcome prepared = outcome_of([&] { return call_number(i, std::array{Operand(ball, place), Operand(behind)}, options); });
    const Outcome fresh = outcome_of([&] { return call_number(i, std::array{&image, &behind}, options); });
    INFO("place " << i);
    CHECK(difference_of(prepared, fresh) == "");
  }
}

TEST_CASE("a crossing of an operand with itself is resolved where a fresh call resolves it, and only there") {
  const PreparedOperand star(scaled(pentagram_prism(-4, 4), 0.125));
  const SurfaceMesh bar = box({-0.1, -0.1, -0.9}, {0.1, 0.1, 0.9});
  const PreparedOperand prepared_bar(bar);
  const auto resolves = [&](const AffineMap& place) {
    const BooleanResult prepared = unite(star, Operand(prepared_bar, place));
    const SurfaceMesh image = transform(bar, place);
    CHECK(test::difference_of(prepared, unite(star.mesh(), image)) == "");
    return !prepared.report.self_contacts.empty();
  };
  CHECK(resolves(AffineMap{}));                   // in the middle, of winding 2
  CHECK(!resolves(translation({0, 1.25, 0})));    // in a tip
  CHECK(!resolves(translation({5, 0, 0})));       // apart
  CHECK(resolves(translation({0.05, 0.05, 0})));  // in the middle again
}

TEST_CASE("maps that have no inverse or overflow are refused as transform refuses them, naming the operand") {
  const PreparedOperand ball(make_icosphere(1, 0));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const AffineMap& place : {scaling({1, 1, 0}), translation({infinity, 0, 0}), scaling({1e308, 1e308, 1e308})}) {
    const AffineMap far = place.linear[0].x > 1e300 ? compose(scaling({8, 8, 8}), place) : place;
    auto error = error_of([&] { (void)unite(ball, Operand(ball, far)); });
    const auto expected = error_of([&] { (void)transform(ball.mesh(), far); });
    REQUIRE((error && expected));
    CHECK(error->operand == 1);
    error->operand = -1;
    CHECK(test::difference_of(*error, *expected) == "");
  }
}

TEST_CASE("calls with prepared operands report progress and can be stopped at every report") {
  const PreparedOperand star(scaled(pentagram_prism(-4, 4), 0.125)), ball(make_icosphere(0.5, 2));
  const AffineMap place = translation({0.125, 0, 0});
  std::size_t reports = 0, stop = 0;
  BooleanOptions options;
  options.progress = [&](std::string_view, double) { return ++reports != stop; };
  const BooleanResult whole = unite(star, Operand(ball, place), options);
  const std::size_t count = reports;
  CHECK(count > 10);
  for (stop = 1; stop <= count; ++stop) {
    reports = 0;
    const auto error = error_of([&] { (void)unite(star, Operand(ball, place), options); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
  }
  stop = 0;
  CHECK(test::difference_of(unite(star, Operand(ball, place), options), whole) == "");
}
