// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cells and their arrays as both of VTK's formats hold them, and what they mean to a mesh of entities.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/io/entity_mesh.h"
#include "mortise/io/text.h"

namespace mortise {

/// The groups of a file, as arrays of its field data.
struct CellGroups {
  static constexpr std::string_view dimensions_name = "group_dimensions";
  static constexpr std::string_view tags_name = "group_tags";
  static constexpr std::string_view names_name = "group_names";
  static constexpr std::string_view members_name = "entity_groups";

  std::vector<std::int64_t> dimensions, tags;
  std::vector<std::string> names;
  std::vector<std::int64_t> members;  ///< rows of three: dimension and tag of an entity, place of its group in the arrays above
};

/// Cells over points: those with one corner first, then lines, then triangles, when it is to be written.
struct CellGrid {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> corners;    ///< cell after cell
  std::vector<std::uint32_t> cell_ends;  ///< per cell: end of its corners
  std::vector<std::uint8_t> types;       ///< VTK's numbers of the kinds of cells
  std::vector<std::uint32_t> lines;      ///< per cell: where it stands in the file
  std::vector<std::int64_t> entities;    ///< empty, or the tag of the entity of every cell
  std::vector<std::int64_t> tags;        ///< empty, or the tag of a group of every cell, 0: none
  CellGroups groups;

  [[nodiscard]] std::size_t cell_count() const { return cell_ends.size(); }
};

/// Is an array of this name the tags of entities, of groups? The names other programs give them count too.
[[nodiscard]] bool is_entity_array(std::string_view name);
[[nodiscard]] bool is_group_array(std::string_view name);

/// The mesh: strings of points and lines one by one, polygons cut into triangles. Without tags of entities the groups of the cells are
/// their entities.
/// @param place  stage of the reader and line of the arrays, for errors
/// @throws Error{ParseFailed} with the line of a cell of another kind, or of arrays that do not fit one another
[[nodiscard]] EntityMesh entity_mesh_of_grid(CellGrid grid, const TextPlace& place);

/// The cells of a mesh; each in the first group of its entity.
[[nodiscard]] CellGrid cell_grid_of(const EntityMesh& mesh);

}  // namespace mortise
