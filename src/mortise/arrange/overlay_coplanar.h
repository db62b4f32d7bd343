// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces that share area in one plane are one overlay: cut and triangulated once, so that all of them get the same facets.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mortise/arrange/find_contacts.h"

namespace mortise {

using OverlayId = Id<struct OverlayTag>;
/// A face in contact, numbered so that the faces of an overlay follow each other.
using SlotId = Id<struct SlotTag>;

/// All faces in contact, grouped. Most overlays hold a single face.
struct Overlays {
  IdVector<OverlayId, std::uint32_t> first_slot;  ///< overlay count + 1 entries
  IdVector<SlotId, SourceId> face;                ///< ascending within an overlay
  IdVector<SlotId, OverlayId> overlay_of_slot;
  IdVector<SourceId, SlotId> slot_of_face;  ///< invalid for a face without contact
  IdVector<OverlayId, PlanePoints> plane;   ///< corners of the lowest face
  IdVector<OverlayId, Axis>
      axis;  ///< one projection for all predicates of the overlay: the lowest of those of its faces, whatever their order

  [[nodiscard]] std::size_t size() const { return plane.size(); }
  [[nodiscard]] OverlayId of_face(SourceId f) const { return overlay_of_slot[slot_of_face[f]]; }
  [[nodiscard]] std::span<const SourceId> faces_of(OverlayId o) const {
    return std::span<const SourceId>(face.values()).subspan(first_slot[o], first_slot[OverlayId(o.index() + 1)] - first_slot[o]);
  }
};

/// Connected components of coplanar overlap (area > 0), not of equal planes (the paper leaves this case open, 4.3).
///
/// Differs from the paper: coincident faces are resolved here, before the face intersection map is built.
/// O(n) in the faces of all operands, plus n log n in those in contact.
[[nodiscard]] Overlays overlay_coplanar(const OperandFaces& faces, const Contacts& contacts);

}  // namespace mortise
