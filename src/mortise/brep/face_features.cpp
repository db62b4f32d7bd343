// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A tree for what is close, and shortest ways (Dijkstra 1959) as far as they matter.
#include "mortise/brep/face_features.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "mortise/base/sort_unique.h"
#include "mortise/geom/length.h"
#include "mortise/geom/placed_triangle.h"

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t no_piece = std::numeric_limits<std::uint32_t>::max();

Vec3d closest_on(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const PlacedTriangle placed = place_triangle({a, b, b}, 2);
  return in_space(placed, closest_in(placed, p).at);
}

constexpr double cos_75_deg = 0.25881904510252074;

bool is_towards(std::span<const Vec3d> directions, const Vec3d& way) {
  const double least = cos_75_deg * length(way);
  const auto is_one = [&](const Vec3d& d) { return dot(way, d) > least * length(d); };
  return directions.empty() || std::any_of(directions.begin(), directions.end(), is_one);
}

}  // namespace

std::vector<std::vector<ModelEdgeId>> edges_of_faces(const ClassifiedBrep& model) {
  std::vector<std::vector<ModelEdgeId>> edges_of_face(model.brep.faces.size());
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    if (model.brep.edges[ModelEdgeId(e)].is_seam) continue;
    for (const FaceUse& use : model.brep.faces_of_edge.of(ModelEdgeId(e))) {
      std::vector<ModelEdgeId>& edges = edges_of_face[use.face.index()];
      if (edges.empty() || edges.back() != ModelEdgeId(e)) edges.emplace_back(e);
    }
  }
  return edges_of_face;
}

FaceFeatures::FaceFeatures(const SurfaceMesh& mesh, const ClassifiedBrep& model, std::span<const ModelEdgeId> edges)
    : mesh_(mesh), model_(model) {
  std::vector<Box3> boxes;
  for (const ModelEdgeId e : edges) {
    const std::span<const VertexId> path = model.classification.path.of(e);
    vertices_.insert(vertices_.end(), path.begin(), path.end());
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      pieces_.push_back({path[k], path[k + 1]});
      boxes.emplace_back();
      for (const VertexId v : pieces_.back()) boxes.back().extend(at(v));
    }
  }
  tree_ = BoxTree(boxes);
  sort_unique(vertices_);
  ways_.assign(vertices_.size(), {infinity, 0});
  pieces_at_.resize(vertices_.size());
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    for (const VertexId v : pieces_[i]) pieces_at_[number_of(v)].push_back(i);
  }
}

FeaturePlace FaceFeatures::at_vertex(VertexId v) const { return {at(v), {{v, 0}}, no_piece}; }

FeaturePlace FaceFeatures::on_piece(std::uint32_t piece, double fraction) const {
  const auto& [a, b] = pieces_[piece];
  const Vec3d along = at(b) - at(a);
  const double whole = length(along);
  return {at(a) + fraction * along, {{a, fraction * whole}, {b, (1 - fraction) * whole}}, piece};
}

std::vector<ClosePart> FaceFeatures::parts_close_to(const FeaturePlace& place, double reach, double farthest_way,
                                                    std::span<const Vec3d> towards) {
  std::vector<ClosePart> parts;
  bool has_ways = false;
  const Vec3d by{reach, reach, reach};
  tree_.for_each_meeting({place.at - by, place.at + by}, [&](std::uint32_t i) {
    if (i == place.piece) return;
    const auto& [a, b] = pieces_[i];
    const Vec3d q = closest_on(at(a), at(b), place.at);
    const double gap = length(q - place.at);
    if (gap >= reach || !is_towards(towards, q - place.at)) return;
    if (!has_ways) find_ways(place, farthest_way);
    has_ways = true;
    const Way by_a = way_through(a), by_b = way_through(b);
    const double to_a = by_a.length + length(q - at(a)), to_b = by_b.length + length(q - at(b));
    parts.push_back({q, gap, std::min(to_a, to_b), to_b < to_a ? by_b.vertices : by_a.vertices});
  });
  return parts;
}

std::size_t FaceFeatures::number_of(VertexId v) const {
  return static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
}

void FaceFeatures::find_ways(const FeaturePlace& from, double farthest) {
  for (const std::size_t v : reached_) ways_[v] = {infinity, 0};
  reached_.clear();
  for (const auto& [v, way] : from.ends) reach(number_of(v), {way, 0});
  while (!next_.empty()) {
    std::pop_heap(next_.begin(), next_.end(), std::greater<>());
    const auto [way, v] = next_.back();
    next_.pop_back();
    if (way > ways_[v].length || way > farthest) continue;
    const Way through = way_through(vertices_[v]);
    for (const std::uint32_t i : pieces_at_[v]) {
      const auto& [a, b] = pieces_[i];
      reach(number_of(a == vertices_[v] ? b : a), {way + length(at(b) - at(a)), through.vertices});
    }
  }
}

void FaceFeatures::reach(std::size_t v, const Way& way) {
  if (way.length >= ways_[v].length) return;
  if (ways_[v].length == infinity) reached_.push_back(v);
  ways_[v] = way;
  next_.emplace_back(way.length, v);
  std::push_heap(next_.begin(), next_.end(), std::greater<>());
}

FaceFeatures::Way FaceFeatures::way_through(VertexId v) const {
  Way way = ways_[number_of(v)];
  const bool is_model_vertex = model_.classification.entity_of_vertex[v.index()].dimension == EntityDimension::Vertex;
  if (is_model_vertex && way.length < infinity) ++way.vertices;
  return way;
}

}  // namespace mortise
