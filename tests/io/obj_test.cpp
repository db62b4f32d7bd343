// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// OBJ: statements, labels, errors with their line, round trip.
#include "mortise/io/obj.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

void check_obj_error(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_obj", IdKind::Line, line, [&] { return read_obj(text); });
}

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

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
