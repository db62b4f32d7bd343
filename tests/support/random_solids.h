// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random small solids on a coarse grid, where most contacts are degenerate.
#pragma once

#include <vector>

#include "mortise/mesh/surface_mesh.h"
#include "support/random_source.h"

namespace mortise::test {

/// Solids of winding 0 or 1 with small whole coordinates.
class RandomSolids : public RandomSource {
 public:
  using RandomSource::RandomSource;

  /// A box, tetrahedron, prism or octahedron: at most 12 faces, convex.
  [[nodiscard]] SurfaceMesh next();
  [[nodiscard]] std::vector<SurfaceMesh> next(std::size_t count);
  /// One of these, or an extruded L or U, or a box with a cavity, or two solids side by side in one mesh; also turned.
  [[nodiscard]] SurfaceMesh next_of_all_kinds();

 private:
  [[nodiscard]] Vec3d grid_point();
  [[nodiscard]] double coordinate();
  [[nodiscard]] double length();
  [[nodiscard]] SurfaceMesh random_box();
  [[nodiscard]] SurfaceMesh random_octahedron();
  [[nodiscard]] SurfaceMesh random_tetrahedron();
  [[nodiscard]] SurfaceMesh random_prism();
  [[nodiscard]] SurfaceMesh random_extrusion();
  [[nodiscard]] SurfaceMesh random_hollow();
  [[nodiscard]] SurfaceMesh side_by_side();
  [[nodiscard]] SurfaceMesh turned(SurfaceMesh mesh);
};

/// The same mesh with vertices and faces in another order and other first corners.
[[nodiscard]] SurfaceMesh renumbered(const SurfaceMesh& mesh, RandomSource& random);

/// Turned so that flush faces are so no more but for a few units in the last place: most contacts have to be repaired.
[[nodiscard]] std::vector<SurfaceMesh> slightly_off(std::vector<SurfaceMesh> solids);

}  // namespace mortise::test
