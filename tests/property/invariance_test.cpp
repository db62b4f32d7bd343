// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must not change a result: order, numbering, soups, exact motions, mirrors and scales, up to the ends of the range of doubles.
#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/mesh/topology.h"
#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/random_solids.h"
#include "support/scene_list.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation all_operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract};

using Operands = std::vector<SurfaceMesh>;

struct SmallScene {
  std::string name;
  Operands operands;
};

bool is_closed(const SurfaceMesh& mesh) { return find_unbalanced_edges(mesh, build_topology(mesh)).empty(); }

std::vector<SmallScene> load_small_scenes() {
  const std::size_t limit = is_reduced_run() ? 3000 : 30000;
  std::vector<SmallScene> scenes;
  for (const ListedScene& scene : listed_scenes()) {
    if (scene.needs_data && !data_folder()) continue;
    SmallScene small{scene.name, {}};
    std::size_t triangles = 0;
    for (const std::string& text : scene.operands) {
      small.operands.push_back(load_operand(text));
      triangles += small.operands.back().triangles.size();
      if (triangles > limit) break;
    }
    if (triangles <= limit && std::all_of(small.operands.begin(), small.operands.end(), is_closed)) scenes.push_back(std::move(small));
  }
  return scenes;
}

/// Runs check(operands) for every listed scene of closed operands that is not too large; a failure names the scene.
template <class Check>
void for_listed_scenes(const Check& check) {
  static const std::vector<SmallScene> scenes = load_small_scenes();
  for (const SmallScene& scene : scenes) {
    INFO(scene.name);
    check(scene.operands);
  }
}

template <class Map>
Operands each(Operands meshes, const Map& map) {
  for (SurfaceMesh& mesh : meshes) mesh = map(std::move(mesh));
  return meshes;
}

/// Triangles as sorted triples of positions, each from its smallest corner on: equal for equal surfaces, however numbered.
std::vector<std::array<std::array<double, 3>, 3>> sorted_triangles(const SurfaceMesh& mesh) {
  std::vector<std::array<std::array<double, 3>, 3>> all;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& p = mesh.points[t[k].index()];
      corners[k] = {p.x, p.y, p.z};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void check_same_graph(const BooleanResult& a, const BooleanResult& b) {
  CHECK(a.graph.points.size() == b.graph.points.size());
  CHECK(a.graph.edges.size() == b.graph.edges.size());
  CHECK(a.graph.closed_loops == b.graph.closed_loops);
  CHECK(a.graph.open_chains == b.graph.open_chains);
}

/// The same surface, triangle by triangle.
void check_same_surface(const BooleanResult& a, const BooleanResult& b) {
  CHECK((sorted_triangles(a.mesh) == sorted_triangles(b.mesh)));
  CHECK(a.report.certificate.status == b.report.certificate.status);
  check_same_graph(a, b);
}

bool is_repaired(const BooleanResult& result) { return result.report.certificate.repair_displacement > 0; }

/// The same points and as many faces, the same graph. Repair goes from place to place in the order of positions, so a result
/// it had to touch is only the same solid.
void check_same_solid(const BooleanResult& a, const BooleanResult& b, const Operands& operands) {
  CHECK(a.report.certificate.status == b.report.certificate.status);
  check_same_graph(a, b);
  if (!is_repaired(a) && !is_repaired(b)) {
    CHECK((sorted_points(a.mesh) == sorted_points(b.mesh)));
    CHECK(a.mesh.triangles.size() == b.mesh.triangles.size());
  }
  const Shape shape_a = shape_of(a.mesh), shape_b = shape_of(b.mesh);
  CHECK(shape_a.genus == shape_b.genus);
  CHECK(shape_a.shells == shape_b.shells);
  const double volume = shape_of(joined(operands)).volume;
  CHECK(std::abs(shape_a.volume - shape_b.volume) <= 1e-12 * volume);
  CHECK(shape_a.area == Approx(shape_b.area).epsilon(1e-12));
}

/// The map of the result is the result of the maps.
template <class Map>
void check_commutes(const Operands& operands, const Map& map) {
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    BooleanResult before = evaluate(operation, operands);
    before.mesh = map(std::move(before.mesh));
    check_same_solid(before, evaluate(operation, each(operands, map)), operands);
  }
}

SurfaceMesh as_soup(const SurfaceMesh& mesh) {
  SurfaceMesh soup = mesh;
  soup.points.clear();
  for (Triangle& t : soup.triangles) {
    for (VertexId& v : t) {
      soup.points.push_back(mesh.points[v.index()]);
      v = VertexId(soup.points.size() - 1);
    }
  }
  return soup;
}

SurfaceMesh mirrored(SurfaceMesh mesh) {
  for (Vec3d& p : mesh.points) p.x = -p.x;
  return inside_out(std::move(mesh));
}

/// Exact, however large the coordinates are.
void check_against_oracle(const Operands& operands) {
  const auto pointers = pointers_to(operands);
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, operands);
    CHECK(faults_of(pointers, result) == "");
    CHECK(oracle::self_crossings(result.mesh).empty());
    CHECK(oracle::volume(result.mesh, exact_positions(pointers, result)) == oracle::boolean_volume(operation, pointers));
  }
}

/// Right but for rounding and its repair, which merges made points that are one double and those next to it.
void check_rounded_against_oracle(const Operands& operands) {
  const auto pointers = pointers_to(operands);
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, operands);
    CHECK(faults_of(pointers, result, Repairs::Allowed) == "");
    CHECK(oracle::self_crossings(result.mesh).empty());
    CHECK(exact_volume(result.mesh) == Approx(oracle::nearest_double(oracle::boolean_volume(operation, pointers))).epsilon(1e-12));
  }
}

