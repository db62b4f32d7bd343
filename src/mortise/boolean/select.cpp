// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A facet stays where the rule differs on its sides.
#include "mortise/boolean/select.h"

#include <algorithm>

namespace mortise {

bool is_inside_result(Operation operation, const RunningWinding& winding) {
  switch (operation) {
    case Operation::Union:
      return winding.inside_count() > 0;
    case Operation::Intersect:
      return winding.inside_count() == winding.operand_count();
    case Operation::Subtract:
      return winding.inside_count() == 1 && winding.is_inside(OperandId(0));
    case Operation::SymmetricDifference:
      return winding.inside_count() % 2 == 1;
  }
  return false;
}

namespace {

// What the walk leaves behind for each region.
struct RegionNote {
  bool is_inside = false;
  std::uint32_t inside_count = 0;  // operands that contain it
};

FacetCategory category_of(const OperandFaces& faces, std::span<const FacetSource> sources, std::uint32_t others_inside) {
  const OperandId own = faces.operand[sources.front().face];
  bool coincides = false;
  for (const FacetSource& s : sources) {
    if (faces.operand[s.face] == own) continue;
    if (!s.is_opposite) return FacetCategory::OnSame;
    coincides = true;
  }
  if (coincides) return FacetCategory::OnOpposite;
  return others_inside > 0 ? FacetCategory::Inside : FacetCategory::Outside;
}

std::vector<OperandId> operands_inside(const RunningWinding& winding) {
  std::vector<OperandId> inside;
  for (std::size_t k = 0; inside.size() < winding.inside_count(); ++k) {
    if (winding.is_inside(OperandId(k))) inside.push_back(OperandId(k));
  }
  return inside;
}

}  // namespace

Selection select(const InsideRule& is_inside, const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  const Patches& patches = categories.patches;
  Selection selection;
  selection.operands_inside.resize(patches.region_count);
  IdVector<RegionId, RegionNote> notes(patches.region_count);
  walk_regions(faces, facets, categories, [&](RegionId r, const RunningWinding& w) {
    notes[r] = {is_inside(w), static_cast<std::uint32_t>(w.inside_count())};
    if (notes[r].is_inside) selection.operands_inside[r] = operands_inside(w);
  });
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    const RegionId front = patches.front[patches.patch_of_facet[f]];
    const RegionId back = patches.back[patches.patch_of_facet[f]];
    if (notes[front].is_inside == notes[back].is_inside) continue;
    const std::uint32_t others = std::min(notes[front].inside_count, notes[back].inside_count);
    selection.kept.push_back(
        {f, notes[front].is_inside, category_of(faces, facets.sources_of(f), others), notes[front].is_inside ? front : back});
  }
  return selection;
}

Selection select(Operation operation, const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  return select([operation](const RunningWinding& w) { return is_inside_result(operation, w); }, faces, facets, categories);
}

}  // namespace mortise
