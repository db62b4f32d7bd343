// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact points became doubles: a proof that this added no crossing, or a list of where it did.
#pragma once

#include "mortise/base/progress.h"
#include "mortise/boolean/merge.h"

namespace mortise {

/// Two triangles of a result that meet beyond what they share; the same one twice when it has no area.
struct FailedPair {
  FaceId a, b;
};

struct CertifiedMesh {
  Certificate certificate;
  std::vector<FailedPair> failed;  ///< every pair behind Certificate::failed_faces
};

/// The certificate of level `relative` (exact-core 5): if the operands had no crossing, the result has none.
///
/// Tested are all triangles with a vertex that is not its exact point, or repaired, each against every triangle whose box
/// it meets: they have area, and they meet exactly in what they share. Round an edge with more than two triangles their
/// order is the exact one; round an edge that a repair made, inside and outside alternate, or, where inner faces are kept,
/// every space has one set of operands. A shell about as thin as vertices moved keeps its sense.
/// @throws Error{Cancelled}
/// O(n log n) in the result.
[[nodiscard]] CertifiedMesh certify(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged,
                                    const ProgressCallback& progress);

}  // namespace mortise
