// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models as files of analysis programs carry them.
#include "mortise/brep/model_mesh.h"

#include <algorithm>
#include <set>

#include "mortise/io/formats.h"
#include "mortise/io/gmsh_script.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "support/catch.h"
#include "support/models.h"

using namespace mortise;
using namespace mortise::test;

namespace {

std::vector<std::string> names_of(const EntityMesh& mesh, const MeshEntity& entity) {
  std::vector<std::string> names;
  for (const std::uint32_t n : entity.names) names.push_back(mesh.names[n].name);
  return names;
}

/// The volume that the bounding faces of a region enclose, as their signs say.
double volume_of(const EntityMesh& mesh, const MeshEntity& region) {
  SurfaceMesh boundary;
  boundary.points = mesh.points;
  for (const std::int32_t signed_tag : region.boundary) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.entities[2][mesh.triangle_entities[t]].tag != std::abs(signed_tag)) continue;
      const Triangle& c = mesh.triangles[t];
      boundary.triangles.push_back(signed_tag > 0 ? c : Triangle{c[0], c[2], c[1]});
    }
  }
  return enclosed_volume(boundary);
}

}  // namespace

TEST_CASE("regions of a partition are bounded by the faces round them, looking out", "[brep][io]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  const EntityMesh mesh = entity_mesh_of(m.result);
  CHECK(mesh.entities[0].size() == 22);
  CHECK(mesh.entities[1].size() == 36);
  CHECK(mesh.entities[2].size() == 18);
  REQUIRE(mesh.entities[3].size() == 3);
  std::multiset<double> volumes;
  for (const MeshEntity& region : mesh.entities[3]) volumes.insert(volume_of(mesh, region));
  CHECK(volumes == std::multiset<double>{1, 7, 7});
  CHECK(mesh.names.empty());
}

TEST_CASE("voids, seams and sheets in a region have no part in the boundaries of regions and faces", "[brep][io]") {
  const SurfaceMesh tube =
      joined({box({-5, -5, -5}, {5, 5, 5}), inside_out(make_cylinder(1, 2, 24)), moved(make_grid_sheet(1, 1, 1, 1), {3, 3, 3})});
  const ClassifiedBrep model = build_brep(tube);
  const EntityMesh mesh = entity_mesh_of(view_of(tube, model));
  REQUIRE(mesh.entities[3].size() == 1);
  CHECK(mesh.entities[3][0].boundary.size() == 6 + 3);
  CHECK(mesh.entities[1].size() == model.brep.edges.size() - 1);
  CHECK(volume_of(mesh, mesh.entities[3][0]) ==
        Approx(enclosed_volume(joined({box({-5, -5, -5}, {5, 5, 5}), inside_out(make_cylinder(1, 2, 24))}))));
}

TEST_CASE("names of labels and attributes arrive, and all of a named model is in groups", "[brep][io]") {
  SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  const ClassifiedBrep model = build_brep(cube);
  const ModelView view = view_of(cube, model);
  const std::vector<Attribute> attributes{
      {"steel", AttributeKind::Material, "1", {{EntityDimension::Region, 1}}, {}},
      {"clamped", AttributeKind::BoundaryCondition, "1", {{EntityDimension::Face, 2}, {EntityDimension::Edge, 0}}, {}}};
  const EntityMesh mesh = entity_mesh_of(view, attributes);
  CHECK(names_of(mesh, mesh.entities[3][0]) == std::vector<std::string>{"steel"});
  CHECK(names_of(mesh, mesh.entities[2][2]) == std::vector<std::string>{"clamped"});
  CHECK(names_of(mesh, mesh.entities[1][0]) == std::vector<std::string>{"clamped"});
  CHECK(names_of(mesh, mesh.entities[2][0]) == std::vector<std::string>{"face 1"});
  CHECK(names_of(mesh, mesh.entities[0][0]).empty());
  const EntityMesh read = read_entity_mesh(write_entity_mesh(mesh, Format::Msh41), "cube.msh");
  CHECK(read.points == mesh.points);
  CHECK(read.triangles == mesh.triangles);
  CHECK(names_of(read, read.entities[3][0]) == std::vector<std::string>{"steel"});
  CHECK(read.entities[3][0].boundary == mesh.entities[3][0].boundary);
}

TEST_CASE("a project for Gmsh defines every region by its faces, and names it", "[brep][io]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {1, 1, 1}), box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})});
  const std::vector<Attribute> attributes{{"steel", AttributeKind::Material, "1", {{EntityDimension::Region, 1}}, {}}};
  const GmshProject project = write_gmsh_project(entity_mesh_of(m.result, attributes), "boxes.msh");
  const std::string& script = project.script;
  CHECK(script.substr(0, 19) == "Merge \"boxes.msh\";\n");
  CHECK(script.find("Volume(1) = {1};") != std::string::npos);
  CHECK(script.find("Volume(2) = {2};") != std::string::npos);
  CHECK(script.find("Physical Volume(\"steel\", 1) = {1};") != std::string::npos);
  CHECK(script.find("Physical Volume(\"region 2\", 2) = {2};") != std::string::npos);
  const EntityMesh read = read_entity_mesh(project.mesh, "boxes.msh");
  CHECK(read.entities[3].empty());
  CHECK(read.triangles == m.boolean.mesh.triangles);
  for (const MeshEntity& face : read.entities[2]) CHECK(face.names.size() == 1);
}
