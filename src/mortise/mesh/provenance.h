// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where the facets and vertices of a result come from.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/base/ids.h"

namespace mortise {

/// How a facet of a result lies to the operands other than its own (the paper's tags: 10 and 20 Outside, 11 and 21 Inside).
enum class FacetCategory : std::uint8_t {
  Outside,     ///< outside all of them
  Inside,      ///< inside one at least
  OnSame,      ///< coincides with a face of another operand, both run the same way
  OnOpposite,  ///< coincides with faces of another operand, all of them opposite
};

/// Where every facet and vertex of a result comes from.
struct Provenance {
  std::vector<std::uint32_t> source_operand;              ///< per facet; the lowest operand where several coincide
  std::vector<std::uint32_t> source_face;                 ///< per facet: triangle of that operand
  std::vector<std::uint8_t> flipped;                      ///< per facet: 1 when it runs against its source
  std::vector<FacetCategory> category;                    ///< per facet
  std::vector<std::uint32_t> covering;                    ///< per facet: index into covering_sets
  std::vector<std::vector<std::uint32_t>> covering_sets;  ///< operands that contain the space just behind a facet, ascending
  std::vector<std::uint32_t> covering_front;              ///< where there may be walls, else empty: the same for the space in front
  bool keeps_regions_apart = false;                       ///< spaces of different operands are different regions: a partition
  std::vector<std::uint32_t> other_source_begin;          ///< CSR: facet count + 1 offsets into the two arrays below
  std::vector<std::uint32_t> other_source_operand;        ///< further sources that coincide with a facet
  std::vector<std::uint32_t> other_source_face;
  std::vector<std::uint8_t> other_source_flipped;  ///< 1 when the facet runs against that source
  std::vector<std::uint32_t> vertex_operand;       ///< per vertex: operand of its source vertex, or none
  std::vector<std::uint32_t> vertex_source;        ///< per vertex: vertex of that operand, or none for a made vertex
  static constexpr std::uint32_t none = 0xffffffffU;

  /// A number for the space that these operands contain: equal for spaces that a result does not keep apart.
  [[nodiscard]] std::uint32_t space_of(std::uint32_t covering_set) const {
    return keeps_regions_apart ? covering_set : covering_sets[covering_set].empty() ? 0 : 1;
  }
};

/// A triangle of an operand that a facet is a part of.
struct FacetOrigin {
  std::uint32_t operand = 0, face = 0;
  bool is_flipped = false;  ///< the facet runs against it
};

/// Calls visit(FacetOrigin) for the first source of a facet, then for the further ones.
template <class Visit>
void for_each_source(const Provenance& p, FaceId facet, Visit visit) {
  const std::size_t t = facet.index();
  visit(FacetOrigin{p.source_operand[t], p.source_face[t], p.flipped[t] != 0});
  if (p.other_source_begin.empty()) return;
  for (std::uint32_t i = p.other_source_begin[t]; i < p.other_source_begin[t + 1]; ++i) {
    visit(FacetOrigin{p.other_source_operand[i], p.other_source_face[i], p.other_source_flipped[i] != 0});
  }
}

}  // namespace mortise
