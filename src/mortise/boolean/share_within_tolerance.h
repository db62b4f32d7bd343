// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operands that nearly touch get common vertices, edges and triangles (exact-core 6, tolerance).
#pragma once

#include <span>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/boolean/imprinted_operand.h"
#include "mortise/boolean/result.h"

namespace mortise {

/// Operands that share what lay within a tolerance, and what that took.
struct SharedOperands {
  std::vector<ImprintedOperand> operands;  ///< mesh, source_vertex and source_face; no data
  ToleranceReport report;
  std::vector<std::uint32_t> folded;  ///< ascending: operands that changed where they meet themselves beyond what their faces share
};

/// Vertices within the tolerance become one, at the place of one of them; a vertex within it of an edge or a face, where no vertex is
/// as near, becomes a vertex of that; edges that pass within it get a common vertex between them. Faces are triangulated again with these,
/// so that triangles of two faces whose corners are the same are the same triangles.
///
/// No vertex moves farther than the tolerance, every new one lies within it of the edges and faces it was put into, so a point of a
/// face moves by at most twice of it: once with the corners, once with what was put in. Neighbours stay joined: an edge is divided
/// once for all its faces. The same for every order of operands where nothing lies within the tolerance of more than one thing.
///
/// Decides in doubles what is near, and exactly what is a triangulation. A face on which the new vertices and edges do not fit
/// (it is about as thin as the tolerance) is listed, and keeps what fits. One whose corners became two or one is no face any more, and
/// listed: a part thinner than the tolerance vanishes. Where an operand is hardly thicker than the tolerance it may come to cross itself;
/// its faces there are listed as well, and whoever arranges it has to resolve its contacts with itself.
/// @param tolerance  length, > 0
/// @throws Error{Cancelled}
/// O(n log n), plus time in proportion to the pairs that are near.
[[nodiscard]] SharedOperands share_within_tolerance(std::span<const SurfaceMesh* const> operands, double tolerance,
                                                    const ProgressCallback& progress = {});

}  // namespace mortise
