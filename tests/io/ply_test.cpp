// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// PLY: the three encodings, every type, errors with line or byte, round trips.
#include "mortise/io/ply.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/io_support.h"
#include "mortise/io/obj.h"
#include "mortise/mesh/corner_data.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const std::string header_tail =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
    "vertex_indices\nend_header\n";
const std::string ascii_header = "ply\nformat ascii 1.0\n" + header_tail;

void check_line(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_ply", IdKind::Line, line, [&] { return read_ply(text); });
}

void check_byte(ErrorCode code, std::uint32_t byte, std::string_view bytes) {
  check_error(code, "read_ply", IdKind::Byte, byte, [&] { return read_ply(bytes); });
}

template <class T>
void append(std::string& bytes, T number, bool is_big_endian) {
  auto raw = cast_bits<std::array<char, sizeof(T)>>(number);  // the machines that run this are little-endian
  if (is_big_endian) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// Vertices as T, corners as Index with a Length in front, surrounded by properties and elements that mean nothing.
template <class T, class Length, class Index>
std::string binary_file(const std::string& type, const std::string& length, const std::string& index, bool is_big_endian) {
  std::string bytes = "ply\nformat binary_" + std::string(is_big_endian ? "big" : "little") + "_endian 1.0\ncomment any\nobj_info any\n";
  bytes += "element camera 2\nproperty list ushort double rays\nelement vertex 4\nproperty uchar red\nproperty " + type + " y\nproperty " +
           type + " x\nproperty double nx\nproperty " + type + " z\nelement face 2\nproperty short id\nproperty list " + length + " " +
           index + " vertex_index\nproperty list uchar float uv\nend_header\n";
  for (const std::uint16_t rays : {std::uint16_t{0}, std::uint16_t{2}}) {
    append(bytes, rays, is_big_endian);
    for (int i = 0; i < rays; ++i) append(bytes, 1.5, is_big_endian);
  }
  for (const std::array<int, 3> p : {std::array{0, 0, 0}, std::array{10, 0, 1}, std::array{10, 10, 1}, std::array{0, 10, 1}}) {
    bytes += '\xff';
    append(bytes, static_cast<T>(p[1]), is_big_endian);
    append(bytes, static_cast<T>(p[0]), is_big_endian);
    append(bytes, 0.25, is_big_endian);
    append(bytes, static_cast<T>(p[2]), is_big_endian);
  }
  for (const std::array<int, 3> corners : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    append(bytes, std::int16_t{-1}, is_big_endian);
    append(bytes, Length{3}, is_big_endian);
    for (const int corner : corners) append(bytes, static_cast<Index>(corner), is_big_endian);
    append(bytes, std::uint8_t{1}, is_big_endian);
    append(bytes, 0.5F, is_big_endian);
  }
  return bytes;
}

template <class T, class Length, class Index>
void check_binary_file(const std::string& type, const std::string& length, const std::string& index) {
  for (const bool is_big_endian : {false, true}) {
    CAPTURE(type, length, index, is_big_endian);
    const SurfaceMesh mesh = read_ply(binary_file<T, Length, Index>(type, length, index, is_big_endian));
    CHECK(mesh.points == std::vector<Vec3d>{{0, 0, 0}, {10, 0, 1}, {10, 10, 1}, {0, 10, 1}});
    CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2), triangle(0, 2, 3)});
  }
}

}  // namespace

TEST_CASE("A PLY text is read, other properties and elements over-read") {
  const SurfaceMesh mesh = read_ply(
      "ply\r\nformat ascii 1.0\r\ncomment any thing\r\nelement edge 1\r\nproperty int a\r\nproperty list uchar int b\r\nelement vertex "
      "3\r\n"
      "property double z\r\nproperty float32 x\r\nproperty uchar red\r\nproperty float y\r\nelement face 2\r\nproperty list uint8 uint32 "
      "vertex_index\r\n"
      "property float quality\r\nend_header\r\n"
      "7 2 1 1\r\n0 0 255 0\r\n\r\n0.1 1 nan 0\r\n0 0 x 1\r\n3 0 1 2 0.5\r\n3 2 1 0 nan\r\n");
  CHECK(mesh.points == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0}});
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2), triangle(2, 1, 0)});
}

