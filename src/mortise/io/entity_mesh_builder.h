// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the readers of analysis files fill: elements by the tags of their entities, in any order.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// Collects an EntityMesh. A dimension is below 4, a tag fits 32 bits.
class EntityMeshBuilder {
 public:
  /// The points come before the polygons, which are cut up by where their corners are.
  std::vector<Vec3d> points;

  /// The entity with this tag, made when it is new. One below 1 is the file's way to say that there is none, and stands for an entity that
  /// finish() gives a free tag.
  [[nodiscard]] std::uint32_t entity_of(std::size_t dimension, std::int64_t tag);
  /// A tag below 0 that no entity has.
  [[nodiscard]] std::int64_t new_tag() { return --last_new_tag_; }
  void set_boundary(std::size_t dimension, std::uint32_t entity, std::vector<std::int32_t> boundary);

  /// The group with this tag, made when it is new, without a name.
  [[nodiscard]] std::uint32_t group_of(std::size_t dimension, std::int32_t tag);
  void set_name(std::uint32_t group, std::string_view name);
  /// Puts an entity into a group of its dimension, once.
  void add_to_group(std::size_t dimension, std::uint32_t entity, std::uint32_t group);

  /// One corner is a point, two are a line, more are a polygon, which is cut into triangles as build_mesh() does it: a corner equal to the
  /// one before is dropped where there are more than three, and none vanishes.
  void add_element(std::span<const std::uint32_t> corners, std::int64_t entity_tag);

  /// The mesh; entities ascending by tag, elements in the order they came in.
  [[nodiscard]] EntityMesh finish() &&;

 private:
  void add_polygon(std::span<const std::uint32_t> corners, std::uint32_t face);
  void add_triangle(const Triangle& triangle, std::uint32_t face);
  void resolve_tags(std::size_t dimension);
  void sort_entities(std::size_t dimension);

  EntityMesh mesh_;
  std::array<std::vector<std::int64_t>, 4> tags_;  ///< per entity, as they were asked for
  std::array<std::map<std::int64_t, std::uint32_t>, 4> entity_of_tag_;
  std::map<std::pair<std::size_t, std::int32_t>, std::uint32_t> group_of_tag_;
  std::set<std::array<std::uint32_t, 3>> members_;  ///< dimension, entity, group
  std::int64_t last_new_tag_ = 0;
};

}  // namespace mortise
