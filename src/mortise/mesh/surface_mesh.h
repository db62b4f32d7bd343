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
struct SurfaceMesh {
  std::vector<Vec3d> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> face_labels;  ///< empty, or one per triangle: index into label_names
  std::vector<std::string> label_names;    ///< groups, named solids, materials
  std::vector<std::uint8_t> walls;         ///< empty, or one per triangle: 1 when the solid is on both of its sides, or on neither
  std::vector<std::uint8_t> diagonals;     ///< empty, or one per triangle: bit k when the edge from corner k is inside a polygon
};

}  // namespace mortise
