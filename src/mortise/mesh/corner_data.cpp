// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Values at the corners of triangles.
#include "mortise/mesh/corner_data.h"

#include <algorithm>

#include "mortise/exact/point_in_triangle.h"
#include "mortise/exact/point_set.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

auto begin_of(FaceId f, DataChannel& channel) {
  return channel.values.begin() + static_cast<std::ptrdiff_t>(f.index() * values_per_face(channel));
}

}  // namespace

std::vector<DataChannel> without_values(const std::vector<DataChannel>& channels) {
  std::vector<DataChannel> result;
  for (const DataChannel& c : channels) result.push_back({c.name, c.components, c.kind, {}});
  return result;
}

void append_values(const DataChannel& channel, std::size_t place, std::vector<double>& values) {
  const auto first = channel.values.begin() + static_cast<std::ptrdiff_t>(place * channel.components);
  values.insert(values.end(), first, first + channel.components);
}

std::vector<DataChannel> select_vertex_data(const std::vector<DataChannel>& channels, const std::vector<VertexId>& vertices) {
  std::vector<DataChannel> result = without_values(channels);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    result[c].values.reserve(vertices.size() * channels[c].components);
    for (const VertexId v : vertices) append_values(channels[c], v.index(), result[c].values);
  }
  return result;
}

DataChannel as_corner_data(const DataChannel& channel, const std::vector<Triangle>& triangles) {
  DataChannel result{channel.name, channel.components, channel.kind, {}};
  result.values.reserve(triangles.size() * values_per_face(channel));
  for (const Triangle& t : triangles) {
    for (const VertexId v : t) append_values(channel, v.index(), result.values);
  }
  return result;
}

std::vector<DataChannel> all_as_corner_data(const SurfaceMesh& mesh) {
  std::vector<DataChannel> result;
  for (const DataChannel& c : mesh.vertex_data) result.push_back(as_corner_data(c, mesh.triangles));
  result.insert(result.end(), mesh.corner_data.begin(), mesh.corner_data.end());
  return result;
}

void copy_corner_data(FaceId from, FaceId to, SurfaceMesh& mesh) {
  if (from == to) return;
  for (DataChannel& c : mesh.corner_data) std::copy_n(begin_of(from, c), values_per_face(c), begin_of(to, c));
}

void append_corner_data(const SurfaceMesh& source, FaceId f, SurfaceMesh& mesh) {
  for (std::size_t c = 0; c < mesh.corner_data.size(); ++c) {
    const std::size_t count = values_per_face(mesh.corner_data[c]);
    for (std::size_t i = 0; i < count; ++i) {
      const double value = source.corner_data[c].values[f.index() * count + i];  // the channel may be the same one
      mesh.corner_data[c].values.push_back(value);
    }
  }
}

void resize_corner_data(SurfaceMesh& mesh) {
  for (DataChannel& c : mesh.corner_data) c.values.resize(mesh.triangles.size() * values_per_face(c), no_value);
}

void reverse_corner_data(FaceId f, SurfaceMesh& mesh) {
  for (DataChannel& c : mesh.corner_data) {
    const auto second = begin_of(f, c) + c.components;
    std::swap_ranges(second, second + c.components, second + c.components);
  }
}

void turn_normals(FaceId f, DataChannel& channel) {
  const auto first = begin_of(f, channel);
  const auto turned = [](double x) { return is_no_value(x) ? no_value : 0.0 - x; };  // never -0
  std::transform(first, first + static_cast<std::ptrdiff_t>(values_per_face(channel)), first, turned);
}

void turn_normals(FaceId f, SurfaceMesh& mesh) {
  for (DataChannel& c : mesh.corner_data) {
    if (c.kind == DataKind::Normal) turn_normals(f, c);
  }
}

void forget_corner_data(FaceId f, SurfaceMesh& mesh) {
  for (DataChannel& c : mesh.corner_data) std::fill_n(begin_of(f, c), values_per_face(c), no_value);
}

FaceData::FaceData(const SurfaceMesh& mesh, FaceId f) : corners_(mesh.triangles[f.index()]) {
  for (const DataChannel& c : mesh.corner_data) {
    const auto first = c.values.begin() + static_cast<std::ptrdiff_t>(f.index() * values_per_face(c));
    values_.emplace_back(first, first + static_cast<std::ptrdiff_t>(values_per_face(c)));
  }
}

void FaceData::give_to(FaceId piece, SurfaceMesh& mesh) const {
  if (values_.empty()) return;
  PointSet points;
  PlanePoints face;
  for (std::size_t i = 0; i < 3; ++i) face[i] = points.add_input(mesh.points[corners_[i].index()]);
  const bool has_area = !are_collinear(points.nearest(face[0]), points.nearest(face[1]), points.nearest(face[2]));
  forget_corner_data(piece, mesh);
  for (std::size_t i = 0; i < 3; ++i) {
    const PointId p = points.add_input(mesh.points[mesh.triangles[piece.index()][i].index()]);
    const bool is_corner = std::find(face.begin(), face.end(), p) != face.end();
    if (has_area || is_corner) give_to_corner(PointInTriangle(points, face, p), piece, i, mesh);
  }
}

void FaceData::give_to_corner(const PointInTriangle& place, FaceId piece, std::size_t corner, SurfaceMesh& mesh) const {
  for (std::size_t c = 0; c < values_.size(); ++c) {
    const std::size_t n = mesh.corner_data[c].components;
    const auto first = begin_of(piece, mesh.corner_data[c]) + static_cast<std::ptrdiff_t>(corner * n);
    for (std::size_t k = 0; k < n; ++k) {
      first[static_cast<std::ptrdiff_t>(k)] = place.interpolate({values_[c][k], values_[c][n + k], values_[c][2 * n + k]});
    }
  }
}

}  // namespace mortise
