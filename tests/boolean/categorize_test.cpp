// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Windings on both sides of every facet against point-in-mesh in rationals, and which operands are doubtful or inside out.
#include "mortise/boolean/categorize.h"

#include <algorithm>
#include <set>

#include "boolean/evaluation.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/grid_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
const OperandId first_operand(std::size_t{0}), second_operand(std::size_t{1});

}  // namespace

TEST_CASE("windings on both sides of every facet of the small scenes are the oracle's") {
  for (const Scene& scene : scenes_for_rationals()) {
    INFO(scene.name);
    const Evaluation evaluation(scene.operands);
    CHECK(evaluation.categories.doubtful.empty());
    CHECK(evaluation.categories.inside_out.empty());
    CHECK(count_wrong_windings(evaluation) == 0);
  }
}

TEST_CASE("windings of random solids that touch in all ways are the oracle's") {
  constexpr std::uint32_t seed = 60;
  INFO("seed " << seed);
  GridSolids random(seed);
  for (std::size_t i = 0, n = scaled_count(60, 4000); i < n; ++i) {
    INFO("case " << i);
    std::vector<SurfaceMesh> operands;
    for (int k = 0; k < 2 + random.below(2); ++k) operands.push_back(random.solid(3));
    const Evaluation scene(operands);
    CHECK(scene.categories.doubtful.empty());
    CHECK(count_wrong_windings(scene) == 0);
  }
}

TEST_CASE("windings of operands made of random parts that overlap are the oracle's once self contacts are searched") {
  constexpr std::uint32_t seed = 61;
  INFO("seed " << seed);
  GridSolids random(seed);
  for (std::size_t i = 0, n = scaled_count(40, 3000); i < n; ++i) {
    INFO("case " << i);
    const SurfaceMesh part = random.solid(3);
    const SurfaceMesh parts = joined({part, random.below(3) == 0 ? inside_out(random.solid(3)) : random.solid(3)});
    const Evaluation scene({parts, random.solid(3)}, {0});
    CHECK(count_wrong_windings(scene) == 0);
  }
}

namespace {

/// One edge of one face is split in places, and the gap to its neighbour is filled with faces without area.
SurfaceMesh with_faces_without_area(SurfaceMesh mesh, GridSolids& random) {
  const auto f = static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles.size())));
  const auto i = static_cast<std::size_t>(random.below(3));
  const Triangle c = mesh.triangles[f];
  const Vec3d from = mesh.points[c[i].index()], to = mesh.points[c[(i + 1) % 3].index()];
  std::vector<VertexId> chain{c[i]};
  for (int k = 0, n = 1 + random.below(2); k < n; ++k) {
    chain.push_back(VertexId(mesh.points.size()));
    mesh.points.push_back(from + 0.25 * (k + 1) * (to - from));
  }
  chain.push_back(c[(i + 1) % 3]);
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(f));
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) mesh.triangles.push_back({chain[k], chain[k + 1], c[(i + 2) % 3]});
  for (std::size_t k = 1; k + 1 < chain.size(); ++k) mesh.triangles.push_back({chain[0], chain[k + 1], chain[k]});
  return mesh;
}

/// A map that is exact for small whole numbers and leaves no face parallel to an axis, times a power of two.
SurfaceMesh sheared(SurfaceMesh mesh, double scale) {
  for (Vec3d& p : mesh.points) p = scale * Vec3d{p.x + 2 * p.y, p.y - p.z, p.x + p.y + 3 * p.z};
  return mesh;
}

}  // namespace

TEST_CASE("windings of random solids in tilted planes, of any size, are the oracle's") {
  constexpr std::uint32_t seed = 62;
  INFO("seed " << seed);
  GridSolids random(seed);
  for (std::size_t i = 0, n = scaled_count(40, 3000); i < n; ++i) {
    INFO("case " << i);
    const double scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 0x1p250 : 0x1p-250;
    const Evaluation scene({sheared(random.solid(3), scale), sheared(random.solid(3), scale)});
    CHECK(scene.categories.doubtful.empty());
    CHECK(count_wrong_windings(scene) == 0);
  }
}

