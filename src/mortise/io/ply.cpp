// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Polygon File Format, text and binary.
#include "mortise/io/ply.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/base/numbers.h"
#include "mortise/io/bytes.h"
#include "mortise/io/ply_data.h"
#include "mortise/io/ply_header.h"
#include "mortise/io/polygon_soup.h"
#include "mortise/io/text.h"
#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/corners_to_vertices.h"
#include "mortise/mesh/polygons.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_ply";

/// What a column means to a mesh.
enum class Role : unsigned char { None, X, Y, Z, Corners, Wall, Label, Data };

Role role_of(const PlyElement& element, const PlyProperty& property) {
  const std::string& name = property.name;
  if (element.name == "vertex" && !property.is_list)
    return name == "x" ? Role::X : name == "y" ? Role::Y : name == "z" ? Role::Z : Role::None;
  const bool is_number_of_face = element.name == "face" && !property.is_list && is_ply_integer(property.type);
  if (is_number_of_face && (name == "wall" || name == "label")) return name == "wall" ? Role::Wall : Role::Label;
  if (element.name == "face" && property.is_list && (name == "vertex_indices" || name == "vertex_index")) return Role::Corners;
  return Role::None;
}

/// One element with the meaning of its columns.
struct Table {
  const PlyElement* element;
  std::vector<Role> roles;
  PlyVertexData data{};  ///< of the vertices

  [[nodiscard]] bool has(Role role) const {
    for (const Role present : roles) {
      if (present == role) return true;
    }
    return false;
  }
};

Table make_table(const PlyElement& element, const TextPlace& header_end) {
  Table table{&element, {}};
  for (const PlyProperty& property : element.properties) {
    const Role role = role_of(element, property);
    table.roles.push_back(table.has(role) ? Role::None : role);
    if (table.roles.back() == Role::Corners && !is_ply_integer(property.type)) {
      fail_at_line(ErrorCode::ParseFailed, header_end, "the corners of faces must be integers");
    }
  }
  const bool has_point = table.has(Role::X) && table.has(Role::Y) && table.has(Role::Z);
  if (element.name == "vertex" && !has_point) fail_at_line(ErrorCode::ParseFailed, header_end, "the vertices have no x, y and z");
  if (element.name == "face" && element.count > 0 && !table.has(Role::Corners)) {
    fail_at_line(ErrorCode::ParseFailed, header_end, "the faces have no list vertex_indices");
  }
  if (has_point) {
    table.data = read_vertex_columns(element);
    for (std::size_t i = 0; i < table.roles.size(); ++i) {
      if (table.data.targets[i].channel != PlyTarget::none) table.roles[i] = Role::Data;
    }
  }
  if (element.name == "tristrips") fail_at_line(ErrorCode::ParseFailed, header_end, "triangle strips are not read");
  return table;
}

std::vector<Table> make_tables(const PlyHeader& header) {
  const TextPlace header_end{stage_name, header.line_count};
  std::vector<Table> tables;
  for (const PlyElement& element : header.elements) {
    for (const Table& earlier : tables) {
      if (earlier.element->name == element.name) fail_at_line(ErrorCode::ParseFailed, header_end, "two elements have the same name");
    }
    tables.push_back(make_table(element, header_end));
  }
  return tables;
}

std::uint32_t vertex_count(const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") return element.count;
  }
  return 0;
}

std::string bad_index_message(std::int64_t index, std::uint32_t vertices) {
  return "the face names vertex " + std::to_string(index) + " of " + std::to_string(vertices) + " (the first is 0)";
}

bool is_label(std::int64_t label, const PolygonSoup& soup) {
  return label >= 0 && static_cast<std::uint64_t>(label) < soup.label_names.size();
}

std::string bad_label_message(std::int64_t label, const PolygonSoup& soup) {
  return "the face has label " + std::to_string(label) + " of " + std::to_string(soup.label_names.size()) + " (the first is 0)";
}

/// Appends a value to its channel, in the order of the components: columns that come in another order wait for one another.
void set_value(const PlyTarget& target, double value, PolygonSoup& soup) {
  DataChannel& channel = soup.point_data[target.channel];
  const std::size_t place = soup.points.size() * channel.components + target.component;
  channel.values.resize(std::max(channel.values.size(), (soup.points.size() + 1) * channel.components), no_value);
  const bool is_finite = std::fabs(value) <= std::numeric_limits<double>::max();
  channel.values[place] = is_finite ? value / target.whole : no_value;
}

constexpr std::string_view too_few_corners = "a face needs at least three corners";

