// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Patches, junctions and regions: counts of simple scenes, order round every junction in rationals, jumps and balance.
#include "mortise/boolean/patches.h"

#include <algorithm>
#include <map>
#include <set>

#include "boolean/evaluation.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/exact_points.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

struct PatchedScene : Arrangement {
  explicit PatchedScene(std::vector<SurfaceMesh> meshes, const std::vector<std::size_t>& self = {})
      : Arrangement(std::move(meshes), self), patches(build_patches(faces, map, facets)) {}
  const Patches patches;
};

using PointPair = std::array<PointId, 2>;

/// Facets at every edge of the arrangement.
std::map<PointPair, std::vector<FacetId>> facets_at_edges(const Arrangement& scene) {
  std::map<PointPair, std::vector<FacetId>> result;
  for (std::size_t i = 0; i < scene.facets.size(); ++i) {
    const PlanePoints& c = scene.facets.corners[FacetId(i)];
    for (std::size_t e = 0; e < 3; ++e) result[{std::min(c[e], c[(e + 1) % 3]), std::max(c[e], c[(e + 1) % 3])}].push_back(FacetId(i));
  }
  return result;
}

SurfaceMesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return make_mesh({a, b, c}, {{0, 1, 2}}); }

}  // namespace

TEST_CASE("a closed operand alone is one patch between two regions") {
  const PatchedScene scene({unit, moved(unit, {5, 0, 0})});
  CHECK(scene.patches.first_facet.size() == 2);
  CHECK(scene.patches.junctions.empty());
  CHECK(scene.patches.unbalanced.empty());
  CHECK(scene.patches.region_count == 4);  // those of different complexes stay apart
  for (std::size_t f = 0; f < 24; ++f) CHECK(scene.patches.patch_of_facet[FacetId(f)] == PatchId(f / 12));
}

TEST_CASE("two boxes through a corner of each other are four patches round a loop, and four regions") {
  const PatchedScene scene({unit, moved(unit, {0.5, 0.5, 0.5})});
  CHECK(scene.patches.first_facet.size() == 4);
  CHECK(scene.patches.region_count == 4);
  CHECK(scene.patches.unbalanced.empty());
  CHECK(!scene.patches.junctions.empty());
  for (const Junction& j : scene.patches.junctions) {
    CHECK(j.u < j.v);
    CHECK(scene.patches.facets_round(j).size() == 4);
  }
}

TEST_CASE("a bar through a box is cut in three by two loops") {
  const PatchedScene scene({unit, box({0.25, 0.25, -1}, {0.75, 0.75, 2})});
  // The box: outside, and two lids; the bar: two ends and the middle.
  CHECK(scene.patches.first_facet.size() == 6);
  // Outside, the two ends, the middle, the rest of the box.
  CHECK(scene.patches.region_count == 5);
}

TEST_CASE("boxes that share a face have three patches and three regions") {
  const PatchedScene scene({unit, moved(unit, {1, 0, 0})});
  CHECK(scene.patches.first_facet.size() == 3);
  CHECK(scene.patches.region_count == 3);
  CHECK(scene.patches.junctions.size() == 4);  // the border of the common face, three facets each
  for (const Junction& j : scene.patches.junctions) CHECK(j.facet_count == 3);
}

TEST_CASE("boxes that share an edge meet in one junction of four") {
  const PatchedScene scene({unit, moved(unit, {1, 1, 0})});
  CHECK(scene.patches.first_facet.size() == 2);
  REQUIRE(scene.patches.junctions.size() == 1);
  CHECK(scene.patches.junctions[0].facet_count == 4);
  CHECK(scene.patches.region_count == 3);
}

TEST_CASE("boxes that share a corner have no junction") {
  const PatchedScene scene({unit, moved(unit, {1, 1, 1})});
  CHECK(scene.patches.first_facet.size() == 2);
  CHECK(scene.patches.junctions.empty());
  CHECK(scene.patches.region_count == 4);
}

TEST_CASE("the order round every junction of the small scenes is that of the exact angles") {
  std::size_t junctions = 0;
  for (const Scene& scene : scenes_for_rationals()) {
    INFO(scene.name);
    const PatchedScene patched(scene.operands);
    const std::vector<oracle::RationalPoint> at = exact_points(patched);
    for (const Junction& j : patched.patches.junctions) {
      const auto around = patched.patches.facets_round(j);
      // Going from one facet to the next, no other facet is passed: of two neighbours a, b and any c, c is not between.
      const auto apex = [&](const FacetAtEdge& f) {
        for (const PointId p : patched.facets.corners[f.facet]) {
          if (p != j.u && p != j.v) return at[p.index()];
        }
        return at[j.u.index()];
      };
      const auto side = [&](const FacetAtEdge& a, const FacetAtEdge& b) {
        return oracle::orient3d(at[j.u.index()], at[j.v.index()], apex(a), apex(b));
      };
      for (std::size_t i = 0; i < around.size(); ++i) {
        const FacetAtEdge& a = around[i];
        const FacetAtEdge& b = around[(i + 1) % around.size()];
        for (const FacetAtEdge& c : around) {
          if (c.facet == a.facet || c.facet == b.facet) continue;
          const bool less_than_half = side(a, b) > 0;
          const bool between = less_than_half ? side(a, c) > 0 && side(c, b) > 0 : side(a, c) > 0 || side(c, b) > 0;
          CHECK_FALSE(between);
        }
      }
      ++junctions;
    }
  }
  CHECK(junctions > 20);
}

