// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes of the sizes wanted on the same model.
#include <emscripten/bind.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "model_tables.h"
#include "models.h"
#include "mortise/boolean/merge_small_features.h"
#include "mortise/brep/result_features.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/remesh/remesh.h"
#include "mortise/size/small_features.h"
#include "size_sources.h"
#include "sizings.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

RemeshRules remesh_rules_in(const val& settings) {
  RemeshRules rules = settings["isPaper"].as<bool>() ? paper_rules() : RemeshRules{};
  if (settings["isFrontal"].as<bool>()) rules.mesher = Mesher::Frontal;
  const val rounds = settings["rounds"];
  if (!rounds.isUndefined()) rules.rounds = emscripten::convertJSArrayToNumberVector<double>(rounds);
  rules.audits = settings["audits"].as<std::uint32_t>();
  rules.last_rounds = settings["lastRounds"].as<std::uint32_t>();
  rules.most_triangles = settings["mostTriangles"].as<double>();
  rules.most_deviation = settings["maxDeviation"].as<double>();
  rules.progress = progress_in(settings["listener"]);
  return rules;
}

/// {triangles, area, minAngleDeg, maxAngleDeg}.
val shape_out(const SurfaceMesh& mesh) {
  const FaceMeasures measures = measure_faces(mesh);
  const bool has_angles = !mesh.triangles.empty();
  val object = val::object();
  object.set("triangles", static_cast<double>(mesh.triangles.size()));
  object.set("area", measures.area);
  object.set("minAngleDeg", has_angles ? val(measures.angles.min_deg) : val::null());
  object.set("maxAngleDeg", has_angles ? val(measures.angles.max_deg) : val::null());
  return object;
}

/// Two vertices for each mesh edge on a model edge.
val model_edges_out(const Classification& on) {
  std::vector<std::uint32_t> ends;
  for (std::size_t e = 0; e + 1 < on.path.begin.size(); ++e) {
    for (std::uint32_t i = on.path.begin[e]; i + 1 < on.path.begin[e + 1]; ++i)
      ends.insert(ends.end(), {on.path.items[i].value, on.path.items[i + 1].value});
  }
  return copy_out(ends);
}

/// What may change: what is marked, or layers round the graph of a result; empty: everything.
std::vector<std::uint8_t> zone_in(const SurfaceMesh& mesh, const val& settings) {
  const val zone = settings["zone"], layers = settings["layers"];
  if (!zone.isUndefined()) return emscripten::convertJSArrayToNumberVector<std::uint8_t>(zone);
  if (layers.isUndefined()) return {};
  return layers_round(mesh, find_graph_edges(mesh, provenance_in(settings["provenance"])), layers.as<std::uint32_t>());
}

/// Features below this are debris, where nobody says otherwise.
double least_feature_in(const val& least, const SurfaceMesh& mesh) {
  if (!least.isUndefined()) return least.as<double>();
  const Box3 box = bounding_box(mesh);
  return mesh.triangles.empty() ? 1 : 1e-6 * length(box.hi - box.lo);
}

/// {mesh, sources, gone, unresolved, movedVertices, largestMove}.
/// @param given  as in given_model_in
/// @param settings  {least?, listener}
val merge_features(const val& given, const val& settings) {
  return answer([&] {
    const BuiltModel built = given_model_in(given);
    const double least = least_feature_in(settings["least"], built.mesh);
    const MergedFeatures merged = merge_small_features(built.mesh, built.model, least, progress_in(settings["listener"]));
    val object = val::object();
    object.set("mesh", mesh_out(merged.mesh));
    object.set("sources", ids_out(merged.sources));
    object.set("gone", ids_out(merged.gone));
    object.set("unresolved", ids_out(merged.unresolved));
    object.set("movedVertices", static_cast<double>(merged.moved_vertices));
    object.set("largestMove", merged.largest_move);
    return object;
  });
}

/// The sizes given, and those that small features ask for.
struct FeatureSizes {
  SizingProxy sizes;
  std::vector<SizeSource> features;
};