// ---- Text rows ------------------------------------------------------------------------------------------------------

class TextRows {
 public:
  TextRows(std::string_view rows, const PlyHeader& header)
      : lines_(rows, stage_name), header_lines_(header.line_count), vertices_(vertex_count(header)) {}

  void read_row(const Table& table, PolygonSoup& soup) {
    if (!next_row()) fail_at_line(ErrorCode::ParseFailed, place(), "the file ends before its last element");
    rest_ = lines_.line();
    Vec3d point;
    for (std::size_t i = 0; i < table.roles.size(); ++i) {
      if (table.roles[i] == Role::Data) {
        set_value(table.data.targets[i], read_value(), soup);
      } else {
        read_property(table.element->properties[i], table.roles[i], point, soup);
      }
    }
    if (!trim(rest_).empty()) fail_at_line(ErrorCode::ParseFailed, place(), "the line holds more than the header promises");
    if (table.has(Role::X)) soup.points.push_back(point);
  }

 private:
  void read_label(PolygonSoup& soup) {
    const std::int64_t label = read_integer(take_word(rest_), place(), "a label");
    if (!is_label(label, soup)) fail_at_line(ErrorCode::ParseFailed, place(), bad_label_message(label, soup));
    soup.face_labels.push_back(static_cast<std::uint32_t>(label));
  }

  bool next_row() {
    while (lines_.next()) {
      if (!trim(lines_.line()).empty()) return true;
    }
    return false;
  }

  [[nodiscard]] TextPlace place() const { return {stage_name, header_lines_ + lines_.place().line}; }

  double read_value() {
    const std::string_view word = take_word(rest_);
    if (word.empty()) fail_at_line(ErrorCode::ParseFailed, place(), "the line holds less than the header promises");
    return value_of_word(word);
  }

  void read_property(const PlyProperty& property, Role role, Vec3d& point, PolygonSoup& soup) {
    if (role == Role::Corners) return read_corners(soup);
    if (role == Role::Wall) return soup.walls.push_back(read_integer(take_word(rest_), place(), "the mark of a wall") != 0 ? 1 : 0);
    if (role == Role::Label && !soup.label_names.empty()) return read_label(soup);
    if (role != Role::None && role != Role::Label) {
      point[static_cast<std::size_t>(role) - static_cast<std::size_t>(Role::X)] = read_coordinate(take_word(rest_), place());
      return;
    }
    const std::uint32_t words = property.is_list ? read_count(take_word(rest_), place(), "the length of a list") : 1;
    for (std::uint32_t i = 0; i < words; ++i) {
      if (take_word(rest_).empty()) fail_at_line(ErrorCode::ParseFailed, place(), "the line holds less than the header promises");
    }
  }

  void read_corners(PolygonSoup& soup) {
    const std::uint32_t count = read_count(take_word(rest_), place(), "the number of corners");
    if (count < 3) fail_at_line(ErrorCode::ParseFailed, place(), std::string(too_few_corners));
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::int64_t index = read_integer(take_word(rest_), place(), "a vertex index");
      if (index < 0 || index >= vertices_) fail_at_line(ErrorCode::BadIndex, place(), bad_index_message(index, vertices_));
      soup.corners.push_back(static_cast<std::uint32_t>(index));
    }
    soup.end_face();
  }

  LineReader lines_;
  std::uint32_t header_lines_;
  std::uint32_t vertices_;
  std::string_view rest_;
};

// ---- Binary rows ----------------------------------------------------------------------------------------------------

class BinaryRows {
 public:
  BinaryRows(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes),
        offset_(header.size),
        vertices_(vertex_count(header)),
        order_(header.encoding == PlyEncoding::BigEndian ? ByteOrder::Big : ByteOrder::Little) {}

  void read_row(const Table& table, PolygonSoup& soup) {
    Vec3d point;
    for (std::size_t i = 0; i < table.roles.size(); ++i) {
      const PlyProperty& property = table.element->properties[i];
      if (table.roles[i] == Role::Data) {
        set_value(table.data.targets[i], take_value(property.type), soup);
      } else {
        read_property(property, table.roles[i], point, soup);
      }
    }
    if (table.has(Role::X)) soup.points.push_back(point);
  }

