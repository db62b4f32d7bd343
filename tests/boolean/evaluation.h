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
        merged(merge(pointers_to(operands), faces, facets, selection, Coordinates::Float64)) {}

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

/// A prism over a five-pointed star drawn in one line: its middle has winding 2. One part, closed, no face twice.
[[nodiscard]] inline SurfaceMesh pentagram_prism(double low, double high) {
  const std::vector<std::array<double, 2>> tips{{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}};
  const std::size_t n = tips.size();
  std::vector<Vec3d> points;
  for (const double z : {low, high}) {
    for (const auto& p : tips) points.push_back({p[0], p[1], z});
    points.push_back({0, 0, z});
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n, up = n + 1;
    triangles.push_back({n, j, i});
    triangles.push_back({up + n, up + i, up + j});
    triangles.push_back({i, j, up + j});
    triangles.push_back({i, up + j, up + i});
  }
  return make_mesh(points, triangles);
}

}  // namespace mortise::test
