// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models in files of analysis programs: what was written comes back, and what others wrote is placed.
#include "mortise/brep/named_model.h"

#include <algorithm>
#include <map>

#include "mortise/brep/model_mesh.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/shapes.h"
#include "support/catch.h"
#include "support/models.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr EntityDimension vertex = EntityDimension::Vertex, edge = EntityDimension::Edge, face = EntityDimension::Face,
                          region = EntityDimension::Region;

using Targets = std::map<std::string, std::vector<ModelEntity>>;

/// The targets of attributes by name, but those of names given to what had none.
Targets targets_of(const std::vector<Attribute>& attributes) {
  Targets targets;
  for (const Attribute& a : attributes) {
    const bool is_made_up = a.name.rfind("face ", 0) == 0 || a.name.rfind("region ", 0) == 0;
    if (!is_made_up) targets[a.name].insert(targets[a.name].end(), a.targets.begin(), a.targets.end());
  }
  return targets;
}

Attribute on(const std::string& name, std::vector<ModelEntity> targets) {
  return {name, AttributeKind::User, "null", std::move(targets), {}};
}

NamedModel read_back(const EntityMesh& mesh, Format format) {
  return named_model_of(read_entity_mesh(write_entity_mesh(mesh, format), ""));
}

}  // namespace

TEST_CASE("names on entities of every dimension come back from the files that hold them", "[brep][io]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  const std::vector<Attribute> given{on("corner", {{vertex, 5}}), on("rim", {{edge, 3}, {edge, 20}}), on("wet", {{face, 0}, {face, 9}}),
                                     on("hot", {{face, 0}}), on("oil", {{region, 2}, {region, 3}})};
  const EntityMesh mesh = entity_mesh_of(m.result, given);
  for (const Format format : {Format::Msh41, Format::Msh22, Format::Vtk, Format::Vtu, Format::Medit}) {
    CAPTURE(format_name(format));
    const NamedModel back = read_back(mesh, format);
    CHECK(back.model.brep.vertex_count == 22);
    CHECK(back.model.brep.edges.size() == 36);
    CHECK(back.model.brep.faces.size() == 18);
    CHECK(back.model.brep.region_count == 4);
    Targets expected = targets_of(given);
    if (format != Format::Msh41) expected.erase("oil");  // the others have no regions
    CHECK(targets_of(back.attributes) == expected);
  }
}

TEST_CASE("faces and lines of a file part faces where there is no crease", "[brep][io]") {
  const SurfaceMesh sheet = make_grid_sheet(2, 1, 2, 1);
  EntityMesh file;
  file.points = sheet.points;
  file.triangles = sheet.triangles;
  file.triangle_entities = {0, 0, 1, 1};
  file.names = {{2, 1, "left"}, {1, 1, "cut"}, {2, 2, ""}};
  file.entities[2] = {{1, {0}, {}}, {2, {2}, {}}};
  const NamedModel two = named_model_of(file);
  CHECK(two.model.brep.faces.size() == 2);
  CHECK(targets_of(two.attributes) == Targets{{"left", {{face, 0}}}, {"group 2", {{face, 1}}}});

  file.triangle_entities = {0, 0, 0, 0};
  CHECK(named_model_of(file).model.brep.faces.size() == 1);
  file.lines = {{VertexId(1), VertexId(4)}, {VertexId(0), VertexId(5)}};  // the second is a side of no triangle
  file.line_entities = {0, 0};
  file.entities[1] = {{1, {1}, {}}};
  const NamedModel cut = named_model_of(file);
  CHECK(cut.model.brep.faces.size() == 2);
  REQUIRE(targets_of(cut.attributes).count("cut") == 1);
  CHECK(targets_of(cut.attributes)["cut"].size() == 1);
  CHECK(targets_of(cut.attributes)["left"] == std::vector<ModelEntity>{{face, 0}, {face, 1}});
}

TEST_CASE("a region is found by the faces round it, with their senses or without", "[brep][io]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2})});
  EntityMesh mesh = entity_mesh_of(m.result, std::vector<Attribute>{on("inner", {{region, 2}}), on("outer", {{region, 1}})});
  REQUIRE(m.model.brep.region_count == 3);
  const Targets expected{{"inner", {{region, 2}}}, {"outer", {{region, 1}}}};
  CHECK(targets_of(named_model_of(mesh).attributes) == expected);
  for (MeshEntity& r : mesh.entities[3]) {
    for (std::int32_t& tag : r.boundary) tag = tag < 0 ? -tag : tag;
  }
  CHECK(targets_of(named_model_of(mesh).attributes)["inner"] == expected.at("inner"));
}

TEST_CASE("a partition is an operand again when its file says what bounds its regions", "[brep][io]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}), make_grid_sheet(9, 9, 1, 1)});
  const EntityMesh mesh = entity_mesh_of(m.result);
  REQUIRE(std::count(m.boolean.mesh.walls.begin(), m.boolean.mesh.walls.end(), 1) > 0);
  const SurfaceMesh back = read_mesh(write_entity_mesh(mesh, Format::Msh41), "");
  CHECK(back.walls == m.boolean.mesh.walls);
  const SurfaceMesh tool = box({-1, -1, -1}, {0.5, 0.5, 0.5});
  const SurfaceMesh cut = evaluate(Operation::Partition, {back, tool}).mesh;
  const SurfaceMesh expected = evaluate(Operation::Partition, {m.boolean.mesh, tool}).mesh;
  CHECK(cut.points == expected.points);
  CHECK(cut.triangles == expected.triangles);
  CHECK(cut.walls == expected.walls);
  CHECK(read_mesh(write_entity_mesh(mesh, Format::Vtk), "").walls.empty());
  EntityMesh unknown = mesh;
  unknown.entities[3][1].boundary.clear();
  CHECK(surface_mesh_of(unknown).walls.empty());
}

TEST_CASE("names made up for what had none do not join those a file brought", "[brep][io]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  const ClassifiedBrep model = build_brep(cube);
  const EntityMesh mesh = entity_mesh_of(view_of(cube, model), std::vector<Attribute>{on("face 4", {{face, 0}})});
  std::vector<std::string> names;
  for (const PhysicalName& name : mesh.names) names.push_back(name.name);
  CHECK(std::count(names.begin(), names.end(), "face 4") == 1);
  CHECK(std::count(names.begin(), names.end(), "face 4_2") == 1);
  CHECK(names.size() == 7);  // six faces, one region
}
