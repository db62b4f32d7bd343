// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces that collapsed.
#pragma once

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Is a vertex named twice? Such a face runs along its edges both ways and changes no balance.
[[nodiscard]] inline bool repeats_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace mortise
