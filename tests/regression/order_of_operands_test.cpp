// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Results that once depended on the order of the operands: diagonals of rectangles, and repairs of what rounding folded.
#include <algorithm>
#include <array>

#include "mortise/mesh/shapes.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_cases.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Place = std::array<double, 3>;

/// The corners of every face, the smallest first, sorted.
std::vector<std::array<Place, 3>> sorted_faces(const SurfaceMesh& mesh) {
  std::vector<std::array<Place, 3>> faces;
  for (const Triangle& t : mesh.triangles) {
    std::array<Place, 3> face{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& p = mesh.points[t[i].index()];
      face[i] = {p.x, p.y, p.z};
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The same without a sense: what separates two operands runs along the first of them.
std::vector<std::array<Place, 3>> sorted_places(const SurfaceMesh& mesh) {
  std::vector<std::array<Place, 3>> faces = sorted_faces(mesh);
  for (std::array<Place, 3>& face : faces) std::sort(face.begin(), face.end());
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

TEST_CASE("diagonals of rectangles do not depend on the order of the operands") {
  // A wedge across a U cuts a rectangle, of which both diagonals are as good.
  const SurfaceMesh wedge = make_mesh({{1, 2, 3}, {1, 3, 1}, {1, 3, 3}, {4, 2, 3}, {4, 3, 1}, {4, 3, 3}},
                                      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
  const std::vector<Vec2d> outline{{0, 0}, {6, 0}, {6, 3}, {3, 3}, {3, 2}, {2, 2}, {2, 3}, {0, 3}};
  const SurfaceMesh u = moved(extrude(outline, 2), {0, 0, 1});
  CHECK(sorted_faces(evaluate(Operation::Union, {wedge, u}).mesh) == sorted_faces(evaluate(Operation::Union, {u, wedge}).mesh));
}

TEST_CASE("repairs of a prism cut by itself moved by one ulp do not depend on the order of the operands") {
  constexpr double half_less = 0.49999999999999994, one_less = 0.9999999999999999, one_more = 1.0000000000000002;
  const SurfaceMesh plain = prism({{{0, 0.75}, {0.5, 0.25}, {1, 1}}}, 0.5, 1);
  SurfaceMesh shaken = plain;
  shaken.points = {{5e-324, 0.7499999999999999, half_less}, {0.5, 0.25000000000000006, 0.5},      {one_less, one_more, 0.5000000000000001},
                   {0, 0.7500000000000001, one_more},       {0.5000000000000001, 0.25, one_more}, {one_more, 1, 1}};
  for (const Operation operation : {Operation::Union, Operation::Intersect}) {
    CHECK(sorted_faces(evaluate(operation, {plain, shaken}).mesh) == sorted_faces(evaluate(operation, {shaken, plain}).mesh));
  }
}

TEST_CASE("triangles that rounding laid on each other have no order that could depend on the operands") {
  const std::vector<std::array<std::size_t, 3>> faces{{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                                                      {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  constexpr double half_less = 0.49999999999999994, less = 0.74999999999999989, one_more = 1.0000000000000002;
  const SurfaceMesh plain = make_mesh({{0.75, 0.25, 1}, {1, 0.25, 0.5}, {0.75, 0.25, 0}, {0.75, 1, 1}, {1, 1, 0.5}, {0.75, 1, 0}}, faces);
  const SurfaceMesh shaken = make_mesh({{0.75000000000000011, 0.25000000000000006, one_more},
                                        {0.99999999999999989, 0.25000000000000006, 0.5},
                                        {less, 0.25, 0},
                                        {less, one_more, 1},
                                        {one_more, 1, half_less},
                                        {less, 1, 0}},
                                       faces);
  CHECK(sorted_faces(evaluate(Operation::Union, {plain, shaken}).mesh) == sorted_faces(evaluate(Operation::Union, {shaken, plain}).mesh));
}

TEST_CASE("neither merged triangles, nor turned shells, nor edges of one length make repairs depend on the order of the operands") {
  const auto& [seed, number] = GENERATE(table<std::uint64_t, std::uint64_t>({{1, 166}, {1, 243}, {1, 345}, {3, 91}, {3, 189}, {6, 108}}));
  INFO("seed " << seed << ", case " << number);
  const std::vector<SurfaceMesh> operands = make_random_case(seed, number).operands;
  const std::vector<SurfaceMesh> backwards(operands.rbegin(), operands.rend());
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Partition}) {
    const BooleanResult result = evaluate(operation, operands), other = evaluate(operation, backwards);
    CHECK(sorted_places(result.mesh) == sorted_places(other.mesh));
    CHECK(result.graph.edges.size() == other.graph.edges.size());
    CHECK((operation != Operation::Partition || result.report.certificate.snap_rounds > 0));
  }
}

TEST_CASE("neither axes of planes nor orders round edges of facets that repairs split make repairs depend on the order of the operands") {
  const auto& [seed, number] = GENERATE(table<std::uint64_t, std::uint64_t>({{2064, 56}, {2064, 238}, {2074, 89}}));
  INFO("seed " << seed << ", case " << number);
  const std::vector<SurfaceMesh> operands = make_random_case(seed, number).operands;
  const std::vector<SurfaceMesh> backwards(operands.rbegin(), operands.rend());
  const BooleanResult result = evaluate(Operation::Partition, operands), other = evaluate(Operation::Partition, backwards);
  CHECK(sorted_places(result.mesh) == sorted_places(other.mesh));
  CHECK(result.graph.edges.size() == other.graph.edges.size());
}

TEST_CASE("a contact of an operand with itself at an edge of another is seen, whatever the order of the operands") {
  // A wedge glued under a box, with which it shares two vertices but no edge, and a wedge that ends at their common edge.
  const std::vector<std::array<std::size_t, 3>> faces{{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                                                      {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  const SurfaceMesh under = make_mesh({{3, 0, 1}, {1, 0, -2}, {0, 0, 1}, {3, 1, 1}, {1, 1, -2}, {0, 1, 1}}, faces);
  const SurfaceMesh glued = weld(joined({under, box({0, 0, 1}, {3, 3, 2})})).mesh;
  const SurfaceMesh beside = make_mesh({{3, -3, 1}, {3, -1, -1}, {3, 1, 1}, {4, -3, 1}, {4, -1, -1}, {4, 1, 1}}, faces);
  const BooleanResult forwards = evaluate(Operation::Union, {glued, beside}), backwards = evaluate(Operation::Union, {beside, glued});
  CHECK(sorted_faces(forwards.mesh) == sorted_faces(backwards.mesh));
  CHECK(forwards.report.self_contacts == std::vector<std::uint32_t>{0});
  CHECK(exact_volume(forwards.mesh) == exact_volume(glued) + exact_volume(beside));
}
