// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The unions whose time is compared with that of peers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise::peers {

/// Operands of one union; every coordinate is a float32, so that each library can take the same ones.
struct SpeedScene {
  std::string name;
  std::vector<SurfaceMesh> operands;
  std::vector<std::size_t> runs;  ///< how a library of pairs had best fold them: unite each run of this many, then runs of those
};

/// Two geodesic spheres, a scan with itself (where the data are), eight tori, a block of 1,000 cubes.
[[nodiscard]] std::vector<SpeedScene> make_speed_scenes();

}  // namespace mortise::peers
