// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// OBJ: statements, labels, errors with their line, round trip.
#include "mortise/io/obj.h"

#include <algorithm>
#include <cmath>

#include "io/io_support.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/mesh/polygons.h"
#include "mortise/mesh/shapes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

void check_obj_error(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_obj", IdKind::Line, line, [&] { return read_obj(text); });
}

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// A square side of 2 x 2 quads with a uv each, and a normal that names one statement for all.
const std::string four_quads =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvt 0 0\nvt 0.1 0\nvt 0.2 0\nvt 0 0.3\nvt 0.1 0.3\nvt 0.2 0.3\nvt 5 6\n"
    "vn 0 0 1\nf 1/1/1 2/2/1 5/5/1 4/4/1\nf 2/2/1 3/3/1 6/6/1 5/7/1\n";

std::vector<std::uint64_t> value_bits(const DataChannel& channel) {
  std::vector<std::uint64_t> bits;
  for (const double x : channel.values) bits.push_back(cast_bits<std::uint64_t>(x));
  return bits;
}

}  // namespace

TEST_CASE("OBJ faces of every corner form are read, absolute and relative") {
  const SurfaceMesh mesh = read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
      "f 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -3 -2 -1\n"
      "v 0 0 5\nf -4/-1 2/1/ -1//\n");
  REQUIRE(mesh.points.size() == 4);
  REQUIRE(mesh.triangles.size() == 6);
  for (std::size_t face = 0; face < 5; ++face) CHECK(mesh.triangles[face] == triangle(0, 1, 2));
  CHECK(mesh.triangles[5] == triangle(0, 1, 3));
  CHECK(mesh.face_labels.empty());
}

TEST_CASE("OBJ statements may be continued, indented, commented and end in CRLF or CR") {
  const SurfaceMesh mesh = read_obj(
      "\xEF\xBB\xBF# made by hand \\\r\n  v 0 0 \\\r\n 0 # origin\r\nv\t1\t0\t0\rv 0 1 0 1.0 0.5 0.5 0.5\r\n\r\nf 1 \\\n2\\\n3 # last\n");
  CHECK(mesh.points == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2)});
}

TEST_CASE("OBJ statements that carry no surface are read over") {
  const SurfaceMesh mesh =
      read_obj("mtllib a b.mtl\ns off\nvp 0.5\n" + three_points + "l 1 2\np 1\ncstype bezier\ncurv 0 1 1 2 \\\n3\nf 1 2 3");
  CHECK(mesh.triangles.size() == 1);
}

TEST_CASE("A face may come before its vertices") { CHECK(read_obj("f 1 2 3\n" + three_points).triangles.size() == 1); }

TEST_CASE("The label of an OBJ face is its group, else its object, else its material") {
  const SurfaceMesh mesh = read_obj(three_points +
                                    "f 1 2 3\nusemtl steel\nf 1 2 3\no hull\nf 1 2 3\ng  deck   upper\nf 1 2 3\nusemtl wood\nf 1 2 3\n"
                                    "g\nf 1 2 3\ng deck upper\nf 1 2 3\no mast\nf 1 2 3\n");
  CHECK(face_names(mesh) == std::vector<std::string>{"", "steel", "hull", "deck upper", "deck upper", "hull", "deck upper", "mast"});
  CHECK(mesh.label_names == std::vector<std::string>{"", "steel", "hull", "deck upper", "mast"});
}

TEST_CASE("An OBJ text of comments only is an empty mesh") {
  CHECK(read_obj("# nothing\n").triangles.empty());
  CHECK(read_obj("").points.empty());
}

TEST_CASE("OBJ coordinates that are no numbers name their line") {
  check_obj_error(ErrorCode::ParseFailed, 2, "v 0 0 0\nv 1 0 x\n");
  check_obj_error(ErrorCode::ParseFailed, 1, "v 1 0\n");
  check_obj_error(ErrorCode::ParseFailed, 2, "# three lines\nv 1 \\\n2 \\\n3.1+e2\n");
  check_obj_error(ErrorCode::NotFinite, 1, "v nan 0 0\n");
  check_obj_error(ErrorCode::NotFinite, 3, "v 0 0 0\r\n\r\nv 0 -Infinity 0\r\n");
  check_obj_error(ErrorCode::OutOfRange, 1, "v 1e400 0 0\n");
  check_obj_error(ErrorCode::ParseFailed, 1, "v 0 0 \\");
}

TEST_CASE("OBJ faces with bad indices name their line") {
  check_obj_error(ErrorCode::BadIndex, 4, three_points + "f 1 2 4\n");
  check_obj_error(ErrorCode::BadIndex, 4, three_points + "f 1 2 0\n");
  check_obj_error(ErrorCode::BadIndex, 4, three_points + "f 1 2 -4\nv 9 9 9\n");
  check_obj_error(ErrorCode::BadIndex, 4, three_points + "f 1 2 99999999999\n");
  check_obj_error(ErrorCode::BadIndex, 5, three_points + "f 1 2 3\nf 1 \\\n2 7\n");
}

TEST_CASE("Malformed OBJ faces name their line") {
  for (const char* face :
       {"f", "f 1 2", "f 1 2 3x", "f 1 2 /3", "f 1 2 3/x", "f 1 2 3/1/1/1", "f 1 2 3.0", "f 1 2 nan", "f 1 2 99999999999999999999"}) {
    check_obj_error(ErrorCode::ParseFailed, 4, three_points + face + "\nf 1 2 3\n");
  }
}

