// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models as tables of JavaScript arrays.
#include <emscripten/bind.h>

#include <string>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/model_queries.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

template <class Items, class NumberOf>
val numbers_out(const Items& items, NumberOf number_of) {
  std::vector<std::uint32_t> numbers;
  for (const auto& item : items) numbers.push_back(static_cast<std::uint32_t>(number_of(item)));
  return copy_out(numbers);
}

template <class Items>
val ids_out(const Items& ids) {
  return numbers_out(ids, [](const auto& id) { return id.value; });
}

BrepRules rules_in(const val& settings) {
  BrepRules rules;
  rules.features.face_angle_deg = settings["faceAngle"].as<double>();
  if (!settings["weakAngle"].isUndefined()) rules.features.weak_angle_deg = settings["weakAngle"].as<double>();
  rules.features.least_dangling = settings["leastDangling"].as<std::uint32_t>();
  rules.features.splits_at_labels = settings["splitAtLabels"].as<bool>();
  std::vector<std::uint32_t> ends(settings["userEdges"]["length"].as<std::size_t>());
  copy_in<std::uint32_t>(settings["userEdges"], ends);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) rules.features.user_edges.push_back({VertexId(ends[i]), VertexId(ends[i + 1])});
  rules.edge_angle_deg = settings["edgeAngle"].as<double>();
  const auto seams = settings["seams"].as<std::string>();
  rules.seams = seams == "none" ? Seams::None : seams == "disc" ? Seams::Disc : Seams::Annulus;
  return rules;
}

template <class T>
std::vector<T> array_in(const val& array) {
  std::vector<T> numbers(array["length"].as<std::size_t>());
  copy_in<T>(array, numbers);
  return numbers;
}

/// @param sources  {provenance, operands} of the result of an operation
FaceNormals source_normals_in(const val& sources) {
  Provenance provenance;
  const val arrays = sources["provenance"];
  provenance.source_operand = array_in<std::uint32_t>(arrays["sourceOperand"]);
  provenance.source_face = array_in<std::uint32_t>(arrays["sourceFace"]);
  provenance.flipped = array_in<std::uint8_t>(arrays["flipped"]);
  std::vector<FaceNormals> normals;
  const auto count = sources["operands"]["length"].as<unsigned>();
  for (unsigned k = 0; k < count; ++k) {
    const SurfaceMesh operand = mesh_in(sources["operands"][k]);
    normals.push_back(measure_normals(operand, build_topology(operand)));
  }
  return source_normals(provenance, normals);
}

void set_entities(const Brep& brep, val& object) {
  object.set("edgeStart", numbers_out(brep.edges, [](const ModelEdge& e) { return e.start.value; }));
  object.set("edgeEnd", numbers_out(brep.edges, [](const ModelEdge& e) { return e.end.value; }));
  object.set("edgeIsSeam", numbers_out(brep.edges, [](const ModelEdge& e) { return e.is_seam; }));
  object.set("faceGenus", numbers_out(brep.faces, [](const ModelFace& f) { return f.genus; }));
  object.set("faceBehind", numbers_out(brep.faces, [](const ModelFace& f) { return f.region_behind.value; }));
  object.set("faceInFront", numbers_out(brep.faces, [](const ModelFace& f) { return f.region_in_front.value; }));
  object.set("loopStart", numbers_out(brep.loops, [](const ModelLoop& l) { return l.start.value; }));
  object.set("shellRegion", ids_out(brep.region_of_shell));
}

void set_adjacency(const Brep& brep, val& object) {
  object.set("loopsOfFaceBegin", copy_out(brep.loops_of_face.begin));
  object.set("usesOfLoopBegin", copy_out(brep.uses_of_loop.begin));
  object.set("useEdge", numbers_out(brep.uses_of_loop.items, [](const EdgeUse& u) { return u.edge.value; }));
  object.set("useIsReversed", numbers_out(brep.uses_of_loop.items, [](const EdgeUse& u) { return u.is_reversed; }));
  object.set("sidesOfShellBegin", copy_out(brep.sides_of_shell.begin));
  object.set("sideFace", numbers_out(brep.sides_of_shell.items, [](const FaceSide& s) { return s.face.value; }));
  object.set("sideIsFront", numbers_out(brep.sides_of_shell.items, [](const FaceSide& s) { return s.is_front; }));
  object.set("shellsOfRegionBegin", copy_out(brep.shells_of_region.begin));
  object.set("shellsOfRegion", ids_out(brep.shells_of_region.items));
  object.set("edgesOfVertexBegin", copy_out(brep.edges_of_vertex.begin));
  object.set("edgesOfVertex", ids_out(brep.edges_of_vertex.items));
  object.set("facesOfEdgeBegin", copy_out(brep.faces_of_edge.begin));
  object.set("faceOfEdge", numbers_out(brep.faces_of_edge.items, [](const FaceUse& u) { return u.face.value; }));
  object.set("faceOfEdgeIsReversed", numbers_out(brep.faces_of_edge.items, [](const FaceUse& u) { return u.is_reversed; }));
}

void set_classification(const Classification& on, val& object) {
  object.set("meshVertex", ids_out(on.mesh_vertex));
  object.set("pathBegin", copy_out(on.path.begin));
  object.set("path", ids_out(on.path.items));
  object.set("triangleFace", ids_out(on.face_of_triangle));
  object.set("vertexDimension", numbers_out(on.entity_of_vertex, [](const ModelEntity& e) { return e.dimension; }));
  object.set("vertexEntity", numbers_out(on.entity_of_vertex, [](const ModelEntity& e) { return e.id; }));
}

val measures_out(const ModelView& view, EntityDimension dimension) {
  std::vector<double> measures;
  for (std::uint32_t i = 0; i < entity_count(view.model.brep, dimension); ++i) measures.push_back(measure(view, {dimension, i}));
  return copy_out(measures);
}

/// @param settings  {faceAngle, weakAngle?, edgeAngle, leastDangling, splitAtLabels, userEdges, seams, sources?}
val model_of(const val& mesh_object, const val& settings) {
  return answer([&] {
    const SurfaceMesh mesh = mesh_in(mesh_object);
    const BrepRules rules = rules_in(settings);
    const val sources = settings["sources"];
    const ClassifiedBrep model = sources.isUndefined() ? build_brep(mesh, rules) : build_brep(mesh, rules, source_normals_in(sources));
    const ModelView view = view_of(mesh, model);
    val object = val::object();
    set_entities(model.brep, object);
    set_adjacency(model.brep, object);
    set_classification(model.classification, object);
    object.set("regionIsVoid", copy_out(find_voids(mesh, model)));
    object.set("edgeLength", measures_out(view, EntityDimension::Edge));
    object.set("faceArea", measures_out(view, EntityDimension::Face));
    object.set("regionVolume", measures_out(view, EntityDimension::Region));
    return object;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_model) { emscripten::function("modelOf", &model_of); }

}  // namespace mortise::wasm
