// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh made of the polygons a reader collected.
#include "mortise/io/polygon_soup.h"

#include <algorithm>

#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/triangulate_polygon.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

struct PolygonCorner {
  VertexId vertex;
  std::uint32_t place;  ///< in PolygonSoup::corners

  bool operator==(const PolygonCorner& other) const { return vertex == other.vertex; }
};

/// Drops corners equal to the one before, cyclically.
void drop_repeated_corners(std::vector<PolygonCorner>& polygon) {
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
}

using PolygonTriangle = std::array<std::uint32_t, 3>;

/// A triangle at corner 0 becomes the first one and begins there, so that the polygon can be found again as it was.
void begin_with_first_corner(std::vector<PolygonTriangle>& triangles) {
  const auto at_first = [](const PolygonTriangle& t) { return std::find(t.begin(), t.end(), 0U) != t.end(); };
  std::swap(triangles.front(), *std::find_if(triangles.begin(), triangles.end(), at_first));
  PolygonTriangle& t = triangles.front();
  std::rotate(t.begin(), std::find(t.begin(), t.end(), 0U), t.end());
}

/// Which edges join corners that are not neighbours in a polygon of n corners.
std::uint8_t diagonals_of(const PolygonTriangle& t, std::size_t n) {
  std::uint8_t bits = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const std::size_t from = t[k], to = t[(k + 1) % 3];
    if ((from + 1) % n != to && (to + 1) % n != from) bits = static_cast<std::uint8_t>(bits | 1U << k);
  }
  return bits;
}

/// A mesh in the making, and where the corners of its triangles were.
struct MeshWithPlaces {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> places;  ///< three per triangle

  void add_triangle(const PolygonCorner& a, const PolygonCorner& b, const PolygonCorner& c) {
    mesh.triangles.push_back({a.vertex, b.vertex, c.vertex});
    places.insert(places.end(), {a.place, b.place, c.place});
  }
};

void append_triangles(std::vector<PolygonCorner>& polygon, MeshWithPlaces& made) {
  SurfaceMesh& mesh = made.mesh;
  if (polygon.size() > 3) drop_repeated_corners(polygon);
  while (polygon.size() < 3) polygon.push_back(polygon.back());
  if (polygon.size() == 3) {
    made.add_triangle(polygon[0], polygon[1], polygon[2]);
    return;
  }
  std::vector<Vec3d> corners;
  for (const PolygonCorner& c : polygon) corners.push_back(mesh.points[c.vertex.index()]);
  std::vector<PolygonTriangle> triangles = triangulate_polygon(corners).triangles;
  begin_with_first_corner(triangles);
  mesh.diagonals.resize(mesh.triangles.size(), 0);
  for (const PolygonTriangle& t : triangles) {
    made.add_triangle(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    mesh.diagonals.push_back(diagonals_of(t, polygon.size()));
  }
}

/// The data of a soup at the corners of the triangles.
std::vector<DataChannel> data_at(const std::vector<std::uint32_t>& places, const PolygonSoup& soup) {
  std::vector<DataChannel> channels = without_values(soup.point_data);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (const std::uint32_t place : places) append_values(soup.point_data[c], soup.corners[place], channels[c].values);
  }
  for (const DataChannel& c : soup.corner_data) {
    channels.push_back({c.name, c.components, c.kind, {}});
    for (const std::uint32_t place : places) append_values(c, place, channels.back().values);
  }
  return channels;
}

}  // namespace

std::uint32_t LabelTable::label_of(std::string_view name) {
  const auto known = label_of_.find(name);
  if (known != label_of_.end()) return known->second;
  const auto label = static_cast<std::uint32_t>(names_.size());
  label_of_.emplace(name, label);
  names_.emplace_back(name);
  return label;
}

bool LabelTable::has_names() const {
  return std::any_of(names_.begin(), names_.end(), [](const std::string& name) { return !name.empty(); });
}

SurfaceMesh build_mesh(PolygonSoup soup) {
  SurfaceMesh loose;
  loose.points = std::move(soup.points);
  WeldedMesh welded = weld(loose);
  MeshWithPlaces made{std::move(welded.mesh), {}};
  SurfaceMesh& mesh = made.mesh;
  mesh.label_names = std::move(soup.label_names);
  mesh.triangles.reserve(soup.face_ends.size());
  std::vector<PolygonCorner> polygon;
  std::uint32_t begin = 0;
  for (std::size_t face = 0; face < soup.face_ends.size(); ++face) {
    polygon.clear();
    for (std::uint32_t i = begin; i < soup.face_ends[face]; ++i) polygon.push_back({welded.new_vertex[soup.corners[i]], i});
    begin = soup.face_ends[face];
    append_triangles(polygon, made);
    if (!mesh.diagonals.empty()) mesh.diagonals.resize(mesh.triangles.size(), 0);
    if (!soup.walls.empty()) mesh.walls.resize(mesh.triangles.size(), soup.walls[face]);
    if (!soup.face_labels.empty()) mesh.face_labels.resize(mesh.triangles.size(), soup.face_labels[face]);
  }
  mesh.corner_data = data_at(made.places, soup);
  return std::move(made.mesh);
}

}  // namespace mortise