/// Sizes that are refused anyway are left alone.
/// @param features  undefined, or {growth, least?}
FeatureSizes sizes_with_features(const SizingProxy& given, const SurfaceMesh& mesh, const ClassifiedBrep& model, double most_triangles,
                                 const val& features) {
  if (features.isUndefined() || mesh.triangles.empty() || !(predict_triangle_count(mesh, given) <= most_triangles)) return {given, {}};
  const SmallFeatureRules rules{least_feature_in(features["least"], mesh), features["growth"].as<double>()};
  std::vector<SizeSource> found = find_small_features(mesh, model, given, rules).sources;
  SizingProxy sizes = given.with(found);
  return {std::move(sizes), std::move(found)};
}

RemeshResult remesh_with(const FeatureSizes& sized, const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals,
                         const RemeshRules& rules) {
  try {
    return remesh(mesh, model, normals, sized.sizes, rules);
  } catch (Error& error) {
    const bool may_be_features = error.code == ErrorCode::ResultTooLarge && !sized.features.empty();
    if (may_be_features) error.message += "; some for small features: features 'keep' leaves these as they are, minFeature those below it";
    throw;
  }
}

/// {mesh, sources, modelFaces, modelEdges, refinement, kept, newCrossings, predicted, before, after, tables?}.
/// @param given  as in given_model_in; a model is answered with its tables
/// @param settings  {features?, isPaper, isFrontal, rounds?, lastRounds, audits, zone?, layers?, provenance?, mostTriangles, maxDeviation,
/// listener}: layers are round the graph of that provenance, (stage, fraction) -> go on?
val remesh_mesh(const val& given, const val& settings, std::uint32_t sizing) {
  return answer([&] {
    const auto given_sizes = sizing_of(sizing);
    const BuiltModel built = given_model_in(given);
    const auto& [mesh, normals, model] = built;
    RemeshRules rules = remesh_rules_in(settings);
    rules.zone = zone_in(mesh, settings);
    const FeatureSizes sized = sizes_with_features(*given_sizes, mesh, model, rules.most_triangles, settings["features"]);
    const RemeshResult result = remesh_with(sized, mesh, model, normals, rules);
    std::vector<SizeSource> refinement = sized.features;
    refinement.insert(refinement.end(), result.refinement.begin(), result.refinement.end());
    val object = val::object();
    object.set("mesh", mesh_out(result.mesh));
    object.set("sources", ids_out(result.sources));
    object.set("modelFaces", ids_out(result.classification.face_of_triangle));
    object.set("modelEdges", model_edges_out(result.classification));
    object.set("refinement", segment_sources_out(refinement));
    object.set("kept", ids_out(result.kept));
    object.set("newCrossings", static_cast<double>(result.new_crossings.size()));
    object.set("predicted", predict_triangle_count(mesh, sized.sizes.with(result.refinement)));
    object.set("before", shape_out(mesh));
    object.set("after", shape_out(result.mesh));
    if (given["isModel"].as<bool>()) {
      const ClassifiedBrep remeshed{model.brep, result.classification};
      object.set("tables", tables_out(view_of(result.mesh, remeshed)));
    }
    return object;
  });
}

/// @param given  as in given_model_in
/// @param features  undefined, or as in sizes_with_features
val predict_triangles(const val& given, const val& features, std::uint32_t sizing) {
  return answer([&] {
    const auto given_sizes = sizing_of(sizing);
    if (features.isUndefined()) return predict_triangle_count(mesh_in(given["mesh"]), *given_sizes);
    const BuiltModel built = given_model_in(given);
    const double whatever = std::numeric_limits<double>::infinity();
    return predict_triangle_count(built.mesh, sizes_with_features(*given_sizes, built.mesh, built.model, whatever, features).sizes);
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_remesh) {
  emscripten::function("remesh", &remesh_mesh);
  emscripten::function("mergeFeatures", &merge_features);
  emscripten::function("predictTriangles", &predict_triangles);
}

}  // namespace mortise::wasm
