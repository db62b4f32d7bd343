// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The last repair: what rounding folded is arranged again from rounded points, some of them on a grid (exact-core 5, repair c).
#pragma once

#include <functional>
#include <span>

#include "mortise/boolean/evaluate_selection.h"

namespace mortise {

/// Evaluates the same selection on other operands, resolving all contacts these have with themselves.
using EvaluateAgain = std::function<EvaluatedSelection(std::span<const SurfaceMesh* const>)>;

/// Tries to get a certificate for a folded result: the operands as they were cut, rounded, are arranged and evaluated again, so that
/// regions and balance are found anew, round after round. At first all points are at their nearest coordinates; then those of failed
/// triangles, and all in their voxels, go to grids of 2^-46, 2^-40, 2^-34, 2^-28 and 2^-23 of their largest coordinate, two
/// rounds each; for float32 to grids of 2^-22 to 2^-14.
///
/// Provenance names the faces and vertices of the operands as given. Vertices of operands that had to move are made vertices
/// of the result, and listed in its certificate. Without success the result is left as it was.
void repair_by_snapping(const OperandList& operands, Coordinates coordinates, const EvaluateAgain& evaluate_again,
                        EvaluatedSelection& folded);

}  // namespace mortise
