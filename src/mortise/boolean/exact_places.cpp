// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Definitions of points, in flat lists.
#include "mortise/boolean/exact_places.h"

#include <algorithm>

#include "mortise/boolean/keep_triangles.h"

namespace mortise {

ExactPlaces exact_places(const SurfaceMesh& mesh, std::span<const std::uint32_t> faces, const PointSet& points,
                         std::span<const PointId> point_of_vertex) {
  ExactPlaces places;
  for (const std::uint32_t f : faces) {
    for (const VertexId v : mesh.triangles[f]) places.vertices.push_back(v.value);
  }
  std::sort(places.vertices.begin(), places.vertices.end());
  places.vertices.erase(std::unique(places.vertices.begin(), places.vertices.end()), places.vertices.end());
  for (const std::uint32_t v : places.vertices) {
    for (const PointId p : points.definition(point_of_vertex[v])) places.points.push_back(points.nearest(p));
    places.begin.push_back(static_cast<std::uint32_t>(places.points.size()));
  }
  return places;
}

ExactPlaces renumbered(const ExactPlaces& places, std::span<const std::uint8_t> is_kept) {
  const std::vector<std::uint32_t> number = numbers_of_kept(is_kept);
  ExactPlaces kept;
  for (std::size_t i = 0; i < places.vertices.size(); ++i) {
    if (is_kept[places.vertices[i]] == 0) continue;
    kept.vertices.push_back(number[places.vertices[i]]);
    kept.points.insert(kept.points.end(), places.points.begin() + places.begin[i], places.points.begin() + places.begin[i + 1]);
    kept.begin.push_back(static_cast<std::uint32_t>(kept.points.size()));
  }
  return kept;
}

}  // namespace mortise
