// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sorts the corners at each vertex by their values.
#include "mortise/mesh/corners_to_vertices.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "mortise/base/bits.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

/// Of length 1; zero for a triangle without area.
Vec3d unit_normal(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
  const double longest = std::max(length(b - a), length(c - a));
  if (!(longest > 0)) return {};
  const Vec3d normal = cross((1 / longest) * (b - a), (1 / longest) * (c - a));
  const double size = length(normal);
  return size > 0 ? Vec3d{normal.x / size, normal.y / size, normal.z / size} : Vec3d{};
}

void fill_normals(const SurfaceMesh& mesh, DataChannel& channel) {
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto begin = channel.values.begin() + static_cast<std::ptrdiff_t>(9 * f);
    if (std::none_of(begin, begin + 9, is_no_value)) continue;
    const Vec3d normal = unit_normal(mesh, mesh.triangles[f]);
    for (std::ptrdiff_t i = 0; i < 9; ++i) {
      if (is_no_value(begin[i])) begin[i] = normal[static_cast<std::size_t>(i % 3)];
    }
  }
}

/// All data at corners, no value missing unless `missing` is none, no -0.
std::vector<DataChannel> complete_data(const SurfaceMesh& mesh, double missing) {
  std::vector<DataChannel> channels = all_as_corner_data(mesh);
  for (DataChannel& c : channels) {
    if (c.kind == DataKind::Normal && !is_no_value(missing)) fill_normals(mesh, c);
    for (double& x : c.values) x = (is_no_value(x) ? missing : x) + 0.0;
  }
  return channels;
}

/// Orders corners by vertex, then by the bits of their values.
class CornerOrder {
 public:
  CornerOrder(const SurfaceMesh& mesh, const std::vector<DataChannel>& channels) : mesh_(mesh), channels_(channels) {}

  [[nodiscard]] VertexId vertex(std::uint32_t corner) const { return mesh_.triangles[corner / 3][corner % 3]; }

  /// Negative, zero or positive as a is before, equal to or behind b.
  [[nodiscard]] int compare(std::uint32_t a, std::uint32_t b) const {
    if (vertex(a) != vertex(b)) return vertex(a) < vertex(b) ? -1 : 1;
    for (const DataChannel& c : channels_) {
      for (std::size_t k = 0; k < c.components; ++k) {
        const auto x = cast_bits<std::uint64_t>(c.values[std::size_t{a} * c.components + k]);
        const auto y = cast_bits<std::uint64_t>(c.values[std::size_t{b} * c.components + k]);
        if (x != y) return x < y ? -1 : 1;
      }
    }
    return 0;
  }

 private:
  const SurfaceMesh& mesh_;
  const std::vector<DataChannel>& channels_;
};

/// For every corner the lowest one with its vertex and values.
std::vector<std::uint32_t> lowest_equals(const CornerOrder& order, std::size_t corner_count) {
  std::vector<std::uint32_t> sorted(corner_count), lowest(corner_count);
  for (std::uint32_t c = 0; c < corner_count; ++c) sorted[c] = c;
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int way = order.compare(a, b);
    return way != 0 ? way < 0 : a < b;
  });
  for (std::size_t i = 0; i < corner_count; ++i) {
    const bool is_new = i == 0 || order.compare(sorted[i - 1], sorted[i]) != 0;
    lowest[sorted[i]] = is_new ? sorted[i] : lowest[sorted[i - 1]];
  }
  return lowest;
}

/// One corner for each new vertex: by old vertex, then by the first corner.
std::vector<std::uint32_t> corners_of_vertices(const CornerOrder& order, const std::vector<std::uint32_t>& lowest) {
  std::vector<std::pair<VertexId, std::uint32_t>> firsts;
  for (std::uint32_t c = 0; c < lowest.size(); ++c) {
    if (lowest[c] == c) firsts.emplace_back(order.vertex(c), c);
  }
  std::sort(firsts.begin(), firsts.end());
  std::vector<std::uint32_t> corners;
  for (const auto& first : firsts) corners.push_back(first.second);
  return corners;
}

}  // namespace

MeshOfVertices corners_to_vertices(const SurfaceMesh& mesh, double missing) {
  validate(mesh);
  const std::vector<DataChannel> channels = complete_data(mesh, missing);
  const CornerOrder order(mesh, channels);
  const std::vector<std::uint32_t> lowest = lowest_equals(order, 3 * mesh.triangles.size());
  MeshOfVertices result{{{}, mesh.triangles, mesh.face_labels, mesh.label_names, mesh.walls, mesh.diagonals, without_values(channels), {}},
                        {}};
  std::vector<VertexId> vertex_of_corner(lowest.size());
  for (const std::uint32_t corner : corners_of_vertices(order, lowest)) {
    vertex_of_corner[corner] = VertexId(result.source_vertex.size());
    result.source_vertex.push_back(order.vertex(corner));
    result.mesh.points.push_back(mesh.points[order.vertex(corner).index()]);
    for (std::size_t c = 0; c < channels.size(); ++c) append_values(channels[c], corner, result.mesh.vertex_data[c].values);
  }
  for (std::size_t c = 0; c < lowest.size(); ++c) result.mesh.triangles[c / 3][c % 3] = vertex_of_corner[lowest[c]];
  return result;
}

}  // namespace mortise
