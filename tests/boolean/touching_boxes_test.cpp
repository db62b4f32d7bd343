// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Boxes that share a face, a part of a face, an edge, a corner or everything: measures, contact and counts, all exact.
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
const SurfaceMesh crossed = box_other_diagonals({0, 0, 0}, {1, 1, 1});

}  // namespace

TEST_CASE("two boxes sharing a face unite to one part without the face") {
  const BooleanResult result = evaluate(Operation::Union, {unit, moved(crossed, {1, 0, 0})});
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 2 && shape.area == 10));
  CHECK((shape.shells == 1 && shape.genus == 0 && shape.pinched_edges == 0));
  // 12 corners; the two diagonals of the shared face cross in a point that is gone with it.
  CHECK(result.mesh.points.size() == 12);
  CHECK(shape.triangles == 20);
}

TEST_CASE("two boxes sharing a face intersect in nothing, and the report gives the contact") {
  const BooleanResult result = evaluate(Operation::Intersect, {unit, moved(crossed, {1, 0, 0})});
  CHECK(result.mesh.triangles.empty());
  CHECK(result.mesh.points.empty());
  CHECK(result.report.contact.area == 1);
}

TEST_CASE("subtracting a box that shares a face leaves the first as it was") {
  const BooleanResult result = evaluate(Operation::Subtract, {unit, moved(unit, {1, 0, 0})});
  CHECK(shape_of(result.mesh).volume == 1);
  CHECK(result.mesh.triangles.size() == 12);
}

TEST_CASE("a smaller face in the middle of a larger one leaves a frame") {
  const BooleanResult result = evaluate(Operation::Union, {unit, box_other_diagonals({1, 0.25, 0.25}, {1.5, 0.75, 0.75})});
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 1.125 && shape.area == 7));
  CHECK((shape.shells == 1 && shape.genus == 0));
}

TEST_CASE("two boxes sharing an edge unite to one mesh with a pinched edge") {
  const BooleanResult result = evaluate(Operation::Union, {unit, moved(unit, {1, 1, 0})});
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 2 && shape.area == 12));
  CHECK(shape.pinched_edges == 1);
  CHECK(result.mesh.points.size() == 14);
  CHECK(shape.triangles == 24);
  CHECK(result.report.contact.length == 1);
  CHECK(result.report.contact.area == 0);
  CHECK((result.graph.open_chains == 1 && result.graph.closed_loops == 0));
}

TEST_CASE("two boxes sharing a corner unite to one mesh with a shared vertex") {
  const BooleanResult result = evaluate(Operation::Union, {unit, moved(unit, {1, 1, 1})});
  const Shape shape = shape_of(result.mesh);
  CHECK((shape.volume == 2 && shape.area == 12));
  CHECK((shape.shells == 2 && shape.genus == 0));
  CHECK(result.mesh.points.size() == 15);
  CHECK((result.report.contact.points == 1 && result.report.contact.length == 0));
  CHECK((result.graph.points.size() == 1 && result.graph.edges.empty() && result.graph.chains.empty()));
}

TEST_CASE("boxes that share an edge or a corner only do not change one another by subtraction") {
  for (const Vec3d& offset : {Vec3d{1, 1, 0}, Vec3d{1, 1, 1}}) {
    const BooleanResult result = evaluate(Operation::Subtract, {unit, moved(unit, offset)});
    CHECK(sorted_points(result.mesh) == sorted_points(unit));
    CHECK(evaluate(Operation::Intersect, {unit, moved(unit, offset)}).mesh.triangles.empty());
  }
}

TEST_CASE("a box with itself unites and intersects to the box, untouched, and subtracts to nothing") {
  for (const Operation operation : {Operation::Union, Operation::Intersect}) {
    const BooleanResult result = evaluate(operation, {unit, unit});
    CHECK(result.mesh.triangles.size() == 12);
    CHECK(sorted_points(result.mesh) == sorted_points(unit));
    CHECK(result.report.contact.area == 6);
    for (std::size_t f = 0; f < 12; ++f) {
      CHECK(result.provenance.source_operand[f] == 0);
      CHECK(result.provenance.other_source_begin[f + 1] - result.provenance.other_source_begin[f] == 1);
    }
  }
  CHECK(evaluate(Operation::Subtract, {unit, unit}).mesh.triangles.empty());
}

TEST_CASE("a box with itself a hundred times is the box") {
  const BooleanResult result = evaluate(Operation::Union, std::vector<SurfaceMesh>(100, unit));
  CHECK(result.mesh.triangles.size() == 12);
  CHECK(result.provenance.other_source_operand.size() == 12 * 99);
}

TEST_CASE("the same box with other diagonals gains the six crossings of diagonals and nothing else") {
  const BooleanResult result = evaluate(Operation::Intersect, {unit, crossed});
  CHECK(result.mesh.points.size() == 14);
  CHECK(result.mesh.triangles.size() == 24);
  CHECK(shape_of(result.mesh).area == 6);
  CHECK(evaluate(Operation::Subtract, {unit, crossed}).mesh.triangles.empty());
}

TEST_CASE("one ulp between two boxes keeps them apart") {
  const BooleanResult result = evaluate(Operation::Union, {unit, box({1.0000000000000002, 0, 0}, {2, 1, 1})});
  CHECK(result.mesh.triangles.size() == 24);
  CHECK(result.graph.points.empty());
  CHECK((result.report.contact.points == 0 && result.report.contact.length == 0 && result.report.contact.area == 0));
}

TEST_CASE("a vertex, an edge or a face on a face is reported as contact") {
  const BooleanResult vertex = evaluate(Operation::Union, {unit, tetrahedron({0.5, 0.25, 1}, {0.3, 0.3, 2}, {0.7, 0.3, 2}, {0.5, 0.7, 2})});
  CHECK((vertex.report.contact.points == 1 && vertex.report.contact.length == 0 && vertex.report.contact.area == 0));
  const BooleanResult edge =
      evaluate(Operation::Union, {unit, tetrahedron({0.25, 0.5, 1}, {0.75, 0.5, 1}, {0.5, 0.25, 2}, {0.5, 0.75, 2})});
  CHECK((edge.report.contact.points == 0 && edge.report.contact.length == 0.5 && edge.report.contact.area == 0));
  const BooleanResult face = evaluate(Operation::Union, {unit, box({0.25, 0.25, 1}, {0.75, 0.75, 2})});
  CHECK(face.report.contact.area == 0.25);
}
