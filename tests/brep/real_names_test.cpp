// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Names of groups and solids of real files: in the results of operations, and in the files these are written to.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/attributes.h"
#include "mortise/brep/model_mesh.h"
#include "mortise/io/files.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/measures.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/models.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr std::array carriers{Format::Msh41, Format::Msh22, Format::Vtu, Format::Medit};

using Names = std::set<std::string>;
using Areas = std::map<std::string, double>;

/// Two solids of files, named in them; an empty file is a slab under the buildings.
struct NamedPair {
  const char* name;
  std::array<const char*, 2> files, moves;
};

constexpr std::array<NamedPair, 4> named_pairs{
    {{"a body and a fin", {"aircraft/cape_bullet.obj", "aircraft/cape_fin1.obj"}, {"", ""}},
     {"an aircraft and its engine", {"aircraft/cape_arrow_reference.obj", "aircraft/cape_engine.obj"}, {"", "t=0,0.01,0.02"}},
     {"two flanges", {"cad/flange.stl", "cad/flange.stl"}, {"", "rz=45 t=0,0,0.003"}},
     {"buildings on a slab", {"terrain/buildings_clean.obj", ""}, {"", ""}}}};

constexpr std::array<const char*, 5> exchanger_parts{"bottomAir", "leftSolid", "rightSolid", "topAir", "heater"};

/// What the lines "g NAME" of an OBJ and "solid NAME" of an STL say.
Names names_in_file(const std::string& file) {
  if (file.empty()) return {"ground"};
  const std::string word = file.substr(file.size() - 3) == "stl" ? "solid " : "g ";
  std::istringstream text(read_file(*data_folder() + "/" + file));
  Names names;
  for (std::string line; std::getline(text, line);) {
    if (line.substr(0, word.size()) == word) names.insert(line.substr(word.size(), line.find('\r') - word.size()));
  }
  return names;
}

SurfaceMesh read_part(const char* file, const char* moves) {
  if (*file != '\0') return read_data(file, moves);
  SurfaceMesh slab = box({0, 0, -5}, {250, 170, 0.5});
  slab.face_labels.assign(12, 0);
  slab.label_names = {"ground"};
  return slab;
}

SurfaceMesh carried(const SurfaceMesh& mesh, Format format) { return read_mesh(write_mesh(mesh, format), ""); }

double area_of(const std::vector<Vec3d>& points, const Triangle& t) {
  return triangle_area(points[t[0].index()], points[t[1].index()], points[t[2].index()]);
}

Areas areas_of_labels(const SurfaceMesh& mesh) {
  Areas areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    areas[mesh.face_labels.empty() ? "" : mesh.label_names[mesh.face_labels[t]]] += area_of(mesh.points, mesh.triangles[t]);
  }
  return areas;
}

/// Areas of all groups of faces that have triangles.
Areas areas_of_groups(const EntityMesh& mesh) {
  Areas areas;
  for (std::uint32_t n = 0; n < mesh.names.size(); ++n) {
    if (mesh.names[n].dimension != 2) continue;
    for (const std::uint32_t t : triangles_of_group(mesh, n)) areas[mesh.names[n].name] += area_of(mesh.points, mesh.triangles[t]);
  }
  return areas;
}

Areas sum_of(const std::vector<Areas>& lists) {
  Areas sum;
  for (const Areas& list : lists) {
    for (const auto& [name, area] : list) sum[name] += area;
  }
  return sum;
}

Names names_of(const Areas& areas) {
  Names names;
  for (const auto& [name, area] : areas) names.insert(name);
  return names;
}

void check_same(const Areas& found, const Areas& expected) {
  CHECK(names_of(found) == names_of(expected));
  for (const auto& [name, area] : expected) {
    INFO(name);
    if (found.count(name) != 0) CHECK(found.at(name) == Approx(area).epsilon(1e-12));
  }
}

/// Whatever a boolean of two solids takes away of a name, another one has.
void check_operations(const std::vector<SurfaceMesh>& solids, const Areas& whole,
                      const std::function<void(const SurfaceMesh&)>& check_file) {
  const std::vector<SurfaceMesh> reversed{solids[1], solids[0]};
  const SurfaceMesh united = evaluate(Operation::Union, solids).mesh, common = evaluate(Operation::Intersect, solids).mesh,
                    less = evaluate(Operation::Subtract, solids).mesh, rest = evaluate(Operation::Subtract, reversed).mesh,
                    parts = evaluate(Operation::Partition, solids).mesh;
  check_same(sum_of({areas_of_labels(united), areas_of_labels(common)}), whole);
  check_same(sum_of({areas_of_labels(less), areas_of_labels(rest)}), whole);
  check_same(areas_of_labels(parts), whole);
  for (const SurfaceMesh* result : {&united, &less, &parts}) check_file(*result);
}

