// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The connected solids that a closed mesh bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

struct MeshRegion {
  double volume = 0;  ///< without its cavities
  double area = 0;    ///< of its whole boundary, cavities included
};

struct MeshRegions {
  std::vector<std::uint32_t> region_of_face;  ///< index into regions
  std::vector<MeshRegion> regions;            ///< in the order of their lowest faces
};

/// Solids connected through their inside: bodies that touch in an edge or a corner are two, a body and its cavities one.
///
/// The mesh is closed and oriented (inside behind its faces) and does not cross itself; a cavity goes to the body it lies
/// in, by an exact ray.
/// O(n log n) in faces, plus a ray for each cavity.
[[nodiscard]] MeshRegions find_regions(const SurfaceMesh& mesh);

}  // namespace mortise
