// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the readers of analysis files fill.
#include "mortise/io/entity_mesh_builder.h"

#include <algorithm>

#include "mortise/mesh/triangulate_polygon.h"

namespace mortise {
namespace {

/// Drops corners equal to the one before, cyclically.
void drop_repeated_corners(std::vector<VertexId>& polygon) {
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
}

}  // namespace

std::uint32_t EntityMeshBuilder::entity_of(std::size_t dimension, std::int64_t tag) {
  const auto next = static_cast<std::uint32_t>(mesh_.entities[dimension].size());
  const auto [place, is_new] = entity_of_tag_[dimension].emplace(tag, next);
  if (is_new) {
    mesh_.entities[dimension].emplace_back();
    tags_[dimension].push_back(tag);
  }
  return place->second;
}

void EntityMeshBuilder::set_boundary(std::size_t dimension, std::uint32_t entity, std::vector<std::int32_t> boundary) {
  mesh_.entities[dimension][entity].boundary = std::move(boundary);
}

std::uint32_t EntityMeshBuilder::group_of(std::size_t dimension, std::int32_t tag) {
  const auto next = static_cast<std::uint32_t>(mesh_.names.size());
  const auto [place, is_new] = group_of_tag_.emplace(std::pair(dimension, tag), next);
  if (is_new) mesh_.names.push_back({static_cast<std::uint8_t>(dimension), tag, {}});
  return place->second;
}

void EntityMeshBuilder::set_name(std::uint32_t group, std::string_view name) { mesh_.names[group].name = name; }

void EntityMeshBuilder::add_to_group(std::size_t dimension, std::uint32_t entity, std::uint32_t group) {
  const bool is_new = members_.insert({static_cast<std::uint32_t>(dimension), entity, group}).second;
  if (is_new) mesh_.entities[dimension][entity].names.push_back(group);
}

void EntityMeshBuilder::add_element(std::span<const std::uint32_t> corners, std::int64_t entity_tag) {
  const std::size_t dimension = std::min<std::size_t>(corners.size() - 1, 2);
  const std::uint32_t entity = entity_of(dimension, entity_tag);
  if (dimension == 0) {
    mesh_.point_elements.emplace_back(corners[0]);
    mesh_.point_entities.push_back(entity);
  } else if (dimension == 1) {
    mesh_.lines.push_back({VertexId(corners[0]), VertexId(corners[1])});
    mesh_.line_entities.push_back(entity);
  } else {
    add_polygon(corners, entity);
  }
}

void EntityMeshBuilder::add_polygon(std::span<const std::uint32_t> corners, std::uint32_t face) {
  std::vector<VertexId> polygon;
  for (const std::uint32_t corner : corners) polygon.emplace_back(corner);
  if (polygon.size() > 3) drop_repeated_corners(polygon);
  while (polygon.size() < 3) polygon.push_back(polygon.back());
  if (polygon.size() == 3) return add_triangle({polygon[0], polygon[1], polygon[2]}, face);
  std::vector<Vec3d> positions;
  for (const VertexId corner : polygon) positions.push_back(points[corner.index()]);
  for (const auto& t : triangulate_polygon(positions).triangles) add_triangle({polygon[t[0]], polygon[t[1]], polygon[t[2]]}, face);
}

void EntityMeshBuilder::add_triangle(const Triangle& triangle, std::uint32_t face) {
  mesh_.triangles.push_back(triangle);
  mesh_.triangle_entities.push_back(face);
}

/// Entities without a tag of their own take the lowest ones that are free.
void EntityMeshBuilder::resolve_tags(std::size_t dimension) {
  std::int32_t free = 1;
  for (std::size_t i = 0; i < tags_[dimension].size(); ++i) {
    std::int64_t tag = tags_[dimension][i];
    if (tag < 1) {
      while (entity_of_tag_[dimension].count(free) > 0) ++free;
      tag = free++;
    }
    mesh_.entities[dimension][i].tag = static_cast<std::int32_t>(tag);
  }
}

void EntityMeshBuilder::sort_entities(std::size_t dimension) {
  std::vector<MeshEntity>& entities = mesh_.entities[dimension];
  std::vector<std::uint32_t> order(entities.size()), place(entities.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return entities[a].tag < entities[b].tag; });
  std::vector<MeshEntity> sorted;
  for (const std::uint32_t old : order) {
    place[old] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(std::move(entities[old]));
  }
  entities = std::move(sorted);
  if (dimension == 3) return;
  const std::array element_entities{&mesh_.point_entities, &mesh_.line_entities, &mesh_.triangle_entities};
  for (std::uint32_t& entity : *element_entities[dimension]) entity = place[entity];
}

EntityMesh EntityMeshBuilder::finish() && {
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    resolve_tags(dimension);
    sort_entities(dimension);
  }
  mesh_.points = std::move(points);
  return std::move(mesh_);
}

}  // namespace mortise
