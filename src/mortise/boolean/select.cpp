// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A facet stays where the rule differs on its sides.
#include "mortise/boolean/select.h"

#include <algorithm>

namespace mortise {

bool is_inside_result(Operation operation, const RunningWinding& winding) {
  switch (operation) {
    case Operation::Union:
    case Operation::Partition:
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

// No facet yet; who contains each region.
Selection with_all_coverings(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection;
  selection.operands_inside.resize(categories.patches.region_count);
  walk_regions(faces, facets, categories, [&](RegionId r, const RunningWinding& w) { selection.operands_inside[r] = operands_inside(w); });
  return selection;
}

// How many operands but for its own contain a facet that coincides with no other operand.
std::uint32_t count_others(const std::vector<OperandId>& front, const std::vector<OperandId>& back, OperandId own) {
  const bool winds_twice = std::binary_search(front.begin(), front.end(), own) && std::binary_search(back.begin(), back.end(), own);
  return static_cast<std::uint32_t>(std::min(front.size(), back.size())) - (winds_twice ? 1 : 0);
}

KeptFacet kept_as_it_is(const OperandFaces& faces, const Facets& facets, const Patches& patches, const Selection& selection, FacetId f) {
  const RegionId front = patches.front[patches.patch_of_facet[f]];
  const RegionId back = patches.back[patches.patch_of_facet[f]];
  const auto sources = facets.sources_of(f);
  const std::uint32_t others =
      count_others(selection.operands_inside[front], selection.operands_inside[back], faces.operand[sources.front().face]);
  return {f, false, category_of(faces, sources, others), back, front};
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
    const FacetCategory category = category_of(faces, facets.sources_of(f), others);
    const bool is_flipped = notes[front].is_inside;
    selection.kept.push_back({f, is_flipped, category, is_flipped ? front : back, is_flipped ? back : front});
  }
  return selection;
}

Selection select(Operation operation, const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  if (operation == Operation::Partition) return select_partition(faces, facets, categories);
  return select([operation](const RunningWinding& w) { return is_inside_result(operation, w); }, faces, facets, categories);
}

Selection select_partition(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  const Patches& patches = categories.patches;
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_inner_faces = true;
  IdVector<PatchId, std::uint8_t> separates;
  for (std::size_t p = 0; p < patches.first_facet.size(); ++p) {
    const PatchId patch(p);
    separates.push_back(selection.operands_inside[patches.front[patch]] != selection.operands_inside[patches.back[patch]] ? 1 : 0);
  }
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    if (separates[patches.patch_of_facet[f]] == 0) continue;
    KeptFacet kept = kept_as_it_is(faces, facets, patches, selection, f);
    if (selection.operands_inside[kept.inside].empty()) {
      kept.is_flipped = true;
      std::swap(kept.inside, kept.outside);
    }
    selection.kept.push_back(kept);
  }
  return selection;
}

Selection select_all(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_inner_faces = selection.keeps_all_sources = true;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    selection.kept.push_back(kept_as_it_is(faces, facets, categories.patches, selection, FacetId(i)));
  }
  return selection;
}

Selection select_implant(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_inner_faces = true;
  std::vector<KeptFacet> all;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    all.push_back(kept_as_it_is(faces, facets, categories.patches, selection, FacetId(i)));
  }
  for (std::vector<OperandId>& inside : selection.operands_inside) {
    if (inside.size() > 1) inside = {inside.back()};
  }
  for (KeptFacet& k : all) {
    const std::vector<OperandId>&behind = selection.operands_inside[k.inside], &in_front = selection.operands_inside[k.outside];
    if (behind == in_front) continue;
    k.is_flipped = behind < in_front;
    if (k.is_flipped) std::swap(k.inside, k.outside);
    selection.kept.push_back(k);
  }
  return selection;
}

Selection select_cut_faces(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_inner_faces = true;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    if (jumps_of(faces, facets, f).empty()) continue;
    selection.kept.push_back(kept_as_it_is(faces, facets, categories.patches, selection, f));
  }
  return selection;
}

}  // namespace mortise
