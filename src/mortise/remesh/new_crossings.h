// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces that came to cross when their mesh changed.
#pragma once

#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/find_self_crossings.h"

namespace mortise {

/// Triangles that meet beyond what they share, but those of two model faces that cross in the given mesh already.
/// @param face_of_triangle  of the mesh
/// @param outside  the first so many triangles are as they were: O(n) for these, but near the others
[[nodiscard]] std::vector<SelfCrossing> find_new_crossings(const SurfaceMesh& mesh, const std::vector<ModelFaceId>& face_of_triangle,
                                                           std::size_t outside, const SurfaceMesh& given,
                                                           const ClassifiedBrep& given_model);

}  // namespace mortise
