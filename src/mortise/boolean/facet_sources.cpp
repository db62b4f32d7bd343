// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reads the sources of facets from provenance.
#include "mortise/boolean/facet_sources.h"

#include <algorithm>

namespace mortise {
namespace {

// Is there an operand other than `own` in both of two ascending lists?
bool share_another(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b, std::uint32_t own) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t k) { return k != own && std::binary_search(b.begin(), b.end(), k); });
}

}  // namespace

std::vector<SourceFace> facet_sources(const Provenance& p, std::size_t facet) {
  std::vector<SourceFace> sources{{p.source_operand[facet], p.source_face[facet], p.flipped[facet] != 0}};
  for (std::uint32_t i = p.other_source_begin[facet]; i < p.other_source_begin[facet + 1]; ++i) {
    sources.push_back({p.other_source_operand[i], p.other_source_face[i], p.other_source_flipped[i] != 0});
  }
  return sources;
}

FacetCategory category_seen_from(const SourceFace& own, const std::vector<SourceFace>& sources, const Provenance& p, std::size_t facet) {
  bool coincides = false;
  for (const SourceFace& s : sources) {
    if (s.operand == own.operand) continue;
    if (s.is_flipped == own.is_flipped) return FacetCategory::OnSame;
    coincides = true;
  }
  if (coincides) return FacetCategory::OnOpposite;
  const auto &behind = p.covering_sets[p.covering[facet]], &in_front = p.covering_sets[p.covering_front[facet]];
  return share_another(behind, in_front, own.operand) ? FacetCategory::Inside : FacetCategory::Outside;
}

}  // namespace mortise
