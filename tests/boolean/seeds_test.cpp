// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One seed per complex, and its windings: nested and touching complexes, and another complex round the point it starts at.
#include "mortise/boolean/seeds.h"

#include <algorithm>

#include "boolean/evaluation.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/grid_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh cube(double lo, double hi) { return box({lo, lo, lo}, {hi, hi, hi}); }
const SurfaceMesh unit = cube(0, 1);

std::vector<std::vector<int>> seed_windings(const Evaluation& scene) {
  std::vector<std::vector<int>> result;
  for (const Seed& s : scene.categories.seeds) result.push_back(s.winding);
  return result;
}

using Windings = std::vector<std::vector<int>>;

/// Every facet has the oracle's windings on both sides: then every seed was right.
bool are_windings_right(const Evaluation& scene) { return count_wrong_windings(scene) == 0; }

SurfaceMesh turned(SurfaceMesh mesh, int quarter_turns, int axis_turns) {
  for (int i = 0; i < axis_turns; ++i) mesh = with_axes_turned(mesh);
  for (int i = 0; i < quarter_turns; ++i) mesh = quarter_turned(mesh);
  return mesh;
}

/// The check in twelve positions: the smallest point is another one each time.
void check_all_ways(const std::vector<SurfaceMesh>& operands) {
  for (int turns = 0; turns < 12; ++turns) {
    std::vector<SurfaceMesh> placed;
    for (const SurfaceMesh& m : operands) placed.push_back(turned(m, turns % 4, turns / 4));
    INFO("turns " << turns);
    CHECK(are_windings_right(Evaluation(placed)));
  }
}

}  // namespace

TEST_CASE("parts apart have a seed each, outside everything") {
  const Evaluation scene({unit, moved(unit, {5, 0, 0}), moved(unit, {-5, 0, 0})});
  CHECK(seed_windings(scene) == Windings(3, {0, 0, 0}));
}

TEST_CASE("operands joined by an edge of their graph are one complex") {
  CHECK(Evaluation({unit, moved(unit, {0.5, 0.5, 0.5})}).categories.seeds.size() == 1);
  CHECK(Evaluation({unit, moved(unit, {1, 0, 0})}).categories.seeds.size() == 1);
  CHECK(Evaluation({unit, moved(unit, {1, 1, 0})}).categories.seeds.size() == 1);
  CHECK(Evaluation({unit, unit}).categories.seeds.size() == 1);
}

TEST_CASE("operands that touch in a point are two complexes") {
  const Evaluation scene({unit, moved(unit, {1, 1, 1})});
  CHECK(seed_windings(scene) == Windings(2, {0, 0}));
}

TEST_CASE("nested operands have seeds that know what is round them") {
  const Evaluation scene({cube(0, 9), cube(3, 4), cube(1, 8), cube(2, 7)});
  CHECK(seed_windings(scene) == Windings{{0, 0, 0, 0}, {1, 0, 1, 1}, {1, 0, 0, 0}, {1, 0, 1, 0}});
  CHECK(are_windings_right(scene));
}

TEST_CASE("crossing parts inside a third are one complex with a seed of its own") {
  const Evaluation scene({cube(0, 9), cube(1, 4), box({3, 3, 3}, {6, 5, 5})});
  CHECK(seed_windings(scene) == Windings{{0, 0, 0}, {1, 0, 0}});
  check_all_ways({cube(0, 9), cube(1, 4), box({3, 3, 3}, {6, 5, 5})});
}

TEST_CASE("a part in the cavity of another is outside it") {
  const SurfaceMesh hollow = joined({cube(0, 9), inside_out(cube(1, 8))});
  const Evaluation scene({hollow, cube(3, 5)});
  CHECK(seed_windings(scene) == Windings{{0, 0}, {1, 0}, {0, 0}});  // the wall of the cavity is seen from within the solid
  CHECK(are_windings_right(scene));
}

TEST_CASE("many complexes, one inside the next, are found by trees as few are without") {
  std::vector<SurfaceMesh> boxes;
  for (int i = 0; i < 12; ++i) boxes.push_back(cube(i, 40 - i));
  const Evaluation scene(boxes);
  REQUIRE(scene.categories.seeds.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t k = 0; k < 12; ++k) CHECK(scene.categories.seeds[i].winding[k] == (k < i ? 1 : 0));
  }
}

