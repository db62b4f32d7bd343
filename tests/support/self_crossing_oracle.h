// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An oracle for self-crossings in big integers: it shares no code and no method with the mesh, exact and geom folders.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise::oracle {

enum class Meeting : std::uint8_t {
  Apart,
  Crossing,  ///< in different planes, inner points of both in common
  Overlap,   ///< in one plane, area in common
  Touching,  ///< anything else beyond the simplex shared by vertex index
};

struct MeetingPair {
  std::uint32_t face_a, face_b;  ///< face_a < face_b
  Meeting meeting;

  auto operator<=>(const MeetingPair&) const = default;
};

/// All pairs of faces with area that meet beyond what they share, sorted. A sweep over boxes, a filter in doubles with a
/// plain error bound, then integers: the points of each triangle on the common line, or corners in triangles.
[[nodiscard]] std::vector<MeetingPair> self_crossings(const SurfaceMesh& mesh);

/// Faces without area, ascending.
[[nodiscard]] std::vector<std::uint32_t> faces_without_area(const SurfaceMesh& mesh);

}  // namespace mortise::oracle
