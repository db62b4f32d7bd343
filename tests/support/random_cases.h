// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The cases of the random campaign: operands of six families that are hard for booleans, drawn from a seed and a number.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise::test {

enum class Family : std::uint8_t {
  Grid,     ///< small solids on a coarse grid, most contacts degenerate; also cavities and several shells
  Copies,   ///< a solid and itself moved, turned, scaled or jittered by 1 ulp to 1e-3
  Needles,  ///< needles, plates and slivers of aspect 1e3 to 1e8
  Fans,     ///< up to 1,000 facets at one vertex, met at the apex and along the edges of the fan
  Forests,  ///< one large face cut by up to 10,000 segments
  Curved,   ///< spheres, tori, cylinders and cones in any pose
};

inline constexpr std::size_t family_count = 6;

[[nodiscard]] std::string_view family_name(Family family);

/// Closed solids, oriented outwards, of winding 0 or 1 but for what the rounding of coordinates does to thin ones.
struct RandomCase {
  Family family = Family::Grid;
  std::vector<SurfaceMesh> operands;  ///< two to four
};

/// The same case for the same seed and number; one in some hundreds is a forest.
[[nodiscard]] RandomCase make_random_case(std::uint64_t seed, std::uint64_t number);

}  // namespace mortise::test
