// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces of an operand that came to cross others of it when vertices moved.
#pragma once

#include <vector>

#include "mortise/boolean/imprinted_operand.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Faces of a mesh that moved or were divided and now meet others beyond what they share, and these others; not where whole
/// triangles coincide. Also where the faces met already before.
///
/// @param given  with at least as many faces as source_face of the operand names
/// @return faces of the mesh as given, ascending
/// O(n log n), plus time in proportion to the pairs whose boxes meet.
[[nodiscard]] std::vector<std::uint32_t> find_folded_faces(const SurfaceMesh& given, const ImprintedOperand& changed);

}  // namespace mortise
