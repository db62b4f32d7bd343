// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Values at the corners of triangles: keeps them in step with the triangles. And what channels have in common.
#pragma once

#include <limits>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

class PointInTriangle;

/// What a channel holds where there is no value.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

[[nodiscard]] inline bool is_no_value(double x) { return x != x; }

/// Values a face has in a channel of corner data.
[[nodiscard]] inline std::size_t values_per_face(const DataChannel& channel) { return std::size_t{3} * channel.components; }

/// The same channels without values.
[[nodiscard]] std::vector<DataChannel> without_values(const std::vector<DataChannel>& channels);

/// Appends the values a channel has at one place, a vertex or a corner.
void append_values(const DataChannel& channel, std::size_t place, std::vector<double>& values);

/// The values of these vertices, in their order.
[[nodiscard]] std::vector<DataChannel> select_vertex_data(const std::vector<DataChannel>& channels, const std::vector<VertexId>& vertices);

/// The values of a channel of vertex data at the corners of all triangles.
[[nodiscard]] DataChannel as_corner_data(const DataChannel& channel, const std::vector<Triangle>& triangles);

/// All data of a mesh as corner data, that of the vertices first: no two corners depend on one another any more.
[[nodiscard]] std::vector<DataChannel> all_as_corner_data(const SurfaceMesh& mesh);

/// `to` gets the values of `from`, a face of the same mesh.
void copy_corner_data(FaceId from, FaceId to, SurfaceMesh& mesh);

/// Appends the values of a face to each channel of `mesh`; its channels are those of `source`, or there are none.
void append_corner_data(const SurfaceMesh& source, FaceId f, SurfaceMesh& mesh);

/// As many values as triangles need; new ones are `no_value`.
void resize_corner_data(SurfaceMesh& mesh);

/// The values of a face from its second and third corner change places.
void reverse_corner_data(FaceId f, SurfaceMesh& mesh);

/// Normals at the corners of a face point the other way.
void turn_normals(FaceId f, DataChannel& channel);
void turn_normals(FaceId f, SurfaceMesh& mesh);

/// The face has no values any more.
void forget_corner_data(FaceId f, SurfaceMesh& mesh);

/// The values of one face, kept while it is cut into pieces.
class FaceData {
 public:
  FaceData(const SurfaceMesh& mesh, FaceId f);

  /// The triangle `piece` of the same mesh, corners set already, lies in the face: its values are interpolated there, exactly, and
  /// rounded once. Of a face without area only corners it had get values.
  void give_to(FaceId piece, SurfaceMesh& mesh) const;

 private:
  void give_to_corner(const PointInTriangle& place, FaceId piece, std::size_t corner, SurfaceMesh& mesh) const;

  Triangle corners_;
  std::vector<std::vector<double>> values_;  ///< per channel
};

}  // namespace mortise
