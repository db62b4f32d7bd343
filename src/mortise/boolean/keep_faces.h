// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The faces of the arrangement chosen by the paper's tags (6.2, Fig. 16), for results no boolean gives.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mortise/boolean/evaluate_boolean.h"

namespace mortise {

/// Tags of facets. Of two operands, the paper's 10 and 11 are facets of the first outside and inside the second, 20 and 21
/// those of the second outside and inside the first; of more, "the second" are all others, and inside is inside one at least
/// of the operands that are not the facet's own. Facets that coincide are one, with a tag of its own.
enum class KeepTag : std::uint8_t {
  FirstOutside = 1,  ///< "10"
  FirstInside = 2,   ///< "11"
  OtherOutside = 4,  ///< "20"
  OtherInside = 8,   ///< "21"
  OnSame = 16,       ///< "same": coincides with a face of another operand that runs the same way
  OnOpposite = 32,   ///< "opposite": all faces of other operands it coincides with run against it
};

/// A set of tags: the sum of their values.
using KeepMask = std::uint8_t;

/// The set of the tags with these names.
/// @throws Error{InvalidArgument}
[[nodiscard]] KeepMask keep_mask(std::span<const std::string> names);

/// The facets whose tags are in the mask, each once and turned as in its first source; the result may be open.
///
/// Operands are those of evaluate_boolean, cut along all their contacts. Provenance::category and covering are as there. All cut
/// faces are rounded, repaired and certified together before any is left out: what different sets keep fits together vertex by
/// vertex, and the certificate is that of all faces; `failed_faces` names those of them that were kept.
/// @throws Error{InvalidArgument} for a mask of 64 and more, and what evaluate_boolean throws
[[nodiscard]] BooleanResult keep_faces(KeepMask mask, const OperandList& operands, const BooleanOptions& options = {});

}  // namespace mortise
