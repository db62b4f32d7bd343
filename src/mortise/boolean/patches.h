// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Facets joined to patches, and the two sides of every patch joined to regions of space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/arrange/face_intersection_map.h"
#include "mortise/arrange/facets.h"
#include "mortise/boolean/radial_order.h"

namespace mortise {

using PatchId = Id<struct PatchTag>;
using RegionId = Id<struct RegionTag>;

/// Change of the winding of one operand from the front of a facet to its back.
struct Jump {
  OperandId operand;
  int change = 0;

  bool operator==(const Jump&) const = default;
};

/// All jumps of a facet: ascending operands, no zero. Walls have none.
[[nodiscard]] std::vector<Jump> jumps_of(const OperandFaces& faces, const Facets& facets, FacetId f);

/// Operands with a wall there, ascending.
[[nodiscard]] std::vector<OperandId> walls_of(const OperandFaces& faces, const Facets& facets, FacetId f);

/// An edge with other than two facets, or where two facets do not continue each other.
struct Junction {
  PointId u, v;  ///< u < v
  std::uint32_t first_facet = 0;
  std::uint32_t facet_count = 0;  ///< in Patches::around, counterclockwise
};

/// An edge at which the facets of an operand, but for walls, do not balance: it has a border there, crosses itself, or is
/// badly oriented.
struct UnbalancedEdge {
  OperandId operand;
  PointId u, v;
  bool is_open = false;  ///< an odd number of its facets meet here
};

/// Patches are facets joined without crossing a junction. Facets also join through a corner that lies on no contact, which
/// is right for the winding of all other operands; operands with self contacts or walls are joined by edges only (exact-core 4).
struct Patches {
  IdVector<FacetId, PatchId> patch_of_facet;
  IdVector<PatchId, FacetId> first_facet;
  IdVector<PatchId, RegionId> front, back;
  std::uint32_t region_count = 0;  ///< pieces of space as seen from one complex; those of different complexes stay apart
  std::vector<Junction> junctions;
  std::vector<FacetAtEdge> around;
  std::vector<UnbalancedEdge> unbalanced;
  std::vector<OperandId> stacked;  ///< operands with facets on one half-plane of a junction: unresolved contacts with themselves

  [[nodiscard]] std::span<const FacetAtEdge> facets_round(const Junction& j) const {
    return {around.data() + j.first_facet, j.facet_count};
  }
};

/// O(n) in the facets, plus n log n in those with an edge between points of contact.
[[nodiscard]] Patches build_patches(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets);

}  // namespace mortise
