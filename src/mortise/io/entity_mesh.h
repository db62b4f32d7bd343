// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What files of analysis programs carry: elements of points, lines and surfaces, the entities of a model they belong to, named groups.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A named group of entities of one dimension: a material, a boundary condition. Gmsh calls it a physical group.
struct PhysicalName {
  std::uint8_t dimension = 2;  ///< 0 vertices, 1 edges, 2 faces, 3 regions
  std::int32_t tag = 1;        ///< positive, unique within its dimension
  std::string name{};          ///< empty: the group has a number only

  bool operator==(const PhysicalName&) const = default;
};

/// A vertex, an edge, a face or a region of a model.
struct MeshEntity {
  std::int32_t tag = 1;                  ///< positive, unique within its dimension
  std::vector<std::uint32_t> names{};    ///< indices into EntityMesh::names, of the entity's dimension, each once
  std::vector<std::int32_t> boundary{};  ///< tags of entities one dimension lower. Of a region: a face whose normal points out of it, minus
                                         ///< the tag of one whose normal points into it. Of a face: edges in order, minus those it runs
                                         ///< backwards along. Of an edge: its start and its end.

  bool operator==(const MeshEntity&) const = default;
};

/// Points, elements over them and the entities they mesh. Regions have no elements: their boundary says what they are.
struct EntityMesh {
  std::vector<Vec3d> points;
  std::vector<VertexId> point_elements;
  std::vector<std::array<VertexId, 2>> lines;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> point_entities, line_entities, triangle_entities;  ///< one per element: index into entities[0], [1], [2]
  std::array<std::vector<MeshEntity>, 4> entities;                              ///< by dimension
  std::vector<PhysicalName> names;
};

/// The mesh with a face, and its name, for every label that a triangle has, in the order of the labels; tags from 1. An empty label gives a
/// face without a name. A mesh without labels, or without triangles, is one face without a name. Data, walls and diagonals are left out.
[[nodiscard]] EntityMesh entity_mesh_of(const SurfaceMesh& mesh);

/// The triangles, labelled by the first name of their face, faces in their order; a name that is empty reads "group 7" by its tag, a face
/// without a name has the empty label. When no face has a name: "surface 7" by the tag of the face when several have triangles, no labels
/// when one has. Points stay as they are, those no triangle uses too. Where all regions say what bounds them, triangles that bound two
/// or none are walls.
[[nodiscard]] SurfaceMesh surface_mesh_of(const EntityMesh& mesh);

/// The name as people read it: "group 7", by its tag, where it is empty.
[[nodiscard]] std::string spoken_name(const PhysicalName& name);

/// The elements of every entity, ascending; `element_entities` is one of those of an EntityMesh.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> elements_of_entities(const std::vector<MeshEntity>& entities,
                                                                           const std::vector<std::uint32_t>& element_entities);

/// The triangles of the faces in a group, ascending; `name` is an index into EntityMesh::names, of dimension 2.
[[nodiscard]] std::vector<std::uint32_t> triangles_of_group(const EntityMesh& mesh, std::uint32_t name);

/// The vertices of the points or lines in a group, ascending, each once; the name is of dimension 0 or 1.
[[nodiscard]] std::vector<std::uint32_t> nodes_of_group(const EntityMesh& mesh, std::uint32_t name);

}  // namespace mortise
