// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What both versions of Gmsh's mesh files share: nodes with numbers of their own, kinds of elements, names of groups.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/io/entity_mesh_builder.h"
#include "mortise/io/text.h"

namespace mortise {

/// An element as a file lists it.
struct MshElement {
  std::int64_t tag = 0;
  std::int64_t entity = 0;    ///< 0: none
  std::int32_t physical = 0;  ///< version 2.2 only; 0: none
  std::uint8_t corner_count = 0;
  std::array<std::uint32_t, 4> corners{};

  [[nodiscard]] std::size_t dimension() const { return corner_count > 3 ? 2 : corner_count - std::size_t{1}; }
  [[nodiscard]] std::span<const std::uint32_t> used_corners() const { return std::span(corners).first(corner_count); }
};

/// Nodes, found by the numbers the file gives them.
class MshNodes {
 public:
  void add(std::int64_t tag, const Vec3d& point, std::uint32_t line) { nodes_.push_back({tag, point, line}); }
  void reserve(std::size_t count) { nodes_.reserve(count); }
  /// Puts the nodes in order.
  /// @throws Error{ParseFailed} when a number comes twice
  void sort(std::string_view stage);
  [[nodiscard]] std::vector<Vec3d> points() const;
  /// The place of the node a word names. After sort().
  /// @throws Error{ParseFailed, BadIndex}
  [[nodiscard]] std::uint32_t find(std::string_view word, const TextPlace& place) const;

 private:
  struct Node {
    std::int64_t tag;
    Vec3d point;
    std::uint32_t line;
  };
  std::vector<Node> nodes_;
};

/// What the sections of a file have said so far.
struct MshContent {
  EntityMeshBuilder builder{};
  MshNodes nodes{};
  std::vector<MshElement> elements{};
};

/// How many corners elements of the type the next word names have.
/// @throws Error{ParseFailed} for types that are not read
[[nodiscard]] std::uint8_t read_element_type(WordReader& words);

/// Reads the corners of one element; its corner_count is known.
void read_corners(WordReader& words, const MshNodes& nodes, MshElement& element);

/// The number of a node or an element.
[[nodiscard]] std::int64_t read_number(WordReader& words, std::string_view what);

[[nodiscard]] Vec3d read_position(WordReader& words);

void read_msh22_nodes(WordReader& words, MshContent& content);
void read_msh22_elements(WordReader& words, MshContent& content);
/// Gives the builder the elements, copies of one element in several groups as one.
void resolve_msh22(MshContent& content);

void read_msh41_entities(WordReader& words, MshContent& content);
void read_msh41_nodes(WordReader& words, MshContent& content);
void read_msh41_elements(WordReader& words, MshContent& content);
/// Gives the builder the elements, in the order of their numbers.
void resolve_msh41(MshContent& content);

/// Appends the sections MeshFormat and PhysicalNames.
void append_msh_head(std::string& text, std::string_view version, const EntityMesh& mesh);

/// The type of an element with so many corners.
[[nodiscard]] std::string_view msh_type_of(std::size_t corner_count);

/// The corners of an element.
[[nodiscard]] std::vector<VertexId> corners_of_element(const EntityMesh& mesh, std::size_t dimension, std::size_t element);

/// Appends " " and the text of a number.
template <class Number>
void append_word(std::string& text, Number number) {
  text.append(" ").append(std::to_string(number));
}

}  // namespace mortise
