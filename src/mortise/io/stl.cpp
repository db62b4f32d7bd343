// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Stereolithography, text and binary.
#include "mortise/io/stl.h"

#include <array>
#include <cmath>
#include <limits>

#include "mortise/base/numbers.h"
#include "mortise/io/bytes.h"
#include "mortise/io/polygon_soup.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::string_view read_stage = "read_stl";
constexpr std::string_view write_stage = "write_stl";
constexpr std::size_t header_size = 80;
constexpr std::size_t preamble_size = 84;
constexpr std::size_t normal_size = 12;
constexpr std::size_t record_size = 50;
constexpr std::size_t probe_size = 1024;

// ---- Text -----------------------------------------------------------------------------------------------------------

void skip_normal(WordReader& words) {
  words.expect("normal");
  for (int i = 0; i < 3; ++i) {
    if (words.next().empty()) words.fail("the file ends inside a facet");
  }
}

void read_facet(WordReader& words, PolygonSoup& soup) {
  skip_normal(words);
  words.expect("outer");
  words.expect("loop");
  for (int corner = 0; corner < 3; ++corner) {
    words.expect("vertex");
    Vec3d point;
    for (std::size_t i = 0; i < 3; ++i) point[i] = read_coordinate(words.next(), words.place());
    soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
    soup.points.push_back(point);
  }
  words.expect("endloop");
  words.expect("endfacet");
  soup.end_face();
}

/// Reads from behind "solid" to behind "endsolid".
void read_solid(WordReader& words, LabelTable& labels, PolygonSoup& soup) {
  const std::string name = one_line_name(words.rest_of_line());
  for (;;) {
    const std::string_view word = words.next();
    if (equals_ignoring_case(word, "facet")) {
      read_facet(words, soup);
      soup.face_labels.push_back(labels.label_of(name));
    } else if (equals_ignoring_case(word, "endsolid")) {
      static_cast<void>(words.rest_of_line());
      return;
    } else {
      words.fail(word.empty() ? "the file ends before 'endsolid'" : "'facet' or 'endsolid' is expected");
    }
  }
}

SurfaceMesh read_ascii(std::string_view text) {
  WordReader words(LineReader(text, read_stage));
  LabelTable labels;
  PolygonSoup soup;
  words.expect("solid");
  for (;;) {
    read_solid(words, labels, soup);
    const std::string_view word = words.next();
    if (word.empty()) break;
    if (!equals_ignoring_case(word, "solid")) words.fail("'solid' or the end of the file is expected");
  }
  if (labels.has_names()) {
    soup.label_names = labels.names();
  } else {
    soup.face_labels.clear();
  }
  return build_mesh(std::move(soup));
}

// ---- Binary ---------------------------------------------------------------------------------------------------------

std::uint64_t size_of_triangles(std::uint32_t count) { return preamble_size + std::uint64_t{count} * record_size; }

Vec3d load_point(std::string_view bytes, std::size_t offset) {
  Vec3d point;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = offset + i * sizeof(float);
    const auto value = load_number<float>(bytes, at, ByteOrder::Little);
    if (!(std::fabs(value) <= std::numeric_limits<float>::max()))
      fail_at_byte(ErrorCode::NotFinite, read_stage, at, "a coordinate is not finite");
    point[i] = value;
  }
  return point;
}

std::uint32_t load_triangle_count(std::string_view bytes) {
  if (bytes.size() < preamble_size) {
    fail_at_byte(ErrorCode::ParseFailed, read_stage, bytes.size(), "the file is neither an STL text nor as long as a binary STL header");
  }
  const auto count = load_number<std::uint32_t>(bytes, header_size, ByteOrder::Little);
  if (size_of_triangles(count) != bytes.size()) {
    fail_at_byte(ErrorCode::ParseFailed, read_stage, header_size,
                 "the header promises " + std::to_string(count) + " triangles, which is a file of " +
                     std::to_string(size_of_triangles(count)) + " bytes, but this one has " + std::to_string(bytes.size()));
  }
  return count;
}

