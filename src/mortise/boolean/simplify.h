// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the cut left inside faces goes again: exact, before any vertex is rounded.
#pragma once

#include <functional>
#include <span>

#include "mortise/arrange/facets.h"
#include "mortise/boolean/select.h"

namespace mortise {

/// May facets of these faces, which lie in one plane and run the same way, be joined? Asked for faces of any operand.
using AgreementOfFaces = std::function<bool(SourceId, SourceId)>;

struct SimplifyRule {
  Simplify level = Simplify::Off;
  AgreementOfFaces agree;                     ///< labels and other data; for Simplify::Coplanar
  std::span<const PointId> contact_points{};  ///< sorted; only facets at them, and at made points, are simplified
};

/// Joins kept facets across edges that nothing needs, and removes vertices that nothing needs (exact-core 6).
///
/// Facets are joined where an edge has two of them, in one plane (of one face: Simplify::Cut), running the same way, with the
/// same operands on each side where the result keeps these apart. A vertex goes when all its facets are joined and
/// no edge that stays ends in it, or two that continue each other straight. Vertices of an operand's own faces stay under
/// Simplify::Cut. What is left of joined facets without such vertices is triangulated anew: new facets, added to `facets`;
/// they know all faces they were made from. All other facets stay as they are.
/// @throws Error{InvalidArgument} when the selection keeps all facets of every operand
/// O(n log n) in the facets at contacts.
[[nodiscard]] Selection simplify(const SimplifyRule& rule, const OperandFaces& faces, Facets& facets, Selection selection);

}  // namespace mortise
