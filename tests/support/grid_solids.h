// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random small solids on a coarse grid: most of them touch each other in some degenerate way.
#pragma once

#include <random>
#include <vector>

#include "support/boolean_scenes.h"

namespace mortise::test {

class GridSolids {
 public:
  explicit GridSolids(std::uint32_t seed) : random_(seed) {}

  /// A tetrahedron with corners on the grid 0 .. size, with volume.
  [[nodiscard]] SurfaceMesh tetrahedron(int size) {
    while (true) {
      const Vec3d a = point(size), b = point(size), c = point(size), d = point(size);
      if (dot(cross(b - a, c - a), d - a) != 0) return test::tetrahedron(a, b, c, d);
    }
  }
  /// A box with corners on the grid 0 .. size.
  [[nodiscard]] SurfaceMesh box(int size) {
    while (true) {
      const Vec3d a = point(size), b = point(size);
      if (a.x < b.x && a.y < b.y && a.z < b.z) return below(2) == 0 ? test::box(a, b) : box_other_diagonals(a, b);
    }
  }
  [[nodiscard]] SurfaceMesh solid(int size) { return below(2) == 0 ? tetrahedron(size) : box(size); }
  [[nodiscard]] int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint32_t>(limit)); }

 private:
  Vec3d point(int size) {
    const auto coordinate = [&] { return static_cast<double>(below(size + 1)); };
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }
  std::mt19937 random_;
};

}  // namespace mortise::test
