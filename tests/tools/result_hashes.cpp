// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Evaluates scenes and writes the raw arrays of operands and results, for scripts/compare-hashes.mjs to take hashes of.
// usage: result_hashes SCENES.txt OUT_FOLDER   (scenes that need MORTISE_DATA are left out where it is not there)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/model_queries.h"
#include "mortise/geom/length.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/inspect.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/round_to_float32.h"
#include "mortise/remesh/deviation.h"
#include "mortise/remesh/quality_report.h"
#include "mortise/remesh/remesh.h"
#include "mortise/size/small_features.h"
#include "support/boolean_scenes.h"
#include "support/data.h"
#include "support/data_checks.h"
#include "support/scene_list.h"

using namespace mortise;
namespace fs = std::filesystem;

namespace {

void write_bytes(const fs::path& path, const void* data, std::size_t size) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  if (!stream) throw std::runtime_error("cannot write " + path.string());
}

template <class T>
void write_array(const fs::path& path, const std::vector<T>& values) {
  write_bytes(path, values.data(), values.size() * sizeof(T));
}

void write_surface(const std::string& prefix, const SurfaceMesh& mesh) {
  write_array(prefix + "positions", mesh.points);
  write_array(prefix + "triangles", mesh.triangles);
  for (const auto* channels : {&mesh.vertex_data, &mesh.corner_data}) {
    for (const DataChannel& c : *channels) write_array(prefix + "data." + c.name, c.values);
  }
  if (mesh.face_labels.empty()) return;
  write_array(prefix + "faceLabels", mesh.face_labels);
  std::string names;
  for (const std::string& name : mesh.label_names) names += name + '\n';
  write_bytes(prefix + "labelNames", names.data(), names.size());
}

void write_provenance(const std::string& prefix, const Provenance& provenance) {
  write_array(prefix + "sourceOperand", provenance.source_operand);
  write_array(prefix + "sourceFace", provenance.source_face);
  write_array(prefix + "flipped", provenance.flipped);
  write_array(prefix + "category", provenance.category);
  write_array(prefix + "covering", provenance.covering);
  std::vector<std::uint32_t> sets;
  for (const auto& set : provenance.covering_sets) sets.insert(sets.end(), set.begin(), set.end());
  write_array(prefix + "coveringSets", sets);
  if (!provenance.covering_front.empty()) write_array(prefix + "coveringFront", provenance.covering_front);
  write_array(prefix + "otherSourceBegin", provenance.other_source_begin);
  write_array(prefix + "otherSourceOperand", provenance.other_source_operand);
  write_array(prefix + "otherSourceFace", provenance.other_source_face);
  write_array(prefix + "otherSourceFlipped", provenance.other_source_flipped);
  write_array(prefix + "vertexOperand", provenance.vertex_operand);
  write_array(prefix + "vertexSource", provenance.vertex_source);
}

void write_graph(const std::string& prefix, const IntersectionGraph& graph) {
  write_array(prefix + "graphPoints", graph.points);
  write_array(prefix + "graphEdges", graph.edges);
  std::vector<std::uint32_t> chains;
  for (const auto& chain : graph.chains) chains.insert(chains.end(), chain.begin(), chain.end());
  write_array(prefix + "graphChains", chains);
}

/// The area, after writing: volume (0 when open), area, smallest and largest angle, length and area of contact, 1 when certified, 1 when
/// closed.
double write_measures(const std::string& prefix, const BooleanResult& result, const ResultRegions& regions) {
  MeshReport report = inspect(result.mesh);
  correct_by_regions(result, regions, report);
  const ContactMeasure& contact = result.report.contact;
  const bool is_certified = result.report.certificate.status == CertificateStatus::Certified;
  write_array(prefix + "measures", std::vector{report.volume.value_or(0), report.area, report.min_angle_deg, report.max_angle_deg,
                                               contact.length, contact.area, is_certified ? 1.0 : 0.0, report.closed ? 1.0 : 0.0});
  return report.area;
}

/// Region ids begin with 1; 0 is outside.
std::vector<std::uint32_t> region_ids(const std::vector<std::uint32_t>& regions) {
  std::vector<std::uint32_t> ids;
  for (const std::uint32_t region : regions) ids.push_back(region == ResultRegions::none ? 0 : region + 1);
  return ids;
}

void write_regions(const std::string& prefix, const ResultRegions& found) {
  write_array(prefix + "regionLeft", region_ids(found.region_of_facet));
  const std::vector<std::uint32_t> outside(found.region_of_facet.size(), ResultRegions::none);
  write_array(prefix + "regionRight", region_ids(found.region_in_front.empty() ? outside : found.region_in_front));
  std::vector<double> measures;
  for (const ResultRegion& region : found.regions) {
    measures.insert(measures.end(), {region.volume, region.area});
    for (const std::uint32_t operand : region.operands) measures.push_back(operand);
  }
  write_array(prefix + "regionMeasures", measures);
}

