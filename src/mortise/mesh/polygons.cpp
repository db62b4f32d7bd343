// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Joins triangles into sets and walks round their borders.
#include "mortise/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

struct Diagonal {
  VertexId low, high;
  HalfEdge half_edge;

  bool operator<(const Diagonal& o) const { return std::tie(low, high, half_edge) < std::tie(o.low, o.high, o.half_edge); }
  [[nodiscard]] bool is_same_edge(const Diagonal& o) const { return low == o.low && high == o.high; }
};

bool is_diagonal(const SurfaceMesh& mesh, HalfEdge h) { return (mesh.diagonals[h / 3] >> (h % 3) & 1U) != 0; }

VertexId end_of(const SurfaceMesh& mesh, HalfEdge h) { return origin_of(mesh, next_in_face(h)); }

/// Do two corners at one vertex have the same values? None is as none.
bool have_same_data(const SurfaceMesh& mesh, HalfEdge a, HalfEdge b) {
  const auto is_same = [](double x, double y) { return x == y || (is_no_value(x) && is_no_value(y)); };
  return std::all_of(mesh.corner_data.begin(), mesh.corner_data.end(), [&](const DataChannel& c) {
    const auto first = c.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{a} * c.components);
    const auto second = c.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{b} * c.components);
    return std::equal(first, first + c.components, second, is_same);
  });
}

bool agree(const SurfaceMesh& mesh, HalfEdge a, HalfEdge b) {
  const std::size_t f = face_of(a).index(), g = face_of(b).index();
  return origin_of(mesh, a) == end_of(mesh, b) && (mesh.face_labels.empty() || mesh.face_labels[f] == mesh.face_labels[g]) &&
         (mesh.walls.empty() || mesh.walls[f] == mesh.walls[g]) && have_same_data(mesh, a, next_in_face(b)) &&
         have_same_data(mesh, next_in_face(a), b);
}

/// Triangles joined across diagonals; is_inner: per half-edge, 1 for these diagonals.
UnionFind join_triangles(const SurfaceMesh& mesh, std::vector<std::uint8_t>& is_inner) {
  std::vector<Diagonal> diagonals;
  for (HalfEdge h = 0; h < 3 * mesh.triangles.size(); ++h) {
    const VertexId u = origin_of(mesh, h), v = end_of(mesh, h);
    if (is_diagonal(mesh, h)) diagonals.push_back({std::min(u, v), std::max(u, v), h});
  }
  std::sort(diagonals.begin(), diagonals.end());
  UnionFind polygons(mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < diagonals.size(); ++i) {
    const Diagonal &a = diagonals[i], &b = diagonals[i + 1];
    const bool is_pair = a.is_same_edge(b) && (i == 0 || !diagonals[i - 1].is_same_edge(a)) &&
                         (i + 2 == diagonals.size() || !diagonals[i + 2].is_same_edge(b));
    if (!is_pair || !agree(mesh, a.half_edge, b.half_edge)) continue;
    is_inner[a.half_edge] = is_inner[b.half_edge] = 1;
    polygons.join(a.half_edge / 3, b.half_edge / 3);
  }
  return polygons;
}

/// The border of some triangles from the first corner on; empty when it is not one loop through every corner once.
std::vector<HalfEdge> border_of(const SurfaceMesh& mesh, std::span<const FaceId> triangles, const std::vector<std::uint8_t>& is_inner) {
  std::map<VertexId, HalfEdge> side_from;
  for (const FaceId f : triangles) {
    for (HalfEdge h = 3 * f.value; h < 3 * f.value + 3; ++h) {
      if (is_inner[h] == 0 && !side_from.emplace(origin_of(mesh, h), h).second) return {};
    }
  }
  if (side_from.size() != triangles.size() + 2) return {};
  const VertexId wanted = mesh.triangles[triangles.front().index()][0];
  const VertexId first = side_from.count(wanted) != 0 ? wanted : side_from.begin()->first;
  std::vector<HalfEdge> border;
  for (VertexId v = first; border.empty() || v != first; v = end_of(mesh, border.back())) border.push_back(side_from.at(v));
  return border.size() == side_from.size() ? border : std::vector<HalfEdge>();
}

void append(const SurfaceMesh& mesh, std::span<const HalfEdge> sides, FaceId first, Polygons& polygons) {
  for (const HalfEdge h : sides) polygons.corners.push_back(origin_of(mesh, h));
  polygons.sides.insert(polygons.sides.end(), sides.begin(), sides.end());
  polygons.ends.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  polygons.first_triangle.push_back(first);
}

void append_triangle(const SurfaceMesh& mesh, FaceId f, Polygons& polygons) {
  const HalfEdge first = 3 * f.value;
  append(mesh, std::array{first, first + 1, first + 2}, f, polygons);
}

}  // namespace

Polygons find_polygons(const SurfaceMesh& mesh) {
  Polygons polygons;
  if (mesh.diagonals.empty()) {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) append_triangle(mesh, FaceId(f), polygons);
    return polygons;
  }
  std::vector<std::uint8_t> is_inner(3 * mesh.triangles.size(), 0);
  UnionFind joined = join_triangles(mesh, is_inner);
  std::vector<std::vector<FaceId>> triangles_of(mesh.triangles.size());  // by the root of a set
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) triangles_of[joined.find(f)].push_back(FaceId(f));
  std::vector<std::uint8_t> is_whole(mesh.triangles.size(), 0);  // by the root of a set: one polygon
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const std::uint32_t root = joined.find(f);
    const std::vector<FaceId>& triangles = triangles_of[root];
    if (triangles.front() == FaceId(f) && triangles.size() > 1) {
      const std::vector<HalfEdge> border = border_of(mesh, triangles, is_inner);
      is_whole[root] = border.empty() ? 0 : 1;
      if (!border.empty()) append(mesh, border, FaceId(f), polygons);
    }
    if (is_whole[root] == 0) append_triangle(mesh, FaceId(f), polygons);
  }
  return polygons;
}

}  // namespace mortise
