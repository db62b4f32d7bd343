// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/bound_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace mortise {
namespace {

constexpr int most_rounds = 40, rounds_without_gain = 3;
constexpr double gain = 0.9;                                                     // of what deviates at most, for a round to be one
constexpr int layers = 3;                                                        // of triangles round a place that may change
constexpr double finer_than_needed = 0.8, most_finer = 0.25, least_finer = 0.7;  // of the size
constexpr double reach = 1;                                                      // of the smaller size, in sizes
constexpr double growth = 1.2;
constexpr double finest = 1.2;  // of the bound

using Marks = std::vector<std::uint8_t>;

/// The triangles there are, without holes.
struct LiveTriangles {
  SurfaceMesh mesh;
  std::vector<ModelFaceId> faces;
  std::vector<FaceId> numbers;
};

LiveTriangles live_triangles(const EditMesh& mesh) {
  LiveTriangles live;
  live.mesh.points = mesh.points;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!mesh.has(FaceId(t))) continue;
    live.mesh.triangles.push_back(mesh.triangle(FaceId(t)));
    live.faces.push_back(mesh.face(FaceId(t)));
    live.numbers.emplace_back(t);
  }
  return live;
}

// The deviation of a smooth surface goes with the square of the size. No point of a triangle that small is beyond the bound from a corner,
// which lies on the surface; what is lost of the given mesh then is lost.
SizeSource finer_source(const PlaceBeyond& place, double size, double bound) {
  const double finer = std::clamp(finer_than_needed * std::sqrt(bound / place.distance), most_finer, least_finer);
  SizeSource source = point_source(place.at, std::max(finer * size, finest * bound), growth);
  source.radius = reach * size;
  return source;
}

// One source for each triangle of the mesh, at the farthest place of it or that it is closest to.
void add_finer_sources(const DeviatingPlaces& places, const SizingProxy& sizes, double bound, std::vector<SizeSource>& sources) {
  std::map<FaceId, PlaceBeyond> farthest;
  const auto note = [&](FaceId t, const PlaceBeyond& place) {
    const auto [at, is_new] = farthest.emplace(t, place);
    if (!is_new && place.distance > at->second.distance) at->second = place;
  };
  for (const PlaceBeyond& place : places.of_mesh) note(place.triangle, place);
  for (const PlaceBeyond& place : places.of_given) note(place.closest, place);
  for (const auto& [t, place] : farthest) sources.push_back(finer_source(place, sizes.size_at(place.at), bound));
}

// Only what is in so many layers round the triangles of places may change, and what might before.
void limit_to(WorkingMesh& w, const DeviatingPlaces& places, const Marks& was_frozen, const Marks& was_fixed) {
  Marks is_reached(w.mesh.vertex_count(), 0), is_open(w.mesh.triangle_count(), 0);
  const auto open = [&](FaceId t) {
    is_open[t.index()] = 1;
    for (const VertexId v : w.mesh.triangle(t)) is_reached[v.index()] = 1;
  };
  for (const PlaceBeyond& place : places.of_mesh) open(place.triangle);
  for (const PlaceBeyond& place : places.of_given) {
    if (place.closest.is_valid()) open(place.closest);
  }
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<FaceId> next;
    for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
      if (!w.mesh.has(FaceId(t)) || is_open[t] != 0) continue;
      const Triangle corners = w.mesh.triangle(FaceId(t));
      if (std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return is_reached[v.index()] != 0; })) next.emplace_back(t);
    }
    for (const FaceId t : next) open(t);
  }
  w.is_frozen.assign(w.mesh.triangle_count(), 0);
  w.is_fixed = was_fixed;
  w.is_fixed.resize(w.mesh.vertex_count(), 0);
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
    if (!w.mesh.has(FaceId(t)) || (is_open[t] != 0 && (t >= was_frozen.size() || was_frozen[t] == 0))) continue;
    w.is_frozen[t] = 1;
    for (const VertexId v : w.mesh.triangle(FaceId(t))) w.is_fixed[v.index()] = 1;
  }
}

}  // namespace

DeviatingPlaces find_deviating(const WorkingMesh& w, const FacedMesh& given, double bound) {
  const LiveTriangles live = live_triangles(w.mesh);
  const FacedMesh now{live.mesh, live.faces};
  DeviatingPlaces places{find_beyond(now, given, bound), find_beyond(given, now, bound)};
  for (PlaceBeyond& place : places.of_mesh) place.triangle = live.numbers[place.triangle.index()];
  for (PlaceBeyond& place : places.of_given) {
    if (place.closest.is_valid()) place.closest = live.numbers[place.closest.index()];
  }
  return places;
}

DeviatingPlaces bound_deviation(WorkingMesh& w, const FacedMesh& given, double bound, const std::function<void(WorkingMesh&)>& remesh_zone,
                                std::vector<SizeSource>& sources) {
  const Marks was_frozen = w.is_frozen, was_fixed = w.is_fixed;
  const SizingProxy* const wanted = w.proxy;
  SizingProxy finer = *wanted;
  DeviatingPlaces places = find_deviating(w, given, bound);
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0, idle = 0; round < most_rounds && idle < rounds_without_gain && !places.empty(); ++round) {
    add_finer_sources(places, finer, bound, sources);
    finer = wanted->with(sources);
    w.proxy = &finer;
    w.sizes = finer.sizes_at(w.mesh.points);
    limit_to(w, places, was_frozen, was_fixed);
    remesh_zone(w);
    places = find_deviating(w, given, bound);
    idle = places.count() < gain * least ? 0 : idle + 1;
    least = std::min(least, places.count());
  }
  w.proxy = wanted;
  return places;
}

}  // namespace mortise
