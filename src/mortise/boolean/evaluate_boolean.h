// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The public door of the booleans: any number of solids, one exact arrangement, one rule.
#pragma once

#include <cstdint>

#include "mortise/arrange/operand_list.h"
#include "mortise/base/progress.h"
#include "mortise/boolean/operation.h"
#include "mortise/boolean/result.h"
#include "mortise/geom/coordinates.h"

namespace mortise {

struct BooleanOptions {
  ProgressCallback progress;
  std::vector<std::size_t> half_spaces;                   ///< positions of operands of make_half_space, which the result must not reach
  CertificateLevel certify = CertificateLevel::Relative;  ///< what the result has to be proven of
  Simplify simplify = Simplify::Off;                      ///< what of the cut is taken out of the result again
  Coordinates coordinates = Coordinates::Float64;         ///< what coordinates the result has, and the certificate is about
  double tolerance = 0;                                   ///< length: vertices, edges and faces this near are made to share (0: none)
  bool require_solids = false;                            ///< operands with a border are errors, not sheets
  std::uint64_t contact_memory = std::uint64_t{1} << 31;  ///< bytes the candidate pairs may take
};

/// The union, the intersection, the first operand minus all others, what lies in an odd number of operands, or the partition:
/// the union with the faces inside it that separate regions of different operands, each of them once.
///
/// Operands are closed and oriented outwards, or open sheets, in any number (one resolves itself); vertices need not be shared. Each is
/// a mesh, or a prepared one where a map puts it: the result is the same to the last bit.
/// They may touch, coincide, contain one another, have cavities and walls and cross themselves. A point is inside a solid where
/// its winding is positive; a crossing of one connected part with itself that no other operand comes near stays as it is
/// (docs/decisions/004). An empty result is a mesh without triangles.
///
/// Sheets are sets of points without volume; see select() for what becomes of them. Subtracted from a solid, a sheet takes what
/// lies behind it where it separates the solid; where it ends inside, report.notes says so. All walls stay in a partition.
/// A half-space (BooleanOptions::half_spaces) may be any operand of a call whose result is bounded; in a partition it divides
/// the others.
/// @throws Error{InvalidArgument} when the result would reach to infinity
/// @throws Error{NotFinite, BadIndex, NotClosed, NotOriented, InsideOut, OutOfRange, ResultTooLarge, Cancelled}
/// Near-linear in the operands, plus time in proportion to the contact. Exact until the vertices are rounded, once.
[[nodiscard]] BooleanResult evaluate_boolean(Operation operation, const OperandList& operands, const BooleanOptions& options = {});

[[nodiscard]] BooleanResult unite(const Operand& a, const Operand& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult intersect(const Operand& a, const Operand& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult subtract(const Operand& a, const Operand& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult symmetric_difference(const Operand& a, const Operand& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult partition(const Operand& a, const Operand& b, const BooleanOptions& options = {});

}  // namespace mortise
