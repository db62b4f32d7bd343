// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The polygons whose triangles a mesh holds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Polygons one after the other.
struct Polygons {
  std::vector<VertexId> corners;       ///< the way its triangles run
  std::vector<std::uint32_t> ends;     ///< per polygon: end of its corners
  std::vector<FaceId> first_triangle;  ///< per polygon, ascending

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::span<const VertexId> corners_of(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span<const VertexId>(corners).subspan(begin, ends[i] - begin);
  }
};

/// Triangles joined across their diagonals (SurfaceMesh::diagonals), where both triangles call the edge one, run opposite ways along
/// it and agree in label and wall. A polygon begins with the first corner of its first triangle if that is one of its own. Triangles
/// whose union is no polygon, or lost part of it, stay triangles. Needs indices in range. O(n log n) in the triangles with diagonals.
[[nodiscard]] Polygons find_polygons(const SurfaceMesh& mesh);

}  // namespace mortise