 private:
  void read_property(const PlyProperty& property, Role role, Vec3d& point, PolygonSoup& soup) {
    if (role == Role::Corners) return read_corners(property, soup);
    if (role == Role::Wall) return soup.walls.push_back(take_integer(property.type) != 0 ? 1 : 0);
    if (role == Role::Label && !soup.label_names.empty()) return read_label(property, soup);
    if (role != Role::None && role != Role::Label) {
      const std::size_t at = offset_;
      const double value = take_value(property.type);
      if (!(std::fabs(value) <= std::numeric_limits<double>::max()))
        fail_at_byte(ErrorCode::NotFinite, stage_name, at, "a coordinate is not finite");
      point[static_cast<std::size_t>(role) - static_cast<std::size_t>(Role::X)] = value;
      return;
    }
    const std::uint64_t items = property.is_list ? take_length(property.count_type) : 1;
    skip(items * ply_type_size(property.type));
  }

  void read_label(const PlyProperty& property, PolygonSoup& soup) {
    const std::size_t at = offset_;
    const std::int64_t label = take_integer(property.type);
    if (!is_label(label, soup)) fail_at_byte(ErrorCode::ParseFailed, stage_name, at, bad_label_message(label, soup));
    soup.face_labels.push_back(static_cast<std::uint32_t>(label));
  }

  void read_corners(const PlyProperty& property, PolygonSoup& soup) {
    const std::size_t start = offset_;
    const std::uint64_t count = take_length(property.count_type);
    if (count < 3) fail_at_byte(ErrorCode::ParseFailed, stage_name, start, std::string(too_few_corners));
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::size_t at = offset_;
      const std::int64_t index = take_integer(property.type);
      if (index < 0 || index >= vertices_) fail_at_byte(ErrorCode::BadIndex, stage_name, at, bad_index_message(index, vertices_));
      soup.corners.push_back(static_cast<std::uint32_t>(index));
    }
    soup.end_face();
  }

  void skip(std::uint64_t size) {
    if (size > bytes_.size() - offset_)
      fail_at_byte(ErrorCode::ParseFailed, stage_name, bytes_.size(), "the file ends before its last element");
    offset_ += static_cast<std::size_t>(size);
  }

  template <class T>
  T take() {
    const std::size_t at = offset_;
    skip(sizeof(T));
    return load_number<T>(bytes_, at, order_);
  }

  std::int64_t take_integer(PlyType type) {
    switch (type) {
      case PlyType::Int8:
        return take<std::int8_t>();
      case PlyType::Uint8:
        return take<std::uint8_t>();
      case PlyType::Int16:
        return take<std::int16_t>();
      case PlyType::Uint16:
        return take<std::uint16_t>();
      case PlyType::Int32:
        return take<std::int32_t>();
      default:
        return take<std::uint32_t>();
    }
  }

  double take_value(PlyType type) {
    if (type == PlyType::Float32) return take<float>();
    if (type == PlyType::Float64) return take<double>();
    return static_cast<double>(take_integer(type));
  }

  std::uint64_t take_length(PlyType type) {
    const std::size_t at = offset_;
    const std::int64_t length = take_integer(type);
    if (length < 0) fail_at_byte(ErrorCode::ParseFailed, stage_name, at, "the length of a list is negative");
    return static_cast<std::uint64_t>(length);
  }

  std::string_view bytes_;
  std::size_t offset_;
  std::uint32_t vertices_;
  ByteOrder order_;
};

template <class Rows>
PolygonSoup read_rows(Rows rows, const PlyHeader& header, const std::vector<Table>& tables, std::size_t byte_count) {
  PolygonSoup soup;
  soup.label_names = header.label_names;
  for (const Table& table : tables) {
    if (table.has(Role::X)) soup.point_data = table.data.channels;
    if (table.has(Role::X)) soup.points.reserve(believable_count(table.element->count, byte_count, 3));
    if (table.has(Role::Corners)) soup.face_ends.reserve(believable_count(table.element->count, byte_count, 4));
    if (table.roles.empty()) continue;
    for (std::uint32_t i = 0; i < table.element->count; ++i) rows.read_row(table, soup);
  }
  if (soup.face_labels.empty()) soup.label_names.clear();
  return soup;
}

// ---- Writing --------------------------------------------------------------------------------------------------------

constexpr std::size_t most_corners_in_byte = 255;

std::size_t most_corners(const Polygons& polygons) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) most = std::max(most, polygons.corners_of(i).size());
  return most;
}

/// What a file holds; all data at the vertices.
struct Content {
  const SurfaceMesh& mesh;
  Polygons polygons;
  std::vector<PlyColumn> columns;

  explicit Content(const SurfaceMesh& m) : mesh(m), polygons(find_polygons(m)), columns(write_vertex_columns(m.vertex_data)) {}
};

