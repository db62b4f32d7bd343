// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Abaqus input files.
#include "mortise/io/abaqus.h"

#include <set>

#include "mortise/io/fitted_number.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::size_t field_width = 20;
constexpr std::size_t ids_per_line = 16;
constexpr std::size_t longest_name = 80;

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_legal(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; }

/// A character of several bytes counts as one.
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string legal_name(std::string_view name) {
  std::string legal;
  for (const char c : name) {
    if (!continues_character(c)) legal += is_legal(c) ? c : '_';
  }
  if (legal.empty() || !is_letter(legal.front())) legal.insert(0, "G_");
  return legal.substr(0, longest_name);
}

std::string in_capitals(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// Hands out names no two of which are equal in capitals.
class UniqueNames {
 public:
  std::string take(const std::string& wanted) {
    std::string name = wanted;
    for (std::size_t copy = 2; !taken_.insert(in_capitals(name)).second; ++copy) {
      const std::string suffix = "_" + std::to_string(copy);
      name = wanted.substr(0, longest_name - suffix.size()) + suffix;
    }
    return name;
  }

 private:
  std::set<std::string> taken_;
};

std::string face_set(const MeshEntity& face) { return "FACE_" + std::to_string(face.tag); }

/// Appends numbers from 1, a full line at a time.
void append_ids(const std::vector<std::uint32_t>& ids, std::string& text) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    text += std::to_string(std::uint64_t{ids[i]} + 1);
    text += (i + 1) % ids_per_line == 0 || i + 1 == ids.size() ? "\n" : ", ";
  }
}

void append_nodes(const EntityMesh& mesh, std::string& text) {
  text += "*NODE, NSET=ALL_NODES\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    text += std::to_string(i + 1);
    for (std::size_t k = 0; k < 3; ++k) {
      text.append(", ").append(fitted_number(mesh.points[i][k], field_width, ExponentStyle::WithLetter));
    }
    text += '\n';
  }
}

void append_faces(const EntityMesh& mesh, const std::vector<std::vector<std::uint32_t>>& parts, std::string& text) {
  for (std::size_t face = 0; face < parts.size(); ++face) {
    if (parts[face].empty()) continue;
    text.append("*ELEMENT, TYPE=S3, ELSET=").append(face_set(mesh.entities[2][face])).append("\n");
    for (const std::uint32_t i : parts[face]) {
      text += std::to_string(std::uint64_t{i} + 1);
      for (const VertexId vertex : mesh.triangles[i]) text.append(", ").append(std::to_string(vertex.index() + 1));
      text += '\n';
    }
  }
}

void append_element_group(const EntityMesh& mesh, std::uint32_t name, const std::string& legal, std::string& text) {
  const std::vector<std::uint32_t> triangles = triangles_of_group(mesh, name);
  if (triangles.empty()) return;
  text.append("*ELSET, ELSET=").append(legal).append("\n");
  append_ids(triangles, text);
  text.append("*SURFACE, NAME=").append(legal).append(", TYPE=ELEMENT\n").append(legal).append(", SPOS\n");
}

void append_node_group(const EntityMesh& mesh, std::uint32_t name, const std::string& legal, std::string& text) {
  const std::vector<std::uint32_t> nodes = nodes_of_group(mesh, name);
  if (nodes.empty()) return;
  text.append("*NSET, NSET=").append(legal).append("\n");
  append_ids(nodes, text);
}

void append_groups(const EntityMesh& mesh, UniqueNames& names, std::string& text) {
  for (std::uint32_t name = 0; name < mesh.names.size(); ++name) {
    if (mesh.names[name].dimension > 2) continue;
    const std::string spoken = one_line_name(spoken_name(mesh.names[name]));
    const std::string legal = names.take(legal_name(spoken));
    if (legal != spoken) text.append("** ").append(legal).append(" is the group '").append(spoken).append("'\n");
    if (mesh.names[name].dimension == 2) {
      append_element_group(mesh, name, legal, text);
    } else {
      append_node_group(mesh, name, legal, text);
    }
  }
}

}  // namespace

std::string write_abaqus(const EntityMesh& mesh) {
  std::string text = "*HEADING\nMortise\n";
  append_nodes(mesh, text);
  append_faces(mesh, elements_of_entities(mesh.entities[2], mesh.triangle_entities), text);
  UniqueNames names;
  static_cast<void>(names.take("ALL_NODES"));
  for (const MeshEntity& face : mesh.entities[2]) static_cast<void>(names.take(face_set(face)));
  append_groups(mesh, names, text);
  return text;
}

}  // namespace mortise
