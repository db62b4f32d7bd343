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

// Runs like the first sheet it lies on.
bool runs_against_sheet(const OperandFaces& faces, std::span<const FacetSource> sources) {
  const auto first = std::find_if(sources.begin(), sources.end(), [&](const FacetSource& s) { return faces.is_wall[s.face] != 0; });
  return first->is_opposite;
}

// Patches of walls that belong to the result where it has no volume. Asks the rule once for each patch.
class KeptWalls {
 public:
  KeptWalls(const InsideRule& is_inside, const OperandFaces& faces, const Facets& facets, const Categories& categories)
      : faces_(faces), facets_(facets), patches_(categories.patches), keeps_(categories.patches.first_facet.size(), 0) {
    if (std::none_of(faces.kind.begin(), faces.kind.end(), has_walls)) return;
    operands_inside_ = with_all_coverings(faces, facets, categories).operands_inside;
    RunningWinding members(std::vector<int>(faces.operand_count(), 0));
    members.change_to(std::vector<int>(faces.operand_count(), 1));  // a rule that follows the walk hears of every operand
    for (std::size_t p = 0; p < keeps_.size(); ++p) {
      const PatchId patch(p);
      if (walls_of(faces, facets, patches_.first_facet[patch]).empty()) continue;
      members.change_to(operands_at(patch));
      keeps_[patch] = is_inside(members) ? 1 : 0;
      members.forget_crossed();
    }
  }

  [[nodiscard]] bool contains(FacetId f) const { return keeps_[patches_.patch_of_facet[f]] != 0; }

 private:
  // 1 for every operand that contains the patch.
  [[nodiscard]] std::vector<int> operands_at(PatchId patch) const {
    std::vector<int> is_member(faces_.operand_count(), 0);
    for (const OperandId k : operands_inside_[patches_.front[patch]]) is_member[k.index()] = 1;
    for (const OperandId k : operands_inside_[patches_.back[patch]]) is_member[k.index()] = 1;
    for (const OperandId k : walls_of(faces_, facets_, patches_.first_facet[patch])) is_member[k.index()] = 1;
    return is_member;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  const Patches& patches_;
  IdVector<RegionId, std::vector<OperandId>> operands_inside_;
  IdVector<PatchId, std::uint8_t> keeps_;
};

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
  const KeptWalls walls(is_inside, faces, facets, categories);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    const RegionId front = patches.front[patches.patch_of_facet[f]];
    const RegionId back = patches.back[patches.patch_of_facet[f]];
    const bool is_wall = !notes[front].is_inside && !notes[back].is_inside && walls.contains(f);
    if (notes[front].is_inside == notes[back].is_inside && !is_wall) continue;
    const std::uint32_t others = std::min(notes[front].inside_count, notes[back].inside_count);
    const FacetCategory category = category_of(faces, facets.sources_of(f), others);
    const bool is_flipped = is_wall ? runs_against_sheet(faces, facets.sources_of(f)) : notes[front].is_inside;
    selection.kept.push_back({f, is_flipped, category, is_flipped ? front : back, is_flipped ? back : front, is_wall});
    selection.keeps_walls |= is_wall;
  }
  return selection;
}

namespace {

// Sheets to subtract, where they lie inside a solid: they cut it once its cells are known.
void add_cutting_sheets(const OperandFaces& faces, const Facets& facets, const Categories& categories, Selection& selection) {
  const Patches& patches = categories.patches;
  IdVector<PatchId, std::uint8_t> cuts;
  for (std::size_t p = 0; p < patches.first_facet.size(); ++p) {
    const PatchId patch(p);
    const std::vector<OperandId> walls = walls_of(faces, facets, patches.first_facet[patch]);
    const bool is_sheet = std::any_of(walls.begin(), walls.end(), [](OperandId k) { return k != OperandId(0); });
    const bool is_inside =
        !selection.operands_inside[patches.front[patch]].empty() && !selection.operands_inside[patches.back[patch]].empty();
    cuts.push_back(is_sheet && is_inside ? 1 : 0);
  }
  const auto kept_count = static_cast<std::ptrdiff_t>(selection.kept.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    if (cuts[patches.patch_of_facet[f]] == 0) continue;
    selection.kept.push_back(kept_as_it_is(faces, facets, patches, selection, f));
    selection.kept.back().is_wall = true;
    selection.keeps_walls = selection.is_cut_by_sheets = true;
  }
  std::inplace_merge(selection.kept.begin(), selection.kept.begin() + kept_count, selection.kept.end(),
                     [](const KeptFacet& a, const KeptFacet& b) { return a.facet < b.facet; });
}

}  // namespace

