// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Whether a closed surface runs outwards, exactly.
#pragma once

#include "mortise/exact/sign.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Sign of the volume a closed surface encloses, of its doubles, exact. Positive: oriented outwards. O(n).
[[nodiscard]] Sign enclosed_volume_sign(const SurfaceMesh& mesh);

}  // namespace mortise
