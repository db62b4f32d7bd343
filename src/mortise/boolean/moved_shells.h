// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Shells that rounding turned inside out; only a shell all of whose vertices moved can be.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/boolean/merge.h"

namespace mortise {

/// One triangle of each shell (triangles connected through vertices) whose volume in doubles has not the sign of its exact
/// one; where inner faces are kept, the volume of the space of any one set of operands. Shells with a vertex that did not move
/// are left out.
/// @param is_moved  per vertex of the result
[[nodiscard]] std::vector<FaceId> find_turned_shells(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged,
                                                     const std::vector<std::uint8_t>& is_moved);

}  // namespace mortise
