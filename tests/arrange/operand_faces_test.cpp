// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operands over one set of points: numbering, welding, faces without area, and which operands need their self contacts.
#include "mortise/arrange/operand_faces.h"

#include <limits>

#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

/// Beside another operand: all self contacts of the only operand of a call are searched.
SelfContacts self_contacts_of(const SurfaceMesh& mesh) { return gather({mesh, unit}).self_contacts[OperandId(std::size_t{0})]; }

FaceShape shape_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return gather({make_mesh({a, b, c}, {{0, 1, 2}})}).shape[SourceId(std::size_t{0})];
}

SurfaceMesh with_face(SurfaceMesh mesh, std::size_t a, std::size_t b, std::size_t c) {
  mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return mesh;
}

}  // namespace

TEST_CASE("faces are numbered operand after operand") {
  const SurfaceMesh tet = tetrahedron({5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6});
  const OperandFaces faces = gather({unit, SurfaceMesh{}, tet});
  CHECK(faces.operand_count() == 3);
  CHECK(faces.first.values() == std::vector<std::uint32_t>{0, 12, 12, 16});
  CHECK(faces.corners.size() == 16);
  for (std::size_t f = 0; f < 16; ++f) {
    const SourceId id(f);
    const std::size_t k = f < 12 ? 0 : 2;
    CHECK(faces.operand[id] == OperandId(k));
    CHECK(faces.face_in_operand(id) == (k == 0 ? f : f - 12));
    const SurfaceMesh& mesh = k == 0 ? unit : tet;
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(faces.corner_position(id, i) == mesh.points[mesh.triangles[faces.face_in_operand(id)][i].index()]);
    }
  }
  CHECK(faces.points.size() == 12);
  CHECK(faces.points.input_count() == 12);
}

TEST_CASE("no operand at all is no face at all") {
  const OperandFaces faces = gather({});
  CHECK(faces.operand_count() == 0);
  CHECK(faces.corners.empty());
  CHECK(faces.first.values() == std::vector<std::uint32_t>{0});
}

TEST_CASE("equal positions are one point, within an operand and across operands") {
  const OperandFaces faces = gather({soup_of(unit), moved(unit, {1, 0, 0})});
  CHECK(faces.points.size() == 12);  // four corners are common
  const auto& points = faces.point_of_vertex;
  REQUIRE(points.size() == 2);
  CHECK(points[OperandId(std::size_t{0})].size() == 36);
  CHECK(points[OperandId(std::size_t{1})].size() == 8);
  CHECK(faces.points.nearest(points[OperandId(std::size_t{1})][0]) == Vec3d{1, 0, 0});
  // Vertex 0 of the second is corner (1, 0, 0) of the first.
  bool found = false;
  for (const PointId p : points[OperandId(std::size_t{0})]) found |= p == points[OperandId(std::size_t{1})][0];
  CHECK(found);
}

TEST_CASE("-0 is where +0 is, and one ulp apart is apart") {
  const double ulp = std::numeric_limits<double>::epsilon();
  const OperandFaces faces =
      gather({make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, -0.0, 0}, {1 + ulp, 0, 0}}, {{0, 1, 2}, {3, 4, 2}})});
  const auto& point = faces.point_of_vertex[OperandId(std::size_t{0})];
  CHECK(point[0] == point[3]);
  CHECK(point[1] != point[4]);
  CHECK(faces.points.size() == 4);
}

TEST_CASE("vertices that no face uses are points too, and change nothing") {
  SurfaceMesh mesh = unit;
  mesh.points.push_back({9, 9, 9});
  const OperandFaces faces = gather({mesh});
  CHECK(faces.points.size() == 9);
  CHECK(self_contacts_of(mesh) == SelfContacts::None);
}

