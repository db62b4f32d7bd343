// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh made of the polygons a reader collected.
#include "mortise/io/polygon_soup.h"

#include <algorithm>
#include <numeric>

namespace mortise {
namespace {

bool is_less(const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

struct WeldedPoints {
  std::vector<Vec3d> points;
  std::vector<VertexId> vertex_of;
};

WeldedPoints weld(const std::vector<Vec3d>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return is_less(points[i], points[j]) || (points[i] == points[j] && i < j); });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || !(points[order[k]] == points[order[k - 1]]);
    first[order[k]] = is_new ? order[k] : first[order[k - 1]];
  }
  WeldedPoints welded;
  welded.vertex_of.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (first[i] == i) {
      welded.vertex_of[i] = VertexId(welded.points.size());
      welded.points.push_back(points[i]);
    } else {
      welded.vertex_of[i] = welded.vertex_of[first[i]];
    }
  }
  return welded;
}

/// Drops corners equal to the one before, cyclically.
void drop_repeated_corners(std::vector<VertexId>& polygon) {
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
}

void append_triangles(std::vector<VertexId>& polygon, SurfaceMesh& mesh) {
  if (polygon.size() > 3) drop_repeated_corners(polygon);
  while (polygon.size() < 3) polygon.push_back(polygon.back());
  for (std::size_t i = 2; i < polygon.size(); ++i) mesh.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
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

SurfaceMesh build_mesh(const PolygonSoup& soup) {
  WeldedPoints welded = weld(soup.points);
  SurfaceMesh mesh;
  mesh.points = std::move(welded.points);
  mesh.label_names = soup.label_names;
  mesh.triangles.reserve(soup.face_ends.size());
  std::vector<VertexId> polygon;
  std::size_t begin = 0;
  for (std::size_t face = 0; face < soup.face_ends.size(); ++face) {
    polygon.clear();
    for (std::size_t i = begin; i < soup.face_ends[face]; ++i) polygon.push_back(welded.vertex_of[soup.corners[i]]);
    begin = soup.face_ends[face];
    append_triangles(polygon, mesh);
    if (!soup.face_labels.empty()) mesh.face_labels.resize(mesh.triangles.size(), soup.face_labels[face]);
  }
  return mesh;
}

}  // namespace mortise
