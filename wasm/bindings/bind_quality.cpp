// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How good the triangles of a mesh are, and how far it is from another. JavaScript knows the numbers by their places: wasm/src/quality.js.
#include <emscripten/bind.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "models.h"
#include "mortise/remesh/quality_table.h"
#include "size_sources.h"
#include "sizings.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

using Numbers = std::vector<double>;

template <class... Values>
void add(Numbers& numbers, Values... values) {
  (numbers.push_back(static_cast<double>(values)), ...);
}

void add(Numbers& numbers, const TriangleMarks& m) {
  add(numbers, m.count, m.least_angle_deg, m.greatest_angle_deg, m.permille_angle_deg, m.percent_angle_deg, m.median_angle_deg, m.below_30,
      m.above_115, m.least_radius_ratio, m.mean_radius_ratio, m.greatest_edge_ratio, m.mean_edge_ratio, m.greatest_growth);
}

void add(Numbers& numbers, const LengthMarks& m) {
  add(numbers, m.count, m.least, m.greatest, m.mean, m.in_band, m.greatest_growth);
  numbers.insert(numbers.end(), m.bins.begin(), m.bins.end());
}

void add(Numbers& numbers, const OneWayDistance& d) { add(numbers, d.greatest, d.in_sizes, d.at.x, d.at.y, d.at.z); }

Numbers numbers_of(const QualityReport& q) {
  Numbers numbers;
  add(numbers, q.all);
  add(numbers, q.free);
  add(numbers, q.edges);
  add(numbers, q.free_edges);
  add(numbers, q.obstacles.short_edges, q.obstacles.sharp_corners, q.obstacles.close_features, q.folds);
  numbers.insert(numbers.end(), q.valences.begin(), q.valences.end());
  return numbers;
}

Numbers numbers_of(const Deviation& d) {
  Numbers numbers;
  for (const OneWayDistance& way : {d.to_reference, d.from_reference, d.curves_to_reference, d.curves_from_reference}) add(numbers, way);
  for (const auto& [to, from] : d.of_faces) add(numbers, to, from);
  return numbers;
}

/// The numbers of model faces are those of the reference.
void number_faces(ClassifiedBrep& model, const std::vector<std::uint32_t>& faces, std::size_t count) {
  const bool are_there = std::all_of(faces.begin(), faces.end(), [&](std::uint32_t face) { return face < count; });
  if (!are_there) throw Error(ErrorCode::InvalidArgument, "", "modelFaces are not faces of the model of the reference");
  std::transform(faces.begin(), faces.end(), model.classification.face_of_triangle.begin(),
                 [](std::uint32_t face) { return ModelFaceId(face); });
  model.brep.faces.resize(count);
}

/// {numbers, deviation?, table}.
/// @param settings  those of rules_in, with refinement?: that of remesh, and reference?, as in given_model_in; with groups
///                  the mesh is as it is, and its groups are the faces of the reference
val measure_mesh(const val& mesh_object, const val& settings, std::uint32_t sizing) {
  return answer([&] {
    const auto given_sizes = sizing_of(sizing);
    const val refinement = settings["refinement"];
    const SizingProxy sizes = refinement.isUndefined() ? *given_sizes : given_sizes->with(segment_sources_in(refinement));
    const BrepRules rules = rules_in(settings);
    const bool is_classified = !rules.features.groups.empty();
    const SurfaceMesh mesh = is_classified ? mesh_in(mesh_object) : welded_mesh_in(mesh_object);
    ClassifiedBrep model = build_brep(mesh, rules);
    const QualityReport report = measure_quality(mesh, model, sizes);
    std::string table = quality_table(report);
    val object = val::object();
    object.set("numbers", copy_out(numbers_of(report)));
    if (!settings["reference"].isUndefined()) {
      const BuiltModel reference = in_operand(1, [&] { return given_model_in(settings["reference"]); });
      if (is_classified) number_faces(model, rules.features.groups, reference.model.brep.faces.size());
      const Matching matching = is_classified ? Matching::Faces : Matching::None;
      const Deviation deviation = measure_deviation(mesh, model, reference.mesh, reference.model, sizes, matching);
      object.set("deviation", copy_out(numbers_of(deviation)));
      table += deviation_table(deviation);
    }
    object.set("table", table);
    return object;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_quality) { emscripten::function("measureMesh", &measure_mesh); }

}  // namespace mortise::wasm
