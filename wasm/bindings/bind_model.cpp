// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models of meshes, of results with what they inherit, and of files; models as files.
#include <emscripten/bind.h>

#include <array>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "model_tables.h"
#include "models.h"
#include "mortise/brep/model_mesh.h"
#include "mortise/brep/named_model.h"
#include "mortise/brep/result_features.h"
#include "mortise/io/formats.h"
#include "mortise/io/gmsh_script.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mesh/measures.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

/// {tables, recipe}.
val model_out(const SurfaceMesh& mesh, const ClassifiedBrep& model, const val& recipe) {
  val object = val::object();
  object.set("tables", tables_out(view_of(mesh, model)));
  object.set("recipe", recipe);
  return object;
}

/// @param settings  those of rules_in, and sources?
val model_of(const val& mesh_object, const val& settings) {
  return answer([&] {
    const SurfaceMesh mesh = mesh_in(mesh_object);
    const BrepRules rules = rules_in(settings);
    const val sources = settings["sources"];
    if (sources.isUndefined()) return model_out(mesh, build_brep(mesh, rules), recipe_out(rules, {}));
    const FaceNormals normals = source_normals_in(sources);
    return model_out(mesh, build_brep(mesh, rules, normals), recipe_out(rules, normals));
  });
}

/// {mesh, tables, recipe, attributes}.
val read_model(const val& bytes_array, const std::string& name, const val& settings) {
  return answer([&] {
    const std::string bytes = bytes_in(bytes_array);
    NamedModel named;
    if (is_analysis_format(detect_format(name, bytes))) {
      named = named_model_of(read_entity_mesh(bytes, name), rules_in(settings));
    } else {
      named.mesh = read_mesh(bytes, name);
      named.rules = rules_in(settings);
      named.model = build_brep(named.mesh, named.rules);
    }
    val object = model_out(named.mesh, named.model, recipe_out(named.rules, {}));
    object.set("mesh", mesh_out(named.mesh));
    object.set("attributes", attributes_out(named.attributes));
    return object;
  });
}

