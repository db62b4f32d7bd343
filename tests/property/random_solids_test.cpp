// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random small solids on a coarse grid, where most contacts are degenerate: exact volumes, order, exact motions and scales.
#include <algorithm>
#include <cmath>
#include <random>

#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation all_operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract};

/// The same solids for the same seed with every compiler: only the bits of the engine are used.
class RandomSolids {
 public:
  explicit RandomSolids(std::uint64_t seed) : engine_(seed) {}

  SurfaceMesh next() {
    switch (below(4)) {
      case 0:
        return random_box();
      case 1:
        return random_tetrahedron();
      case 2:
        return turned(random_prism());
      default:
        return octahedron(grid_point(), 1 + static_cast<double>(below(2)));
    }
  }

  std::vector<SurfaceMesh> next(std::size_t count) {
    std::vector<SurfaceMesh> solids;
    while (solids.size() < count) solids.push_back(next());
    return solids;
  }

  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() >> 32) % bound; }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  static constexpr std::size_t side_ = 4;

  Vec3d grid_point() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }
  double coordinate() { return static_cast<double>(below(side_ + 1)); }

  SurfaceMesh random_box() {
    const Vec3d lo = grid_point();
    Vec3d hi = lo;
    for (std::size_t i = 0; i < 3; ++i) hi[i] += 1 + static_cast<double>(below(3));
    return below(2) == 0 ? box(lo, hi) : box_other_diagonals(lo, hi);
  }

  SurfaceMesh random_tetrahedron() {
    for (;;) {
      const Vec3d a = grid_point(), b = grid_point(), c = grid_point(), d = grid_point();
      if (dot(cross(b - a, c - a), d - a) != 0) return tetrahedron(a, b, c, d);
    }
  }

  SurfaceMesh random_prism() {
    for (;;) {
      const Vec3d a = grid_point(), b = grid_point(), c = grid_point();
      const double low = coordinate(), high = low + 1 + static_cast<double>(below(3));
      if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0) return prism({{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}, low, high);
    }
  }

  SurfaceMesh turned(SurfaceMesh mesh) {
    for (std::size_t turns = below(3); turns > 0; --turns) mesh = with_axes_turned(std::move(mesh));
    return mesh;
  }

  std::mt19937_64 engine_;
};

/// Runs check(solids, random) for many seeds; a failure names the seed.
template <class Check>
void for_random_solids(std::size_t full, std::size_t long_count, std::size_t operands, const Check& check) {
  for (std::size_t seed = 1; seed <= scaled_count(full, long_count); ++seed) {
    INFO("seed " << seed << ", " << operands << " operands");
    RandomSolids random(seed * 1000 + operands);
    check(random.next(operands), random);
  }
}

void check_against_oracle(const std::vector<SurfaceMesh>& solids) {
  const auto operands = pointers_to(solids);
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, solids);
    CHECK(faults_of(operands, result) == "");
    CHECK(oracle::self_crossings(result.mesh).empty());
    CHECK(oracle::volume(result.mesh, exact_positions(operands, result)) == oracle::boolean_volume(operation, operands));
  }
}

template <class Map>
std::vector<SurfaceMesh> each(std::vector<SurfaceMesh> meshes, const Map& map) {
  for (SurfaceMesh& mesh : meshes) mesh = map(std::move(mesh));
  return meshes;
}

/// The map of the result and the result of the maps have the same points, faces and graph.
template <class Map>
void check_commutes(const std::vector<SurfaceMesh>& solids, const Map& map) {
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult before = evaluate(operation, solids), after = evaluate(operation, each(solids, map));
    CHECK(sorted_points(map(before.mesh)) == sorted_points(after.mesh));
    CHECK(before.mesh.triangles.size() == after.mesh.triangles.size());
    CHECK(before.graph.edges.size() == after.graph.edges.size());
    CHECK(before.graph.closed_loops == after.graph.closed_loops);
    CHECK(before.graph.open_chains == after.graph.open_chains);
  }
}

SurfaceMesh renumbered(const SurfaceMesh& mesh, RandomSolids& random) {
  std::vector<std::size_t> place(mesh.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = i;
  random.shuffle(place);
  SurfaceMesh shuffled = mesh;
  for (std::size_t i = 0; i < place.size(); ++i) shuffled.points[place[i]] = mesh.points[i];
  for (Triangle& t : shuffled.triangles) {
    t = {VertexId(place[t[0].index()]), VertexId(place[t[1].index()]), VertexId(place[t[2].index()])};
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
  }
  random.shuffle(shuffled.triangles);
  return shuffled;
}

}  // namespace

TEST_CASE("pairs of random solids have exactly the oracle's volumes and no fault") {
  for_random_solids(1000, 20000, 2, [](const auto& solids, RandomSolids&) { check_against_oracle(solids); });
}

TEST_CASE("three and four random solids have exactly the oracle's volumes and no fault") {
  for_random_solids(200, 4000, 3, [](const auto& solids, RandomSolids&) { check_against_oracle(solids); });
  for_random_solids(20, 400, 4, [](const auto& solids, RandomSolids&) { check_against_oracle(solids); });
}

