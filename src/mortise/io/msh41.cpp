// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// MSH 4.1: the entities of the model, then nodes and elements in blocks for each.
#include <algorithm>
#include <map>

#include "mortise/base/numbers.h"
#include "mortise/geom/vec.h"
#include "mortise/io/msh.h"
#include "mortise/io/msh_parts.h"

namespace mortise {
namespace {

// ---- Reading --------------------------------------------------------------------------------------------------------

/// A tag whose sign says which way round.
std::int32_t read_signed_tag(WordReader& words, std::string_view what) {
  const std::string_view word = words.next();
  const std::int32_t tag = read_tag(word, words.place(), what, -0x7fffffff);
  if (tag == 0) words.fail(std::string(what) + " is 0");
  return tag;
}

std::int32_t without_sign(std::int32_t tag) { return tag < 0 ? -tag : tag; }

void read_entity(WordReader& words, std::size_t dimension, EntityMeshBuilder& builder) {
  const std::string_view word = words.next();
  const std::uint32_t entity = builder.entity_of(dimension, read_tag(word, words.place(), "the tag of an entity", 1));
  for (int corner = 0; corner < (dimension == 0 ? 1 : 2); ++corner) static_cast<void>(read_position(words));
  const std::uint32_t groups = read_count(words.next(), words.place(), "the number of groups");
  for (std::uint32_t i = 0; i < groups; ++i) {
    const std::int32_t group = without_sign(read_signed_tag(words, "the number of a group"));
    builder.add_to_group(dimension, entity, builder.group_of(dimension, group));
  }
  if (dimension == 0) return;
  const std::uint32_t sides = read_count(words.next(), words.place(), "the number of bounding entities");
  std::vector<std::int32_t> boundary;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::int32_t tag = read_signed_tag(words, "the tag of a bounding entity");
    boundary.push_back(dimension == 1 ? without_sign(tag) : tag);
  }
  builder.set_boundary(dimension, entity, std::move(boundary));
}

/// What the head of a block of nodes or elements says.
struct Block {
  std::size_t dimension;
  std::int32_t entity;
};

Block read_block(WordReader& words) {
  const std::int32_t dimension = read_tag(words.next(), words.place(), "the dimension of an entity", 0);
  if (dimension > 3) words.fail("a dimension is at most 3");
  const std::int32_t entity = read_tag(words.next(), words.place(), "the tag of an entity", 1);
  return {static_cast<std::size_t>(dimension), entity};
}

/// The first word of a section, and three more numbers that nothing depends on.
std::uint32_t read_block_count(WordReader& words) {
  const std::uint32_t blocks = read_count(words.next(), words.place(), "the number of blocks");
  for (int i = 0; i < 3; ++i) static_cast<void>(read_number(words, "a number of the section"));
  return blocks;
}

void read_node_block(WordReader& words, MshNodes& nodes) {
  struct Numbered {
    std::int64_t tag;
    std::uint32_t line;
  };
  const Block block = read_block(words);
  const bool is_parametric = read_number(words, "whether nodes have parameters") != 0;
  const std::uint32_t count = read_count(words.next(), words.place(), "the number of nodes");
  std::vector<Numbered> numbers;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int64_t tag = read_number(words, "the number of a node");
    numbers.push_back({tag, words.place().line});
  }
  for (const Numbered& number : numbers) {
    nodes.add(number.tag, read_position(words), number.line);
    for (std::size_t i = 0; is_parametric && i < block.dimension; ++i) {
      if (words.next().empty()) words.fail("a parameter is missing");
    }
  }
}

void read_element_block(WordReader& words, MshContent& content) {
  const Block block = read_block(words);
  MshElement element;
  element.entity = block.entity;
  element.corner_count = read_element_type(words);
  if (element.dimension() != block.dimension) words.fail("the elements of the block are of another dimension than its entity");
  const std::uint32_t count = read_count(words.next(), words.place(), "the number of elements");
  for (std::uint32_t i = 0; i < count; ++i) {
    element.tag = read_number(words, "the number of an element");
    read_corners(words, content.nodes, element);
    content.elements.push_back(element);
  }
}

// ---- Writing --------------------------------------------------------------------------------------------------------

constexpr std::uint8_t no_dimension = 4;

/// The entity a node is written with.
struct Owner {
  std::uint8_t dimension = no_dimension;
  std::uint32_t entity = 0;
};