/// A cube with one corner moved far out along its diagonal and one edge all but gone.
SurfaceMesh stretched_cube(double far, double edge) {
  SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  for (Vec3d& p : cube.points) {
    if (p == Vec3d{1, 1, 1}) p = {far, far, far};
    if (p == Vec3d{0, 0, 1}) p = {0, 0, edge};
  }
  return cube;
}

}  // namespace

TEST_CASE("the order of operands does not change a surface", "[scenario]") {
  for_listed_scenes([](const Operands& operands) {
    Operands reversed(operands.rbegin(), operands.rend());
    for (const Operation operation : {Operation::Union, Operation::Intersect}) {
      INFO(operation_name(operation));
      check_same_surface(evaluate(operation, operands), evaluate(operation, reversed));
    }
    std::rotate(reversed.begin(), reversed.end() - 1, reversed.end());
    check_same_surface(evaluate(Operation::Subtract, operands), evaluate(Operation::Subtract, reversed));
  });
}

TEST_CASE("the order of faces and vertices does not change a solid", "[scenario]") {
  RandomSolids random(11);
  for_listed_scenes([&](const Operands& operands) {
    const Operands shuffled = each(operands, [&](const SurfaceMesh& mesh) { return renumbered(mesh, random); });
    for (const Operation operation : all_operations) {
      INFO(operation_name(operation));
      check_same_solid(evaluate(operation, operands), evaluate(operation, shuffled), operands);
    }
  });
}

TEST_CASE("a soup of triangles gives the surface of the indexed mesh", "[scenario]") {
  for_listed_scenes([](const Operands& operands) {
    const Operands soups = each(operands, [](const SurfaceMesh& mesh) { return as_soup(mesh); });
    for (const Operation operation : all_operations) {
      INFO(operation_name(operation));
      check_same_surface(evaluate(operation, operands), evaluate(operation, soups));
    }
  });
}

TEST_CASE("exact rigid motions move the result", "[scenario]") {
  for_listed_scenes([](const Operands& operands) {
    check_commutes(operands, [](SurfaceMesh mesh) { return with_axes_turned(std::move(mesh)); });
    check_commutes(operands, [](SurfaceMesh mesh) { return quarter_turned(std::move(mesh)); });
  });
}

TEST_CASE("mirrored operands give the mirrored result", "[scenario]") {
  for_listed_scenes([](const Operands& operands) { check_commutes(operands, mirrored); });
}

TEST_CASE("powers of two from 2^-300 to 2^300 scale the arrays of the result, bit for bit", "[scenario]") {
  for_listed_scenes([](const Operands& operands) {
    const BooleanResult plain = evaluate(Operation::Subtract, operands);
    for (const int exponent : {-300, -151, -1, 77, 300}) {
      INFO("2^" << exponent);
      const double factor = std::ldexp(1.0, exponent);
      const BooleanResult result =
          evaluate(Operation::Subtract, each(operands, [&](SurfaceMesh mesh) { return scaled(std::move(mesh), factor); }));
      CHECK((result.mesh.points == scaled(plain.mesh, factor).points));
      CHECK((result.mesh.triangles == plain.mesh.triangles));
      CHECK((result.graph.edges == plain.graph.edges));
      CHECK((result.provenance.vertex_source == plain.provenance.vertex_source));
      CHECK(result.report.certificate.status == plain.report.certificate.status);
    }
  });
}

TEST_CASE("a cube with one vertex at 1e38 and one edge of 1e-300 is cut right") {
  const SurfaceMesh cube = stretched_cube(1e38, 1e-300);
  check_rounded_against_oracle({cube, box({-0.5, 0.25, -0.5}, {0.5, 0.75, 0.5})});
  check_rounded_against_oracle({cube, box({-1000, -1000, -1000}, {900, 800, 700})});
  check_rounded_against_oracle({cube, box({-1, -1, 0.5e-300}, {1e38, 2, 1e-300})});
}

TEST_CASE("what doubles cannot hold is closed all the same, and the report says how far it moved") {
  // At 0.3e38 the spike is 1e21 times thinner than the distance of two doubles.
  const Operands operands{stretched_cube(1e38, 1e-300), box({-1e38, -1e38, -1e38}, {0.5e38, 0.4e38, 0.3e38})};
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, operands);
    CHECK(faults_of_mesh(result) == "");
    CHECK(oracle::self_crossings(result.mesh).empty());
    CHECK(result.report.certificate.largest_displacement < 1e25);
  }
}

TEST_CASE("a stretched cube has the topology of the tame one") {
  const SurfaceMesh tool = box({-0.5, 0.25, -0.5}, {0.5, 0.75, 2});
  const Operands tame{stretched_cube(8, 0.125), tool}, wild{stretched_cube(1e38, 0.125), tool};
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult expected = evaluate(operation, tame), result = evaluate(operation, wild);
    CHECK(result.mesh.points.size() == expected.mesh.points.size());
    CHECK(shape_of(result.mesh).genus == shape_of(expected.mesh).genus);
    check_same_graph(result, expected);
  }
}

TEST_CASE("boxes out to 3.4e38 give what boxes of unit size give") {
  const double end = std::numeric_limits<float>::max();  // 24 bits: halves and quarters add up exactly
  const auto scene = [](double s) {
    return Operands{box({-s, -s, -s}, {s, s, s}), box({0, -s / 2, -s}, {s, s / 2, s / 4}), octahedron({s / 4, 0, 0}, s / 2)};
  };
  check_against_oracle(scene(end));
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult unit = evaluate(operation, scene(1)), result = evaluate(operation, scene(end));
    CHECK(result.mesh.points.size() == unit.mesh.points.size());
    CHECK(result.mesh.triangles.size() == unit.mesh.triangles.size());
    check_same_graph(result, unit);
  }
}