TEST_CASE("Binary PLY files of every type and both byte orders are read") {
  check_binary_file<std::int8_t, std::uint8_t, std::int8_t>("char", "uchar", "int8");
  check_binary_file<std::uint8_t, std::int8_t, std::uint8_t>("uint8", "int8", "uchar");
  check_binary_file<std::int16_t, std::uint16_t, std::int16_t>("short", "uint16", "int16");
  check_binary_file<std::uint16_t, std::int16_t, std::uint16_t>("ushort", "short", "ushort");
  check_binary_file<std::int32_t, std::uint32_t, std::int32_t>("int32", "uint", "int");
  check_binary_file<std::uint32_t, std::int32_t, std::uint32_t>("uint", "int32", "uint32");
  check_binary_file<float, std::uint8_t, std::int32_t>("float", "uchar", "int");
  check_binary_file<double, std::uint8_t, std::uint32_t>("float64", "uint8", "uint");
}

TEST_CASE("A PLY header with lone CR ends where its CR is, whatever byte follows") {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
  std::replace(bytes.begin(), bytes.end(), '\n', '\r');
  CHECK(read_ply(bytes + "\x0a\x0b\x0c").points == std::vector<Vec3d>{{10, 11, 12}});
}

TEST_CASE("A PLY file without faces is a mesh of points") {
  CHECK(read_ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n")
            .points.size() == 1);
  CHECK(read_ply("ply\nformat ascii 1.0\nend_header\n").points.empty());
}