/// One number of every item, as the tables of the package have it.
template <class Items, class NumberOf>
void write_numbers(const fs::path& path, const Items& items, NumberOf number_of) {
  std::vector<std::uint32_t> numbers;
  for (const auto& item : items) numbers.push_back(static_cast<std::uint32_t>(number_of(item)));
  write_array(path, numbers);
}

void write_entities(const std::string& prefix, const Brep& brep) {
  write_numbers(prefix + "edgeStart", brep.edges, [](const ModelEdge& e) { return e.start.value; });
  write_numbers(prefix + "edgeEnd", brep.edges, [](const ModelEdge& e) { return e.end.value; });
  write_numbers(prefix + "edgeIsSeam", brep.edges, [](const ModelEdge& e) { return e.is_seam; });
  write_numbers(prefix + "faceGenus", brep.faces, [](const ModelFace& f) { return f.genus; });
  write_numbers(prefix + "faceBehind", brep.faces, [](const ModelFace& f) { return f.region_behind.value; });
  write_numbers(prefix + "faceInFront", brep.faces, [](const ModelFace& f) { return f.region_in_front.value; });
  write_array(prefix + "usesOfLoopBegin", brep.uses_of_loop.begin);
  write_numbers(prefix + "useEdge", brep.uses_of_loop.items, [](const EdgeUse& u) { return u.edge.value; });
  write_numbers(prefix + "useIsReversed", brep.uses_of_loop.items, [](const EdgeUse& u) { return u.is_reversed; });
  write_array(prefix + "sidesOfShellBegin", brep.sides_of_shell.begin);
  write_numbers(prefix + "sideFace", brep.sides_of_shell.items, [](const FaceSide& s) { return s.face.value; });
}

void write_model(const std::string& prefix, const SurfaceMesh& mesh) {
  const ClassifiedBrep model = build_brep(mesh);
  const ModelView view = view_of(mesh, model);
  write_entities(prefix, model.brep);
  write_array(prefix + "pathBegin", model.classification.path.begin);
  write_array(prefix + "path", model.classification.path.items);
  write_array(prefix + "triangleFace", model.classification.face_of_triangle);
  write_numbers(prefix + "vertexDimension", model.classification.entity_of_vertex, [](const ModelEntity& e) { return e.dimension; });
  write_numbers(prefix + "vertexEntity", model.classification.entity_of_vertex, [](const ModelEntity& e) { return e.id; });
  std::vector<double> volumes;
  for (std::uint32_t r = 0; r < model.brep.region_count; ++r) volumes.push_back(measure(view, {EntityDimension::Region, r}));
  write_array(prefix + "regionVolume", volumes);
}

struct Remeshed {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  const SizingProxy& sizes;
};

/// On the model as JavaScript finds it again, from faces and mesh edges.
void write_quality(const std::string& prefix, const RemeshResult& result, const Remeshed& from) {
  BrepRules rules;
  rules.seams = Seams::None;
  rules.features.face_angle_deg = 180;
  rules.features.splits_at_labels = false;
  for (const ModelFaceId face : result.classification.face_of_triangle) rules.features.groups.push_back(face.value);
  for (std::size_t e = 0; e < result.classification.path.size(); ++e) {
    const std::span<const VertexId> path = result.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 0; k + 1 < path.size(); ++k) rules.features.user_edges.push_back({path[k], path[k + 1]});
  }
  ClassifiedBrep model = build_brep(result.mesh, rules);
  const QualityReport q = measure_quality(result.mesh, model, from.sizes);
  model.classification.face_of_triangle = result.classification.face_of_triangle;
  model.brep.faces.resize(from.model.brep.faces.size());
  const Deviation d = measure_deviation(result.mesh, model, from.mesh, from.model, from.sizes, Matching::Faces);
  write_array(prefix + "quality", std::vector{q.all.least_angle_deg, q.all.mean_radius_ratio, static_cast<double>(q.free.count),
                                              q.edges.mean, q.edges.in_band, d.to_reference.greatest, d.from_reference.greatest,
                                              d.curves_to_reference.greatest, d.curves_from_reference.greatest});
}

/// With sizes for small features, of small results.
void write_predicted(const std::string& prefix, const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizes) {
  std::vector<double> predicted;
  if (mesh.triangles.size() <= 1000) {
    const Box3 box = bounding_box(mesh);
    const SmallFeatures small = find_small_features(mesh, model, sizes, {.least = 1e-6 * length(box.hi - box.lo)});
    predicted.push_back(predict_triangle_count(mesh, sizes.with(small.sources)));
  }
  write_array(prefix + "predicted", predicted);
}

