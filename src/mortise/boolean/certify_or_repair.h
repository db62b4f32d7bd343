// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The doubles of a result with what is proven of them, after the repair of what rounding folded.
#pragma once

#include "mortise/boolean/certify.h"

namespace mortise {

struct RoundedResult {
  MergedMesh merged;
  CertifiedMesh certified;
  bool is_given_up = false;  ///< without a repair, and without a list of pairs that failed
};

/// Certifies the coordinates of a result. Where rounding folded it, merges and swaps within repair_reach, and certifies again as
/// long as there is something to repair, in so many rounds (exact-core 5, repair a and b; docs/decisions/003). Gives up at once when
/// a quarter of the vertices are at the float32 places of others: all triangles fail.
/// @throws Error{Cancelled}
[[nodiscard]] RoundedResult certify_or_repair(const OperandFaces& faces, const Facets& facets, MergedMesh merged, Coordinates coordinates,
                                              int most_rounds, const ProgressCallback& progress);

/// The certificate of a result raised to CertificateLevel::Absolute: all pairs of triangles are looked at, those also that the
/// operands had.
/// O(n log n) in the result, plus time in proportion to the pairs whose boxes meet.
[[nodiscard]] Certificate certify_all_pairs(const SurfaceMesh& mesh, Certificate relative);

}  // namespace mortise