TEST_CASE("Bad PLY headers name their line") {
  check_line(ErrorCode::ParseFailed, 1, "");
  check_line(ErrorCode::ParseFailed, 1, "plyx\n");
  check_line(ErrorCode::ParseFailed, 2, "ply\nformat ascii 1.0\n");
  check_line(ErrorCode::ParseFailed, 2, "ply\nformat binary_middle_endian 1.0\nend_header\n");
  check_line(ErrorCode::ParseFailed, 2, "ply\nend_header\n");
  check_line(ErrorCode::ParseFailed, 2, "ply\nproperty float x\nend_header\n");
  check_line(ErrorCode::ParseFailed, 3, "ply\nformat ascii 1.0\nelement vertex many\nend_header\n");
  check_line(ErrorCode::ParseFailed, 3, "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n");
  check_line(ErrorCode::ParseFailed, 4, "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n");
  check_line(ErrorCode::ParseFailed, 4, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float\nend_header\n");
  check_line(ErrorCode::ParseFailed, 4, "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_index\nend_header\n");
  check_line(ErrorCode::ParseFailed, 3, "ply\nformat ascii 1.0\nbanana\nend_header\n");
}

TEST_CASE("PLY elements that cannot make a mesh are refused at the end of the header") {
  check_line(ErrorCode::ParseFailed, 5, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n");
  check_line(ErrorCode::ParseFailed, 5, "ply\nformat ascii 1.0\nelement face 1\nproperty float q\nend_header\n1\n");
  check_line(ErrorCode::ParseFailed, 5,
             "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar float vertex_index\nend_header\n3 0 1 2\n");
  check_line(ErrorCode::ParseFailed, 5,
             "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n3 0 1 2\n");
  check_line(ErrorCode::ParseFailed, 5, "ply\nformat ascii 1.0\nelement edge 1\nelement edge 1\nend_header\n");
}

TEST_CASE("Bad PLY text rows name their line") {
  check_line(ErrorCode::ParseFailed, 10, ascii_header + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  check_line(ErrorCode::ParseFailed, 11, ascii_header + "0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n");
  check_line(ErrorCode::NotFinite, 11, ascii_header + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n");
  check_line(ErrorCode::OutOfRange, 10, ascii_header + "0 0 1e999\n1 0 0\n0 1 0\n3 0 1 2\n");
  check_line(ErrorCode::ParseFailed, 10, ascii_header + "0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  check_line(ErrorCode::BadIndex, 13, ascii_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  check_line(ErrorCode::BadIndex, 13, ascii_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n");
  check_line(ErrorCode::ParseFailed, 13, ascii_header + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n");
  check_line(ErrorCode::ParseFailed, 13, ascii_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n");
  check_line(ErrorCode::ParseFailed, 13, ascii_header + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n");
  check_line(ErrorCode::ParseFailed, 12, ascii_header + "0 0 0\n1 0 0\n0 1 0\n");
}

TEST_CASE("PLY counts that the file does not hold are an error, not an allocation") {
  const std::string columns = "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  check_line(ErrorCode::ParseFailed, 8, "ply\nformat ascii 1.0\nelement vertex 4294967294" + columns + "0 0 0\n");
  const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 4294967294" + columns + std::string(13, '\0');
  check_byte(ErrorCode::ParseFailed, static_cast<std::uint32_t>(binary.size()), binary);
  const std::string nothing = "ply\nformat binary_little_endian 1.0\nelement nothing 4294967294\nend_header\n";
  CHECK(read_ply(nothing).points.empty());
}

TEST_CASE("Bad binary PLY rows name their byte") {
  const std::string header = "ply\nformat binary_little_endian 1.0\n" + header_tail;
  const auto at = static_cast<std::uint32_t>(header.size());
  std::string vertices(36, '\0');
  const std::string face("\x03\0\0\0\0\x01\0\0\0\x02\0\0\0", 13);
  CHECK(read_ply(header + vertices + face).triangles.size() == 1);

  check_byte(ErrorCode::ParseFailed, at + 48, header + vertices + face.substr(0, 12));
  check_byte(ErrorCode::ParseFailed, at + 35, header + vertices.substr(0, 35));
  check_byte(ErrorCode::ParseFailed, at + 36, header + vertices + std::string("\x02\0\0\0\0\x01\0\0\0", 9));
  check_byte(ErrorCode::BadIndex, at + 41, header + vertices + std::string("\x03\0\0\0\0\x03\0\0\0\x02\0\0\0", 13));
  check_byte(ErrorCode::BadIndex, at + 37, header + vertices + std::string("\x03\xff\xff\xff\xff\x01\0\0\0\x02\0\0\0", 13));
  vertices.replace(16, 4, std::string("\0\0\xc0\x7f", 4));
  check_byte(ErrorCode::NotFinite, at + 16, header + vertices + face);

  const std::string signed_length =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list char int other\nproperty list char int "
      "vertex_indices\nend_header\n";
  check_byte(ErrorCode::ParseFailed, static_cast<std::uint32_t>(signed_length.size()), signed_length + "\xff");
}

TEST_CASE("A PLY round trip keeps every bit and every triangle, as text and binary") {
  const SurfaceMesh mesh = awkward_tetrahedron();
  for (const std::string& bytes : {write_ply_ascii(mesh), write_ply_binary(mesh)}) {
    const SurfaceMesh back = read_ply(bytes);
    CHECK(point_bits(back) == point_bits(mesh));
    CHECK(back.triangles == mesh.triangles);
  }
  CHECK(is_ascii_ply(write_ply_ascii(mesh)));
  CHECK_FALSE(is_ascii_ply(write_ply_binary(mesh)));
}

TEST_CASE("PLY keeps walls, in text and binary") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.walls = {0, 1, 0, 1};
  CHECK(read_ply(write_ply_ascii(mesh)).walls == mesh.walls);
  CHECK(read_ply(write_ply_binary(mesh)).walls == mesh.walls);
  CHECK(read_ply(write_ply_binary(float_tetrahedron())).walls.empty());
  const std::string polygon =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property int wall\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
      "7 4 0 1 2 3\n0 3 0 1 2\n";
  CHECK(read_ply(polygon).walls == std::vector<std::uint8_t>{1, 1, 0});
}

TEST_CASE("PLY numbers of vertices are data: normals, texture coordinates, colours and others by name", "[data]") {
  const SurfaceMesh mesh = read_ply(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty uchar green\nproperty float y\nproperty float z\n"
      "property uchar blue\nproperty uchar red\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float v\nproperty float "
      "u\n"
      "property double heat\nproperty list uchar int ring\nproperty float texture_u\nelement face 1\nproperty list uchar int "
      "vertex_indices\n"
      "end_header\n"
      "0 51 0 0 255 0 0 0 1 0.25 0.5 20 2 7 8 -1\n1 0 0 0 0 0 0 0 1 0 1 nan 0 -2\n0 0 1 0 0 102 0 1 0 0 0 1e999 1 5 -3\n3 0 1 2\n");
  std::vector<std::string> names;
  for (const DataChannel& c : mesh.corner_data) names.push_back(c.name);
  REQUIRE(names == std::vector<std::string>{"normal", "uv", "color", "heat", "texture_u"});
  CHECK(mesh.corner_data[0].kind == DataKind::Normal);
  CHECK(mesh.corner_data[0].values == std::vector<double>{0, 0, 1, 0, 0, 1, 0, 1, 0});
  CHECK(mesh.corner_data[1].values == std::vector<double>{0.5, 0.25, 1, 0, 0, 0});
  CHECK(mesh.corner_data[2].values == std::vector<double>{0, 0.2, 1, 0, 0, 0, 0.4, 0, 0});
  CHECK(mesh.corner_data[3].values[0] == 20);
  CHECK((std::isnan(mesh.corner_data[3].values[1]) && std::isnan(mesh.corner_data[3].values[2])));
  CHECK(mesh.corner_data[4].values == std::vector<double>{-1, -2, -3});
}

TEST_CASE("A PLY round trip keeps data, seams and missing values; colours to a byte", "[data]") {
  SurfaceMesh mesh =
      read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.3 0.4\nvt 0.5 0.6\nvt 7 8\nf 1/1 2/2 3/3 4/4\nf 3/2 2/2 4\n");
  mesh.vertex_data.push_back({"heat", 1, DataKind::Value, {0.1, 0.2, std::numeric_limits<double>::quiet_NaN(), 0.7}});
  mesh.vertex_data.push_back({"color", 3, DataKind::Value, {1, 0, 0.5, 0.2, 0.4, 0.6, 0, 0, 0, 2, -1, 1}});
  mesh.vertex_data.push_back({"normal", 3, DataKind::Normal, std::vector<double>(12, 0.7)});
  mesh.vertex_data.push_back({"speed", 2, DataKind::Value, {1, 2, 3, 4, 5, 6, 7, 8}});
  mesh.vertex_data.push_back({"no word", 1, DataKind::Value, {1, 2, 3, 4}});
  for (const std::string& file : {write_ply_ascii(mesh), write_ply_binary(mesh)}) {
    const SurfaceMesh back = read_ply(file);
    CHECK(back.points == mesh.points);
    CHECK(back.triangles == mesh.triangles);
    const auto bits_of = [](const DataChannel& c) {
      std::vector<std::uint64_t> bits;
      for (const double x : c.values) bits.push_back(cast_bits<std::uint64_t>(x));
      return bits;
    };
    const auto find = [&](const SurfaceMesh& m, const std::string& name) {
      for (DataChannel& c : all_as_corner_data(m)) {
        if (c.name == name) return c;
      }
      return DataChannel{};
    };
    for (const char* name : {"uv", "heat", "normal"}) {
      CAPTURE(name);
      CHECK(bits_of(find(back, name)) == bits_of(find(mesh, name)));
    }
    const std::vector<double> speeds = find(mesh, "speed").values;
    for (std::size_t i = 0; i < 9; ++i) CHECK(find(back, "speed_1").values[i] == speeds[2 * i + 1]);
    CHECK(find(back, "no word").values.empty());
    const std::vector<double> color = find(back, "color").values;
    REQUIRE(color.size() == 27);
    for (std::size_t i = 0; i < 27; ++i) CHECK(std::abs(color[i] - std::clamp(find(mesh, "color").values[i], 0.0, 1.0)) <= 0.5 / 255);
  }
}

TEST_CASE("A PLY row without its data is cut off, not read", "[data]") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty float heat\nend_header\n";
  check_line(ErrorCode::ParseFailed, 9, header + "0 0 0\n");
  CHECK(read_ply(header + "0 0 0 cold\n").points.size() == 1);
}

TEST_CASE("PLY files keep labels as numbers of faces and their names as comments") {
  SurfaceMesh mesh = awkward_tetrahedron();
  mesh.label_names = {"", "back side", "50% unused"};
  const std::string text = write_ply_ascii(mesh);
  CHECK(text.find("comment label 0 \ncomment label 1 back side\ncomment label 2 50% unused\n") != std::string::npos);
  for (const std::string& bytes : {text, write_ply_binary(mesh)}) {
    const SurfaceMesh back = read_ply(bytes);
    CHECK(back.face_labels == mesh.face_labels);
    CHECK(back.label_names == mesh.label_names);
  }
}

TEST_CASE("PLY labels without names mean nothing, and those beyond the names are refused with their line or byte") {
  const std::string rest =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property int label\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  CHECK(read_ply("ply\nformat ascii 1.0\ncomment label 1 late\n" + rest + "7\n").face_labels.empty());
  check_line(ErrorCode::ParseFailed, 15, "ply\nformat ascii 1.0\ncomment label 0 a\n" + rest + "1\n");
  check_line(ErrorCode::ParseFailed, 15, "ply\nformat ascii 1.0\ncomment label 0 a\n" + rest + "-1\n");
  std::string bytes = write_ply_binary(awkward_tetrahedron());
  bytes[bytes.size() - 4] = 2;
  check_byte(ErrorCode::ParseFailed, static_cast<std::uint32_t>(bytes.size() - 4), bytes);
}