std::string header_text(const Content& content, std::string_view encoding) {
  const auto& [mesh, polygons, columns] = content;
  std::string text = "ply\nformat ";
  text.append(encoding).append(" 1.0\ncomment Mortise\n");
  for (std::size_t i = 0; !mesh.face_labels.empty() && i < mesh.label_names.size(); ++i) {
    text.append("comment label ").append(std::to_string(i)).append(" ").append(one_line_name(mesh.label_names[i])).append("\n");
  }
  text.append("element vertex ").append(std::to_string(mesh.points.size()));
  text += "\nproperty double x\nproperty double y\nproperty double z";
  for (const PlyColumn& c : columns) text.append(c.is_byte ? "\nproperty uchar " : "\nproperty double ").append(c.name);
  text += "\nelement face ";
  text.append(std::to_string(polygons.size())).append("\nproperty list ");
  text.append(most_corners(polygons) > most_corners_in_byte ? "int" : "uchar").append(" int vertex_indices\n");
  if (!mesh.walls.empty()) text += "property uchar wall\n";
  if (!mesh.face_labels.empty()) text += "property int label\n";
  text += "end_header\n";
  return text;
}

void append_value(std::string& bytes, const PlyColumn& column, std::size_t vertex) {
  if (column.is_byte) return append_little_endian(bytes, column.byte(vertex));
  append_little_endian(bytes, column.value(vertex));
}

}  // namespace

SurfaceMesh read_ply(std::string_view bytes) {
  const PlyHeader header = read_ply_header(bytes);
  const std::vector<Table> tables = make_tables(header);
  const std::string_view rows = bytes.substr(header.size);
  return build_mesh(header.encoding == PlyEncoding::Ascii ? read_rows(TextRows(rows, header), header, tables, rows.size())
                                                          : read_rows(BinaryRows(bytes, header), header, tables, rows.size()));
}

bool is_ascii_ply(std::string_view bytes) {
  LineReader lines(bytes, stage_name);
  while (lines.next() && trim(lines.line()) != "end_header") {
    std::string_view rest = lines.line();
    if (take_word(rest) == "format") return take_word(rest) == "ascii";
  }
  return false;
}

std::string write_ply_ascii(const SurfaceMesh& given) {
  if (!given.corner_data.empty()) return write_ply_ascii(corners_to_vertices(given, no_value).mesh);
  const Content content(given);
  const auto& [mesh, polygons, columns] = content;
  std::string text = header_text(content, "ascii");
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    append_point(text, mesh.points[v]);
    for (const PlyColumn& c : columns) append_double(text.append(" "), c.is_byte ? c.byte(v) : c.value(v));
    text += '\n';
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    text += std::to_string(polygons.corners_of(i).size());
    for (const VertexId vertex : polygons.corners_of(i)) text.append(" ").append(std::to_string(vertex.value));
    const std::size_t first = polygons.first_triangle[i].index();
    if (!mesh.walls.empty()) text += mesh.walls[first] != 0 ? " 1" : " 0";
    if (!mesh.face_labels.empty()) text.append(" ").append(std::to_string(mesh.face_labels[first]));
    text += '\n';
  }
  return text;
}

std::string write_ply_binary(const SurfaceMesh& given) {
  if (!given.corner_data.empty()) return write_ply_binary(corners_to_vertices(given, no_value).mesh);
  const Content content(given);
  const auto& [mesh, polygons, columns] = content;
  const bool has_long_lists = most_corners(polygons) > most_corners_in_byte;
  std::string bytes = header_text(content, "binary_little_endian");
  bytes.reserve(bytes.size() + mesh.points.size() * 24 + mesh.triangles.size() * 14);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) append_little_endian(bytes, mesh.points[v][i]);
    for (const PlyColumn& c : columns) append_value(bytes, c, v);
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto corners = polygons.corners_of(i);
    if (has_long_lists) {
      append_little_endian(bytes, static_cast<std::int32_t>(corners.size()));
    } else {
      append_little_endian(bytes, static_cast<std::uint8_t>(corners.size()));
    }
    for (const VertexId vertex : corners) append_little_endian(bytes, static_cast<std::int32_t>(vertex.value));
    const std::size_t first = polygons.first_triangle[i].index();
    if (!mesh.walls.empty()) append_little_endian(bytes, mesh.walls[first]);
    if (!mesh.face_labels.empty()) append_little_endian(bytes, static_cast<std::int32_t>(mesh.face_labels[first]));
  }
  return bytes;
}

}  // namespace mortise
