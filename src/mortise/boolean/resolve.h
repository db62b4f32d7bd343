// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A mesh that overlaps itself becomes the boundary of what it covers.
#pragma once

#include "mortise/boolean/evaluate_boolean.h"

namespace mortise {

/// The boundary of the space where the winding of a mesh is positive: the union of one operand.
///
/// All crossings of the mesh with itself are found, also those within one connected part, which a boolean of several operands
/// leaves alone away from the others (docs/decisions/004). Overlapping and nested parts count once, doubled faces once, faces
/// that cancel not at all; a mesh without any of these comes back as it was.
/// @throws what evaluate_boolean does
/// Near-linear in the faces, plus time in proportion to the crossings.
[[nodiscard]] BooleanResult resolve(const Operand& mesh, const BooleanOptions& options = {});

}  // namespace mortise
