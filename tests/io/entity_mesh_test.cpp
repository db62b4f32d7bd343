// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Labels as named faces and back; what readers of analysis files collect.
#include "mortise/io/entity_mesh.h"

#include "io/io_support.h"
#include "mortise/io/entity_mesh_builder.h"

using namespace mortise;
using namespace mortise::test;

TEST_CASE("Every label that a triangle has becomes a named face, in the order of the labels") {
  SurfaceMesh mesh = awkward_tetrahedron();
  mesh.label_names = {"unused", "b", "", "a"};
  mesh.face_labels = {3, 1, 2, 3};
  const EntityMesh made = entity_mesh_of(mesh);
  CHECK((made.names == std::vector<PhysicalName>{{2, 1, "b"}, {2, 3, "a"}}));
  CHECK((made.entities[2] == std::vector<MeshEntity>{{1, {0}, {}}, {2, {}, {}}, {3, {1}, {}}}));
  CHECK(made.triangle_entities == std::vector<std::uint32_t>{2, 0, 1, 2});
  CHECK(face_names(surface_mesh_of(made)) == face_names(mesh));
}

TEST_CASE("A mesh without labels is one face without a name, and comes back without labels") {
  SurfaceMesh mesh = awkward_tetrahedron();
  mesh.face_labels.clear();
  mesh.label_names.clear();
  const EntityMesh made = entity_mesh_of(mesh);
  CHECK((made.entities[2] == std::vector<MeshEntity>{{1, {}, {}}}));
  CHECK(made.names.empty());
  CHECK(surface_mesh_of(made).face_labels.empty());
  CHECK(entity_mesh_of({}).entities[2].size() == 1);
}

TEST_CASE("Faces are labelled by their first name, or the number of their group") {
  const SurfaceMesh mesh = surface_mesh_of(two_regions());
  const std::string left = "left, outer \xC3\xA4";
  CHECK(mesh.label_names == std::vector<std::string>{left, "", "group 5"});
  CHECK(face_names(mesh) == std::vector<std::string>{"", "group 5", "", left, "", left, left});
  CHECK(mesh.points.size() == 6);
}

TEST_CASE("Several faces without any name are labelled by their tags") {
  EntityMesh mesh = two_regions();
  for (MeshEntity& face : mesh.entities[2]) face.names.clear();
  CHECK(surface_mesh_of(mesh).label_names == std::vector<std::string>{"surface 2", "surface 4", "surface 7"});
}

TEST_CASE("Faces of one name get one label") {
  EntityMesh mesh = two_regions();
  for (MeshEntity& face : mesh.entities[2]) face.names = {0};
  CHECK(surface_mesh_of(mesh).label_names == std::vector<std::string>{"wall"});
}

TEST_CASE("The triangles and nodes of a group are those of all its entities") {
  const EntityMesh mesh = two_regions();
  CHECK(triangles_of_group(mesh, 0) == std::vector<std::uint32_t>{3, 5, 6});
  CHECK(nodes_of_group(mesh, 2) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(nodes_of_group(mesh, 4) == std::vector<std::uint32_t>{1});
}

TEST_CASE("Entities without a tag get the lowest that are free, and all come ascending") {
  EntityMeshBuilder builder;
  builder.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (const std::int64_t tag : {0, 4, 1, -8}) builder.add_element(std::array<std::uint32_t, 3>{0, 1, 2}, tag);
  const EntityMesh mesh = std::move(builder).finish();
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{1, {}, {}}, {2, {}, {}}, {3, {}, {}}, {4, {}, {}}}));
  CHECK(mesh.triangle_entities == std::vector<std::uint32_t>{1, 3, 0, 2});
}

TEST_CASE("Polygons become triangles of their face, repeated corners dropped where more than three are left") {
  EntityMeshBuilder builder;
  builder.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  builder.add_element(std::array<std::uint32_t, 4>{0, 1, 2, 3}, 1);
  builder.add_element(std::array<std::uint32_t, 4>{0, 1, 1, 2}, 2);
  builder.add_element(std::array<std::uint32_t, 4>{3, 3, 3, 3}, 2);
  const EntityMesh mesh = std::move(builder).finish();
  CHECK(mesh.triangle_entities == std::vector<std::uint32_t>{0, 0, 1, 1});
  CHECK(mesh.triangles[2] == triangle(0, 1, 2));
  CHECK(mesh.triangles[3] == triangle(3, 3, 3));
}