TEST_CASE("a face is proper, collinear or repeated") {
  CHECK(shape_of({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) == FaceShape::Proper);
  CHECK(shape_of({0, 0, 0}, {1, 1, 1}, {2, 2, 2}) == FaceShape::Collinear);
  CHECK(shape_of({0, 0, 0}, {2, 2, 2}, {1, 1, 1}) == FaceShape::Collinear);
  CHECK(shape_of({0, 0, 0}, {1, 0, 0}, {0, 0, 0}) == FaceShape::Repeated);  // equal positions, different vertices
  CHECK(shape_of({1, 1, 1}, {1, 1, 1}, {1, 1, 1}) == FaceShape::Repeated);
  CHECK(gather({make_mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}})}).shape[SourceId(std::size_t{0})] == FaceShape::Repeated);
}

TEST_CASE("a face one ulp high is proper, and one of a tenth is judged by its doubles") {
  CHECK(shape_of({0, 0, 0}, {1, 1, 1}, {2, 2, 2.0000000000000004}) == FaceShape::Proper);
  CHECK(shape_of({0, 0, 0}, {1e300, 0, 0}, {5e299, 5e-324, 0}) == FaceShape::Proper);
  // 0.1 + 0.2 is not 0.3: the third point is beside the line in z only.
  CHECK(shape_of({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.1 + 0.2}) == FaceShape::Proper);
}

TEST_CASE("closed operands need no self contacts, however their vertices are shared") {
  CHECK(self_contacts_of(unit) == SelfContacts::None);
  CHECK(self_contacts_of(inside_out(unit)) == SelfContacts::None);
  CHECK(self_contacts_of(soup_of(unit)) == SelfContacts::None);
  CHECK(self_contacts_of(joined({unit, moved(unit, {1, 1, 0})})) == SelfContacts::None);  // an edge of four faces
  CHECK(self_contacts_of(SurfaceMesh{}) == SelfContacts::None);
}

TEST_CASE("all self contacts of the only operand of a call are searched") {
  CHECK(gather({unit}).self_contacts.values() == std::vector{SelfContacts::All});
}

TEST_CASE("parts of an operand whose boxes meet ask for the contacts between them") {
  CHECK(self_contacts_of(joined({unit, moved(unit, {0.5, 0.5, 0.5})})) == SelfContacts::Parts);
  CHECK(self_contacts_of(joined({unit, box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75})})) == SelfContacts::Parts);
  CHECK(self_contacts_of(joined({unit, moved(unit, {1.25, 0, 0})})) == SelfContacts::None);
  // Of three parts in a row the first and the last meet nothing else.
  CHECK(self_contacts_of(joined({unit, moved(unit, {4, 0, 0}), moved(unit, {2, 0, 0})})) == SelfContacts::None);
  CHECK(self_contacts_of(joined({unit, moved(unit, {4, 0, 0}), moved(unit, {4, 1, 0.5})})) == SelfContacts::Parts);
}

TEST_CASE("faces connected through vertices at equal positions are one part") {
  const OperandFaces faces = gather({joined({soup_of(unit), moved(unit, {1, 1, 1}), moved(unit, {5, 0, 0})}), moved(unit, {1, 0, 0})});
  const auto part = [&](std::size_t f) { return faces.part[SourceId(f)]; };
  for (std::size_t f = 0; f < 24; ++f) CHECK(part(f) == part(0));  // the second box shares a corner with the first
  for (std::size_t f = 24; f < 36; ++f) CHECK((part(f) == part(24) && part(f) != part(0)));
  for (std::size_t f = 36; f < 48; ++f) CHECK(part(f) == part(36));
}

