// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizes that features too small for the sizes wanted ask for: else there are no good triangles at them (paper 7.3).
#pragma once

#include <cstddef>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

struct SmallFeatureRules {
  double least = 0;     ///< edge length: smaller features are left as they are
  double growth = 1.2;  ///< of the sources
};

struct SmallFeatures {
  std::vector<SizeSource> sources;
  std::size_t short_edges = 0;   ///< model edges
  std::size_t close_places = 0;  ///< on model edges
};

/// Model edges below 0.7 of the size ask for their length, closed ones for a third of it. Where two parts of the model edges of one face
/// have less than 0.7 of the size of it between them, both ask for equilateral triangles as high as the gap; but not where they meet in one
/// model vertex: towards it there is no end to that. Edges are looked at every half size. Seams are no features.
///
/// @throws what check_sources does about the growth; Error{InvalidArgument} for a `least` that is negative or not finite
[[nodiscard]] SmallFeatures find_small_features(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizes,
                                                const SmallFeatureRules& rules = {});

}  // namespace mortise
