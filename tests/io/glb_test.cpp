// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Binary glTF, taken apart: header, text, numbers. Other programs read it in scripts/check-formats.
#include "mortise/io/glb.h"

#include <algorithm>
#include <array>
#include <limits>

#include "io/io_support.h"
#include "mortise/io/bytes.h"
#include "mortise/mesh/shapes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A file in its parts.
struct Glb {
  explicit Glb(const std::string& bytes) {
    REQUIRE(bytes.substr(0, 4) == "glTF");
    REQUIRE(word(bytes, 4) == 2);
    REQUIRE(word(bytes, 8) == bytes.size());
    REQUIRE(bytes.size() % 4 == 0);
    REQUIRE(bytes.substr(16, 4) == "JSON");
    const std::size_t end_of_text = 20 + word(bytes, 12);
    text = bytes.substr(20, end_of_text - 20);
    if (end_of_text == bytes.size()) return;
    REQUIRE(bytes.substr(end_of_text + 4, 4) == std::string("BIN\0", 4));
    numbers = bytes.substr(end_of_text + 8);
    REQUIRE(word(bytes, end_of_text) == numbers.size());
  }

  static std::uint32_t word(std::string_view bytes, std::size_t at) { return load_number<std::uint32_t>(bytes, at, ByteOrder::Little); }
  [[nodiscard]] float number(std::size_t i) const { return load_number<float>(numbers, 4 * i, ByteOrder::Little); }
  [[nodiscard]] std::vector<std::uint32_t> last_words(std::size_t count) const {
    std::vector<std::uint32_t> words;
    for (std::size_t i = count; i > 0; --i) words.push_back(word(numbers, numbers.size() - 4 * i));
    return words;
  }
  [[nodiscard]] bool has(const std::string& part) const { return text.find(part) != std::string::npos; }

  std::string text, numbers;
};

/// One triangle with a value of a channel at each corner.
SurfaceMesh triangle_with(const std::string& name, std::uint32_t components, std::vector<double> values) {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.triangles = {triangle(0, 1, 2)};
  mesh.corner_data = {{name, components, DataKind::Value, std::move(values)}};
  return mesh;
}

std::vector<float> channel_of(const Glb& glb, std::size_t components) {
  std::vector<float> values;
  for (std::size_t i = 0; i < 3 * components; ++i) values.push_back(glb.number(9 + i));
  return values;
}

}  // namespace

TEST_CASE("A GLB file is its vertices as floats, then triangles in the order of their labels, one primitive and material for each") {
  const Glb glb(write_glb(float_tetrahedron()));
  REQUIRE(glb.numbers.size() == 4 * 12 + 4 * 12);
  const SurfaceMesh mesh = float_tetrahedron();
  for (std::size_t i = 0; i < 12; ++i)
    CHECK(cast_bits<std::uint32_t>(glb.number(i)) == cast_bits<std::uint32_t>(static_cast<float>(mesh.points[i / 3][i % 3])));
  CHECK(glb.last_words(12) == std::vector<std::uint32_t>{0, 2, 1, 2, 0, 3, 0, 1, 3, 1, 2, 3});
  CHECK(glb.has(
      "\"materials\":[{\"name\":\"front\",\"pbrMetallicRoughness\":{\"metallicFactor\":0},\"doubleSided\":true},{\"name\":\"back side\","));
  CHECK(
      glb.has("\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0},{\"attributes\":{\"POSITION\":0},\"indices\":"
              "2,\"material\":1}]"));
  CHECK(glb.has("\"count\":4,\"min\":[0.25,-0,-16777215],\"max\":[2,3,1]}"));
  CHECK(glb.has("{\"bufferView\":1,\"byteOffset\":24,\"componentType\":5125,\"type\":\"SCALAR\",\"count\":6}"));
  CHECK(glb.has("\"buffers\":[{\"byteLength\":96}]"));
}

TEST_CASE("A mesh without labels is one primitive in a GLB file, one without triangles an empty scene") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.face_labels.clear();
  const Glb glb(write_glb(mesh));
  CHECK(glb.has("\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0},\"doubleSided\":true}]"));
  CHECK(glb.last_words(12) == std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
  mesh.triangles.clear();
  const Glb empty(write_glb(mesh));
  CHECK(empty.text == "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Mortise\"},\"scene\":0,\"scenes\":[{}]}   ");
  CHECK(empty.numbers.empty());
}

