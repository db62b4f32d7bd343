// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Smaller triangles where a mesh deviates from the given one by more than a bound.
#pragma once

#include <functional>
#include <vector>

#include "mortise/remesh/beyond_bound.h"
#include "mortise/remesh/working_mesh.h"

namespace mortise {

/// Places where the surface of the mesh and that of the given one are too far apart, on both.
struct DeviatingPlaces {
  std::vector<PlaceBeyond> of_mesh;   ///< triangles of the mesh under change, `closest` of the given one
  std::vector<PlaceBeyond> of_given;  ///< the other way round

  [[nodiscard]] bool empty() const { return of_mesh.empty() && of_given.empty(); }
  [[nodiscard]] double count() const { return static_cast<double>(of_mesh.size() + of_given.size()); }
};

[[nodiscard]] DeviatingPlaces find_deviating(const WorkingMesh& w, const FacedMesh& given, double bound);

/// Remeshes what is round places that deviate, in smaller sizes there, round after round as long as fewer deviate; all else stays as it is.
/// Returns what is left.
///
/// @param remesh_zone  changes what may change
/// @param sources  of the smaller sizes: more are added
[[nodiscard]] DeviatingPlaces bound_deviation(WorkingMesh& w, const FacedMesh& given, double bound,
                                              const std::function<void(WorkingMesh&)>& remesh_zone, std::vector<SizeSource>& sources);

}  // namespace mortise