/// In some two thousand triangles, of results that are not large and no needles.
void write_remeshed(const std::string& prefix, const SurfaceMesh& mesh, double area) {
  if (mesh.triangles.size() > 10000 || !(area > 0)) return;
  const Box3 box = bounding_box(mesh);
  const Vec3d extent = box.hi - box.lo;
  const double size = std::sqrt(area * 2.31 / 2000);
  if (std::max({extent.x, extent.y, extent.z}) > 300 * size) return;
  BrepRules rules;
  rules.seams = Seams::None;
  const FaceNormals normals = measure_normals(mesh, build_topology(mesh));
  const ClassifiedBrep model = build_brep(mesh, rules, normals);
  const SizingProxy sizes({}, {.global = size});
  const RemeshResult result = remesh(mesh, model, normals, sizes);
  write_array(prefix + "positions", result.mesh.points);
  write_array(prefix + "triangles", result.mesh.triangles);
  write_numbers(prefix + "sources", result.sources, [](FaceId t) { return t.value; });
  write_numbers(prefix + "modelFaces", result.classification.face_of_triangle, [](ModelFaceId f) { return f.value; });
  write_quality(prefix, result, {mesh, model, sizes});
  write_predicted(prefix, mesh, model, sizes);
}

void write_result(const std::string& prefix, const BooleanResult& result) {
  write_surface(prefix, result.mesh);
  write_provenance(prefix, result.provenance);
  const ResultRegions regions = find_result_regions(result);
  write_regions(prefix, regions);
  write_graph(prefix, result.graph);
  write_remeshed(prefix + "remeshed.", result.mesh, write_measures(prefix, result, regions));
  write_surface(prefix + "float32.", round_to_float32(result.mesh));
  write_model(prefix + "model.", result.mesh);
  for (const Format format : {Format::PlyAscii, Format::StlBinary, Format::Glb}) {
    const std::string bytes = write_mesh(result.mesh, format);
    write_bytes(prefix + std::string(format_name(format)), bytes.data(), bytes.size());
  }
}

void write_imprint(const std::string& prefix, const ImprintResult& result) {
  write_result(prefix, result.whole);
  for (std::size_t k = 0; k < result.operands.size(); ++k) {
    const ImprintedOperand& operand = result.operands[k];
    const std::string part = prefix + "part" + std::to_string(k) + ".";
    write_surface(part, operand.mesh);
    write_array(part + "vertexIds", operand.vertex_ids);
    write_array(part + "facetIds", operand.facet_ids);
    write_array(part + "sourceVertex", operand.source_vertex);
    write_array(part + "sourceFace", operand.source_face);
    write_array(part + "category", operand.category);
  }
}

/// The arrays of a result, or the code of the error instead.
void write_outcome(const std::string& prefix, const std::string& word, const std::vector<const SurfaceMesh*>& operands) {
  try {
    const auto [operation, options] = test::operation_word(word);
    if (operation == "imprint") return write_imprint(prefix, imprint(operands, options));
    write_result(prefix, test::evaluate_word(word, operands));
  } catch (const Error& error) {
    const std::string_view code = error_code_name(error.code);
    write_bytes(prefix + "error", code.data(), code.size());
  }
}

void write_operands(const fs::path& folder, const std::string& name, const std::vector<SurfaceMesh>& operands) {
  fs::create_directories(folder);
  write_bytes(folder / "name", name.data(), name.size());
  for (std::size_t k = 0; k < operands.size(); ++k) write_surface((folder / ("operand" + std::to_string(k) + ".")).string(), operands[k]);
}

/// All operands but the second, in every scene that is generated, carry data.
std::vector<SurfaceMesh> with_data(std::vector<SurfaceMesh> operands) {
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (k != 1) operands[k] = test::with_chart(std::move(operands[k]));
  }
  return operands;
}

void write_small_scene(const fs::path& folder, const test::Scene& scene) {
  const std::vector<SurfaceMesh> operands = with_data(scene.operands);
  write_operands(folder, scene.name, operands);
  for (const std::string& word : test::default_words()) {
    write_outcome((folder / (word + ".")).string(), word, test::pointers_to(operands));
  }
}

void write_listed_scene(const fs::path& folder, const test::ListedScene& scene) {
  std::vector<SurfaceMesh> operands;
  for (const std::string& text : scene.operands) operands.push_back(test::load_operand(text));
  if (!scene.needs_data) operands = with_data(std::move(operands));
  write_operands(folder, scene.name, operands);
  for (const test::ListedEvaluation& evaluation : scene.evaluations) {
    std::vector<const SurfaceMesh*> chosen;
    for (const std::size_t i : evaluation.order) chosen.push_back(&operands[i]);
    write_outcome((folder / (evaluation.name + ".")).string(), evaluation.word, chosen);
  }
}

/// Scenes of the list go to folders "listed-LINE", small scenes to "small-NUMBER".
void write_scenes(const fs::path& list, const fs::path& out) {
  for (const test::ListedScene& scene : test::read_scene_list(list.string())) {
    if (!scene.needs_data || test::data_folder()) write_listed_scene(out / ("listed-" + std::to_string(scene.line)), scene);
  }
  const std::vector<test::Scene> small = test::small_scenes();
  for (std::size_t i = 0; i < small.size(); ++i) write_small_scene(out / ("small-" + std::to_string(i)), small[i]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: result_hashes SCENES.txt OUT_FOLDER\n", stderr);
    return 2;
  }
  try {
    write_scenes(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "result_hashes: %s\n", error.what());
    return 1;
  }
  return 0;
}
