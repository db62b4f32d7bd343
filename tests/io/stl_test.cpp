// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// STL: text and binary, solids as labels, errors with line or byte, round trips.
#include "mortise/io/stl.h"

#include <limits>

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const std::string one_facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

void check_line(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_stl", IdKind::Line, line, [&] { return read_stl(text); });
}

void check_byte(ErrorCode code, std::uint32_t byte, std::string_view bytes) {
  check_error(code, "read_stl", IdKind::Byte, byte, [&] { return read_stl(bytes); });
}

/// A binary file of one triangle whose header begins with `header`.
std::string one_triangle(const std::string& header) {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {triangle(0, 1, 2)};
  return write_stl_binary(mesh).replace(0, header.size(), header);
}

}  // namespace

TEST_CASE("An STL text is read whatever its case, spacing and line ends") {
  const SurfaceMesh plain = read_stl("solid\n" + one_facet + "endsolid\n");
  CHECK(plain.points == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(plain.triangles == std::vector<Triangle>{triangle(0, 1, 2)});
  CHECK(plain.face_labels.empty());
  const SurfaceMesh odd = read_stl(
      "\r\n  SOLID \r\n FACET NORMAL nan nan -1.#IND\r\n\tOuter  Loop\rVERTEX 0 0 0 VERTEX 1 0 0\n\nVERTEX 0 1 0 ENDLOOP "
      "ENDFACET\r\nENDSOLID whatever");
  CHECK(point_bits(odd) == point_bits(plain));
  CHECK(odd.triangles == plain.triangles);
}

TEST_CASE("Named solids become labels, solids of one name one label, empty solids none") {
  const SurfaceMesh mesh =
      read_stl("solid inlet pipe \n" + one_facet + one_facet + "endsolid inlet pipe\nsolid empty\nendsolid empty\nsolid wall\n" +
               one_facet + "endsolid wall\nsolid inlet  pipe\n" + one_facet + "endsolid\n");
  CHECK(mesh.label_names == std::vector<std::string>{"inlet pipe", "wall"});
  CHECK(mesh.face_labels == std::vector<std::uint32_t>{0, 0, 1, 0});
  CHECK(mesh.points.size() == 3);
}

TEST_CASE("An STL of empty solids is an empty mesh") {
  CHECK(read_stl("solid a\nendsolid a\n").triangles.empty());
  CHECK(read_stl(write_stl_ascii({})).triangles.empty());
  CHECK(read_stl(write_stl_binary({})).triangles.empty());
}

TEST_CASE("A binary STL is known by its length even when it begins with the word solid") {
  const std::string bytes = one_triangle("solid by an exporter");
  CHECK(is_binary_stl(bytes));
  CHECK_FALSE(is_ascii_stl(bytes));
  CHECK(read_stl(bytes).triangles.size() == 1);
}

TEST_CASE("Attribute bytes of a binary STL are read over") {
  std::string bytes = one_triangle("COLOR=");
  bytes[84 + 48] = '\x1f';
  bytes[84 + 49] = '\x80';
  CHECK(read_stl(bytes).triangles.size() == 1);
}

TEST_CASE("Malformed STL texts name their line") {
  check_line(ErrorCode::ParseFailed, 2, "solid a\nfacet 0 0 1\n");
  check_line(ErrorCode::ParseFailed, 3, "solid a\nfacet normal 0 0 1\nloop\n");
  check_line(ErrorCode::ParseFailed, 4, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n");
  check_line(ErrorCode::NotFinite, 4, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n");
  check_line(ErrorCode::NotFinite, 4, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 -1.#INF\n");
  check_line(ErrorCode::OutOfRange, 4, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e999\n");
  check_line(ErrorCode::ParseFailed, 7,
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\nendloop\n");
  check_line(ErrorCode::ParseFailed, 6, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n");
  check_line(ErrorCode::ParseFailed, 9, "solid a\n" + one_facet + "facets\n");
  check_line(ErrorCode::ParseFailed, 10, "solid a\n" + one_facet + "endsolid a\nfacet normal 0 0 1\n");
}

TEST_CASE("Truncated STL texts name their last line") {
  check_line(ErrorCode::ParseFailed, 8, "solid a\n" + one_facet);
  check_line(ErrorCode::ParseFailed, 4, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0");
  check_line(ErrorCode::ParseFailed, 2, "solid a\nfacet normal 0");
  check_line(ErrorCode::ParseFailed, 1, "solid a");
}

TEST_CASE("A binary STL whose length and count disagree names the count, one without a count its end") {
  const std::string bytes = one_triangle("binary");
  check_byte(ErrorCode::ParseFailed, 80, bytes.substr(0, 100));
  check_byte(ErrorCode::ParseFailed, 80, bytes + "x");
  check_byte(ErrorCode::ParseFailed, 83, bytes.substr(0, 83));
  check_byte(ErrorCode::ParseFailed, 0, "");
  std::string absurd = bytes;
  absurd.replace(80, 4, "\xff\xff\xff\xff");
  check_byte(ErrorCode::ParseFailed, 80, absurd);
}

TEST_CASE("A coordinate of a binary STL that is not finite names its byte") {
  for (const char* value : {"\x00\x00\xc0\x7f", "\x00\x00\x80\x7f", "\x00\x00\x80\xff"}) {
    check_byte(ErrorCode::NotFinite, 84 + 12 + 12 + 4, one_triangle("").replace(84 + 12 + 12 + 4, 4, std::string(value, 4)));
  }
  const std::string nan_normal = one_triangle("").replace(84, 4, std::string("\x00\x00\xc0\x7f", 4));
  CHECK(read_stl(nan_normal).triangles.size() == 1);
}

TEST_CASE("An STL text round trip keeps every corner bit for bit, and the labels") {
  const SurfaceMesh mesh = awkward_tetrahedron();
  const SurfaceMesh back = read_stl(write_stl_ascii(mesh));
  CHECK(corner_bits(back) == corner_bits(mesh));
  CHECK(face_names(back) == face_names(mesh));
  SurfaceMesh unlabelled = mesh;
  unlabelled.face_labels.clear();
  CHECK(read_stl(write_stl_ascii(unlabelled)).label_names.empty());
}

TEST_CASE("A binary STL round trip keeps every corner that floats hold bit for bit") {
  const SurfaceMesh mesh = float_tetrahedron();
  const std::string bytes = write_stl_binary(mesh);
  CHECK(bytes.size() == 84 + 4 * 50);
  CHECK(corner_bits(read_stl(bytes)) == corner_bits(mesh));
}

TEST_CASE("A binary STL rounds coordinates to the nearest float") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.points[1].x = 0.1;
  CHECK(read_stl(write_stl_binary(mesh)).points[2].x == static_cast<double>(0.1F));
}

TEST_CASE("A coordinate too large for a float is refused by the binary STL writer, naming the vertex") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.points[3].y = 1e39;
  check_error(ErrorCode::OutOfRange, "write_stl", IdKind::Vertices, 3, [&] { return write_stl_binary(mesh); });
  mesh.points[3].y = static_cast<double>(std::numeric_limits<float>::max());
  CHECK_NOTHROW(write_stl_binary(mesh));
}

TEST_CASE("Normals written to STL are unit length, and zero for triangles without area") {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 4, 0}, {0, 0, 2}, {0, 8, 0}};
  mesh.triangles = {triangle(0, 1, 2), triangle(0, 1, 3)};
  const std::string text = write_stl_ascii(mesh);
  CHECK(text.find("facet normal 1 0 0\n") != std::string::npos);
  CHECK(text.find("facet normal 0 0 0\n") != std::string::npos);
}
