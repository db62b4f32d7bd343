// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Walks the graph of regions and patches with one running winding.
#include "mortise/boolean/categorize.h"

#include <algorithm>
#include <string>

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
      : patches_(patches), arcs_(collect_arcs(patches)), visited_(patches.region_count, 0) {
    for (const FacetId f : patches.first_facet) jumps_.push_back(jumps_of(faces, facets, f));
  }

  template <class Visit>
  void walk_from(const Seed& seed, Visit visit) {
    RunningWinding winding(seed.winding);
    std::vector<Step> path{{seed.outside, PatchId(), arcs_.first[seed.outside.index()]}};
    visited_[seed.outside.index()] = 1;
    visit(seed.outside, winding);
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next_arc == arcs_.first[step.region.index() + 1]) {
        if (step.entered_by.is_valid()) cross(step.entered_by, step.region, winding);
        path.pop_back();
        continue;
      }
      const PatchId patch = arcs_.patches[step.next_arc++];
      const RegionId from = step.region;
      const RegionId to = patches_.front[patch] == from ? patches_.back[patch] : patches_.front[patch];
      if (visited_[to.index()] != 0) continue;
      cross(patch, from, winding);
      visited_[to.index()] = 1;
      visit(to, winding);
      path.push_back({to, patch, arcs_.first[to.index()]});
    }
  }

 private:
  struct Step {
    RegionId region;
    PatchId entered_by;
    std::uint32_t next_arc;
  };

  void cross(PatchId patch, RegionId from, RunningWinding& winding) const {
    const int sense = patches_.front[patch] == from ? 1 : -1;
    for (const Jump& j : jumps_[patch]) winding.change(j.operand, sense * j.change);
  }

  const Patches& patches_;
  RegionArcs arcs_;
  IdVector<PatchId, std::vector<Jump>> jumps_;
  std::vector<std::uint8_t> visited_;
};

// Judges the windings each operand takes anywhere.
void judge_operands(const OperandFaces& faces, const Facets& facets, Categories& categories) {
  const std::size_t n = faces.operand_count();
  IdVector<OperandId, int> lowest(n, 0);
  IdVector<OperandId, int> highest(n, 0);
  walk_regions(faces, facets, categories, [&](RegionId, const RunningWinding& w) {
    for (std::size_t i = 0; i < n; ++i) {
      const OperandId k(i);
      lowest[k] = std::min(lowest[k], w.of(k));
      highest[k] = std::max(highest[k], w.of(k));
    }
  });
  IdVector<OperandId, std::uint8_t> is_unbalanced(n, 0);
  for (const UnbalancedEdge& e : categories.patches.unbalanced) is_unbalanced[e.operand] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const OperandId k(i);
    const bool is_simple = lowest[k] == 0 && highest[k] <= 1 && is_unbalanced[k] == 0;
    if (!is_simple && faces.self_contacts[k] != SelfContacts::All) categories.doubtful.push_back(k);
    if (highest[k] <= 0 && lowest[k] < 0) categories.inside_out.push_back(k);
  }
}

}  // namespace

RunningWinding::RunningWinding(std::vector<int> winding) : winding_(std::move(winding)) {
  for (const int w : winding_) inside_count_ += w > 0 ? 1 : 0;
}

void RunningWinding::change(OperandId k, int by) {
  int& w = winding_[k.index()];
  inside_count_ -= w > 0 ? 1 : 0;
  w += by;
  inside_count_ += w > 0 ? 1 : 0;
}

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
