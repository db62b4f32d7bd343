// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Shells that rounding turned inside out; only one about as thin as vertices moved can be.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/boolean/merge.h"

namespace mortise {

/// The triangle at the lowest place of each shell (triangles connected through vertices) whose volume, of its coordinates, has not the sign
/// of its exact one; where inner faces are kept, the volume of the space of any one set of operands. Shells are left out that have no
/// vertex that moved, or volumes larger than the motion of their surface explains.
/// @param is_moved      per vertex of the result
/// @param displacement  the farthest that any point moved
[[nodiscard]] std::vector<FaceId> find_turned_shells(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged,
                                                     const std::vector<std::uint8_t>& is_moved, double displacement);

}  // namespace mortise