const std::vector<std::uint32_t>& element_entities(const EntityMesh& mesh, std::size_t dimension) {
  return dimension == 0 ? mesh.point_entities : dimension == 1 ? mesh.line_entities : mesh.triangle_entities;
}

/// An entity for nodes that no element uses.
Owner owner_of_loose_nodes(const EntityMesh& mesh) {
  for (const std::uint8_t dimension : {std::uint8_t{2}, std::uint8_t{1}, std::uint8_t{0}}) {
    if (!mesh.entities[dimension].empty()) return {dimension, 0};
  }
  return {3, 0};
}

/// Every node belongs to the entity of lowest dimension that has it in an element.
std::vector<Owner> find_owners(const EntityMesh& mesh) {
  std::vector<Owner> owners(mesh.points.size());
  for (std::uint8_t dimension = 0; dimension < 3; ++dimension) {
    const std::vector<std::uint32_t>& entities = element_entities(mesh, dimension);
    for (std::size_t i = 0; i < entities.size(); ++i) {
      for (const VertexId vertex : corners_of_element(mesh, dimension, i)) {
        Owner& owner = owners[vertex.index()];
        if (owner.dimension == no_dimension) owner = {dimension, entities[i]};
      }
    }
  }
  for (Owner& owner : owners) {
    if (owner.dimension == no_dimension) owner = owner_of_loose_nodes(mesh);
  }
  return owners;
}

using Boxes = std::vector<Box3>;

/// Adds to the box of every entity those of its boundary.
void extend_by_boundaries(const std::vector<MeshEntity>& entities, const std::vector<MeshEntity>& below, const Boxes& boxes_below,
                          Boxes& boxes) {
  std::map<std::int32_t, std::size_t> place_of;
  for (std::size_t i = 0; i < below.size(); ++i) place_of.emplace(below[i].tag, i);
  for (std::size_t i = 0; i < entities.size(); ++i) {
    for (const std::int32_t side : entities[i].boundary) {
      const auto place = place_of.find(without_sign(side));
      if (place != place_of.end()) boxes[i].extend(boxes_below[place->second]);
    }
  }
}

/// Boxes of the entities of a dimension: round their elements and their boundaries.
Boxes find_boxes(const EntityMesh& mesh, std::size_t dimension, const Boxes& boxes_below) {
  Boxes boxes(mesh.entities[dimension].size());
  const std::size_t count = dimension == 3 ? 0 : element_entities(mesh, dimension).size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const VertexId vertex : corners_of_element(mesh, dimension, i)) {
      boxes[element_entities(mesh, dimension)[i]].extend(mesh.points[vertex.index()]);
    }
  }
  if (dimension > 0) extend_by_boundaries(mesh.entities[dimension], mesh.entities[dimension - 1], boxes_below, boxes);
  return boxes;
}

void append_entity(const EntityMesh& mesh, std::size_t dimension, const MeshEntity& entity, const Box3& box, std::string& text) {
  const Box3 written = box.is_empty() ? Box3{{0, 0, 0}, {0, 0, 0}} : box;
  text.append(std::to_string(entity.tag)).append(" ");
  append_point(text, written.lo);
  if (dimension > 0) append_point(text.append(" "), written.hi);
  append_word(text, entity.names.size());
  for (const std::uint32_t name : entity.names) append_word(text, mesh.names[name].tag);
  if (dimension > 0) append_word(text, entity.boundary.size());
  for (std::size_t i = 0; dimension > 0 && i < entity.boundary.size(); ++i) {
    const bool is_end_of_edge = dimension == 1 && i > 0;
    append_word(text, is_end_of_edge ? -entity.boundary[i] : entity.boundary[i]);
  }
  text += '\n';
}

void append_entities(const EntityMesh& mesh, std::string& text) {
  text += "$Entities\n";
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    text.append(dimension > 0 ? " " : "").append(std::to_string(mesh.entities[dimension].size()));
  }
  text += '\n';
  Boxes boxes;
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    boxes = find_boxes(mesh, dimension, boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) append_entity(mesh, dimension, mesh.entities[dimension][i], boxes[i], text);
  }
  text += "$EndEntities\n";
}

void append_node_block(const EntityMesh& mesh, const Owner& owner, const std::vector<std::uint32_t>& nodes, std::string& text) {
  text += std::to_string(owner.dimension);
  append_word(text, mesh.entities[owner.dimension][owner.entity].tag);
  text += " 0";
  append_word(text, nodes.size());
  text += '\n';
  for (const std::uint32_t node : nodes) text.append(std::to_string(std::uint64_t{node} + 1)).append("\n");
  for (const std::uint32_t node : nodes) {
    append_point(text, mesh.points[node]);
    text += '\n';
  }
}

