// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh every operation reads and writes: plain arrays.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mortise/base/ids.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Three vertices, counterclockwise seen from outside.
using Triangle = std::array<VertexId, 3>;

/// Triangles over shared points. No adjacency is stored: a stage builds what it needs.
/// What happens to values when the surface they lie on is moved or turned over.
enum class DataKind : std::uint8_t {
  Value,   ///< nothing: texture coordinates, colours, temperatures
  Vector,  ///< they move along with the mesh: three components, velocities
  Normal,  ///< they stay at right angles to the mesh, their length stays, and they turn round with a face: three components
};

/// A named quantity with values at the vertices, or at the corners of the triangles, of a mesh; linear on each triangle.
struct DataChannel {
  std::string name;
  std::uint32_t components = 1;
  DataKind kind = DataKind::Value;
  std::vector<double> values;  ///< `components` per vertex, or three times as many per triangle; NaN where there is no value
};

struct SurfaceMesh {
  std::vector<Vec3d> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> face_labels;  ///< empty, or one per triangle: index into label_names
  std::vector<std::string> label_names;    ///< groups, named solids, materials
  std::vector<std::uint8_t> walls;         ///< empty, or one per triangle: 1 when the solid is on both of its sides, or on neither
  std::vector<std::uint8_t> diagonals;     ///< empty, or one per triangle: bit k when the edge from corner k is inside a polygon
  std::vector<DataChannel> vertex_data{};  ///< values per vertex; names differ from one another and from those of corner_data
  std::vector<DataChannel> corner_data{};  ///< values per triangle and corner
};

}  // namespace mortise