TEST_CASE("faces without area that close an operand leave it closed, and its windings right") {
  constexpr std::uint32_t seed = 63;
  INFO("seed " << seed);
  GridSolids random(seed);
  for (std::size_t i = 0, n = scaled_count(40, 3000); i < n; ++i) {
    INFO("case " << i);
    const SurfaceMesh first = with_faces_without_area(scaled(random.solid(3), 4), random), second = scaled(random.solid(3), 4);
    const Evaluation scene({first, i % 2 == 0 ? second : with_faces_without_area(second, random)});
    CHECK(scene.faces.self_contacts[first_operand] == SelfContacts::Collinear);
    CHECK(scene.categories.patches.unbalanced.empty());
    CHECK(scene.categories.doubtful.empty());
    CHECK(count_wrong_windings(scene) == 0);
  }
}

TEST_CASE("the walk visits every region once") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const Evaluation evaluation(scene.operands);
    std::vector<int> visits(evaluation.categories.patches.region_count, 0);
    walk_regions(evaluation.faces, evaluation.facets, evaluation.categories,
                 [&](RegionId r, const RunningWinding&) { ++visits[r.index()]; });
    CHECK(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
  }
}

TEST_CASE("no operand, no face, no region") {
  const Evaluation nothing({SurfaceMesh{}});
  CHECK(nothing.categories.seeds.empty());
  CHECK((nothing.categories.doubtful.empty() && nothing.categories.inside_out.empty()));
}

// ---- operands that are not what they seem --------------------------------------------------------------------------------

TEST_CASE("an operand that another meets where it covers space twice is doubtful, and final once its crossings are resolved") {
  const SurfaceMesh star = pentagram_prism(0, 2), through_middle = box({-0.5, -0.5, -1}, {0.5, 0.5, 3});
  const Evaluation once({star, through_middle});
  CHECK(once.faces.self_contacts[first_operand] == SelfContacts::None);
  const auto& doubtful = once.categories.doubtful;
  CHECK(std::find(doubtful.begin(), doubtful.end(), first_operand) != doubtful.end());
  const Evaluation resolved({star, through_middle}, {0});
  CHECK(resolved.categories.doubtful.empty());
  CHECK(count_wrong_windings(resolved) == 0);
  const auto windings = resolved.windings();
  CHECK(std::any_of(windings.begin(), windings.end(), [](const std::vector<int>& w) { return w[0] == 2 && w[1] == 1; }));
}

TEST_CASE("a part where another operand covers space twice makes that operand doubtful, and no other") {
  const Evaluation scene({box({-0.5, -0.5, 0.5}, {0.5, 0.5, 1.5}), pentagram_prism(0, 2), moved(unit, {50, 0, 0})});
  CHECK(scene.contacts.contacts.empty());
  CHECK(scene.categories.doubtful == std::vector<OperandId>{second_operand});
}

TEST_CASE("an operand that crosses itself far from all others is taken as it is") {
  const Evaluation scene({pentagram_prism(0, 2), moved(unit, {50, 0, 0})});
  CHECK(scene.categories.doubtful.empty());
}

TEST_CASE("an operand oriented inwards is doubtful first and inside out in the end") {
  const Evaluation first({unit, moved(inside_out(unit), {5, 0, 0})});
  CHECK(first.categories.doubtful == std::vector<OperandId>{second_operand});
  const Evaluation second({unit, moved(inside_out(unit), {5, 0, 0})}, {1});
  CHECK(second.categories.doubtful.empty());
  CHECK(second.categories.inside_out == std::vector<OperandId>{second_operand});
}

TEST_CASE("an inside-out operand is found where it lies inside, crosses and coincides with others") {
  for (const SurfaceMesh& other :
       {box({-1, -1, -1}, {2, 2, 2}), moved(unit, {0.5, 0.5, 0.5}), unit, moved(unit, {1, 0, 0}), moved(unit, {1, 1, 1})}) {
    const Evaluation scene({inside_out(unit), other}, {0, 1});
    CHECK(scene.categories.inside_out == std::vector<OperandId>{first_operand});
    CHECK(scene.categories.doubtful.empty());
  }
}

