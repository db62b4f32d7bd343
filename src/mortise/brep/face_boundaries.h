// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The loops of half-edges that bound each piece of a surface, and its genus.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/base/lists.h"
#include "mortise/mesh/topology.h"

namespace mortise {

using BoundaryId = Id<struct BoundaryTag>;

/// A vertex that a piece touches from within: all round it, while it has other triangles too.
struct TouchedVertex {
  VertexId vertex;
  std::uint32_t piece = 0;

  auto operator<=>(const TouchedVertex&) const = default;
};

/// Boundaries of pieces of a surface: the triangles joined through edges that are no features.
struct FaceBoundaries {
  Lists<BoundaryId, HalfEdge> half_edges;  ///< per boundary end to end, the piece on their left; by lowest half-edge
  std::vector<std::uint32_t> piece;        ///< per boundary
  std::vector<TouchedVertex> touched;      ///< sorted; boundaries of their pieces too, without an edge
  std::vector<std::uint32_t> genus;        ///< per piece
};

/// Walks round the boundaries. Edges that are no features have two triangles that run opposite ways.
/// @param is_feature  per edge
/// O(n).
[[nodiscard]] FaceBoundaries find_face_boundaries(const SurfaceMesh& mesh, const MeshTopology& topology,
                                                  const std::vector<std::uint8_t>& is_feature, const FaceComponents& pieces);

}  // namespace mortise