/// Appends the line that blocks of nodes or elements begin with; their numbers run from 1.
void append_section_counts(std::size_t blocks, std::size_t items, std::string& text) {
  text += std::to_string(blocks);
  append_word(text, items);
  append_word(text, items == 0 ? 0 : 1);
  append_word(text, items);
  text += '\n';
}

void append_nodes(const EntityMesh& mesh, std::string& text) {
  std::array<std::vector<std::vector<std::uint32_t>>, 4> nodes_of;
  for (std::size_t dimension = 0; dimension < 4; ++dimension) nodes_of[dimension].resize(mesh.entities[dimension].size());
  const std::vector<Owner> owners = find_owners(mesh);
  for (std::uint32_t i = 0; i < owners.size(); ++i) nodes_of[owners[i].dimension][owners[i].entity].push_back(i);
  std::string blocks;
  std::size_t block_count = 0;
  for (std::uint8_t dimension = 0; dimension < 4; ++dimension) {
    for (std::uint32_t entity = 0; entity < nodes_of[dimension].size(); ++entity) {
      if (nodes_of[dimension][entity].empty()) continue;
      append_node_block(mesh, {dimension, entity}, nodes_of[dimension][entity], blocks);
      ++block_count;
    }
  }
  text += "$Nodes\n";
  append_section_counts(block_count, mesh.points.size(), text);
  text.append(blocks).append("$EndNodes\n");
}

void append_elements(const EntityMesh& mesh, std::string& text) {
  std::string blocks;
  std::size_t block_count = 0, before = 0;
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    const auto parts = elements_of_entities(mesh.entities[dimension], element_entities(mesh, dimension));
    for (std::size_t entity = 0; entity < parts.size(); ++entity) {
      if (parts[entity].empty()) continue;
      ++block_count;
      blocks += std::to_string(dimension);
      append_word(blocks, mesh.entities[dimension][entity].tag);
      blocks.append(" ").append(msh_type_of(dimension + 1));
      append_word(blocks, parts[entity].size());
      blocks += '\n';
      for (const std::uint32_t i : parts[entity]) {
        blocks += std::to_string(before + i + 1);
        for (const VertexId vertex : corners_of_element(mesh, dimension, i)) append_word(blocks, vertex.index() + 1);
        blocks += '\n';
      }
    }
    before += element_entities(mesh, dimension).size();
  }
  text += "$Elements\n";
  append_section_counts(block_count, before, text);
  text.append(blocks).append("$EndElements\n");
}

bool has_entities(const EntityMesh& mesh) {
  return std::any_of(mesh.entities.begin(), mesh.entities.end(), [](const auto& entities) { return !entities.empty(); });
}

}  // namespace

void read_msh41_entities(WordReader& words, MshContent& content) {
  std::array<std::uint32_t, 4> counts{};
  for (std::uint32_t& count : counts) {
    const std::string_view word = words.next();
    count = read_count(word, words.place(), "the number of entities");
  }
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    for (std::uint32_t i = 0; i < counts[dimension]; ++i) read_entity(words, dimension, content.builder);
  }
}

void read_msh41_nodes(WordReader& words, MshContent& content) {
  const std::uint32_t blocks = read_block_count(words);
  for (std::uint32_t i = 0; i < blocks; ++i) read_node_block(words, content.nodes);
}

void read_msh41_elements(WordReader& words, MshContent& content) {
  const std::uint32_t blocks = read_block_count(words);
  for (std::uint32_t i = 0; i < blocks; ++i) read_element_block(words, content);
}

void resolve_msh41(MshContent& content) {
  std::stable_sort(content.elements.begin(), content.elements.end(),
                   [](const MshElement& a, const MshElement& b) { return a.tag < b.tag; });
  for (const MshElement& element : content.elements) content.builder.add_element(element.used_corners(), element.entity);
}

std::string write_msh41(const EntityMesh& mesh) {
  if (!has_entities(mesh)) {
    EntityMesh with_face = mesh;
    with_face.entities[2].push_back({1});
    return write_msh41(with_face);
  }
  std::string text;
  append_msh_head(text, "4.1", mesh);
  append_entities(mesh, text);
  append_nodes(mesh, text);
  append_elements(mesh, text);
  return text;
}

}  // namespace mortise
