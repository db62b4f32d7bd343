// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where the facets and vertices of a result come from.
#pragma once

#include <cstdint>
#include <vector>

namespace mortise {

/// Where every facet and vertex of a result comes from.
struct Provenance {
  std::vector<std::uint32_t> source_operand;        ///< per facet; the lowest operand where several coincide
  std::vector<std::uint32_t> source_face;           ///< per facet: triangle of that operand
  std::vector<std::uint8_t> flipped;                ///< per facet: 1 when it runs against its source
  std::vector<std::uint32_t> other_source_begin;    ///< CSR: facet count + 1 offsets into the two arrays below
  std::vector<std::uint32_t> other_source_operand;  ///< further sources that coincide with a facet
  std::vector<std::uint32_t> other_source_face;
  std::vector<std::uint32_t> vertex_operand;  ///< per vertex: operand of its source vertex, or none
  std::vector<std::uint32_t> vertex_source;   ///< per vertex: vertex of that operand, or none for a made vertex
  static constexpr std::uint32_t none = 0xffffffffU;
};

}  // namespace mortise
