// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Parts that touch others in single points only: they were once lost.
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

TEST_CASE("a tetrahedron that touches another in one corner is a part of the union") {
  // There is no edge between them along which a winding could be carried.
  const SurfaceMesh a = tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
                    b = tetrahedron({0, 0, 1}, {1, 0, 2}, {0, 1, 2}, {0, 0, 2});
  const BooleanResult result = evaluate(Operation::Union, {a, b});
  CHECK(result.mesh.triangles.size() == 8);
  CHECK(result.mesh.points.size() == 7);
  CHECK(evaluate(Operation::Intersect, {a, b}).mesh.triangles.empty());
}

TEST_CASE("a tetrahedron whose smallest vertex is on a corner of another is a part of the union") {
  // A ray from that vertex would start on the other's surface.
  const SurfaceMesh a = tetrahedron({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
                    b = tetrahedron({0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, 0, -1});
  for (const auto& operands : {std::vector{a, b}, std::vector{b, a}}) {
    const BooleanResult result = evaluate(Operation::Union, operands);
    CHECK(result.mesh.triangles.size() == 8);
    CHECK(result.mesh.points.size() == 7);
  }
}

TEST_CASE("a tetrahedron whose smallest vertex is on a face of another, inside it, is no part of the union") {
  const SurfaceMesh a = tetrahedron({0, -9, -9}, {0, 9, -9}, {0, 0, 9}, {9, 0, 0}),
                    b = tetrahedron({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1});
  CHECK(evaluate(Operation::Union, {a, b}).mesh.triangles.size() == 6);  // one face of a is split in three at the point
  CHECK(exact_volume(evaluate(Operation::Subtract, {a, b}).mesh) == exact_volume(a) - exact_volume(b));
}
