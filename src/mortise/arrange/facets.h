// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The arrangement: all facets of all operands, each of them once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mortise/arrange/operand_faces.h"

namespace mortise {

using FacetId = Id<struct FacetTag>;

/// A face that contains a facet.
struct FacetSource {
  SourceId face;
  bool is_opposite = false;  ///< the facet runs the other way round than this face
};

/// Facets meet in shared points and whole shared edges only. A face without contact is one facet.
struct Facets {
  IdVector<FacetId, PlanePoints> corners;         ///< run as in the first source
  IdVector<FacetId, std::uint32_t> first_source;  ///< facet count + 1 entries
  std::vector<FacetSource> sources;               ///< per facet ascending by face; several where faces coincide

  [[nodiscard]] std::size_t size() const { return corners.size(); }
  [[nodiscard]] std::span<const FacetSource> sources_of(FacetId f) const {
    return std::span<const FacetSource>(sources).subspan(first_source[f], first_source[FacetId(f.index() + 1)] - first_source[f]);
  }
};

}  // namespace mortise