TEST_CASE("an operand is not inside out when something of it has positive winding") {
  const Evaluation scene({joined({unit, inside_out(moved(unit, {5, 0, 0}))}), moved(unit, {50, 0, 0})}, {0});
  CHECK(scene.categories.inside_out.empty());
  const Evaluation cavity({joined({box({0, 0, 0}, {9, 9, 9}), inside_out(box({1, 1, 1}, {8, 8, 8}))}), moved(unit, {50, 0, 0})});
  CHECK((cavity.categories.inside_out.empty() && cavity.categories.doubtful.empty()));
}

TEST_CASE("a surface of no volume is neither inside out nor doubtful") {
  const SurfaceMesh flat = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const Evaluation scene({flat, moved(unit, {5, 0, 0})});
  CHECK((scene.categories.inside_out.empty() && scene.categories.doubtful.empty()));
  // Across x as well, where every edge at its smallest point has the same slope in (x, y).
  const SurfaceMesh upright = make_mesh({{0, 0, 0}, {0, 1, 1}, {0, 1, 2}}, {{0, 1, 2}, {0, 2, 1}});
  const Evaluation across({upright, box({-1, -1, -1}, {3, 3, 3})});
  CHECK((across.categories.inside_out.empty() && across.categories.doubtful.empty()));
  CHECK(count_wrong_windings(across) == 0);
}

TEST_CASE("an open operand is out of balance and does not make others doubtful") {
  const SurfaceMesh sheet = make_mesh({{-1, -1, 0.5}, {3, -1, 0.5}, {-1, 3, 0.5}}, {{0, 1, 2}});
  const Evaluation scene({unit, sheet});
  CHECK(scene.categories.doubtful.empty());
  CHECK(!scene.categories.patches.unbalanced.empty());
  const auto windings = scene.windings();
  for (const std::vector<int>& w : windings) CHECK((w[0] == 0 || w[0] == 1));
}

// ---- running windings ----------------------------------------------------------------------------------------------------

TEST_CASE("a running winding counts the operands it is inside of") {
  RunningWinding w({0, 1, -1});
  CHECK(w.operand_count() == 3);
  CHECK(w.inside_count() == 1);
  CHECK((!w.is_inside(OperandId(std::size_t{0})) && w.is_inside(OperandId(std::size_t{1})) && !w.is_inside(OperandId(std::size_t{2}))));
  w.change(OperandId(std::size_t{2}), 2);
  CHECK((w.of(OperandId(std::size_t{2})) == 1 && w.inside_count() == 2));
  w.change(OperandId(std::size_t{2}), 3);
  CHECK(w.inside_count() == 2);
  w.change(OperandId(std::size_t{1}), -1);
  CHECK((w.of(OperandId(std::size_t{1})) == 0 && w.inside_count() == 1));
}

TEST_CASE("equal windings have equal digests, however they are reached; different ones differ") {
  std::set<std::uint64_t> digests;
  for (int a = -3; a <= 3; ++a) {
    for (int b = -3; b <= 3; ++b) {
      for (int c = -3; c <= 3; ++c) {
        RunningWinding walked({0, 0, 0});
        walked.change(OperandId(std::size_t{2}), c - 5);
        walked.change(OperandId(std::size_t{0}), a);
        walked.change(OperandId(std::size_t{1}), b);
        walked.change(OperandId(std::size_t{2}), 5);
        CHECK(walked.digest() == RunningWinding({a, b, c}).digest());
        digests.insert(walked.digest());
      }
    }
  }
  CHECK(digests.size() == 7 * 7 * 7);
  const RunningWinding from({1, 2}), to({1, -1});
  CHECK(from.digest() + RunningWinding::digest_of_change(OperandId(std::size_t{1}), -3) == to.digest());
}
