// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Components set into a host, as a gun into a deck (paper Fig. 16, 28).
#pragma once

#include <span>

#include "mortise/boolean/evaluate_boolean.h"

namespace mortise {

/// What becomes of the faces between the host and a component.
enum class ImplantContact : std::uint8_t {
  Keep,  ///< they stay, once: host and components are regions of their own
  Drop,  ///< they go: one body
};

/// The host, which comes first, with components set into it; both sides share every edge of the loops.
///
/// Host faces inside a component go; where faces coincide there is one. A component stays entire, also where it lies inside the
/// host: there the space is the component's (where components overlap, the last one's). The result is a partition into the
/// components and what is left of the host: `covering` and `covering_front` name the one owner of a space, faces between two
/// owners run outwards of the later one. Sheets stay where no later component has the space. With ImplantContact::Drop it is the union
/// (docs/decisions/005).
/// @throws Error{InvalidArgument} for less than two operands, and what evaluate_boolean throws
[[nodiscard]] BooleanResult implant(const OperandList& operands, ImplantContact contact = ImplantContact::Keep,
                                    const BooleanOptions& options = {});

}  // namespace mortise
