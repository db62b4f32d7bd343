// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// MSH 2.2: elements one by one, each with the number of a group and that of an entity.
#include <algorithm>
#include <map>

#include "mortise/io/msh.h"
#include "mortise/io/msh_parts.h"

namespace mortise {
namespace {

MshElement read_element(WordReader& words, const MshNodes& nodes) {
  MshElement element;
  element.tag = read_number(words, "the number of an element");
  element.corner_count = read_element_type(words);
  const std::uint32_t tags = read_count(words.next(), words.place(), "the number of tags");
  for (std::uint32_t i = 0; i < tags; ++i) {
    const std::string_view word = words.next();
    if (i == 0) element.physical = read_tag(word, words.place(), "the number of a group", -0x7fffffff);
    if (i == 1) element.entity = read_tag(word, words.place(), "the number of an entity", 0);
    if (i > 1) static_cast<void>(read_integer(word, words.place(), "a tag"));
  }
  if (element.physical < 0) element.physical = -element.physical;
  read_corners(words, nodes, element);
  return element;
}

/// The elements of one entity in one group, ascending.
struct Part {
  std::int32_t physical;
  std::vector<std::uint32_t> elements;
};

using PartsOfEntities = std::map<std::pair<std::size_t, std::int64_t>, std::vector<Part>>;

/// The parts of every entity, in the order of their first elements.
PartsOfEntities find_parts(const std::vector<MshElement>& elements) {
  PartsOfEntities parts_of;
  std::map<std::array<std::int64_t, 3>, std::size_t> place_of;
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const MshElement& element = elements[i];
    const auto dimension = static_cast<std::int64_t>(element.dimension());
    std::vector<Part>& parts = parts_of[{element.dimension(), element.entity}];
    const auto [place, is_new] = place_of.emplace(std::array{dimension, element.entity, std::int64_t{element.physical}}, parts.size());
    if (is_new) parts.push_back({element.physical, {}});
    parts[place->second].elements.push_back(i);
  }
  return parts_of;
}

bool are_copies(const std::vector<MshElement>& elements, const Part& a, const Part& b) {
  const auto same_corners = [&](std::uint32_t i, std::uint32_t j) {
    return elements[i].corner_count == elements[j].corner_count && elements[i].corners == elements[j].corners;
  };
  return std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(), same_corners);
}

void add_to_group(const Part& part, std::size_t dimension, std::int64_t entity, EntityMeshBuilder& builder) {
  if (part.physical == 0) return;
  builder.add_to_group(dimension, builder.entity_of(dimension, entity), builder.group_of(dimension, part.physical));
}

void append_elements(const EntityMesh& mesh, std::size_t dimension, const std::vector<std::uint32_t>& element_entities, std::string& text,
                     std::size_t& count) {
  for (std::size_t i = 0; i < element_entities.size(); ++i) {
    const MeshEntity& entity = mesh.entities[dimension][element_entities[i]];
    const std::vector<VertexId> corners = corners_of_element(mesh, dimension, i);
    for (std::size_t copy = 0; copy < std::max<std::size_t>(entity.names.size(), 1); ++copy) {
      text.append(std::to_string(++count)).append(" ").append(msh_type_of(corners.size())).append(" 2");
      append_word(text, entity.names.empty() ? 0 : mesh.names[entity.names[copy]].tag);
      append_word(text, entity.tag);
      for (const VertexId vertex : corners) append_word(text, vertex.index() + 1);
      text += '\n';
    }
  }
}

}  // namespace

void read_msh22_nodes(WordReader& words, MshContent& content) {
  const std::uint32_t count = read_count(words.next(), words.place(), "the number of nodes");
  content.nodes.reserve(believable_count(count, words.bytes_left(), 8));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int64_t tag = read_number(words, "the number of a node");
    const std::uint32_t line = words.place().line;
    content.nodes.add(tag, read_position(words), line);
  }
}

void read_msh22_elements(WordReader& words, MshContent& content) {
  const std::uint32_t count = read_count(words.next(), words.place(), "the number of elements");
  for (std::uint32_t i = 0; i < count; ++i) content.elements.push_back(read_element(words, content.nodes));
}

void resolve_msh22(MshContent& content) {
  std::vector<bool> is_copy(content.elements.size(), false);
  for (const auto& [key, parts] : find_parts(content.elements)) {
    const auto& [dimension, entity] = key;
    for (const Part& part : parts) {
      const bool is_first = &part == &parts.front();
      const bool copies_first = !is_first && are_copies(content.elements, parts.front(), part);
      const std::int64_t own = is_first || copies_first ? entity : content.builder.new_tag();
      add_to_group(part, dimension, own, content.builder);
      for (const std::uint32_t i : part.elements) {
        content.elements[i].entity = own;
        is_copy[i] = copies_first;
      }
    }
  }
  for (std::size_t i = 0; i < content.elements.size(); ++i) {
    if (!is_copy[i]) content.builder.add_element(content.elements[i].used_corners(), content.elements[i].entity);
  }
}

std::string write_msh22(const EntityMesh& mesh) {
  std::string text;
  append_msh_head(text, "2.2", mesh);
  text.append("$Nodes\n").append(std::to_string(mesh.points.size())).append("\n");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    text.append(std::to_string(i + 1)).append(" ");
    append_point(text, mesh.points[i]);
    text += '\n';
  }
  std::string elements;
  std::size_t count = 0;
  append_elements(mesh, 0, mesh.point_entities, elements, count);
  append_elements(mesh, 1, mesh.line_entities, elements, count);
  append_elements(mesh, 2, mesh.triangle_entities, elements, count);
  text.append("$EndNodes\n$Elements\n").append(std::to_string(count)).append("\n");
  return text.append(elements).append("$EndElements\n");
}

}  // namespace mortise
