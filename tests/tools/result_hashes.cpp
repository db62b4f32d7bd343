// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Evaluates scenes and writes the raw arrays of operands and results, for scripts/compare-hashes.mjs to take hashes of.
// usage: result_hashes SCENES.txt OUT_FOLDER [DATA_FOLDER]   (without data, scenes that need it are left out)
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/io/files.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/inspect.h"
#include "mortise/mesh/round_to_float32.h"
#include "mortise/mesh/shape_by_name.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"

using namespace mortise;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<double> numbers_of(const std::vector<std::string>& words) {
  std::vector<double> numbers;
  for (const std::string& word : words) numbers.push_back(std::stod(word));
  return numbers;
}

Axis axis_named(char letter) {
  if (letter < 'x' || letter > 'z') throw std::invalid_argument(std::string("no axis is called ") + letter);
  return static_cast<Axis>(letter - 'x');
}

AffineMap map_of(const std::string& move) {
  const std::size_t equals = move.find('=');
  const std::string name = move.substr(0, equals);
  const std::vector<double> n = equals == std::string::npos ? std::vector<double>() : numbers_of(split(move.substr(equals + 1), ','));
  if (name == "s" && n.size() == 1) return scaling({n[0], n[0], n[0]});
  if (name == "t" && n.size() == 3) return translation({n[0], n[1], n[2]});
  if (name.size() == 2 && name[0] == 'r' && n.size() == 1) return rotation(axis_named(name[1]), n[0]);
  if (name.size() == 2 && name[0] == 'm' && n.empty()) return mirroring(axis_named(name[1]));
  throw std::invalid_argument("not a move: " + move);
}

SurfaceMesh source_of(const std::vector<std::string>& words, const fs::path& data) {
  if (words.at(0) != "make") return read_mesh_file((data / words[0]).string());
  return make_shape(words.at(1), numbers_of({words.begin() + 2, words.end()}));
}

/// @param text  "make torus 2 0.5 48 24 ; rx=90 t=1,2,3"
SurfaceMesh operand_of(const std::string& text, const fs::path& data) {
  const std::vector<std::string> halves = split(text, ';');
  SurfaceMesh mesh = source_of(words_of(halves.at(0)), data);
  if (halves.size() == 1) return mesh;
  for (const std::string& move : words_of(halves[1])) mesh = transform(mesh, map_of(move));
  return mesh;
}

bool needs_data(const std::vector<std::string>& operands) {
  for (const std::string& text : operands) {
    if (words_of(text).at(0) != "make") return true;
  }
  return false;
}

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
  write_array(prefix + "otherSourceBegin", provenance.other_source_begin);
  write_array(prefix + "otherSourceOperand", provenance.other_source_operand);
  write_array(prefix + "otherSourceFace", provenance.other_source_face);
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

/// Volume (0 when open), area, smallest and largest angle, length and area of contact.
void write_measures(const std::string& prefix, const BooleanResult& result) {
  const MeshReport report = inspect(result.mesh);
  const ContactMeasure& contact = result.report.contact;
  write_array(prefix + "measures", std::vector{report.volume.value_or(0), report.area, report.min_angle_deg, report.max_angle_deg,
                                               contact.length, contact.area});
}

/// Region ids begin with 1; nothing lies in front of a triangle.
void write_regions(const std::string& prefix, const BooleanResult& result) {
  const ResultRegions found = find_result_regions(result);
  std::vector<std::uint32_t> behind;
  for (const std::uint32_t region : found.region_of_facet) behind.push_back(region + 1);
  write_array(prefix + "regionLeft", behind);
  write_array(prefix + "regionRight", std::vector<std::uint32_t>(behind.size(), 0));
  std::vector<double> measures;
  for (const ResultRegion& region : found.regions) {
    measures.insert(measures.end(), {region.volume, region.area});
    for (const std::uint32_t operand : region.operands) measures.push_back(operand);
  }
  write_array(prefix + "regionMeasures", measures);
}

void write_result(const std::string& prefix, const BooleanResult& result) {
  write_surface(prefix, result.mesh);
  write_provenance(prefix, result.provenance);
  write_regions(prefix, result);
  write_graph(prefix, result.graph);
  write_measures(prefix, result);
  write_surface(prefix + "float32.", round_to_float32(result.mesh));
  for (const Format format : {Format::PlyAscii, Format::StlBinary}) {
    const std::string bytes = write_mesh(result.mesh, format);
    write_bytes(prefix + std::string(format_name(format)), bytes.data(), bytes.size());
  }
}

/// The arrays of a result, or the code of the error instead.
void write_outcome(const std::string& prefix, Operation operation, const std::vector<SurfaceMesh>& operands) {
  try {
    write_result(prefix, evaluate_boolean(operation, test::pointers_to(operands)));
  } catch (const Error& error) {
    const std::string_view code = error_code_name(error.code);
    write_bytes(prefix + "error", code.data(), code.size());
  }
}

void write_scene(const fs::path& folder, const test::Scene& scene) {
  fs::create_directories(folder);
  write_bytes(folder / "name", scene.name.data(), scene.name.size());
  for (std::size_t k = 0; k < scene.operands.size(); ++k) {
    write_surface((folder / ("operand" + std::to_string(k) + ".")).string(), scene.operands[k]);
  }
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract}) {
    write_outcome((folder / (std::string(operation_name(operation)) + ".")).string(), operation, scene.operands);
  }
}

/// Scenes of the list go to folders "listed-LINE".
void write_listed(const fs::path& list, const fs::path& out, const fs::path& data) {
  std::ifstream stream(list);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    const std::size_t colon = line.find(" : ");
    const std::vector<std::string> texts = split(line.substr(colon + 3), '|');
    if (needs_data(texts) && data.empty()) continue;
    test::Scene scene{line.substr(0, colon), {}};
    for (const std::string& text : texts) scene.operands.push_back(operand_of(text, data));
    write_scene(out / ("listed-" + std::to_string(number)), scene);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: result_hashes SCENES.txt OUT_FOLDER [DATA_FOLDER]\n", stderr);
    return 2;
  }
  try {
    write_listed(argv[1], argv[2], argc > 3 ? argv[3] : "");
    const std::vector<test::Scene> small = test::small_scenes();
    for (std::size_t i = 0; i < small.size(); ++i) write_scene(fs::path(argv[2]) / ("small-" + std::to_string(i)), small[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "result_hashes: %s\n", error.what());
    return 1;
  }
  return 0;
}