TEST_CASE("open edges, faces that run the wrong way and coincident faces ask for all self contacts") {
  SurfaceMesh open = unit;
  open.triangles.pop_back();
  CHECK(self_contacts_of(open) == SelfContacts::All);
  SurfaceMesh flipped = unit;
  std::swap(flipped.triangles[3][1], flipped.triangles[3][2]);
  CHECK(self_contacts_of(flipped) == SelfContacts::All);
  CHECK(self_contacts_of(joined({unit, unit})) == SelfContacts::All);
  SurfaceMesh fin = unit;
  fin.points.push_back({0.5, 0.5, 3});
  fin = with_face(with_face(fin, 4, 7, 8), 7, 4, 8);  // closed: a fin of two opposite faces
  CHECK(self_contacts_of(fin) == SelfContacts::All);
}

TEST_CASE("a closed operand with a face without area asks for the contacts of that face only") {
  SurfaceMesh split = unit;  // (0, 3, 1) of the bottom becomes two faces over the middle of edge 0 - 1, and a face without area
  split.points.push_back({0.5, 0, 0});
  split.triangles.erase(split.triangles.begin() + 1);
  split = with_face(with_face(with_face(split, 0, 3, 8), 8, 3, 1), 0, 8, 1);
  CHECK(self_contacts_of(split) == SelfContacts::Collinear);
  CHECK(self_contacts_of(with_face(unit, 0, 1, 1)) == SelfContacts::None);  // a repeated corner leaves no trace
}

TEST_CASE("every operand is judged by itself") {
  SurfaceMesh open = unit;
  open.triangles.pop_back();
  const OperandFaces faces = gather({unit, open, unit});
  CHECK(faces.self_contacts.values() == std::vector{SelfContacts::None, SelfContacts::All, SelfContacts::None});
}

TEST_CASE("faces and operands know their boxes") {
  const OperandFaces faces = gather({unit, SurfaceMesh{}, tetrahedron({5, 5, 5}, {7, 5, 5}, {5, 8, 5}, {5, 5, 9})});
  const auto bounds = [&](std::size_t k) { return faces.bounds[OperandId(k)]; };
  CHECK((bounds(0).lo == Vec3d{0, 0, 0} && bounds(0).hi == Vec3d{1, 1, 1}));
  CHECK(bounds(1).is_empty());
  CHECK((bounds(2).lo == Vec3d{5, 5, 5} && bounds(2).hi == Vec3d{7, 8, 9}));
  Box3 all;
  for (std::uint32_t f = faces.first[OperandId(std::size_t{2})]; f < faces.end(OperandId(std::size_t{2})); ++f)
    all.extend(faces.box(SourceId(f)));
  CHECK((all.lo == bounds(2).lo && all.hi == bounds(2).hi));
  CHECK((faces.box(SourceId(std::size_t{0})).lo == Vec3d{0, 0, 0} && faces.box(SourceId(std::size_t{0})).hi == Vec3d{1, 1, 0}));
}

TEST_CASE("an operand that cannot be worked on is named with its vertices or faces") {
  SurfaceMesh not_finite = unit;
  not_finite.points[5].y = std::numeric_limits<double>::quiet_NaN();
  not_finite.points[7].z = std::numeric_limits<double>::infinity();
  const auto nan = error_of([&] { (void)gather({unit, not_finite}); });
  REQUIRE(nan);
  CHECK(nan->code == ErrorCode::NotFinite);
  CHECK(nan->operand == 1);
  CHECK(nan->id_kind == IdKind::Vertices);
  CHECK(nan->ids == std::vector<std::uint32_t>{5, 7});

  const auto index = error_of([&] { (void)gather({unit, unit, with_face(unit, 0, 1, 8)}); });
  REQUIRE(index);
  CHECK(index->code == ErrorCode::BadIndex);
  CHECK(index->operand == 2);
  CHECK(index->id_kind == IdKind::Faces);
  CHECK(index->ids == std::vector<std::uint32_t>{12});

  SurfaceMesh unnamed = unit;
  unnamed.face_labels.assign(12, 0);
  const auto label = error_of([&] { (void)gather({unnamed}); });
  REQUIRE(label);
  CHECK(label->code == ErrorCode::InvalidArgument);
  CHECK(label->operand == 0);
}
