// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// All sources of a facet of a result in one list, and how it lies seen from each of them.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/provenance.h"

namespace mortise {

/// A face of an operand that contains a facet.
struct SourceFace {
  std::uint32_t operand, face;
  bool is_flipped;  ///< the facet runs against it

  auto operator<=>(const SourceFace&) const = default;
};

/// The sources of a facet, the first one first.
[[nodiscard]] std::vector<SourceFace> facet_sources(const Provenance& provenance, std::size_t facet);

/// How a facet lies to all operands but that of `own`, one of its sources. Needs both coverings.
[[nodiscard]] FacetCategory category_seen_from(const SourceFace& own, const std::vector<SourceFace>& sources, const Provenance& provenance,
                                               std::size_t facet);

}  // namespace mortise
