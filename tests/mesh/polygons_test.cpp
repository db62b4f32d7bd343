// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Polygons of a file come back as they were from whatever leaves them whole.
#include "mortise/mesh/polygons.h"

#include <algorithm>
#include <sstream>

#include "boolean/evaluation.h"
#include "mortise/boolean/imprint.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/split_parts.h"
#include "mortise/mesh/transform.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A prism 0 <= z <= 1 over an L of six corners: two hexagons and six quads, the second hexagon from another corner.
const std::string l_shape =
    "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
    "6 5 4 3 2 1 0\n6 8 9 10 11 6 7\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n";

SurfaceMesh read(const std::string& off) { return read_mesh(off, "mesh.off"); }
std::string write(const SurfaceMesh& mesh) { return write_mesh(mesh, Format::Off); }

/// The lines of faces.
std::vector<std::string> faces_of(const std::string& off) {
  std::istringstream text(off);
  std::string line;
  std::getline(text, line);
  std::size_t points = 0;
  text >> points;
  std::getline(text, line);
  for (std::size_t i = 0; i < points; ++i) std::getline(text, line);
  std::vector<std::string> faces;
  while (std::getline(text, line)) faces.push_back(line);
  return faces;
}

std::vector<std::size_t> corner_counts(const SurfaceMesh& mesh) {
  const Polygons polygons = find_polygons(mesh);
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < polygons.size(); ++i) counts.push_back(polygons.corners_of(i).size());
  return counts;
}

}  // namespace

TEST_CASE("polygons that are read are written as they were, in every format that has them") {
  const SurfaceMesh mesh = read(l_shape);
  CHECK(mesh.triangles.size() == 20);
  CHECK(write(mesh) == l_shape);
  for (const Format format : {Format::Obj, Format::PlyAscii, Format::PlyBinary}) {
    const SurfaceMesh again = read_mesh(write_mesh(mesh, format), format == Format::Obj ? "mesh.obj" : "mesh.ply");
    CHECK(write(again) == l_shape);
    CHECK(again.diagonals == mesh.diagonals);
  }
}

TEST_CASE("a mesh without polygons has no diagonals, and one with some has none elsewhere") {
  CHECK(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").diagonals.empty());
  const SurfaceMesh mesh = read("OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 1\n3 1 4 2\n4 0 1 2 3\n");
  CHECK(mesh.diagonals.size() == 3);
  CHECK(mesh.diagonals[0] == 0);
  CHECK(corner_counts(mesh) == std::vector<std::size_t>{3, 4});
}

TEST_CASE("polygons an operation leaves whole stay, cut ones become triangles") {
  const SurfaceMesh solid = read(l_shape), cutter = box({1.5, -1, 0.25}, {3, 3, 0.75});  // cuts three of the sides
  const BooleanResult cut = evaluate(Operation::Subtract, {solid, cutter});
  std::vector<std::size_t> counts = corner_counts(cut.mesh);
  std::sort(counts.rbegin(), counts.rend());
  CHECK(std::vector<std::size_t>(counts.begin(), counts.begin() + 5) == std::vector<std::size_t>{6, 6, 4, 4, 4});
  CHECK(counts[5] == 3);
  const std::vector<std::string> before = faces_of(l_shape), after = faces_of(write(cut.mesh));
  for (const std::size_t whole : {0U, 1U, 5U, 6U, 7U}) CHECK(std::count(after.begin(), after.end(), before[whole]) == 1);
  // Far away nothing is touched.
  CHECK(write(evaluate(Operation::Union, {solid, moved(cutter, {9, 9, 9})}).mesh).substr(0, 11) == "OFF\n20 20 0");
}

TEST_CASE("polygons of a subtracted solid run the other way") {
  const SurfaceMesh hole = evaluate(Operation::Subtract, {box({-1, -1, -1}, {3, 3, 2}), read(l_shape)}).mesh;
  const Polygons polygons = find_polygons(hole);
  std::size_t hexagons = 0, quads = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    hexagons += polygons.corners_of(i).size() == 6 ? 1 : 0;
    quads += polygons.corners_of(i).size() == 4 ? 1 : 0;
  }
  CHECK(hexagons == 2);
  CHECK(quads == 6);
  CHECK(find_polygons(read(write(hole))).size() == polygons.size());
}

TEST_CASE("polygons go through what changes no corner: transform, weld, split, imprint") {
  const SurfaceMesh mesh = read(l_shape);
  const std::vector<std::size_t> counts = corner_counts(mesh);
  CHECK(corner_counts(transform(mesh, mirroring(Axis::X))) == counts);
  CHECK(write(transform(transform(mesh, mirroring(Axis::X)), mirroring(Axis::X))) == l_shape);
  CHECK(write(weld(mesh).mesh) == l_shape);
  CHECK(write(split_parts(mesh, SplitBy::Regions).front().mesh) == l_shape);
  CHECK(write(imprint(mesh, box({5, 5, 5}, {6, 6, 6})).operands[0].mesh) == l_shape);
  const SurfaceMesh beside = box({-1, 0.25, 0.25}, {0, 0.75, 0.75});  // its face divides the last quad
  std::vector<std::size_t> divided = corner_counts(imprint(mesh, beside).operands[0].mesh);
  CHECK(std::vector<std::size_t>(divided.begin(), divided.begin() + 7) == std::vector<std::size_t>{6, 6, 4, 4, 4, 4, 4});
  CHECK(std::count(divided.begin() + 7, divided.end(), 3) == static_cast<std::ptrdiff_t>(divided.size() - 7));
}

TEST_CASE("triangles whose union is no polygon stay triangles") {
  SurfaceMesh mesh = read("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  const std::vector<std::uint8_t> diagonals = mesh.diagonals;
  REQUIRE(corner_counts(mesh) == std::vector<std::size_t>{4});
  mesh.face_labels = {0, 1};
  mesh.label_names = {"a", "b"};
  CHECK(corner_counts(mesh) == std::vector<std::size_t>{3, 3});
  mesh.face_labels = {1, 1};
  CHECK(corner_counts(mesh) == std::vector<std::size_t>{4});
  mesh.walls = {0, 1};
  CHECK(corner_counts(mesh) == std::vector<std::size_t>{3, 3});
  mesh.walls.clear();
  mesh.diagonals = {7, 7};  // only one edge has a partner
  CHECK(corner_counts(mesh) == std::vector<std::size_t>{4});
  mesh.diagonals = {diagonals[0], 0};
  CHECK(corner_counts(mesh) == std::vector<std::size_t>{3, 3});
  // Round a vertex: the border does not pass through it.
  SurfaceMesh fan = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
  fan.diagonals = {5, 5, 5};
  CHECK(corner_counts(fan) == std::vector<std::size_t>{3, 3, 3});
}
