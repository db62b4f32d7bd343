// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cells and their arrays as a mesh of entities, and back.
#include "mortise/io/cell_grid.h"

#include <algorithm>
#include <limits>
#include <span>

#include "mortise/io/entity_mesh_builder.h"

namespace mortise {
namespace {

// VTK's numbers.
enum CellType : std::uint8_t { Vertex = 1, PolyVertex, Line, PolyLine, FlatTriangle, TriangleStrip, Polygon, Pixel, Quad, FirstVolume };
constexpr std::uint8_t last_volume = 16;

constexpr std::int64_t largest_tag = std::numeric_limits<std::int32_t>::max();

void check_type(std::uint8_t type, const TextPlace& place) {
  const std::string name = "cells of type " + std::to_string(int{type});
  if (type >= FirstVolume && type <= last_volume) {
    fail_at_line(ErrorCode::ParseFailed, place, "volume elements are not read yet (" + name + "): save the surface only");
  }
  if (type < Vertex || type == TriangleStrip || type > last_volume) {
    fail_at_line(ErrorCode::ParseFailed, place, name + " are not read: only points, lines and polygons with straight edges are");
  }
}

void check_corner_count(std::uint8_t type, std::size_t count, const TextPlace& place) {
  const bool fits = type == Vertex                    ? count == 1
                    : type == PolyVertex              ? count >= 1
                    : type == Line                    ? count == 2
                    : type == PolyLine                ? count >= 2
                    : type == FlatTriangle            ? count == 3
                    : (type == Pixel || type == Quad) ? count == 4
                                                      : count >= 3;
  if (!fits) {
    fail_at_line(ErrorCode::ParseFailed, place,
                 "a cell of type " + std::to_string(int{type}) + " has " + std::to_string(count) + (count == 1 ? " corner" : " corners"));
  }
}

std::size_t dimension_of(std::uint8_t type) { return type <= PolyVertex ? 0 : type <= PolyLine ? 1 : 2; }

/// Adds one cell, in as many elements as it takes.
void add_cell(std::uint8_t type, std::span<const std::uint32_t> corners, std::int64_t entity, EntityMeshBuilder& builder) {
  if (type == Pixel) {
    const std::array<std::uint32_t, 4> round{corners[0], corners[1], corners[3], corners[2]};
    return builder.add_element(round, entity);
  }
  if (dimension_of(type) == 2) return builder.add_element(corners, entity);
  const std::size_t size = dimension_of(type) + 1;
  for (std::size_t i = 0; i + size <= corners.size(); ++i) builder.add_element(corners.subspan(i, size), entity);
}

bool is_tag(std::int64_t number) { return number >= 1 && number <= largest_tag; }

/// The groups of the field data; their places in the builder.
std::vector<std::uint32_t> add_groups(const CellGroups& groups, const TextPlace& place, EntityMeshBuilder& builder) {
  const std::size_t count = groups.tags.size();
  if (groups.dimensions.size() != count || groups.names.size() != count) {
    fail_at_line(ErrorCode::ParseFailed, place, "the arrays of groups in the field data are not equally long");
  }
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t dimension = groups.dimensions[i];
    if (dimension < 0 || dimension > 3 || !is_tag(groups.tags[i])) {
      fail_at_line(ErrorCode::ParseFailed, place, "a group in the field data has a dimension or a tag that is out of range");
    }
    places.push_back(builder.group_of(static_cast<std::size_t>(dimension), static_cast<std::int32_t>(groups.tags[i])));
    builder.set_name(places.back(), groups.names[i]);
  }
  return places;
}

/// Further groups of entities that cells have.
void add_members(const CellGroups& groups, const std::vector<std::uint32_t>& places, const TextPlace& place, EntityMeshBuilder& builder) {
  const std::vector<std::int64_t>& members = groups.members;
  for (std::size_t i = 0; i + 2 < members.size(); i += 3) {
    const bool is_sound = members[i] >= 0 && members[i] <= 3 && is_tag(members[i + 1]) && members[i + 2] >= 0 &&
                          static_cast<std::size_t>(members[i + 2]) < places.size() &&
                          groups.dimensions[static_cast<std::size_t>(members[i + 2])] == members[i];
    if (!is_sound) fail_at_line(ErrorCode::ParseFailed, place, "a row of entity_groups in the field data does not fit the groups");
    const auto dimension = static_cast<std::size_t>(members[i]);
    builder.add_to_group(dimension, builder.entity_of(dimension, members[i + 1]), places[static_cast<std::size_t>(members[i + 2])]);
  }
}

void check_tags(const std::vector<std::int64_t>& tags, std::size_t cells, const TextPlace& place) {
  if (!tags.empty() && tags.size() != cells)
    fail_at_line(ErrorCode::ParseFailed, place, "an array of the cells is not as long as they are many");
  const auto is_large = [](std::int64_t tag) { return tag > largest_tag; };
  if (std::any_of(tags.begin(), tags.end(), is_large)) fail_at_line(ErrorCode::ParseFailed, place, "the tag of a cell is out of range");
}

}  // namespace

