// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every model is built once for all its sources.
#include "size_sources.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "arrays.h"
#include "models.h"
#include "mortise/base/error.h"
#include "mortise/size/curvature_sources.h"
#include "mortise/size/graph_sources.h"
#include "mortise/size/model_sources.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

constexpr std::size_t numbers_of_segment = 9;

// Stays where it is: the view refers to it.
struct ViewedModel {
  explicit ViewedModel(const val& object)
      : built(model_in(object)), view(view_of(built.mesh, built.model)), attributes(attributes_in(object["attributes"])) {}
  ViewedModel(const ViewedModel&) = delete;
  ViewedModel& operator=(const ViewedModel&) = delete;

  BuiltModel built;
  ModelView view;
  std::vector<Attribute> attributes;
};

std::optional<double> number_if_any(const val& number) {
  return number.isUndefined() ? std::nullopt : std::optional<double>(number.as<double>());
}

std::vector<SizeSource> plain_source_in(const val& object, double growth) {
  const std::vector<Vec3d> corners = points_in(object["corners"]);
  const auto sizes = numbers_in<double>(object["sizes"]);
  SizeSource source;
  source.corner_count = static_cast<std::uint8_t>(corners.size());
  std::copy(corners.begin(), corners.end(), source.corners.begin());
  std::copy(sizes.begin(), sizes.end(), source.strengths.begin());
  source.growth = growth;
  if (sizes.size() > 1) source.order = sizes.size() == corners.size() ? StrengthOrder::Linear : StrengthOrder::Quadratic;
  return {source};
}

std::vector<SizeSource> graph_sources_in(const val& object, double growth) {
  const std::vector<Vec3d> points = points_in(object["points"]);
  const auto ends = numbers_in<std::uint32_t>(object["edges"]);
  std::vector<std::array<VertexId, 2>> edges;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) edges.push_back({VertexId(ends[i]), VertexId(ends[i + 1])});
  std::vector<SizeSource> sources = sources_of_graph(points, edges, growth);
  if (const std::optional<double> size = number_if_any(object["size"])) {
    for (SizeSource& source : sources) source.strengths[0] = *size;
  }
  return sources;
}

class SourceReader {
 public:
  explicit SourceReader(const val& models) : models_(models) {}

  [[nodiscard]] std::vector<SizeSource> read(const val& object) {
    std::vector<SizeSource> sources = read_kind(object["kind"].as<std::string>(), object, object["growth"].as<double>());
    for (SizeSource& source : sources) source.radius = object["radius"].as<double>();
    check_sources(sources);
    return sources;
  }

 private:
  [[nodiscard]] std::vector<SizeSource> read_kind(const std::string& kind, const val& object, double growth) {
    if (kind == "plain") return plain_source_in(object, growth);
    if (kind == "graph") return graph_sources_in(object, growth);
    if (kind == "vertexSizes") return sources_of_vertex_sizes(mesh_in(object["mesh"]), numbers_in<double>(object["sizes"]), growth);
    const ViewedModel& model = model_of(object["model"].as<std::uint32_t>());
    if (kind == "attributes") return sources_of_attributes(model.view, model.attributes, growth);
    if (kind == "edgeCount")
      return sources_for_edge_counts(model.view, object["count"].as<std::uint32_t>(), object["smallest"].as<double>(), growth);
    if (kind == "curvature") {
      const CurvatureRules rules{number_if_any(object["chordError"]), number_if_any(object["perTurn"]), object["smallest"].as<double>(),
                                 object["largest"].as<double>(), growth};
      return sources_of_curvature(model.view, rules, model.built.normals);
    }
    const ModelEntity entity{static_cast<EntityDimension>(object["entity"][0].as<unsigned>()), object["entity"][1].as<std::uint32_t>()};
    return sources_on(model.view, entity, object["size"].as<double>(), growth);
  }

  [[nodiscard]] const ViewedModel& model_of(std::uint32_t number) {
    std::unique_ptr<ViewedModel>& kept = built_[number];
    if (!kept) kept = std::make_unique<ViewedModel>(models_[number]);
    return *kept;
  }

  val models_;
  std::map<std::uint32_t, std::unique_ptr<ViewedModel>> built_;
};

}  // namespace

std::vector<SizeSource> size_sources_in(const val& object) {
  SourceReader reader(object["models"]);
  const val array = object["sources"];
  std::vector<SizeSource> sources;
  const auto count = array["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    try {
      const std::vector<SizeSource> added = reader.read(array[i]);
      sources.insert(sources.end(), added.begin(), added.end());
    } catch (Error& error) {
      error.message.insert(0, "sources[" + std::to_string(i) + "]: ");
      throw;
    }
  }
  return sources;
}

val segment_sources_out(const std::vector<SizeSource>& sources) {
  std::vector<double> numbers;
  for (const SizeSource& source : sources) {
    const Vec3d &from = source.corners[0], &to = source.corners[source.corner_count - 1];
    numbers.insert(numbers.end(), {from.x, from.y, from.z, to.x, to.y, to.z, source.strengths[0], source.growth, source.radius});
  }
  return copy_out(numbers);
}

std::vector<SizeSource> segment_sources_in(const val& array) {
  const auto numbers = numbers_in<double>(array);
  std::vector<SizeSource> sources;
  for (std::size_t i = 0; i + numbers_of_segment <= numbers.size(); i += numbers_of_segment) {
    const double* n = &numbers[i];
    sources.push_back(segment_source({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], n[7]));
    sources.back().radius = n[8];
  }
  return sources;
}

}  // namespace mortise::wasm
