// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Walks the graph of regions and patches with one running winding.
#include "mortise/boolean/categorize.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mortise/base/error.h"

namespace mortise {
namespace {

// Patches at each region, as one array.
struct RegionArcs {
  std::vector<std::uint32_t> first;
  std::vector<PatchId> patches;
};

RegionArcs collect_arcs(const Patches& patches) {
  RegionArcs arcs;
  arcs.first.assign(patches.region_count + 1, 0);
  for (std::size_t p = 0; p < patches.front.size(); ++p) {
    ++arcs.first[patches.front[PatchId(p)].index() + 1];
    ++arcs.first[patches.back[PatchId(p)].index() + 1];
  }
  for (std::size_t r = 0; r < patches.region_count; ++r) arcs.first[r + 1] += arcs.first[r];
  arcs.patches.resize(2 * patches.front.size());
  std::vector<std::uint32_t> next(arcs.first.begin(), arcs.first.end() - 1);
  for (std::size_t p = 0; p < patches.front.size(); ++p) {
    arcs.patches[next[patches.front[PatchId(p)].index()]++] = PatchId(p);
    arcs.patches[next[patches.back[PatchId(p)].index()]++] = PatchId(p);
  }
  return arcs;
}

class RegionWalk {
 public:
  RegionWalk(const OperandFaces& faces, const Facets& facets, const Patches& patches)
      : patches_(patches),
        arcs_(collect_arcs(patches)),
        visited_(patches.region_count, 0),
        winding_(std::vector<int>(faces.operand_count(), 0)) {
    for (const FacetId f : patches.first_facet) jumps_.push_back(jumps_of(faces, facets, f));
  }

  template <class Visit>
  void walk_from(const Seed& seed, Visit visit) {
    winding_.change_to(seed.winding);
    std::vector<Step> path{{seed.outside, PatchId(), arcs_.first[seed.outside.index()]}};
    visited_[seed.outside.index()] = 1;
    visit_next(seed.outside, visit);
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next_arc == arcs_.first[step.region.index() + 1]) {
        if (step.entered_by.is_valid()) cross(step.entered_by, step.region);
        path.pop_back();
        continue;
      }
      const PatchId patch = arcs_.patches[step.next_arc++];
      const RegionId from = step.region;
      const RegionId to = patches_.front[patch] == from ? patches_.back[patch] : patches_.front[patch];
      if (visited_[to.index()] != 0) continue;
      cross(patch, from);
      visited_[to.index()] = 1;
      visit_next(to, visit);
      path.push_back({to, patch, arcs_.first[to.index()]});
    }
  }

 private:
  struct Step {
    RegionId region;
    PatchId entered_by;
    std::uint32_t next_arc;
  };

  void cross(PatchId patch, RegionId from) {
    const int sense = patches_.front[patch] == from ? 1 : -1;
    for (const Jump& j : jumps_[patch]) winding_.change(j.operand, sense * j.change);
  }

  template <class Visit>
  void visit_next(RegionId region, Visit visit) {
    visit(region, std::as_const(winding_));
    winding_.forget_crossed();
  }

  const Patches& patches_;
  RegionArcs arcs_;
  IdVector<PatchId, std::vector<Jump>> jumps_;
  std::vector<std::uint8_t> visited_;
  RunningWinding winding_;  // after a walk: of its seed
};

// The windings each operand takes anywhere.
struct WindingRange {
  IdVector<OperandId, int> lowest, highest;
};

WindingRange find_range(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  const std::size_t n = faces.operand_count();
  WindingRange range{IdVector<OperandId, int>(n, 0), IdVector<OperandId, int>(n, 0)};
  walk_regions(faces, facets, categories, [&](RegionId, const RunningWinding& w) {
    for (std::size_t i = 0; i < n; ++i) {
      const OperandId k(i);
      range.lowest[k] = std::min(range.lowest[k], w.of(k));
      range.highest[k] = std::max(range.highest[k], w.of(k));
    }
  });
  return range;
}

