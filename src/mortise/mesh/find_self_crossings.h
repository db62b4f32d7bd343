// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Finds the pairs of faces that meet in more than the corner or edge they share; exact.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/topology.h"

namespace mortise {

enum class PairMeeting : std::uint8_t {
  Apart,            ///< the closed triangles meet exactly in the simplex they share by vertex index, if any
  Crossing,         ///< in different planes, inner points of one are inner points of the other
  CoplanarOverlap,  ///< in one plane, with common area
  Touching,         ///< they meet beyond what they share, but only on the boundary of at least one
};

/// How two different faces of a mesh meet. Both have area; indices in range, coordinates finite. Exact, O(1).
[[nodiscard]] PairMeeting classify_meeting(const SurfaceMesh& mesh, FaceId a, FaceId b);

/// Has the face no area: a repeated vertex, or three points on a line?
[[nodiscard]] bool is_degenerate(const SurfaceMesh& mesh, FaceId face);

/// Do two different faces meet in more than the simplex they share? A face without area always does.
[[nodiscard]] bool triangles_meet_beyond_shared(const SurfaceMesh& mesh, FaceId a, FaceId b);

struct SelfCrossing {
  FaceId a, b;  ///< a < b
  PairMeeting kind = PairMeeting::Apart;

  auto operator<=>(const SelfCrossing&) const = default;
};

/// All pairs of faces that meet beyond what they share, sorted. Faces without area are left out: find them by
/// is_degenerate. Indices in range, coordinates finite.
/// O(n log n) in faces plus time in proportion to the pairs whose boxes meet.
[[nodiscard]] std::vector<SelfCrossing> find_self_crossings(const SurfaceMesh& mesh);

struct SelfCrossingCounts {
  std::uint64_t crossing = 0;
  std::uint64_t coplanar_overlap = 0;
  std::uint64_t touching = 0;
  std::uint64_t degenerate_faces = 0;
};

/// The number of pairs find_self_crossings finds, without storing them, and of the faces it leaves out.
[[nodiscard]] SelfCrossingCounts count_self_crossings(const SurfaceMesh& mesh);
[[nodiscard]] SelfCrossingCounts count_self_crossings(const SurfaceMesh& mesh, const MeshTopology& topology);

}  // namespace mortise