TEST_CASE("rays pass through edges and corners of other operands without losing count") {
  // The inner part has its smallest point on lines through corners, edges and diagonals of what is round it.
  check_all_ways({cube(-4, 4), octahedron({0, 0, 0}, 1)});
  check_all_ways({octahedron({0, 0, 0}, 8), octahedron({0, 0, 0}, 1)});
  check_all_ways({octahedron({0, 0, 0}, 8), cube(-1, 1)});
  check_all_ways({octahedron({0, 0, 0}, 8), octahedron({0, 0, 0}, 4), octahedron({0, 0, 0}, 1)});
  check_all_ways({cube(-4, 4), tetrahedron({-4.5, 0, 0}, {-5, 1, 0}, {-5, 0, 1}, {-5, -1, -1})});
}

TEST_CASE("a corner that touches another complex in its inside, on an edge and on a corner") {
  const SurfaceMesh spike = tetrahedron({0, 0, 0}, {2, 1, 0}, {2, -1, 1}, {2, 0, -1});
  for (const Vec3d& corner : {Vec3d{-4, -2, -1.5}, Vec3d{-4, -4, -1}, Vec3d{-4, -4, -4}, Vec3d{-4, 0, 0}}) {
    check_all_ways({box(corner, corner + Vec3d{4, 4, 4}), spike});                                                          // from outside
    check_all_ways({joined({cube(-20, 20), inside_out(box(corner, corner + Vec3d{4, 4, 4}))}), moved(spike, {-3, 0, 0})});  // near a cavity
  }
  const SurfaceMesh wall = joined({cube(-20, 20), inside_out(box({0, -4, -4}, {8, 4, 4}))});
  check_all_ways({wall, spike});                         // inside a cavity, on its wall
  check_all_ways({box({0, -4, -4}, {8, 4, 4}), spike});  // inside a solid, on its wall
}

TEST_CASE("a corner in the tip of a pit, and in the tip of a cone, of another complex") {
  // A box with a pyramid taken out of its side x = 4, down to the tip at the origin.
  const SurfaceMesh pit = make_mesh(
      {{-4, -4, -4}, {4, -4, -4}, {-4, 4, -4}, {4, 4, -4}, {-4, -4, 4}, {4, -4, 4}, {-4, 4, 4}, {4, 4, 4}, {0, 0, 0}}, {{0, 2, 3},
                                                                                                                        {0, 3, 1},
                                                                                                                        {4, 5, 7},
                                                                                                                        {4, 7, 6},
                                                                                                                        {0, 1, 5},
                                                                                                                        {0, 5, 4},
                                                                                                                        {2, 6, 7},
                                                                                                                        {2, 7, 3},
                                                                                                                        {0, 4, 6},
                                                                                                                        {0, 6, 2},
                                                                                                                        {1, 3, 8},
                                                                                                                        {3, 7, 8},
                                                                                                                        {7, 5, 8},
                                                                                                                        {5, 1, 8}});
  const SurfaceMesh needle = tetrahedron({0, 0, 0}, {3, 1, 0}, {3, -1, 1}, {3, -1, -1});
  check_all_ways({pit, needle});                                                         // in the pit: outside
  check_all_ways({pit, turned(needle, 2, 0)});                                           // behind its tip: inside
  check_all_ways({needle, scaled(needle, -0.25)});                                       // tip to tip
  check_all_ways({tetrahedron({0, 0, 0}, {9, 6, 0}, {9, -6, 6}, {9, -6, -6}), needle});  // a cone round a cone, one tip
}

TEST_CASE("many parts that touch in one point are all seeded") {
  const SurfaceMesh spike = tetrahedron({0, 0, 0}, {4, 1, 0}, {4, -1, 1}, {4, -1, -1});
  std::vector<SurfaceMesh> star;
  for (int turns = 0; turns < 4; ++turns) star.push_back(turned(spike, turns, 0));
  for (const int turns : {0, 2}) star.push_back(turned(turned(spike, turns, 0), 0, 2));
  const Evaluation scene(star);
  CHECK(scene.categories.seeds.size() == star.size());
  CHECK(are_windings_right(scene));
  check_all_ways({joined(star), octahedron({0, 0, 0}, 1)});
}

TEST_CASE("random tetrahedra that share corners have the oracle's windings") {
  constexpr std::uint32_t seed = 5;
  INFO("seed " << seed);
  GridSolids random(seed);
  std::size_t complexes = 0;
  for (std::size_t i = 0, n = scaled_count(60, 4000); i < n; ++i) {
    INFO("case " << i);
    std::vector<SurfaceMesh> operands;
    for (int k = 0; k < 4; ++k) operands.push_back(random.tetrahedron(2));
    const Evaluation scene(operands);
    CHECK(are_windings_right(scene));
    complexes += scene.categories.seeds.size();
  }
  CHECK(complexes > scaled_count(60, 4000));
}
