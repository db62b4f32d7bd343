// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The booleans: meshes in, {mesh, report, graph, provenance} out.
#include <emscripten/bind.h>

#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/transform.h"
#include "prepared.h"
#include "report.h"
#include "steps.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

/// What JavaScript handed in. Copies of meshes live here; prepared operands stay for the call, even if its listener disposes of them.
struct Operands {
  std::deque<SurfaceMesh> meshes;
  std::vector<KeptOperand> kept;
  std::vector<Operand> operands;
  std::vector<std::size_t> half_spaces;
};

/// A mesh, or a prepared one and the steps that move it: {prepared, steps}.
Operand operand_in(const val& object, Operands& operands) {
  const val prepared = object["prepared"];
  if (prepared.isUndefined()) return Operand(operands.meshes.emplace_back(mesh_in(object)));
  operands.kept.push_back(prepared_operand(prepared.as<std::uint32_t>()));
  return Operand(*operands.kept.back(), map_of_steps(object["steps"]));
}

/// The box round all operands that are no half-spaces.
Box3 box_of(const Operands& operands) {
  Box3 box;
  for (const Operand& operand : operands.operands) box.extend(bounding_box(transform(operand.mesh(), operand.place())));
  return box;
}

/// Half-spaces {plane} are as large as the others need.
void put_half_spaces(const val& array, Operands& operands) {
  if (operands.half_spaces.empty()) return;
  const Box3 box = box_of(operands);
  for (const std::size_t i : operands.half_spaces) {
    const auto make = [&] { return make_half_space(plane_in(array[i]["plane"]), box); };
    const SurfaceMesh& mesh = operands.meshes.emplace_back(in_operand(i, make));
    operands.operands.insert(operands.operands.begin() + static_cast<std::ptrdiff_t>(i), Operand(mesh));
  }
}

Operands operands_in(const val& array) {
  Operands operands;
  const auto count = array["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    if (array[i]["plane"].isUndefined()) {
      operands.operands.push_back(in_operand(i, [&] { return operand_in(array[i], operands); }));
    } else {
      operands.half_spaces.push_back(i);
    }
  }
  put_half_spaces(array, operands);
  return operands;
}

/// @param settings  {listener: (stage, fraction) -> go on? or undefined, requireSolids, simplify, certify, coordinates, tolerance,
///                  contactMemory}
BooleanOptions options_in(const val& settings) {
  BooleanOptions options;
  options.contact_memory = static_cast<std::uint64_t>(settings["contactMemory"].as<double>());
  options.tolerance = settings["tolerance"].as<double>();
  options.require_solids = settings["requireSolids"].as<bool>();
  if (settings["certify"].as<std::string>() == "absolute") options.certify = CertificateLevel::Absolute;
  if (settings["coordinates"].as<std::string>() == "float32") options.coordinates = Coordinates::Float32;
  const std::string simplify = settings["simplify"].as<std::string>();
  options.simplify = simplify == "cut" ? Simplify::Cut : simplify == "coplanar" ? Simplify::Coplanar : Simplify::Off;
  options.progress = progress_in(settings["listener"]);
  return options;
}

Search search_in(const val& settings) { return settings["inspect"].as<bool>() ? Search::SelfIntersections : Search::Nothing; }

val lists_out(const std::vector<std::vector<std::uint32_t>>& lists) {
  val array = val::array();
  for (const std::vector<std::uint32_t>& list : lists) array.call<void>("push", copy_out(list));
  return array;
}

std::span<const std::uint8_t> category_codes(const std::vector<FacetCategory>& categories) {
  return {reinterpret_cast<const std::uint8_t*>(categories.data()), categories.size()};
}

val graph_out(const IntersectionGraph& graph) {
  val object = val::object();
  object.set("points", points_out(graph.points));
  object.set("edges", pairs_out(graph.edges));
  object.set("chains", lists_out(graph.chains));
  object.set("closedLoops", graph.closed_loops);
  object.set("openChains", graph.open_chains);
  return object;
}

/// Region ids begin with 1; 0 is outside.
val region_ids_out(const std::vector<std::uint32_t>& regions) {
  std::vector<std::uint32_t> ids;
  for (const std::uint32_t region : regions) ids.push_back(region == ResultRegions::none ? 0 : region + 1);
  return copy_out(ids);
}

/// Region ids per triangle: behind it, and in front of it, where nothing of a result lies but of a partition.
void set_regions(val& object, const ResultRegions& regions) {
  object.set("regionLeft", region_ids_out(regions.region_of_facet));
  const std::vector<std::uint32_t> outside(regions.region_of_facet.size(), ResultRegions::none);
  object.set("regionRight", region_ids_out(regions.region_in_front.empty() ? outside : regions.region_in_front));
}