TEST_CASE("facets of one patch have the same jumps, and junctions are where patches end") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const PatchedScene patched(scene.operands);
    const Patches& patches = patched.patches;
    CHECK(patches.unbalanced.empty());
    std::set<PointPair> at_junction;
    for (const Junction& j : patches.junctions) at_junction.insert({j.u, j.v});
    for (std::size_t i = 0; i < patched.facets.size(); ++i) {
      const FacetId f(i), first = patches.first_facet[patches.patch_of_facet[f]];
      CHECK(first <= f);
      CHECK(jumps_of(patched.faces, patched.facets, f) == jumps_of(patched.faces, patched.facets, first));
    }
    for (const auto& [edge, facets] : facets_at_edges(patched)) {
      if (facets.size() != 2) {
        CHECK(at_junction.count(edge) == 1);
      } else if (at_junction.count(edge) == 0) {
        CHECK(patches.patch_of_facet[facets[0]] == patches.patch_of_facet[facets[1]]);
      }
    }
  }
}

TEST_CASE("searching all self contacts joins by edges and finds the same windings on both sides of every facet") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < scene.operands.size(); ++k) all.push_back(k);
    const Evaluation by_vertices(scene.operands), by_edges(scene.operands, all);
    REQUIRE(by_vertices.facets.size() == by_edges.facets.size());
    const auto first = by_vertices.windings(), second = by_edges.windings();
    for (std::size_t i = 0; i < by_edges.facets.size(); ++i) {
      const FacetId f(i);
      CHECK(first[by_vertices.front(f)] == second[by_edges.front(f)]);
      CHECK(first[by_vertices.back(f)] == second[by_edges.back(f)]);
    }
  }
}

// ---- jumps and balance ---------------------------------------------------------------------------------------------------

TEST_CASE("the jump of a facet adds up over its sources") {
  const SurfaceMesh up = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), down = triangle({0, 0, 0}, {0, 4, 0}, {4, 0, 0});
  const auto jumps = [](const std::vector<SurfaceMesh>& operands) {
    const Arrangement scene(operands);
    REQUIRE(scene.facets.size() == 1);
    return jumps_of(scene.faces, scene.facets, FacetId(std::size_t{0}));
  };
  const OperandId a(std::size_t{0}), b(std::size_t{1}), c(std::size_t{2});
  CHECK(jumps({up}) == std::vector<Jump>{{a, 1}});
  CHECK(jumps({up, up}) == std::vector<Jump>{{a, 1}, {b, 1}});
  CHECK(jumps({up, down}) == std::vector<Jump>{{a, 1}, {b, -1}});
  CHECK(jumps({down, up, up}) == std::vector<Jump>{{a, 1}, {b, -1}, {c, -1}});  // as seen from the first
  CHECK(jumps({joined({up, up})}) == std::vector<Jump>{{a, 2}});
  CHECK(jumps({joined({up, down})}).empty());
  CHECK(jumps({joined({up, down, up}), up}) == std::vector<Jump>{{a, 1}, {b, 1}});
}

TEST_CASE("open edges and edges that run the same way are out of balance, and told apart") {
  SurfaceMesh open = unit;
  open.triangles.pop_back();
  const PatchedScene hole({open});
  REQUIRE(hole.patches.unbalanced.size() == 3);
  for (const UnbalancedEdge& e : hole.patches.unbalanced) CHECK((e.is_open && e.operand == OperandId(std::size_t{0}) && e.u < e.v));
  SurfaceMesh flipped = unit;
  std::swap(flipped.triangles[3][1], flipped.triangles[3][2]);
  const PatchedScene wrong({unit, moved(flipped, {9, 0, 0})});
  REQUIRE(wrong.patches.unbalanced.size() == 3);
  for (const UnbalancedEdge& e : wrong.patches.unbalanced) CHECK((!e.is_open && e.operand == OperandId(std::size_t{1})));
}

TEST_CASE("edges of four faces are in balance when as many run either way") {
  const PatchedScene pinched({joined({unit, moved(unit, {1, 1, 0})})});
  CHECK(pinched.patches.unbalanced.empty());
  REQUIRE(pinched.patches.junctions.size() == 1);
  CHECK(pinched.patches.facets_round(pinched.patches.junctions[0]).size() == 4);
}

TEST_CASE("a closed operand where another lies open is in balance there") {
  // A sheet through the box: its border is out of balance, the box is not.
  const PatchedScene scene({unit, triangle({-1, -1, 0.5}, {3, -1, 0.5}, {-1, 3, 0.5})});
  CHECK(!scene.patches.unbalanced.empty());
  for (const UnbalancedEdge& e : scene.patches.unbalanced) CHECK(e.operand == OperandId(std::size_t{1}));
}

TEST_CASE("both sides of an open patch are one region") {
  const PatchedScene sheet({triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})});
  CHECK(sheet.patches.region_count == 1);
  CHECK(sheet.patches.front[PatchId(std::size_t{0})] == sheet.patches.back[PatchId(std::size_t{0})]);
}