SurfaceMesh read_binary(std::string_view bytes) {
  const std::uint32_t count = load_triangle_count(bytes);
  PolygonSoup soup;
  soup.points.reserve(std::size_t{count} * 3);
  soup.corners.reserve(std::size_t{count} * 3);
  soup.face_ends.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t record = preamble_size + i * record_size + normal_size;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(load_point(bytes, record + corner * normal_size));
    }
    soup.end_face();
  }
  return build_mesh(std::move(soup));
}

// ---- Writing --------------------------------------------------------------------------------------------------------

using FloatVector = std::array<float, 3>;

/// Unit normal for viewers that do not compute their own; zero where a triangle has none.
FloatVector unit_normal(const SurfaceMesh& mesh, const Triangle& triangle) {
  const Vec3d& a = mesh.points[triangle[0].index()];
  const Vec3d normal = cross(mesh.points[triangle[1].index()] - a, mesh.points[triangle[2].index()] - a);
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0) || !(length <= std::numeric_limits<double>::max())) return {0, 0, 0};
  return {static_cast<float>(normal.x / length), static_cast<float>(normal.y / length), static_cast<float>(normal.z / length)};
}

std::string solid_name(const SurfaceMesh& mesh, std::size_t face) {
  return mesh.face_labels.empty() ? std::string() : one_line_name(mesh.label_names[mesh.face_labels[face]]);
}

bool starts_solid(const SurfaceMesh& mesh, std::size_t face) {
  return face == 0 || (!mesh.face_labels.empty() && mesh.face_labels[face] != mesh.face_labels[face - 1]);
}

void append_facet(std::string& text, const SurfaceMesh& mesh, const Triangle& triangle) {
  text += "facet normal";
  for (const float value : unit_normal(mesh, triangle)) text.append(" ").append(format_float(value));
  text += "\nouter loop\n";
  for (const VertexId vertex : triangle) {
    text += "vertex ";
    append_point(text, mesh.points[vertex.index()]);
    text += '\n';
  }
  text += "endloop\nendfacet\n";
}

void append_float_point(std::string& bytes, const SurfaceMesh& mesh, VertexId vertex) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = mesh.points[vertex.index()][i];
    const bool fits = std::fabs(value) < 0x1.ffffffp127;  // half a unit above the largest float
    if (!fits)
      throw Error(ErrorCode::OutOfRange, write_stage, "a coordinate does not fit a float").with_ids(IdKind::Vertices, {vertex.value});
    append_little_endian(bytes, static_cast<float>(value));
  }
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= preamble_size &&
         size_of_triangles(load_number<std::uint32_t>(bytes, header_size, ByteOrder::Little)) == bytes.size();
}

bool is_ascii_stl(std::string_view bytes) {
  WordReader words(LineReader(bytes.substr(0, probe_size), read_stage));
  if (!equals_ignoring_case(words.next(), "solid")) return false;
  static_cast<void>(words.rest_of_line());
  const std::string_view word = words.next();
  return equals_ignoring_case(word, "facet") || equals_ignoring_case(word, "endsolid");
}

SurfaceMesh read_stl(std::string_view bytes) {
  if (is_binary_stl(bytes)) return read_binary(bytes);
  WordReader words(LineReader(bytes.substr(0, probe_size), read_stage));
  return equals_ignoring_case(words.next(), "solid") && bytes.find('\0') == std::string_view::npos ? read_ascii(bytes) : read_binary(bytes);
}

std::string write_stl_ascii(const SurfaceMesh& mesh) {
  std::string text;
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    if (starts_solid(mesh, face)) {
      if (face > 0) text.append("endsolid ").append(solid_name(mesh, face - 1)).append("\n");
      text.append("solid ").append(solid_name(mesh, face)).append("\n");
    }
    append_facet(text, mesh, mesh.triangles[face]);
  }
  if (mesh.triangles.empty()) return "solid \nendsolid \n";
  return text.append("endsolid ").append(solid_name(mesh, mesh.triangles.size() - 1)).append("\n");
}

std::string write_stl_binary(const SurfaceMesh& mesh) {
  std::string bytes = "Mortise binary STL";
  bytes.resize(header_size, ' ');
  bytes.reserve(preamble_size + mesh.triangles.size() * record_size);
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    for (const float value : unit_normal(mesh, triangle)) append_little_endian(bytes, value);
    for (const VertexId vertex : triangle) append_float_point(bytes, mesh, vertex);
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace mortise