val provenance_out(const Provenance& provenance, const ResultRegions& regions) {
  val object = val::object();
  object.set("sourceOperand", copy_out(provenance.source_operand));
  object.set("sourceFace", copy_out(provenance.source_face));
  object.set("flipped", copy_out(provenance.flipped));
  set_regions(object, regions);
  object.set("category", copy_out(category_codes(provenance.category)));
  object.set("categoryNames", strings_out({"outside", "inside", "onSame", "onOpposite"}));
  object.set("covering", copy_out(provenance.covering));
  object.set("coveringSets", lists_out(provenance.covering_sets));
  if (!provenance.covering_front.empty()) object.set("coveringFront", copy_out(provenance.covering_front));
  object.set("otherSourceBegin", copy_out(provenance.other_source_begin));
  object.set("otherSourceOperand", copy_out(provenance.other_source_operand));
  object.set("otherSourceFace", copy_out(provenance.other_source_face));
  object.set("otherSourceFlipped", copy_out(provenance.other_source_flipped));
  object.set("vertexOperand", copy_out(provenance.vertex_operand));
  object.set("vertexSource", copy_out(provenance.vertex_source));
  return object;
}

/// What was called, and with what.
struct Called {
  const OperandList& operands;
  const BooleanOptions& options;
  Search search;
};

val result_out(const Called& call, const BooleanResult& result) {
  val object = val::object();
  object.set("mesh", mesh_out(result.mesh));
  const ResultRegions regions = find_result_regions(result);
  object.set("report", boolean_report_out({call.operands.meshes(), call.options, result, regions}, call.search));
  object.set("graph", graph_out(result.graph));
  object.set("provenance", provenance_out(result.provenance, regions));
  return object;
}

val imprinted_operand_out(const ImprintedOperand& operand) {
  val object = mesh_out(operand.mesh);
  object.set("vertexIds", copy_out(operand.vertex_ids));
  object.set("facetIds", copy_out(operand.facet_ids));
  object.set("sourceVertex", copy_out(operand.source_vertex));
  object.set("sourceFace", copy_out(operand.source_face));
  object.set("category", copy_out(category_codes(operand.category)));
  return object;
}

using Evaluate = std::function<val(const Called&)>;

/// @param settings  {inspect}, and those of options_in
val answer_call(const val& meshes, const val& settings, const Evaluate& evaluate) {
  return answer([&] {
    const Operands given = operands_in(meshes);
    BooleanOptions options = options_in(settings);
    options.half_spaces = given.half_spaces;
    return evaluate({OperandList(given.operands), options, search_in(settings)});
  });
}

val evaluate(const std::string& operation, const val& meshes, const val& settings) {
  return answer_call(meshes, settings, [&](const Called& call) {
    return result_out(call, evaluate_boolean(operation_from_name(operation), call.operands, call.options));
  });
}

val combine(const std::string& expression, const val& meshes, const val& settings) {
  return answer_call(meshes, settings,
                     [&](const Called& call) { return result_out(call, evaluate_expression(expression, call.operands, call.options)); });
}

val keep(const val& tags, const val& meshes, const val& settings) {
  return answer_call(meshes, settings, [&](const Called& call) {
    return result_out(call, keep_faces(keep_mask(strings_in(tags)), call.operands, call.options));
  });
}

val implant_components(const std::string& contact, const val& meshes, const val& settings) {
  const ImplantContact kind = contact == "drop" ? ImplantContact::Drop : ImplantContact::Keep;
  return answer_call(meshes, settings, [&](const Called& call) { return result_out(call, implant(call.operands, kind, call.options)); });
}

/// The union of one operand resolves it.
val resolve_mesh(const val& mesh, const val& settings) {
  const val meshes = val::array();
  meshes.call<void>("push", mesh);
  return evaluate(std::string(operation_name(Operation::Union)), meshes, settings);
}

val imprint_operands(const val& meshes, const val& settings) {
  return answer_call(meshes, settings, [&](const Called& call) {
    const ImprintResult result = imprint(call.operands, call.options);
    val object = result_out(call, result.whole);
    val array = val::array();
    for (const ImprintedOperand& operand : result.operands) array.call<void>("push", imprinted_operand_out(operand));
    object.set("operands", array);
    return object;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_boolean) {
  emscripten::function("evaluateBoolean", &evaluate);
  emscripten::function("evaluateExpression", &combine);
  emscripten::function("keepFaces", &keep);
  emscripten::function("implant", &implant_components);
  emscripten::function("imprint", &imprint_operands);
  emscripten::function("resolve", &resolve_mesh);
}

}  // namespace mortise::wasm
