// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact points became doubles: a proof that this added no crossing, or a list of where it did.
#pragma once

#include "mortise/base/progress.h"
#include "mortise/boolean/merge.h"

namespace mortise {

/// The certificate of level `relative` (exact-core 5): if the operands had no crossing, the result has none.
///
/// Tested are all triangles with a vertex that is not its exact point, each against every triangle whose box it meets:
/// they have area, they meet exactly in the corners they share, and the order of triangles round an edge with more than two
/// is the exact one. Every closed shell all of whose vertices moved keeps the sign of its volume.
/// @throws Error{Cancelled}
/// O(n log n) in the tested triangles and what is near them.
[[nodiscard]] Certificate certify(const OperandFaces& faces, const Facets& facets, std::span<const KeptFacet> kept, const MergedMesh& merged,
                                  const ProgressCallback& progress);

}  // namespace mortise
