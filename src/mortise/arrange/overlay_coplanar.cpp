// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Groups the faces in contact by coplanar overlap.
#include "mortise/arrange/overlay_coplanar.h"

#include <algorithm>

#include "mortise/base/union_find.h"
#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

std::vector<SourceId> faces_in_contact(const Contacts& contacts) {
  std::vector<SourceId> result;
  for (const Contact& c : contacts.contacts) {
    result.push_back(c.face_a);
    result.push_back(c.face_b);
  }
  for (const StrayPoint& s : contacts.stray_points) result.push_back(s.face);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::uint32_t position_in(const std::vector<SourceId>& sorted, SourceId f) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), f) - sorted.begin());
}

// (representative, member) for every face in contact, grouped by the lowest face of its overlay.
std::vector<std::pair<std::uint32_t, std::uint32_t>> group_by_overlap(const Contacts& contacts, const std::vector<SourceId>& touched) {
  UnionFind groups(touched.size());
  for (const Contact& c : contacts.contacts) {
    if (c.kind == PairContact::Overlap) groups.join(position_in(touched, c.face_a), position_in(touched, c.face_b));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members;
  for (std::uint32_t i = 0; i < touched.size(); ++i) members.emplace_back(groups.find(i), i);
  std::sort(members.begin(), members.end());
  return members;
}

}  // namespace

Overlays overlay_coplanar(const OperandFaces& faces, const Contacts& contacts) {
  const std::vector<SourceId> touched = faces_in_contact(contacts);
  Overlays overlays;
  overlays.slot_of_face.resize(faces.corners.size());
  for (const auto& [representative, member] : group_by_overlap(contacts, touched)) {
    const SourceId f = touched[member];
    if (representative == member) {
      const TriangleCorners t = corners_of(faces, f);
      overlays.first_slot.push_back(static_cast<std::uint32_t>(overlays.face.size()));
      overlays.plane.push_back(faces.corners[f]);
      overlays.axis.push_back(*projection_axis(t.position[0], t.position[1], t.position[2]));
    }
    overlays.slot_of_face[f] = overlays.face.push_back(f);
    overlays.overlay_of_slot.push_back(OverlayId(overlays.plane.size() - 1));
  }
  overlays.first_slot.push_back(static_cast<std::uint32_t>(overlays.face.size()));
  return overlays;
}

}  // namespace mortise
