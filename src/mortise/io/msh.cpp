// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Gmsh's mesh files: the sections, and what both versions share.
#include "mortise/io/msh.h"

#include <algorithm>

#include "mortise/base/numbers.h"
#include "mortise/io/msh_parts.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_msh";

enum class Version : unsigned char { Msh22, Msh41 };

Version read_version(WordReader& words) {
  const std::string_view word = words.next();
  const double version = value_of_word(word);
  const bool is_two = version >= 2 && version < 3;
  if (!is_two && word != "4.1") words.fail("only versions 2.2 and 4.1 of the format are read");
  const std::int64_t kind = read_integer(words.next(), words.place(), "the file type");
  if (kind != 0) words.fail("the file is binary, and only text files are read: save it as ASCII");
  static_cast<void>(read_integer(words.next(), words.place(), "the size of a number"));
  return is_two ? Version::Msh22 : Version::Msh41;
}

/// What stands between the first and the last double quote of the current line.
std::string_view quoted_rest(WordReader& words) {
  const std::string_view rest = words.rest_of_line();
  if (rest.size() < 2 || rest.front() != '"' || rest.back() != '"') words.fail("a name in double quotes is expected");
  return rest.substr(1, rest.size() - 2);
}

void read_names(WordReader& words, EntityMeshBuilder& builder) {
  const std::uint32_t count = read_count(words.next(), words.place(), "the number of names");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int32_t dimension = read_tag(words.next(), words.place(), "the dimension", 0);
    if (dimension > 3) words.fail("a dimension is at most 3");
    const std::int32_t tag = read_tag(words.next(), words.place(), "the number of a group", 1);
    builder.set_name(builder.group_of(static_cast<std::size_t>(dimension), tag), quoted_rest(words));
  }
}

void skip_section(WordReader& words, std::string_view section) {
  const std::string end = "$End" + std::string(section.substr(1));
  for (std::string_view word = words.next(); word != end; word = words.next()) {
    if (word.empty()) words.fail("the file ends before '" + end + "'");
  }
}

/// Reads the inside of a section; false when it has no meaning here.
bool read_section(std::string_view section, Version version, WordReader& words, MshContent& content) {
  const bool is_22 = version == Version::Msh22;
  if (section == "$PhysicalNames") {
    read_names(words, content.builder);
  } else if (section == "$Entities" && !is_22) {
    read_msh41_entities(words, content);
  } else if (section == "$Nodes") {
    if (!content.builder.points.empty()) words.fail("the file has two sections of nodes");
    is_22 ? read_msh22_nodes(words, content) : read_msh41_nodes(words, content);
    content.nodes.sort(stage_name);
    content.builder.points = content.nodes.points();
  } else if (section == "$Elements") {
    is_22 ? read_msh22_elements(words, content) : read_msh41_elements(words, content);
  } else {
    return false;
  }
  return true;
}

void expect_end(WordReader& words, std::string_view section) {
  const std::string end = "$End" + std::string(section.substr(1));
  const std::string_view word = words.next();
  if (word != end) words.fail("'" + end + "' is expected" + (word.empty() ? " but the file ends" : ""));
}

/// Reads up to behind the format section, over comments.
Version find_version(WordReader& words) {
  for (;;) {
    const std::string_view section = words.next();
    if (section.size() < 2 || section[0] != '$') words.fail("'$MeshFormat' is expected");
    if (section == "$MeshFormat") break;
    skip_section(words, section);
  }
  const Version version = read_version(words);
  expect_end(words, "$MeshFormat");
  return version;
}

std::string quoted_name(std::string_view name) {
  std::string text = one_line_name(name);
  std::replace(text.begin(), text.end(), '"', '\'');
  return "\"" + text + "\"";
}

std::string_view first_section(std::string_view bytes) {
  const std::size_t begin = std::min(bytes.find('$'), bytes.size());
  if (!trim(bytes.substr(0, begin)).empty()) return {};
  return bytes.substr(begin);
}

}  // namespace

void MshNodes::sort(std::string_view stage) {
  std::stable_sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.tag < b.tag; });
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    if (nodes_[i].tag != nodes_[i - 1].tag) continue;
    fail_at_line(ErrorCode::ParseFailed, {stage, nodes_[i].line}, "node " + std::to_string(nodes_[i].tag) + " is listed twice");
  }
}

