// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Gmsh's answer, by its command line.
#pragma once

#include <string>

#include "remesher_answer.h"

namespace mortise::peers {

/// Surfaces classified by our angles, parametrised, and meshed anew by Gmsh's frontal algorithm with one size. Time is processor time of
/// the whole program, files included; memory is its peak.
/// @param path  of files to make: path.stl, path.geo, path.msh, path.log
[[nodiscard]] RemesherAnswer gmsh_remesh(const SurfaceMesh& mesh, double size, const std::string& path);

}  // namespace mortise::peers