bool is_entity_array(std::string_view name) {
  return name == "entity" || name == "CellEntityIds" || name == "gmsh:geometrical" || name == "medit:ref";
}

bool is_group_array(std::string_view name) { return name == "group" || name == "gmsh:physical"; }

EntityMesh entity_mesh_of_grid(CellGrid grid, const TextPlace& place) {
  check_tags(grid.entities, grid.cell_count(), place);
  check_tags(grid.tags, grid.cell_count(), place);
  if (grid.types.size() != grid.cell_count()) fail_at_line(ErrorCode::ParseFailed, place, "there are not as many types as cells");
  EntityMeshBuilder builder;
  builder.points = std::move(grid.points);
  const std::vector<std::uint32_t> groups = add_groups(grid.groups, place, builder);
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < grid.cell_count(); ++i) {
    const TextPlace cell_place{place.stage, grid.lines[i]};
    const std::uint8_t type = grid.types[i];
    const std::span<const std::uint32_t> corners = std::span<const std::uint32_t>(grid.corners).subspan(begin, grid.cell_ends[i] - begin);
    check_type(type, cell_place);
    check_corner_count(type, corners.size(), cell_place);
    begin = grid.cell_ends[i];
    const std::int64_t group = grid.tags.empty() ? 0 : grid.tags[i];
    const std::int64_t entity = grid.entities.empty() ? group : grid.entities[i];
    add_cell(type, corners, entity, builder);
    if (!is_tag(group)) continue;
    const std::size_t dimension = dimension_of(type);
    builder.add_to_group(dimension, builder.entity_of(dimension, entity), builder.group_of(dimension, static_cast<std::int32_t>(group)));
  }
  add_members(grid.groups, groups, place, builder);
  return std::move(builder).finish();
}

namespace {

class GridWriter {
 public:
  explicit GridWriter(const EntityMesh& mesh) : mesh_(mesh) {}

  template <class Corners>
  void add_cell(CellType type, const Corners& corners, std::size_t dimension, std::uint32_t entity_index) {
    const MeshEntity& entity = mesh_.entities[dimension][entity_index];
    for (const VertexId vertex : corners) grid.corners.push_back(vertex.value);
    grid.cell_ends.push_back(static_cast<std::uint32_t>(grid.corners.size()));
    grid.types.push_back(type);
    grid.entities.push_back(entity.tag);
    grid.tags.push_back(entity.names.empty() ? 0 : mesh_.names[entity.names.front()].tag);
  }

  void add_groups() {
    for (const PhysicalName& name : mesh_.names) {
      grid.groups.dimensions.push_back(name.dimension);
      grid.groups.tags.push_back(name.tag);
      grid.groups.names.push_back(one_line_name(name.name));
    }
    for (std::size_t dimension = 0; dimension < 3; ++dimension) {
      for (const MeshEntity& entity : mesh_.entities[dimension]) {
        for (const std::uint32_t name : entity.names) {
          grid.groups.members.insert(grid.groups.members.end(), {static_cast<std::int64_t>(dimension), entity.tag, name});
        }
      }
    }
  }

  CellGrid grid;

 private:
  const EntityMesh& mesh_;
};

}  // namespace

CellGrid cell_grid_of(const EntityMesh& mesh) {
  GridWriter writer(mesh);
  writer.grid.points = mesh.points;
  for (std::size_t i = 0; i < mesh.point_elements.size(); ++i) {
    writer.add_cell(Vertex, std::array{mesh.point_elements[i]}, 0, mesh.point_entities[i]);
  }
  for (std::size_t i = 0; i < mesh.lines.size(); ++i) writer.add_cell(Line, mesh.lines[i], 1, mesh.line_entities[i]);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) writer.add_cell(FlatTriangle, mesh.triangles[i], 2, mesh.triangle_entities[i]);
  writer.add_groups();
  return std::move(writer.grid);
}

}  // namespace mortise