TEST_CASE("made vertices of pairs of random solids are the oracle's points") {
  for_random_solids(60, 2000, 2, [](const auto& solids, RandomSolids&) {
    const std::vector<oracle::MadePoint> points = oracle::made_points(pointers_to(solids));
    const BooleanResult result = evaluate(Operation::Union, solids);
    for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
      if (result.provenance.vertex_source[v] != Provenance::none) continue;
      CHECK(std::any_of(points.begin(), points.end(), [&](const auto& made) { return made.rounded == result.mesh.points[v]; }));
    }
  });
}

TEST_CASE("results of many random solids keep the rules of inclusion and exclusion with one solid more") {
  // V(all or x) + V(all and x) = V(all) + V(x), where `all` is a result that was rounded: its faces are nearly coplanar with those of x.
  std::size_t calls = 0, uncertified = 0;
  const auto check = [&](const BooleanResult& result) {
    ++calls;
    if (result.report.certificate.status == CertificateStatus::Uncertified) {
      ++uncertified;
      CHECK(is_balanced(result.mesh));
    } else {
      CHECK(faults_of_mesh(result) == "");
    }
  };
  for_random_solids(30, 1000, 8, [&](const auto& solids, RandomSolids& random) {
    const SurfaceMesh all = evaluate(Operation::Union, solids).mesh, more = random.next();
    const BooleanResult either = evaluate(Operation::Union, {all, more}), both = evaluate(Operation::Intersect, {all, more});
    check(either);
    check(both);
    const double sum = exact_volume(all) + exact_volume(more);
    CHECK(exact_volume(either.mesh) + exact_volume(both.mesh) == Approx(sum).epsilon(1e-12));
  });
  CHECK(100 * uncertified <= calls);
}

TEST_CASE("the order of random operands does not change the result") {
  for_random_solids(60, 2000, 5, [](auto solids, RandomSolids& random) {
    const BooleanResult all = evaluate(Operation::Union, solids), rest = evaluate(Operation::Subtract, solids);
    std::vector<SurfaceMesh> others(solids.begin() + 1, solids.end());
    random.shuffle(others);
    others.insert(others.begin(), solids[0]);
    const BooleanResult same_rest = evaluate(Operation::Subtract, others);
    random.shuffle(solids);
    const BooleanResult same_all = evaluate(Operation::Union, solids);
    CHECK(sorted_points(all.mesh) == sorted_points(same_all.mesh));
    CHECK(all.mesh.triangles.size() == same_all.mesh.triangles.size());
    CHECK(sorted_points(rest.mesh) == sorted_points(same_rest.mesh));
    CHECK(rest.mesh.triangles.size() == same_rest.mesh.triangles.size());
  });
}

TEST_CASE("the numbering of faces and vertices does not change the result") {
  for_random_solids(60, 2000, 3, [](const auto& solids, RandomSolids& random) {
    std::vector<SurfaceMesh> shuffled;
    for (const SurfaceMesh& solid : solids) shuffled.push_back(renumbered(solid, random));
    for (const Operation operation : all_operations) {
      const BooleanResult one = evaluate(operation, solids), other = evaluate(operation, shuffled);
      CHECK(sorted_points(one.mesh) == sorted_points(other.mesh));
      CHECK(one.mesh.triangles.size() == other.mesh.triangles.size());
      CHECK(one.graph.edges.size() == other.graph.edges.size());
    }
  });
}

TEST_CASE("quarter turns turn the result, bit for bit") {
  for_random_solids(40, 1000, 3, [](const auto& solids, RandomSolids&) {
    check_commutes(solids, [](SurfaceMesh mesh) { return quarter_turned(std::move(mesh)); });
    check_commutes(solids, [](SurfaceMesh mesh) { return with_axes_turned(std::move(mesh)); });
  });
}

TEST_CASE("scales by 2^300 and 2^-300 scale the result, bit for bit") {
  for (const int exponent : {300, -300}) {
    for_random_solids(40, 1000, 3, [&](const auto& solids, RandomSolids&) {
      check_commutes(solids, [&](SurfaceMesh mesh) { return scaled(std::move(mesh), std::ldexp(1.0, exponent)); });
    });
  }
}

TEST_CASE("a far translation keeps every count, exactly") {
  // The made points round otherwise; what meets what stays the same.
  for_random_solids(40, 1000, 3, [](const auto& solids, RandomSolids&) {
    const auto far = each(solids, [](SurfaceMesh mesh) { return moved(std::move(mesh), {0x1p20, -0x1p20, 0x1p19}); });
    for (const Operation operation : all_operations) {
      const BooleanResult here = evaluate(operation, solids), there = evaluate(operation, far);
      CHECK(here.mesh.triangles.size() == there.mesh.triangles.size());
      CHECK(here.mesh.points.size() == there.mesh.points.size());
      CHECK(here.graph.edges.size() == there.graph.edges.size());
      CHECK(oracle::volume(there.mesh, exact_positions(pointers_to(far), there)) == oracle::boolean_volume(operation, pointers_to(solids)));
    }
  });
}