/// The models of the operands of a call, by number. They stay where they are: views refer to them.
class OperandModels {
 public:
  /// @param array  of {mesh, settings, attributes, carried}, or {plane} for a half-space as large as the others need
  explicit OperandModels(const val& array) {
    const auto count = array["length"].as<std::size_t>();
    models_.resize(count);
    attributes_.resize(count);
    Box3 box;
    for (std::size_t k = 0; k < count; ++k) {
      const val operand = array[k];
      if (!operand["plane"].isUndefined()) continue;
      in_operand(k, [&] { models_[k] = model_in(operand); });
      box.extend(bounding_box(models_[k].mesh));
      attributes_[k] = attributes_in(operand["attributes"]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const val plane = array[k]["plane"];
      if (!plane.isUndefined()) in_operand(k, [&] { models_[k] = half_space(make_half_space(plane_in(plane), box)); });
      add(k, plane.isUndefined() && array[k]["carried"].as<bool>());
    }
  }
  OperandModels(const OperandModels&) = delete;
  OperandModels& operator=(const OperandModels&) = delete;

  [[nodiscard]] std::span<const ModelView> views() const { return views_; }
  [[nodiscard]] std::span<const OperandAttributes> carried() const { return carried_; }

  [[nodiscard]] std::vector<FaceNormals> normals() const {
    std::vector<FaceNormals> normals;
    for (const BuiltModel& m : models_) normals.push_back(m.normals);
    return normals;
  }

  [[nodiscard]] std::vector<const Classification*> classifications() const {
    std::vector<const Classification*> classifications;
    for (const BuiltModel& m : models_) classifications.push_back(&m.model.classification);
    return classifications;
  }

  /// Of faces with attributes the name of the first.
  [[nodiscard]] std::map<OperandEntity, std::string> names_of_faces() const {
    std::map<OperandEntity, std::string> names;
    for (std::uint32_t k = 0; k < attributes_.size(); ++k) {
      for (const Attribute& a : attributes_[k]) {
        for (const ModelEntity& target : a.targets) names.emplace(OperandEntity{k, target}, a.name);
      }
    }
    return names;
  }

 private:
  static BuiltModel half_space(SurfaceMesh mesh) {
    BuiltModel built{std::move(mesh), {}, {}};
    built.normals = measure_normals(built.mesh, build_topology(built.mesh));
    built.model = build_brep(built.mesh, {}, built.normals);
    return built;
  }

  void add(std::size_t k, bool is_carried) {
    views_.push_back(view_of(models_[k].mesh, models_[k].model));
    carried_.push_back({{}, &models_[k].model.brep});
    if (is_carried) carried_.back().attributes = attributes_[k];
  }

  std::deque<BuiltModel> models_;
  std::deque<std::vector<Attribute>> attributes_;
  std::vector<ModelView> views_;
  std::vector<OperandAttributes> carried_;
};

/// Groups that tell apart what either does; those there are, if any, are categories of facets.
void add_groups(std::vector<std::uint32_t> added, std::vector<std::uint32_t>& groups) {
  constexpr std::uint32_t category_count = 4;
  for (std::size_t t = 0; t < groups.size() && t < added.size(); ++t) added[t] = category_count * added[t] + groups[t];
  groups = std::move(added);
}

/// {tables, recipe, attributes, interfaces, lineage}.
/// @param result  {mesh, provenance}
/// @param settings  those of rules_in, and {splitAtAttributes, graphEdges, names}: of the operands
val result_model(const val& result, const val& operand_array, const val& settings) {
  return answer([&] {
    const SurfaceMesh mesh = mesh_in(result["mesh"]);
    const OperandModels operands(operand_array);
    const Provenance provenance = provenance_in(result["provenance"]);
    check_provenance(provenance, mesh.triangles.size(), operands.views());
    BrepRules rules = rules_in(settings);
    if (settings["splitAtAttributes"].as<bool>())
      add_groups(group_by_attributes(provenance, operands.classifications(), operands.carried()), rules.features.groups);
    if (settings["graphEdges"].as<bool>()) {
      const std::vector<std::array<VertexId, 2>> graph = find_graph_edges(mesh, provenance);
      rules.features.user_edges.insert(rules.features.user_edges.end(), graph.begin(), graph.end());
    }
    const FaceNormals normals = source_normals(provenance, operands.normals());
    const ClassifiedBrep model = build_brep(mesh, rules, normals);
    const ModelView view = view_of(mesh, model);
    const Lineage lineage = trace_lineage(view, provenance, operands.views());
    const std::map<OperandEntity, std::string> names = operands.names_of_faces();
    const std::vector<std::string> operand_names = strings_in(settings["names"]);
    const auto name_of = [&](const OperandEntity& e) {
      const auto found = names.find(e);
      return operand_names[e.operand] + "." + (found == names.end() ? entity_name(e.entity) : found->second);
    };
    val object = model_out(mesh, model, recipe_out(rules, normals));
    object.set("attributes", attributes_out(transfer_attributes(lineage, operands.carried())));
    object.set("interfaces", attributes_out(interface_attributes(view, lineage, name_of)));
    object.set("lineage", lineage_out(lineage));
    return object;
  });
}

/// Labels part faces, but give no names: these are attributes.
EntityMesh entity_mesh_in(const val& model_object, const val& attributes) {
  BuiltModel built = model_in(model_object);
  built.mesh.face_labels.clear();
  built.mesh.label_names.clear();
  return entity_mesh_of(view_of(built.mesh, built.model), attributes_in(attributes));
}

val write_model(const val& model, const val& attributes, const std::string& format) {
  return answer([&] { return bytes_out(write_entity_mesh(entity_mesh_in(model, attributes), format_from_name(format))); });
}

/// {mesh, script}: bytes.
val gmsh_project(const val& model, const val& attributes, const std::string& mesh_file) {
  return answer([&] {
    const GmshProject project = write_gmsh_project(entity_mesh_in(model, attributes), mesh_file);
    val object = val::object();
    object.set("mesh", bytes_out(project.mesh));
    object.set("script", project.script);
    return object;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_model) {
  emscripten::function("modelOf", &model_of);
  emscripten::function("readModel", &read_model);
  emscripten::function("resultModel", &result_model);
  emscripten::function("writeModel", &write_model);
  emscripten::function("gmshProject", &gmsh_project);
}

}  // namespace mortise::wasm
