// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The public door of the booleans: any number of solids, one exact arrangement, one rule.
#pragma once

#include <cstdint>
#include <span>

#include "mortise/base/progress.h"
#include "mortise/boolean/operation.h"
#include "mortise/boolean/result.h"

namespace mortise {

struct BooleanOptions {
  ProgressCallback progress;
  std::uint64_t contact_memory = std::uint64_t{1} << 31;  ///< bytes the candidate pairs may take
};

/// The union, the intersection, the first operand minus all others, what lies in an odd number of operands, or the partition:
/// the union with the faces inside it that separate regions of different operands, each of them once.
///
/// Operands are solids: closed, oriented outwards, in any number (one resolves itself); vertices need not be shared. They
/// may touch, coincide, contain one another, have cavities and cross themselves. A point is inside an operand where its
/// winding is positive; a crossing of one connected part with itself that no other operand comes near stays as it is
/// (docs/decisions/004). An empty result is a mesh without triangles.
/// @throws Error{NotFinite, BadIndex, NotClosed, NotOriented, InsideOut, OutOfRange, ResultTooLarge, Cancelled}
/// Near-linear in the operands, plus time in proportion to the contact. Exact until the vertices are rounded, once.
[[nodiscard]] BooleanResult evaluate_boolean(Operation operation, std::span<const SurfaceMesh* const> operands,
                                             const BooleanOptions& options = {});

[[nodiscard]] BooleanResult unite(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult intersect(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult subtract(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult symmetric_difference(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult partition(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});

}  // namespace mortise