/// Every label of an operand as an attribute of the faces that have it.
std::vector<Attribute> attributes_of_labels(const ModelView& view) {
  std::map<std::string, std::set<ModelEntity>> targets;
  for (std::size_t t = 0; t < view.mesh.triangles.size(); ++t) {
    targets[view.mesh.label_names[view.mesh.face_labels[t]]].insert(
        {EntityDimension::Face, view.model.classification.face_of_triangle[t].value});
  }
  std::vector<Attribute> attributes;
  for (const auto& [name, faces] : targets) {
    attributes.push_back({name, AttributeKind::BoundaryCondition, "null", {faces.begin(), faces.end()}, {}});
  }
  return attributes;
}

/// The attributes of a result whose operands have their labels, and names of their own for their regions.
std::vector<Attribute> named_attributes(const ResultModel& m, const std::vector<std::string>& names) {
  std::vector<std::vector<Attribute>> given;
  for (std::size_t k = 0; k < m.operands.size(); ++k) {
    given.push_back(attributes_of_labels(m.operands[k]));
    given.back().push_back({names[k], AttributeKind::Material, "null", {{EntityDimension::Region, 1}}, {}});
  }
  std::vector<OperandAttributes> operands;
  for (std::size_t k = 0; k < given.size(); ++k) operands.push_back({given[k], &m.operand_models[k].brep});
  return transfer_attributes(m.lineage, operands);
}

}  // namespace

TEST_CASE("names in real files are names in the result, after round trips of operands and result too", "[brep][io][scenario]") {
  if (is_data_missing()) return;
  for (const NamedPair& pair : named_pairs) {
    INFO(pair.name);
    std::vector<SurfaceMesh> solids;
    for (std::size_t k = 0; k < 2; ++k) solids.push_back(read_part(pair.files[k], pair.moves[k]));
    for (std::size_t k = 0; k < 2; ++k) CHECK(names_of(areas_of_labels(solids[k])) == names_in_file(pair.files[k]));
    const Areas whole = sum_of({areas_of_labels(solids[0]), areas_of_labels(solids[1])});
    if (is_reduced_run() && solids[0].triangles.size() + solids[1].triangles.size() > 10000) continue;
    check_operations(solids, whole, [](const SurfaceMesh&) {});
    for (const Format format : carriers) {
      INFO(format_name(format));
      const std::vector<SurfaceMesh> read{carried(solids[0], format), carried(solids[1], format)};
      check_operations(read, whole,
                       [&](const SurfaceMesh& result) { check_same(areas_of_labels(carried(result, format)), areas_of_labels(result)); });
    }
  }
}

TEST_CASE("a body and four fins in one call: all names of the five files", "[brep][io][scenario]") {
  if (is_data_missing()) return;
  std::vector<SurfaceMesh> solids;
  Names names;
  std::vector<Areas> areas;
  for (const char* part : {"bullet", "fin1", "fin2", "fin3", "fin4"}) {
    const std::string file = std::string("aircraft/cape_") + part + ".obj";
    solids.push_back(read_data(file));
    areas.push_back(areas_of_labels(solids.back()));
    names.merge(names_in_file(file));
  }
  const SurfaceMesh united = evaluate(Operation::Union, solids).mesh, less = evaluate(Operation::Subtract, solids).mesh;
  check_same(areas_of_labels(evaluate(Operation::Partition, solids).mesh), sum_of(areas));
  CHECK(names_of(areas_of_labels(united)) == names);
  // What the union keeps of the body, the difference keeps; the fins do not touch one another.
  const Areas of_union = areas_of_labels(united), of_difference = areas_of_labels(less);
  for (const auto& [name, area] : areas[0]) CHECK(of_difference.at(name) == Approx(of_union.at(name)).epsilon(1e-12));
  for (std::size_t k = 1; k < 5; ++k) {
    for (const auto& [name, area] : areas[k]) {
      const auto inside = of_difference.find(name);
      CHECK(of_union.at(name) + (inside == of_difference.end() ? 0 : inside->second) == Approx(area).epsilon(1e-12));
    }
  }
  for (const Format format : carriers) check_same(areas_of_labels(carried(united, format)), of_union);
}