std::vector<Vec3d> MshNodes::points() const {
  std::vector<Vec3d> points;
  points.reserve(nodes_.size());
  for (const Node& node : nodes_) points.push_back(node.point);
  return points;
}

std::uint32_t MshNodes::find(std::string_view word, const TextPlace& place) const {
  const std::int64_t tag = read_integer(word, place, "a node");
  const auto node = std::lower_bound(nodes_.begin(), nodes_.end(), tag, [](const Node& n, std::int64_t t) { return n.tag < t; });
  if (node == nodes_.end() || node->tag != tag) {
    fail_at_line(ErrorCode::BadIndex, place, "the element names node " + std::to_string(tag) + ", which is not listed before it");
  }
  return static_cast<std::uint32_t>(node - nodes_.begin());
}

std::uint8_t read_element_type(WordReader& words) {
  const std::int64_t type = read_integer(words.next(), words.place(), "the type of an element");
  if (type == 15) return 1;
  if (type >= 1 && type <= 3) return static_cast<std::uint8_t>(type + 1);
  const std::string name = "elements of type " + std::to_string(type);
  if (type >= 4 && type <= 7) words.fail("volume elements are not read yet (" + name + "): save the surface mesh only");
  words.fail(name + " are not read: only points, lines, triangles and quadrangles with straight edges are");
}

void read_corners(WordReader& words, const MshNodes& nodes, MshElement& element) {
  for (std::size_t i = 0; i < element.corner_count; ++i) {
    const std::string_view word = words.next();
    element.corners[i] = nodes.find(word, words.place());
  }
}

std::int64_t read_number(WordReader& words, std::string_view what) {
  const std::string_view word = words.next();
  return read_integer(word, words.place(), what);
}

Vec3d read_position(WordReader& words) {
  Vec3d point;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view word = words.next();
    point[i] = read_coordinate(word, words.place());
  }
  return point;
}

void append_msh_head(std::string& text, std::string_view version, const EntityMesh& mesh) {
  text.append("$MeshFormat\n").append(version).append(" 0 8\n$EndMeshFormat\n");
  if (mesh.names.empty()) return;
  text.append("$PhysicalNames\n").append(std::to_string(mesh.names.size())).append("\n");
  for (const PhysicalName& name : mesh.names) {
    text += std::to_string(name.dimension);
    append_word(text, name.tag);
    text.append(" ").append(quoted_name(name.name)).append("\n");
  }
  text += "$EndPhysicalNames\n";
}

std::string_view msh_type_of(std::size_t corner_count) { return corner_count == 1 ? "15" : corner_count == 2 ? "1" : "2"; }

std::vector<VertexId> corners_of_element(const EntityMesh& mesh, std::size_t dimension, std::size_t element) {
  if (dimension == 0) return {mesh.point_elements[element]};
  if (dimension == 1) return {mesh.lines[element].begin(), mesh.lines[element].end()};
  return {mesh.triangles[element].begin(), mesh.triangles[element].end()};
}

bool is_msh(std::string_view bytes) {
  const std::string_view section = first_section(bytes);
  return section.substr(0, 11) == "$MeshFormat" || section.substr(0, 9) == "$Comments";
}

bool is_msh22(std::string_view bytes) {
  const std::size_t begin = bytes.find("$MeshFormat");
  if (!is_msh(bytes) || begin == std::string_view::npos) return false;
  WordReader words(LineReader(bytes.substr(begin), stage_name));
  static_cast<void>(words.next());
  return words.next().substr(0, 1) == "2";
}

EntityMesh read_msh(std::string_view bytes) {
  WordReader words(LineReader(bytes, stage_name));
  const Version version = find_version(words);
  MshContent content;
  for (std::string_view section = words.next(); !section.empty(); section = words.next()) {
    if (section.size() < 2 || section[0] != '$') words.fail("the beginning of a section is expected");
    if (read_section(section, version, words, content)) {
      expect_end(words, section);
    } else {
      skip_section(words, section);
    }
  }
  version == Version::Msh22 ? resolve_msh22(content) : resolve_msh41(content);
  return std::move(content.builder).finish();
}

}  // namespace mortise
