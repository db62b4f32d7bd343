// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh made of the polygons a reader collected.
#include "mortise/io/polygon_soup.h"

#include <algorithm>

#include "mortise/mesh/triangulate_polygon.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

/// Drops corners equal to the one before, cyclically.
void drop_repeated_corners(std::vector<VertexId>& polygon) {
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

void append_triangles(std::vector<VertexId>& polygon, SurfaceMesh& mesh) {
  if (polygon.size() > 3) drop_repeated_corners(polygon);
  while (polygon.size() < 3) polygon.push_back(polygon.back());
  if (polygon.size() == 3) {
    mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  std::vector<Vec3d> corners;
  for (const VertexId vertex : polygon) corners.push_back(mesh.points[vertex.index()]);
  std::vector<PolygonTriangle> triangles = triangulate_polygon(corners).triangles;
  begin_with_first_corner(triangles);
  mesh.diagonals.resize(mesh.triangles.size(), 0);
  for (const PolygonTriangle& t : triangles) {
    mesh.triangles.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    mesh.diagonals.push_back(diagonals_of(t, polygon.size()));
  }
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
  SurfaceMesh mesh = std::move(welded.mesh);
  mesh.label_names = std::move(soup.label_names);
  mesh.triangles.reserve(soup.face_ends.size());
  std::vector<VertexId> polygon;
  std::size_t begin = 0;
  for (std::size_t face = 0; face < soup.face_ends.size(); ++face) {
    polygon.clear();
    for (std::size_t i = begin; i < soup.face_ends[face]; ++i) polygon.push_back(welded.new_vertex[soup.corners[i]]);
    begin = soup.face_ends[face];
    append_triangles(polygon, mesh);
    if (!mesh.diagonals.empty()) mesh.diagonals.resize(mesh.triangles.size(), 0);
    if (!soup.walls.empty()) mesh.walls.resize(mesh.triangles.size(), soup.walls[face]);
    if (!soup.face_labels.empty()) mesh.face_labels.resize(mesh.triangles.size(), soup.face_labels[face]);
  }
  return mesh;
}

}  // namespace mortise