// Patches whose two sides do not differ by their jumps: an operand crosses itself unresolved.
std::vector<PatchId> find_torn_patches(const OperandFaces& faces, const Facets& facets, const Categories& categories) {
  const Patches& patches = categories.patches;
  IdVector<RegionId, std::uint64_t> digest(patches.region_count, 0);
  walk_regions(faces, facets, categories, [&](RegionId r, const RunningWinding& w) { digest[r] = w.digest(); });
  std::vector<PatchId> torn;
  for (std::size_t p = 0; p < patches.first_facet.size(); ++p) {
    std::uint64_t expected = digest[patches.front[PatchId(p)]];
    for (const Jump& j : jumps_of(faces, facets, patches.first_facet[PatchId(p)])) {
      expected += RunningWinding::digest_of_change(j.operand, j.change);
    }
    if (expected != digest[patches.back[PatchId(p)]]) torn.push_back(PatchId(p));
  }
  return torn;
}

// Operands whose winding does not fit the jumps of a torn patch.
void mark_torn_operands(const OperandFaces& faces, const Facets& facets, const Categories& categories,
                        IdVector<OperandId, std::uint8_t>& is_torn) {
  const Patches& patches = categories.patches;
  const std::vector<PatchId> torn = find_torn_patches(faces, facets, categories);
  if (torn.empty()) return;
  IdVector<RegionId, std::vector<int>> winding(patches.region_count);
  for (const PatchId p : torn) winding[patches.front[p]].resize(faces.operand_count());
  for (const PatchId p : torn) winding[patches.back[p]].resize(faces.operand_count());
  walk_regions(faces, facets, categories, [&](RegionId r, const RunningWinding& w) {
    for (std::size_t k = 0; k < winding[r].size(); ++k) winding[r][k] = w.of(OperandId(k));
  });
  for (const PatchId p : torn) {
    std::vector<int> expected = winding[patches.front[p]];
    for (const Jump& j : jumps_of(faces, facets, patches.first_facet[p])) expected[j.operand.index()] += j.change;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      if (expected[k] != winding[patches.back[p]][k]) is_torn[OperandId(k)] = 1;
    }
  }
}

void judge_operands(const OperandFaces& faces, const Facets& facets, Categories& categories) {
  const std::size_t n = faces.operand_count();
  const WindingRange range = find_range(faces, facets, categories);
  IdVector<OperandId, std::uint8_t> is_torn(n, 0);
  mark_torn_operands(faces, facets, categories, is_torn);
  IdVector<OperandId, std::uint8_t> is_unbalanced(n, 0);
  for (const UnbalancedEdge& e : categories.patches.unbalanced) is_unbalanced[e.operand] = 1;
  IdVector<OperandId, std::uint8_t> is_stacked(n, 0);
  for (const OperandId k : categories.patches.stacked) is_stacked[k] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const OperandId k(i);
    const bool is_simple = range.lowest[k] == 0 && range.highest[k] <= 1 && is_torn[k] == 0 && is_unbalanced[k] == 0 && is_stacked[k] == 0;
    const bool is_resolved = faces.self_contacts[k] == SelfContacts::All;
    if (!is_simple && !is_resolved) categories.doubtful.push_back(k);
    MORTISE_CHECK(is_torn[k] == 0 || !is_resolved || is_unbalanced[k] != 0, "operand " + std::to_string(i));
    if (range.highest[k] <= 0 && range.lowest[k] < 0) categories.inside_out.push_back(k);
  }
}

}  // namespace

Categories categorize(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets) {
  Categories categories;
  categories.patches = build_patches(faces, map, facets);
  categories.seeds = find_seeds(faces, facets, categories.patches);
  judge_operands(faces, facets, categories);
  return categories;
}

void walk_regions(const OperandFaces& faces, const Facets& facets, const Categories& categories,
                  const std::function<void(RegionId, const RunningWinding&)>& visit) {
  RegionWalk walk(faces, facets, categories.patches);
  for (const Seed& seed : categories.seeds) walk.walk_from(seed, visit);
}

}  // namespace mortise
