// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The polygons whose triangles a mesh holds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/mesh/surface_mesh.h"
#include "mortise/mesh/topology.h"

namespace mortise {

/// Polygons one after the other.
struct Polygons {
  std::vector<VertexId> corners;       ///< the way its triangles run
  std::vector<HalfEdge> sides;         ///< per corner: that of a triangle which begins there and is a side of the polygon
  std::vector<std::uint32_t> ends;     ///< per polygon: end of its corners
  std::vector<FaceId> first_triangle;  ///< per polygon, ascending

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::size_t begin_of(std::size_t i) const { return i == 0 ? 0 : ends[i - 1]; }
  [[nodiscard]] std::span<const VertexId> corners_of(std::size_t i) const {
    return std::span<const VertexId>(corners).subspan(begin_of(i), ends[i] - begin_of(i));
  }
  [[nodiscard]] std::span<const HalfEdge> sides_of(std::size_t i) const {
    return std::span<const HalfEdge>(sides).subspan(begin_of(i), ends[i] - begin_of(i));
  }
};

/// Triangles joined across their diagonals (SurfaceMesh::diagonals), where both triangles call the edge one, run opposite ways along
/// it and agree in label, wall and data. A polygon begins with the first corner of its first triangle if that is one of its own. Triangles
/// whose union is no polygon, or lost part of it, stay triangles. Needs indices in range. O(n log n) in the triangles with diagonals.
[[nodiscard]] Polygons find_polygons(const SurfaceMesh& mesh);

}  // namespace mortise
