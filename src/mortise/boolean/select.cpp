// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One table of predicates, one rule.
#include "mortise/boolean/select.h"

namespace mortise {

std::string_view operation_name(Operation operation) {
  switch (operation) {
    case Operation::Union:
      return "union";
    case Operation::Intersect:
      return "intersect";
    case Operation::Subtract:
      return "subtract";
  }
  return "";
}

bool is_inside_result(Operation operation, const RunningWinding& winding) {
  switch (operation) {
    case Operation::Union:
      return winding.inside_count() > 0;
    case Operation::Intersect:
      return winding.inside_count() == winding.operand_count();
    case Operation::Subtract:
      return winding.inside_count() == 1 && winding.is_inside(OperandId(0));
  }
  return false;
}

std::vector<KeptFacet> select(Operation operation, const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  const Patches& patches = categories.patches;
  IdVector<RegionId, std::uint8_t> is_inside(patches.region_count, 0);
  walk_regions(faces, facets, categories,
               [&](RegionId r, const RunningWinding& w) { is_inside[r] = is_inside_result(operation, w) ? 1 : 0; });
  std::vector<KeptFacet> kept;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const PatchId patch = patches.patch_of_facet[FacetId(i)];
    const bool in_front = is_inside[patches.front[patch]] != 0;
    const bool behind = is_inside[patches.back[patch]] != 0;
    if (in_front != behind) kept.push_back({FacetId(i), in_front});
  }
  return kept;
}

}  // namespace mortise
