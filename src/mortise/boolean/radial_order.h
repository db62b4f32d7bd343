// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The facets round an edge, in order of angle; decided by the planes of their source faces (paper 6.1, Fig. 15).
#pragma once

#include <span>
#include <vector>

#include "mortise/arrange/facets.h"

namespace mortise {

/// A facet at an edge that runs from u to v.
struct FacetAtEdge {
  FacetId facet;
  bool is_forward = false;  ///< the facet runs from u to v along the edge
  SourceId face;            ///< its first source: the plane
  PointId witness;          ///< an input point in that plane strictly on the facet's side of the edge

  /// On which side of a facet one comes out going counterclockwise over it, seen against the direction of the edge.
  [[nodiscard]] bool is_front_after() const { return is_forward; }
};

/// The facet as it stands at its edge u -> v; the edge is one of its own.
[[nodiscard]] FacetAtEdge facet_at_edge(const OperandFaces& faces, const Facets& facets, FacetId f, PointId u, PointId v);

/// Sorts the facets counterclockwise round the edge, looking from v to u, beginning with the first.
/// The order of facets on one half-plane is arbitrary: that of an operand whose contacts with itself are not resolved.
void sort_round_edge(const OperandFaces& faces, std::vector<FacetAtEdge>& around);

/// Do two facets at one edge lie on the same half-plane?
[[nodiscard]] bool share_half_plane(const OperandFaces& faces, const FacetAtEdge& a, const FacetAtEdge& b);

/// The first facet met when turning counterclockwise round the edge (looking from v to u) from the half-plane that contains
/// the direction (0, -1, 0); no facet lies on that half-plane.
[[nodiscard]] FacetAtEdge first_after_minus_y(const OperandFaces& faces, std::span<const FacetAtEdge> around);

}  // namespace mortise
