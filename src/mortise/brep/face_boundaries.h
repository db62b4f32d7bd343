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

/// Per half-edge the other one of its edge, where triangles are joined; `no_half_edge` at features.
using HalfEdgesAcross = std::vector<HalfEdge>;

/// @param is_feature  per edge. Edges that are no features have two triangles that run opposite ways.
[[nodiscard]] HalfEdgesAcross half_edges_across(const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature);

/// Boundaries of pieces of a surface: the triangles joined through edges that are no features.
struct FaceBoundaries {
  Lists<BoundaryId, HalfEdge> half_edges;  ///< per boundary end to end, the piece on their left; by lowest half-edge
  std::vector<std::uint32_t> piece;        ///< per boundary
  std::vector<TouchedVertex> touched;      ///< sorted; boundaries of their pieces too, without an edge
  std::vector<std::uint32_t> genus;        ///< per piece
};

/// Walks round the boundaries.
/// O(n).
[[nodiscard]] FaceBoundaries find_face_boundaries(const SurfaceMesh& mesh, const HalfEdgesAcross& across, const FaceComponents& pieces);

/// Walks round the boundaries again after pieces were opened along seams to pieces of genus 0 that no vertex touches.
/// @param across  seams are features in it
/// @param opened  per piece
void walk_again(const HalfEdgesAcross& across, const FaceComponents& pieces, const std::vector<std::uint8_t>& opened,
                FaceBoundaries& boundaries);

}  // namespace mortise
