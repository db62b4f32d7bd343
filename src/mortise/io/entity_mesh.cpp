// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Labels of a surface mesh as named faces of a model, and back.
#include "mortise/io/entity_mesh.h"

#include <algorithm>
#include <map>

#include "mortise/io/polygon_soup.h"

namespace mortise {
namespace {

constexpr std::uint32_t unused = 0xffffffffU;

/// For each label the number of its face, counting those that triangles have.
std::vector<std::uint32_t> number_used_labels(const SurfaceMesh& mesh) {
  std::vector<std::uint32_t> face_of_label(mesh.label_names.size(), unused);
  for (const std::uint32_t label : mesh.face_labels) face_of_label[label] = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& face : face_of_label) {
    if (face != unused) face = next++;
  }
  return face_of_label;
}

void add_face(const std::string& label, EntityMesh& mesh) {
  const auto tag = static_cast<std::int32_t>(mesh.entities[2].size() + 1);
  mesh.entities[2].push_back({tag});
  if (label.empty()) return;
  mesh.entities[2].back().names = {static_cast<std::uint32_t>(mesh.names.size())};
  mesh.names.push_back({2, tag, label});
}

bool has_names(const std::vector<MeshEntity>& entities) {
  return std::any_of(entities.begin(), entities.end(), [](const MeshEntity& e) { return !e.names.empty(); });
}

/// A label for every face.
std::vector<std::string> labels_of_faces(const EntityMesh& mesh) {
  const bool is_named = has_names(mesh.entities[2]);
  std::vector<std::string> labels;
  for (const MeshEntity& face : mesh.entities[2]) {
    if (!face.names.empty()) {
      labels.push_back(spoken_name(mesh.names[face.names.front()]));
    } else {
      labels.push_back(is_named ? std::string() : "surface " + std::to_string(face.tag));
    }
  }
  return labels;
}

/// Per face: does it bound two regions, or none? Empty when there are no regions, or one does not say what bounds it.
std::vector<bool> find_wall_faces(const EntityMesh& mesh) {
  const std::vector<MeshEntity>& regions = mesh.entities[3];
  if (std::any_of(regions.begin(), regions.end(), [](const MeshEntity& r) { return r.boundary.empty(); })) return {};
  std::map<std::int64_t, std::size_t> region_count;
  for (const MeshEntity& region : regions) {
    for (const std::int64_t tag : region.boundary) ++region_count[tag < 0 ? -tag : tag];
  }
  std::vector<bool> is_wall;
  for (const MeshEntity& face : mesh.entities[2]) is_wall.push_back(!regions.empty() && region_count[face.tag] != 1);
  return is_wall;
}

/// Per triangle: is it a wall? Empty when none is.
std::vector<std::uint8_t> find_walls(const EntityMesh& mesh) {
  const std::vector<bool> is_wall = find_wall_faces(mesh);
  if (std::find(is_wall.begin(), is_wall.end(), true) == is_wall.end()) return {};
  std::vector<std::uint8_t> walls;
  for (const std::uint32_t face : mesh.triangle_entities) walls.push_back(is_wall[face] ? 1 : 0);
  return walls;
}

/// Per entity of the dimension of a group: is it in the group?
std::vector<bool> find_members(const EntityMesh& mesh, std::uint32_t name) {
  std::vector<bool> is_member;
  for (const MeshEntity& entity : mesh.entities[mesh.names[name].dimension]) {
    is_member.push_back(std::find(entity.names.begin(), entity.names.end(), name) != entity.names.end());
  }
  return is_member;
}

}  // namespace

EntityMesh entity_mesh_of(const SurfaceMesh& mesh) {
  EntityMesh made;
  made.points = mesh.points;
  made.triangles = mesh.triangles;
  if (mesh.face_labels.empty()) {
    add_face({}, made);
    made.triangle_entities.assign(mesh.triangles.size(), 0);
    return made;
  }
  const std::vector<std::uint32_t> face_of_label = number_used_labels(mesh);
  for (std::size_t label = 0; label < mesh.label_names.size(); ++label) {
    if (face_of_label[label] != unused) add_face(mesh.label_names[label], made);
  }
  for (const std::uint32_t label : mesh.face_labels) made.triangle_entities.push_back(face_of_label[label]);
  return made;
}

SurfaceMesh surface_mesh_of(const EntityMesh& mesh) {
  SurfaceMesh made;
  made.points = mesh.points;
  made.triangles = mesh.triangles;
  made.walls = find_walls(mesh);
  const std::vector<std::vector<std::uint32_t>> parts = elements_of_entities(mesh.entities[2], mesh.triangle_entities);
  const auto used = std::count_if(parts.begin(), parts.end(), [](const auto& part) { return !part.empty(); });
  if (used == 0 || (used == 1 && !has_names(mesh.entities[2]))) return made;
  const std::vector<std::string> labels = labels_of_faces(mesh);
  LabelTable table;
  made.face_labels.resize(mesh.triangles.size());
  for (std::size_t face = 0; face < parts.size(); ++face) {
    if (parts[face].empty()) continue;
    const std::uint32_t label = table.label_of(labels[face]);
    for (const std::uint32_t triangle : parts[face]) made.face_labels[triangle] = label;
  }
  made.label_names = table.names();
  return made;
}

std::string spoken_name(const PhysicalName& name) { return name.name.empty() ? "group " + std::to_string(name.tag) : name.name; }

std::vector<std::vector<std::uint32_t>> elements_of_entities(const std::vector<MeshEntity>& entities,
                                                             const std::vector<std::uint32_t>& element_entities) {
  std::vector<std::vector<std::uint32_t>> parts(entities.size());
  for (std::size_t i = 0; i < element_entities.size(); ++i) parts[element_entities[i]].push_back(static_cast<std::uint32_t>(i));
  return parts;
}

std::vector<std::uint32_t> triangles_of_group(const EntityMesh& mesh, std::uint32_t name) {
  const std::vector<bool> is_member = find_members(mesh, name);
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (is_member[mesh.triangle_entities[i]]) triangles.push_back(i);
  }
  return triangles;
}

std::vector<std::uint32_t> nodes_of_group(const EntityMesh& mesh, std::uint32_t name) {
  const std::vector<bool> is_member = find_members(mesh, name);
  std::vector<std::uint32_t> nodes;
  const bool is_of_points = mesh.names[name].dimension == 0;
  for (std::size_t i = 0; is_of_points && i < mesh.point_elements.size(); ++i) {
    if (is_member[mesh.point_entities[i]]) nodes.push_back(mesh.point_elements[i].value);
  }
  for (std::size_t i = 0; !is_of_points && i < mesh.lines.size(); ++i) {
    if (is_member[mesh.line_entities[i]]) nodes.insert(nodes.end(), {mesh.lines[i][0].value, mesh.lines[i][1].value});
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace mortise