TEST_CASE("Names in a GLB file are JSON in UTF-8, whatever the labels hold") {
  const auto text_of = [](const std::string& label) {
    SurfaceMesh mesh = float_tetrahedron();
    mesh.label_names = {label, "other"};
    const std::string text = Glb(write_glb(mesh)).text;
    const std::size_t begin = text.find("\"materials\":[{\"name\":") + 21;
    return text.substr(begin, text.find(",\"pbr") - begin);
  };
  CHECK(text_of("inlet \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x94\xA9") == "\"inlet \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x94\xA9\"");
  CHECK(text_of("a\"b\\c\nd") == "\"a\\u0022b\\u005cc\\u000ad\"");
  CHECK(text_of("l\xE4nge") == "\"l\\u00e4nge\"");
  CHECK(text_of("cut \xE2\x82") == "\"cut \\u00e2\\u0082\"");
  CHECK(text_of("\xC0\xAF\xFF") == "\"\\u00c0\\u00af\\u00ff\"");
}

TEST_CASE("Vertices without triangles are left out of a GLB file, and may be anywhere") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.points.insert(mesh.points.begin(), {1e300, 0, 0});
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = VertexId(v.value + 1);
  }
  CHECK(write_glb(mesh) == write_glb(float_tetrahedron()));
}

TEST_CASE("Coordinates too large for a float are refused by the GLB writer, naming the vertices") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.points[3].y = 1e39;
  check_error(ErrorCode::OutOfRange, "write_glb", IdKind::Vertices, 3, [&] { return write_glb(mesh); });
  mesh.points[3].y = static_cast<double>(std::numeric_limits<float>::max());
  CHECK(Glb(write_glb(mesh)).has("3.4028235e+38"));
}

TEST_CASE("Normals in a GLB file have length 1, where there is none that of the triangle") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Glb scaled(write_glb(triangle_with("normal", 3, {0, 3, 4, 1e-200, 0, 0, 0, -1e300, 0})));
  CHECK(channel_of(scaled, 3) == std::vector<float>{0, 0.6F, 0.8F, 1, 0, 0, 0, -1, 0});
  CHECK(scaled.has("\"attributes\":{\"POSITION\":0,\"NORMAL\":1}"));
  SurfaceMesh mesh = triangle_with("normal", 3, {nan, nan, nan, 0, 1, 0, 0, 0, 0});
  mesh.corner_data[0].kind = DataKind::Normal;
  CHECK(channel_of(Glb(write_glb(mesh)), 3) == std::vector<float>{0, 0, 1, 0, 1, 0, 0, 0, 1});
}

TEST_CASE("Texture coordinates in a GLB file begin at the top, colours are from 0 to 1") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Glb uv(write_glb(triangle_with("uv", 2, {0.25, 0.25, 1e300, 1, 2, nan})));
  CHECK(channel_of(uv, 2) == std::vector<float>{0.25F, 0.75F, std::numeric_limits<float>::max(), 0, 2, 1});
  CHECK(uv.has("\"TEXCOORD_0\":1"));
  const Glb color(write_glb(triangle_with("color", 4, {0, 0.5, 1, 1, -1, 2, 0, nan, 0, 0, 0, 0.25})));
  CHECK(channel_of(color, 4) == std::vector<float>{0, 0.5F, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0.25F});
  CHECK(color.has("\"COLOR_0\":1"));
  CHECK(color.has("\"VEC4\""));
}

TEST_CASE("Vertices of a GLB file are copied along seams of what it keeps, and only there") {
  SurfaceMesh cube = make_box({0, 0, 0}, {1, 1, 1});
  DataChannel per_face{"temperature", 1, DataKind::Value, {}}, uv{"uv", 2, DataKind::Value, {}};
  for (std::size_t corner = 0; corner < 36; ++corner) {
    per_face.values.push_back(static_cast<double>(corner / 6));
    uv.values.insert(uv.values.end(), {corner < 6 ? 1.0 : 0.0, 0.0});
  }
  cube.corner_data = {per_face};
  CHECK(Glb(write_glb(cube)).has("\"type\":\"VEC3\",\"count\":8,"));
  cube.corner_data = {per_face, uv};
  CHECK(Glb(write_glb(cube)).has("\"type\":\"VEC3\",\"count\":12,"));
}
