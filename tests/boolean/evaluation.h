// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The stages up to the merged mesh, run over a scene written in a test.
#pragma once

#include <vector>

#include "mortise/boolean/categorize.h"
#include "mortise/boolean/merge.h"
#include "support/arrangement.h"
#include "support/winding_oracle.h"

namespace mortise::test {

/// An arrangement and its categories, in one pass: operands that turn out doubtful stay as they are.
struct Evaluation : Arrangement {
  explicit Evaluation(std::vector<SurfaceMesh> meshes, const std::vector<std::size_t>& self = {})
      : Arrangement(std::move(meshes), self), categories(categorize(faces, map, facets)) {}

  const Categories categories;

  /// The winding of every operand in every region, as the walk visits them; empty for a region it does not visit.
  [[nodiscard]] IdVector<RegionId, std::vector<int>> windings() const {
    IdVector<RegionId, std::vector<int>> result(categories.patches.region_count);
    walk_regions(faces, facets, categories, [&](RegionId r, const RunningWinding& w) {
      for (std::size_t k = 0; k < w.operand_count(); ++k) result[r].push_back(w.of(OperandId(k)));
    });
    return result;
  }

  [[nodiscard]] RegionId front(FacetId f) const { return categories.patches.front[categories.patches.patch_of_facet[f]]; }
  [[nodiscard]] RegionId back(FacetId f) const { return categories.patches.back[categories.patches.patch_of_facet[f]]; }
};

/// The result of an operation, before it is certified and repaired.
struct MergedScene : Evaluation {
  MergedScene(Operation operation, std::vector<SurfaceMesh> meshes, const std::vector<std::size_t>& self = {})
      : Evaluation(std::move(meshes), self),
        selection(select(operation, faces, facets, categories)),
        merged(merge(pointers_to(operands), faces, facets, selection)) {}

  const Selection selection;
  MergedMesh merged;
};

/// Facets with other windings on their sides than the oracle's.
[[nodiscard]] inline std::size_t count_wrong_windings(const Evaluation& scene) {
  const auto windings = scene.windings();
  const std::vector<WindingsBeside> expected = windings_beside_facets(scene);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const WindingsBeside found{windings[scene.front(FacetId(i))], windings[scene.back(FacetId(i))]};
    wrong += found == expected[i] ? 0 : 1;
  }
  return wrong;
}

}  // namespace mortise::test
