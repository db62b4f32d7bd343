// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Groups the faces in contact by coplanar overlap.
#include "mortise/arrange/overlay_coplanar.h"

#include <algorithm>

#include "mortise/base/union_find.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

constexpr std::uint32_t untouched = 0xffffffffU;

// Numbers the faces in contact, in their order.
IdVector<SourceId, std::uint32_t> number_touched(const OperandFaces& faces, const Contacts& contacts) {
  IdVector<SourceId, std::uint32_t> number(faces.corners.size(), untouched);
  for (const Contact& c : contacts.contacts) number[c.face_a] = number[c.face_b] = 0;
  for (const StrayPoint& s : contacts.stray_points) number[s.face] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t& n : number) {
    if (n != untouched) n = count++;
  }
  return number;
}

// (representative, member) for every face in contact, grouped by the lowest face of its overlay.
std::vector<std::pair<SourceId, SourceId>> group_by_overlap(const Contacts& contacts, const IdVector<SourceId, std::uint32_t>& number) {
  std::vector<SourceId> touched;
  for (std::size_t f = 0; f < number.size(); ++f) {
    if (number[SourceId(f)] != untouched) touched.push_back(SourceId(f));
  }
  UnionFind groups(touched.size());
  for (const Contact& c : contacts.contacts) {
    if (c.kind == PairContact::Overlap) groups.join(number[c.face_a], number[c.face_b]);
  }
  std::vector<std::pair<SourceId, SourceId>> members;
  for (std::uint32_t i = 0; i < touched.size(); ++i) members.emplace_back(touched[groups.find(i)], touched[i]);
  std::sort(members.begin(), members.end());
  return members;
}

}  // namespace

Overlays overlay_coplanar(const OperandFaces& faces, const Contacts& contacts) {
  Overlays overlays;
  overlays.slot_of_face.resize(faces.corners.size());
  for (const auto& [representative, f] : group_by_overlap(contacts, number_touched(faces, contacts))) {
    const TriangleCorners t = corners_of(faces, f);
    const Axis axis = *projection_axis(t.position[0], t.position[1], t.position[2]);
    if (representative == f) {
      overlays.first_slot.push_back(static_cast<std::uint32_t>(overlays.face.size()));
      overlays.plane.push_back(faces.corners[f]);
      overlays.axis.push_back(axis);
    }
    Axis& of_plane = overlays.axis[OverlayId(overlays.plane.size() - 1)];
    of_plane = std::min(of_plane, axis);
    overlays.slot_of_face[f] = overlays.face.push_back(f);
    overlays.overlay_of_slot.push_back(OverlayId(overlays.plane.size() - 1));
  }
  overlays.first_slot.push_back(static_cast<std::uint32_t>(overlays.face.size()));
  return overlays;
}

}  // namespace mortise
