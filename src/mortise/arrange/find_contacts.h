// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps 1 to 3 of the paper: which faces touch, and where on each of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/arrange/classify_pair.h"
#include "mortise/arrange/operand_faces.h"
#include "mortise/base/progress.h"

namespace mortise {

/// Two faces that touch, face_a < face_b.
struct Contact {
  SourceId face_a, face_b;
  PairContact kind = PairContact::Touching;
  std::uint32_t first_incidence = 0;
  std::uint32_t incidence_count = 0;
};

/// A corner of a face without area that lies on an edge or inside of another face of its operand.
struct StrayPoint {
  PointId point;
  SourceId face;
  Feature feature;
};

struct Contacts {
  std::vector<Contact> contacts;  ///< sorted by (face_a, face_b), no duplicates
  std::vector<Incidence> incidences;
  std::vector<StrayPoint> stray_points;
  std::uint64_t candidate_pairs = 0;

  [[nodiscard]] std::span<const Incidence> incidences_of(const Contact& contact) const {
    return {incidences.data() + contact.first_incidence, contact.incidence_count};
  }
};

/// All touching pairs of faces of different operands, and of one operand where its SelfContacts asks for it.
///
/// Pairs that only share corners or an edge of one operand are not contacts.
/// @param memory  bytes the candidate pairs may take
/// @throws Error{ResultTooLarge, Cancelled}
/// O(n log n) in the faces, plus time in proportion to the pairs whose boxes meet.
[[nodiscard]] Contacts find_contacts(const OperandFaces& faces, std::uint64_t memory, const ProgressCallback& progress);

/// Do two faces with area meet in more than the corners or the edge they share?
[[nodiscard]] bool meet_beyond_shared(const OperandFaces& faces, SourceId f, SourceId g);

/// Corners and positions of a face, as classify_pair reads them.
[[nodiscard]] TriangleCorners corners_of(const OperandFaces& faces, SourceId f);

}  // namespace mortise
