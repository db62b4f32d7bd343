// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cells of boxes in every relation: side by side, nested, touching, with walls and sheets.
#include "mortise/mesh/find_cells.h"

#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// Volumes of the cells, the unbounded one left out.
std::vector<double> volumes_of(const MeshCells& cells) {
  std::vector<double> volumes;
  for (std::size_t c = 1; c < cells.cells.size(); ++c) volumes.push_back(cells.cells[c].volume);
  return volumes;
}

std::vector<double> cell_volumes(const std::vector<SurfaceMesh>& parts) { return volumes_of(find_cells(weld(joined(parts)).mesh)); }

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

/// The square from (x, 0, 0) to (x, 1, 1), looking to +x.
SurfaceMesh wall_at(double x) { return make_mesh({{x, 0, 0}, {x, 1, 0}, {x, 1, 1}, {x, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}); }

/// A box without its two faces at x = `x`.
SurfaceMesh without_side_at(SurfaceMesh mesh, double x) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return mesh.points[t[0].index()].x == x && mesh.points[t[1].index()].x == x && mesh.points[t[2].index()].x == x;
  });
  return mesh;
}

}  // namespace

TEST_CASE("nothing has no cell but the unbounded one", "[find_cells]") {
  const MeshCells cells = find_cells({});
  CHECK(cells.cells.size() == 1);
  CHECK(cells.behind.empty());
}

TEST_CASE("a box is one cell behind its faces, inside out it is in front of them", "[find_cells]") {
  const MeshCells cells = find_cells(unit);
  CHECK(volumes_of(cells) == std::vector<double>{1});
  CHECK(cells.cells[1].area == 6);
  for (std::size_t f = 0; f < 12; ++f) CHECK((cells.behind[f] == 1 && cells.in_front[f] == MeshCells::unbounded));
  const MeshCells turned = find_cells(inside_out(unit));
  CHECK(volumes_of(turned) == std::vector<double>{1});
  for (std::size_t f = 0; f < 12; ++f) CHECK((turned.in_front[f] == 1 && turned.behind[f] == MeshCells::unbounded));
}

TEST_CASE("a wall through a box cuts it in two, whichever way it looks", "[find_cells]") {
  const SurfaceMesh left = without_side_at(box({0, 0, 0}, {1, 1, 1}), 1), right = without_side_at(box({1, 0, 0}, {3, 1, 1}), 1);
  for (const SurfaceMesh& wall : {wall_at(1), inside_out(wall_at(1))}) {
    const MeshCells cells = find_cells(weld(joined({left, right, wall})).mesh);
    CHECK(volumes_of(cells) == std::vector<double>{1, 2});
    CHECK(cells.cells[1].area == 6);
    CHECK(cells.cells[2].area == 10);
    CHECK(cells.behind[20] + cells.in_front[20] == 3);
    CHECK(cells.behind[20] == cells.behind[21]);
  }
}

TEST_CASE("cells that touch in an edge or a corner are two, and the space round them is one", "[find_cells]") {
  CHECK(cell_volumes({unit, box({1, 1, 0}, {2, 2, 1})}) == std::vector<double>{1, 1});
  CHECK(cell_volumes({unit, box({1, 1, 1}, {2, 2, 2})}) == std::vector<double>{1, 1});
  CHECK(cell_volumes({unit, box({1, 1, 1}, {2, 2, 2}), box({1, 0, 0}, {2, 1, 1})}).size() == 3);
}

TEST_CASE("a cell in a cell takes its space from the one round it, at any depth and in any order", "[find_cells]") {
  const SurfaceMesh outer = box({0, 0, 0}, {8, 8, 8}), middle = box({1, 1, 1}, {7, 7, 7}), inner = box({2, 2, 2}, {4, 4, 4});
  CHECK(cell_volumes({outer, middle, inner}) == std::vector<double>{512 - 216, 216 - 8, 8});
  CHECK(cell_volumes({inner, outer, inside_out(middle)}) == std::vector<double>{8, 216 - 8, 512 - 216});
  CHECK(cell_volumes({outer, inner, box({5, 5, 5}, {6, 6, 6})}) == std::vector<double>{512 - 9, 8, 1});
}

TEST_CASE("a cell in a cell may touch it in a corner", "[find_cells]") {
  const SurfaceMesh outer = box({0, 0, 0}, {8, 8, 8});
  CHECK(cell_volumes({outer, tetrahedron({0, 0, 0}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2})}).size() == 2);
  CHECK(cell_volumes({outer, box({1, 1, 1}, {2, 2, 2}), box({2, 2, 2}, {3, 3, 3})}) == std::vector<double>{510, 1, 1});
}

TEST_CASE("a sheet bounds nothing, also where it hangs in a cell", "[find_cells]") {
  const MeshCells alone = find_cells(wall_at(1));
  CHECK(alone.cells.size() == 1);
  const MeshCells hung = find_cells(joined({box({-1, -1, -1}, {3, 3, 3}), wall_at(1)}));
  CHECK(volumes_of(hung) == std::vector<double>{64});
  CHECK(hung.cells[1].area == 96);
  CHECK((hung.behind[12] == 1 && hung.in_front[12] == 1));
}
