// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Nastran bulk data: fields of 8 or 16 characters.
#include "mortise/io/nastran.h"

#include <algorithm>

#include "mortise/base/error.h"
#include "mortise/io/fitted_number.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::size_t small_field = 8;
constexpr std::size_t large_field = 16;
constexpr std::size_t fields_per_line = 8;
constexpr std::uint64_t largest_id = 99999999;

void append_left(std::string_view word, std::size_t width, std::string& text) {
  text.append(word).append(width - std::min(width, word.size()), ' ');
}

void append_right(std::string_view word, std::size_t width, std::string& text) {
  text.append(width - std::min(width, word.size()), ' ').append(word);
}

void append_id(std::uint64_t id, std::string& text) { append_right(std::to_string(id), small_field, text); }

void check_ids(const EntityMesh& mesh) {
  const auto is_large = [](const MeshEntity& e) { return static_cast<std::uint64_t>(e.tag) > largest_id; };
  const bool has_large_tag = std::any_of(mesh.entities[2].begin(), mesh.entities[2].end(), is_large);
  if (mesh.points.size() <= largest_id && mesh.triangles.size() <= largest_id && !has_large_tag) return;
  throw Error(ErrorCode::OutOfRange, "write_nastran", "Nastran numbers nodes, elements and properties up to 99,999,999");
}

std::string quoted(std::string_view name) {
  std::string text = one_line_name(name);
  std::replace(text.begin(), text.end(), '"', '\'');
  return "\"" + text + "\"";
}

void append_face_names(const EntityMesh& mesh, std::string& text) {
  for (const MeshEntity& face : mesh.entities[2]) {
    if (face.names.empty()) continue;
    append_left("$HMNAME COMP", 2 * large_field - small_field, text);
    append_id(static_cast<std::uint64_t>(face.tag), text);
    text.append(quoted(spoken_name(mesh.names[face.names.front()]))).append("\n");
  }
}

/// A comment for each group of faces, with the properties it consists of.
void append_face_groups(const EntityMesh& mesh, std::string& text) {
  for (std::uint32_t name = 0; name < mesh.names.size(); ++name) {
    if (mesh.names[name].dimension != 2) continue;
    text.append("$ group ").append(quoted(spoken_name(mesh.names[name]))).append(": properties");
    for (const MeshEntity& face : mesh.entities[2]) {
      const bool is_member = std::find(face.names.begin(), face.names.end(), name) != face.names.end();
      if (is_member) text.append(" ").append(std::to_string(face.tag));
    }
    text += '\n';
  }
}

void append_nodes(const EntityMesh& mesh, std::string& text) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    append_left("GRID*", small_field, text);
    append_right(std::to_string(i + 1), large_field, text);
    append_left("", large_field, text);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == 2) append_left("\n*", small_field + 1, text);
      append_right(fitted_number(mesh.points[i][k], large_field, ExponentStyle::SignOnly), large_field, text);
    }
    text += '\n';
  }
}

void append_triangles(const EntityMesh& mesh, std::string& text) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    append_left("CTRIA3", small_field, text);
    append_id(i + 1, text);
    append_id(static_cast<std::uint64_t>(mesh.entities[2][mesh.triangle_entities[i]].tag), text);
    for (const VertexId vertex : mesh.triangles[i]) append_id(vertex.index() + 1, text);
    text += '\n';
  }
}

/// Sets of nodes, numbered from 1.
void append_node_groups(const EntityMesh& mesh, std::string& text) {
  std::uint64_t set = 0;
  for (std::uint32_t name = 0; name < mesh.names.size(); ++name) {
    if (mesh.names[name].dimension > 1) continue;
    const std::vector<std::uint32_t> nodes = nodes_of_group(mesh, name);
    if (nodes.empty()) continue;
    ++set;
    text.append("$ SET1 ").append(std::to_string(set)).append(" is the group ").append(quoted(spoken_name(mesh.names[name]))).append("\n");
    append_left("SET1", small_field, text);
    append_id(set, text);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if ((i + 1) % fields_per_line == 0) append_left("\n+", small_field + 1, text);
      append_id(std::uint64_t{nodes[i]} + 1, text);
    }
    text += '\n';
  }
}

}  // namespace

std::string write_nastran(const EntityMesh& mesh) {
  check_ids(mesh);
  std::string text = "$ Mortise\nBEGIN BULK\n";
  append_face_names(mesh, text);
  append_face_groups(mesh, text);
  append_nodes(mesh, text);
  append_triangles(mesh, text);
  append_node_groups(mesh, text);
  return text += "ENDDATA\n";
}

}  // namespace mortise
