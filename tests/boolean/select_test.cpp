// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operations as truth tables, and the facets they keep against windings by the oracle.
#include "mortise/boolean/select.h"

#include <algorithm>
#include <set>

#include "boolean/evaluation.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/grid_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation all_operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference};

/// The operations by their definition.
bool is_inside(Operation operation, const std::vector<int>& winding) {
  const auto inside = [](int w) { return w > 0; };
  if (operation == Operation::Union) return std::any_of(winding.begin(), winding.end(), inside);
  if (operation == Operation::Intersect) return std::all_of(winding.begin(), winding.end(), inside);
  if (operation == Operation::SymmetricDifference) return std::count_if(winding.begin(), winding.end(), inside) % 2 == 1;
  return inside(winding[0]) && std::none_of(winding.begin() + 1, winding.end(), inside);
}

/// All windings of n operands between lowest and highest.
std::vector<std::vector<int>> all_windings(std::size_t n, int lowest, int highest) {
  std::vector<std::vector<int>> result{{}};
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<std::vector<int>> longer;
    for (const std::vector<int>& w : result) {
      for (int x = lowest; x <= highest; ++x) {
        longer.push_back(w);
        longer.back().push_back(x);
      }
    }
    result = longer;
  }
  return result;
}

/// What a facet is to the operands other than its own, by the definition of the categories.
FacetCategory category_of(const Evaluation& scene, FacetId f, const WindingsBeside& windings) {
  const auto sources = scene.facets.sources_of(f);
  const OperandId own = scene.faces.operand[sources.front().face];
  bool is_opposite = false;
  for (const FacetSource& s : sources) {
    if (scene.faces.operand[s.face] == own) continue;
    if (!s.is_opposite) return FacetCategory::OnSame;
    is_opposite = true;
  }
  if (is_opposite) return FacetCategory::OnOpposite;
  for (std::size_t k = 0; k < windings.front.size(); ++k) {
    if (k != own.index() && windings.front[k] > 0) return FacetCategory::Inside;
  }
  return FacetCategory::Outside;
}

std::vector<OperandId> operands_in(const std::vector<int>& winding) {
  std::vector<OperandId> inside;
  for (std::size_t k = 0; k < winding.size(); ++k) {
    if (winding[k] > 0) inside.push_back(OperandId(k));
  }
  return inside;
}

void check_selection(Operation operation, const Evaluation& scene, const std::vector<WindingsBeside>& windings) {
  const Selection selection = select(operation, scene.faces, scene.facets, scene.categories);
  std::size_t next = 0;
  for (std::size_t i = 0; i < scene.facets.size(); ++i) {
    const WindingsBeside& w = windings[i];
    const bool in_front = is_inside(operation, w.front), behind = is_inside(operation, w.back);
    const bool is_kept = next < selection.kept.size() && selection.kept[next].facet == FacetId(i);
    CHECK(is_kept == (in_front != behind));
    if (!is_kept) continue;
    const KeptFacet& kept = selection.kept[next++];
    CHECK(kept.is_flipped == in_front);
    CHECK(kept.category == category_of(scene, kept.facet, w));
    CHECK(selection.operands_inside[kept.inside] == operands_in(in_front ? w.front : w.back));
  }
  CHECK(next == selection.kept.size());
}

}  // namespace

TEST_CASE("operations are their truth tables, for all windings of one to three operands") {
  for (const Operation operation : all_operations) {
    for (std::size_t n = 1; n <= 3; ++n) {
      for (const std::vector<int>& w : all_windings(n, -1, 2))
        CHECK(is_inside_result(operation, RunningWinding(w)) == is_inside(operation, w));
    }
  }
}

TEST_CASE("outside all operands is outside every result") {
  for (const Operation operation : all_operations) {
    for (std::size_t n = 1; n <= 5; ++n) CHECK_FALSE(is_inside_result(operation, RunningWinding(std::vector<int>(n, 0))));
  }
}

TEST_CASE("operations have the names users type") {
  CHECK(operation_name(Operation::Union) == "union");
  CHECK(operation_name(Operation::Intersect) == "intersect");
  CHECK(operation_name(Operation::Subtract) == "subtract");
}

TEST_CASE("the four cases of the paper for two operands (Fig. 16)") {
  // Tags 10 and 20: outside the other; 11 and 21: inside it.
  const Evaluation scene({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5})});
  const auto kept = [&](Operation operation) {
    std::set<std::pair<std::uint32_t, FacetCategory>> tags;
    for (const KeptFacet& k : select(operation, scene.faces, scene.facets, scene.categories).kept) {
      tags.insert({scene.faces.operand[scene.facets.sources_of(k.facet).front().face].value, k.category});
      CHECK(k.is_flipped == (operation == Operation::Subtract && k.category == FacetCategory::Inside));
    }
    return tags;
  };
  using Tags = std::set<std::pair<std::uint32_t, FacetCategory>>;
  CHECK(kept(Operation::Union) == Tags{{0, FacetCategory::Outside}, {1, FacetCategory::Outside}});
  CHECK(kept(Operation::Intersect) == Tags{{0, FacetCategory::Inside}, {1, FacetCategory::Inside}});
  CHECK(kept(Operation::Subtract) == Tags{{0, FacetCategory::Outside}, {1, FacetCategory::Inside}});
}

TEST_CASE("facets kept of the small scenes are those where the oracle's windings differ, with their sense and category") {
  for (const Scene& scene : scenes_for_rationals()) {
    INFO(scene.name);
    const Evaluation evaluation(scene.operands);
    const std::vector<WindingsBeside> windings = windings_beside_facets(evaluation);
    for (const Operation operation : all_operations) check_selection(operation, evaluation, windings);
  }
}

TEST_CASE("facets kept of random solids are those where the oracle's windings differ") {
  constexpr std::uint32_t seed = 16;
  INFO("seed " << seed);
  GridSolids random(seed);
  for (std::size_t i = 0, n = scaled_count(40, 3000); i < n; ++i) {
    INFO("case " << i);
    const Evaluation scene({random.solid(3), random.solid(3), random.solid(3)});
    const std::vector<WindingsBeside> windings = windings_beside_facets(scene);
    for (const Operation operation : all_operations) check_selection(operation, scene, windings);
  }
}

TEST_CASE("coincident faces are kept once when they agree and vanish when they oppose") {
  const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
  const Evaluation beside({unit, moved(unit, {1, 0, 0})});
  const Selection all = select(Operation::Union, beside.faces, beside.facets, beside.categories);
  CHECK(all.kept.size() == 20);  // twelve of each, less the two faces both have
  const Evaluation same({unit, unit});
  const Selection both = select(Operation::Intersect, same.faces, same.facets, same.categories);
  CHECK(both.kept.size() == 12);
  for (const KeptFacet& k : both.kept) CHECK(k.category == FacetCategory::OnSame);
  CHECK(select(Operation::Subtract, same.faces, same.facets, same.categories).kept.empty());
  const Selection rest = select(Operation::Subtract, beside.faces, beside.facets, beside.categories);
  CHECK(std::count_if(rest.kept.begin(), rest.kept.end(), [](const KeptFacet& k) { return k.category == FacetCategory::OnOpposite; }) == 2);
}