TEST_CASE("A text without any OBJ statement is refused") { check_obj_error(ErrorCode::ParseFailed, 2, "\nhello world\n"); }

TEST_CASE("An OBJ round trip keeps every bit, every triangle and every label") {
  const SurfaceMesh mesh = awkward_tetrahedron();
  const SurfaceMesh back = read_obj(write_obj(mesh));
  CHECK(point_bits(back) == point_bits(mesh));
  CHECK(back.triangles == mesh.triangles);
  CHECK(back.face_labels == mesh.face_labels);
  CHECK(back.label_names == mesh.label_names);
}

TEST_CASE("Label names that OBJ cannot hold are written in a form it can") {
  SurfaceMesh mesh = awkward_tetrahedron();
  mesh.label_names = {"two\nlines\\", "tab\there"};
  CHECK(read_obj(write_obj(mesh)).label_names == std::vector<std::string>{"two lines", "tab here"});
}

TEST_CASE("OBJ texture coordinates and normals are data of corners", "[data]") {
  const SurfaceMesh mesh = read_obj(three_points +
                                    "vt 0.5 0.25 9\nvt 1\nvn 0 0 1\nvn 0 nan 1\n"
                                    "f 1/1/1 2/2/1 3/-1/-1\nf 1 2//1 3/99/\n");
  REQUIRE(mesh.corner_data.size() == 2);
  const DataChannel &uv = mesh.corner_data[0], &normal = mesh.corner_data[1];
  CHECK((uv.name == "uv" && uv.components == 2 && uv.kind == DataKind::Value));
  CHECK((normal.name == "normal" && normal.components == 3 && normal.kind == DataKind::Normal));
  CHECK(std::vector<double>(uv.values.begin(), uv.values.begin() + 6) == std::vector<double>{0.5, 0.25, 1, 0, 1, 0});
  CHECK(std::all_of(uv.values.begin() + 6, uv.values.end(), [](double x) { return std::isnan(x); }));
  CHECK(std::vector<double>(normal.values.begin(), normal.values.begin() + 7) == std::vector<double>{0, 0, 1, 0, 0, 1, 0});
  CHECK(std::isnan(normal.values[7]));
  CHECK(normal.values[14] == 1);
  CHECK(read_obj(three_points + "vt 0 0\nvn 0 0 1\nf 1 2 3\n").corner_data.empty());
}

TEST_CASE("An OBJ round trip keeps every bit of texture coordinates and normals, and polygons with them", "[data]") {
  SurfaceMesh mesh = awkward_tetrahedron();
  DataChannel uv{"uv", 2, DataKind::Value, {}};
  for (std::size_t i = 0; i < 6 * mesh.triangles.size(); ++i) uv.values.push_back(i % 5 == 4 ? -0.0 : 0.1 * static_cast<double>(i % 7));
  mesh.corner_data.push_back(uv);
  mesh.vertex_data.push_back({"normal", 3, DataKind::Normal, std::vector<double>(3 * mesh.points.size(), 0.7)});
  mesh.vertex_data.push_back({"heat", 1, DataKind::Value, std::vector<double>(mesh.points.size(), 1)});
  const SurfaceMesh back = read_obj(write_obj(mesh));
  REQUIRE(back.corner_data.size() == 2);
  CHECK(value_bits(back.corner_data[0]) == value_bits(uv));
  CHECK(back.corner_data[1].values == std::vector<double>(9 * mesh.triangles.size(), 0.7));
  CHECK(write_obj(back) == write_obj(mesh));
  const SurfaceMesh quads = read_obj(four_quads);
  CHECK(find_polygons(quads).size() == 2);
  const SurfaceMesh again = read_obj(write_obj(quads));
  CHECK(again.triangles == quads.triangles);
  CHECK(value_bits(again.corner_data[0]) == value_bits(quads.corner_data[0]));
  CHECK(value_bits(again.corner_data[1]) == value_bits(quads.corner_data[1]));
  CHECK(write_obj(quads).find("f 1/1/1 2/2/1 5/3/1 4/4/1\n") != std::string::npos);
}

TEST_CASE("A polygon whose triangles have different data at a corner is written as triangles", "[data]") {
  SurfaceMesh quads = read_obj(four_quads);
  for (std::size_t i = 0; i < 6; ++i) quads.corner_data[0].values[i] += 1;
  CHECK(find_polygons(quads).size() == 3);
}

TEST_CASE("Texture coordinates of OBJ files come through a boolean", "[data]") {
  SurfaceMesh box = make_box({0, 0, 0}, {2, 2, 2});
  box.vertex_data.push_back({"uv", 2, DataKind::Value, {}});
  for (const Vec3d& p : box.points) box.vertex_data[0].values.insert(box.vertex_data[0].values.end(), {p.x + p.z, p.y});
  const SurfaceMesh read = read_obj(write_obj(box));
  const SurfaceMesh cut = read_obj(write_obj(subtract(read, make_box({1, 1, 1}, {3, 3, 3})).mesh));
  std::size_t with_values = 0;
  for (std::size_t c = 0; c < 3 * cut.triangles.size(); ++c) {
    const Vec3d& p = cut.points[cut.triangles[c / 3][c % 3].index()];
    if (std::isnan(cut.corner_data[0].values[2 * c])) continue;
    ++with_values;
    CHECK((cut.corner_data[0].values[2 * c] == p.x + p.z && cut.corner_data[0].values[2 * c + 1] == p.y));
  }
  CHECK(with_values > 36);
}