TEST_CASE("models of results carry the names of real files into groups of faces", "[brep][io][scenario]") {
  if (is_data_missing()) return;
  for (const NamedPair& pair : named_pairs) {
    for (const Operation operation : {Operation::Union, Operation::Subtract, Operation::Partition}) {
      INFO(pair.name << ", " << operation_name(operation));
      const ResultModel m(operation, {read_part(pair.files[0], pair.moves[0]), read_part(pair.files[1], pair.moves[1])});
      const Areas expected = areas_of_labels(m.boolean.mesh);
      const EntityMesh mesh = entity_mesh_of(m.result, named_attributes(m, {"first", "second"}));
      check_same(areas_of_groups(mesh), expected);
      for (const Format format : carriers) {
        INFO(format_name(format));
        check_same(areas_of_groups(read_entity_mesh(write_entity_mesh(mesh, format), "")), expected);
      }
    }
  }
}

TEST_CASE("five solids of a heat exchange: regions and both sides of every face between them keep their names", "[brep][io][scenario]") {
  if (is_data_missing()) return;
  BooleanOptions options;
  options.tolerance = 1e-12;
  std::vector<SurfaceMesh> solids;
  std::vector<std::string> names;
  Names in_files;
  for (const char* part : exchanger_parts) {
    const std::string file = std::string("cad/cht_") + part + ".stl";
    names.emplace_back(part);
    solids.push_back(read_data(file));
    in_files.merge(names_in_file(file));
  }
  std::optional<Format> carrier;
  for (std::size_t i = 0; i <= carriers.size(); ++i) {
    if (i > 0) carrier = carriers[i - 1];
    INFO((carrier ? format_name(*carrier) : "as read"));
    std::vector<SurfaceMesh> operands;
    for (const SurfaceMesh& solid : solids) operands.push_back(carrier ? carried(solid, *carrier) : solid);
    const ResultModel m(Operation::Partition, operands, {}, options);
    const std::vector<Attribute> attributes = named_attributes(m, names);
    std::map<std::string, std::vector<ModelEntity>> targets;
    for (const Attribute& a : attributes) targets[a.name] = a.targets;

    // Regions, a name each.
    REQUIRE(m.model.brep.region_count == 6);
    std::map<std::uint32_t, std::string> region_names;
    for (const std::string& name : names) {
      REQUIRE(targets[name].size() == 1);
      CHECK(targets[name][0].dimension == EntityDimension::Region);
      region_names[targets[name][0].id] = name;
    }
    CHECK(region_names.size() == 5);

    // Faces between two have "a_to_b" and "b_to_a", and the name of the contact.
    const auto interfaces = interface_attributes(m.result, m.lineage, [&](const OperandEntity& e) { return names[e.operand]; });
    std::size_t between = 0;
    for (std::uint32_t f = 0; f < m.model.brep.faces.size(); ++f) {
      const ModelFace& face = m.model.brep.faces[ModelFaceId(f)];
      const auto behind = region_names.find(face.region_behind.value), in_front = region_names.find(face.region_in_front.value);
      if (behind == region_names.end() || in_front == region_names.end()) continue;
      ++between;
      const std::string &a = behind->second, &b = in_front->second;
      Names found;
      for (const auto* list : {&attributes, &interfaces}) {
        for (const Attribute& attribute : *list) {
          if (std::binary_search(attribute.targets.begin(), attribute.targets.end(), ModelEntity{EntityDimension::Face, f}))
            found.insert(attribute.name);
        }
      }
      const bool is_a_first = std::find(names.begin(), names.end(), a) < std::find(names.begin(), names.end(), b);
      CHECK(found == Names{a + "_to_" + b, b + "_to_" + a, "interface(" + (is_a_first ? a + ", " + b : b + ", " + a) + ")"});
    }
    CHECK(between == 13);

    // All names of the files, and the same ones with the same areas in files of the result.
    const EntityMesh mesh = entity_mesh_of(m.result, attributes);
    const Areas areas = areas_of_groups(mesh);
    CHECK(names_of(areas) == in_files);
    for (const Format format : carriers) check_same(areas_of_groups(read_entity_mesh(write_entity_mesh(mesh, format), "")), areas);
    Names of_regions;
    const EntityMesh read = read_entity_mesh(write_entity_mesh(mesh, Format::Msh41), "");
    for (const MeshEntity& region : read.entities[3]) {
      REQUIRE(region.names.size() == 1);
      of_regions.insert(read.names[region.names[0]].name);
    }
    CHECK(of_regions == Names(names.begin(), names.end()));
  }
}