Selection select(Operation operation, const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  if (operation == Operation::Partition) return select_partition(faces, facets, categories);
  Selection selection = select([operation](const RunningWinding& w) { return is_inside_result(operation, w); }, faces, facets, categories);
  if (operation == Operation::Subtract && faces.kind[OperandId(0)] != OperandKind::Sheet)
    add_cutting_sheets(faces, facets, categories, selection);
  return selection;
}

namespace {

// Space that only half-spaces reach belongs to no partition.
void empty_unbounded_regions(const OperandFaces& faces, Selection& selection) {
  const auto is_half_space = [&](OperandId k) { return faces.kind[k] == OperandKind::HalfSpace; };
  for (std::vector<OperandId>& operands : selection.operands_inside) {
    if (std::all_of(operands.begin(), operands.end(), is_half_space)) operands.clear();
  }
}

}  // namespace

Selection select_partition(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  const Patches& patches = categories.patches;
  Selection selection = with_all_coverings(faces, facets, categories);
  empty_unbounded_regions(faces, selection);
  selection.keeps_walls = selection.keeps_regions_apart = true;
  IdVector<PatchId, std::uint8_t> is_kept;
  for (std::size_t p = 0; p < patches.first_facet.size(); ++p) {
    const PatchId patch(p);
    const bool separates = selection.operands_inside[patches.front[patch]] != selection.operands_inside[patches.back[patch]];
    is_kept.push_back(separates || !walls_of(faces, facets, patches.first_facet[patch]).empty() ? 1 : 0);
  }
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    if (is_kept[patches.patch_of_facet[f]] == 0) continue;
    KeptFacet kept = kept_as_it_is(faces, facets, patches, selection, f);
    const bool is_void_behind = selection.operands_inside[kept.inside].empty();
    kept.is_wall = is_void_behind == selection.operands_inside[kept.outside].empty();
    if (is_void_behind && !kept.is_wall) {
      kept.is_flipped = true;
      std::swap(kept.inside, kept.outside);
    }
    selection.kept.push_back(kept);
  }
  return selection;
}

namespace {

// A wall where the operands are on both sides, or on neither.
KeptFacet kept_as_wall_or_not(const OperandFaces& faces, const Facets& facets, const Patches& patches, const Selection& selection,
                              FacetId f) {
  KeptFacet kept = kept_as_it_is(faces, facets, patches, selection, f);
  kept.is_wall = selection.operands_inside[kept.inside].empty() == selection.operands_inside[kept.outside].empty();
  return kept;
}

}  // namespace

Selection select_all(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_walls = selection.keeps_regions_apart = selection.keeps_all_sources = true;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    selection.kept.push_back(kept_as_wall_or_not(faces, facets, categories.patches, selection, FacetId(i)));
  }
  return selection;
}

Selection select_implant(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_walls = selection.keeps_regions_apart = true;
  std::vector<KeptFacet> all;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    all.push_back(kept_as_it_is(faces, facets, categories.patches, selection, FacetId(i)));
  }
  for (std::vector<OperandId>& inside : selection.operands_inside) {
    if (inside.size() > 1) inside = {inside.back()};
  }
  for (KeptFacet& k : all) {
    const std::vector<OperandId>&behind = selection.operands_inside[k.inside], &in_front = selection.operands_inside[k.outside];
    k.is_wall = behind.empty() == in_front.empty();
    if (behind == in_front) {  // a sheet stays where no later operand has the space
      const std::vector<OperandId> walls = walls_of(faces, facets, k.facet);
      if (walls.empty() || (!behind.empty() && walls.back() < behind.back())) continue;
    }
    k.is_flipped = behind < in_front;
    if (k.is_flipped) std::swap(k.inside, k.outside);
    selection.kept.push_back(k);
  }
  return selection;
}

Selection select_cut_faces(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  Selection selection = with_all_coverings(faces, facets, categories);
  selection.keeps_walls = selection.keeps_regions_apart = true;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId f(i);
    if (jumps_of(faces, facets, f).empty() && walls_of(faces, facets, f).empty()) continue;
    selection.kept.push_back(kept_as_wall_or_not(faces, facets, categories.patches, selection, f));
  }
  return selection;
}

}  // namespace mortise
