// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random small solids on a coarse grid.
#include "support/random_solids.h"

#include <algorithm>

#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"

namespace mortise::test {
namespace {

constexpr std::size_t grid_side = 4;

double lowest_x(const SurfaceMesh& mesh) {
  double lowest = mesh.points[0].x;
  for (const Vec3d& p : mesh.points) lowest = std::min(lowest, p.x);
  return lowest;
}

double highest_x(const SurfaceMesh& mesh) {
  double highest = mesh.points[0].x;
  for (const Vec3d& p : mesh.points) highest = std::max(highest, p.x);
  return highest;
}

}  // namespace

SurfaceMesh RandomSolids::next() {
  switch (below(4)) {
    case 0:
      return random_box();
    case 1:
      return random_tetrahedron();
    case 2:
      return turned(random_prism());
    default:
      return random_octahedron();
  }
}

std::vector<SurfaceMesh> RandomSolids::next(std::size_t count) {
  std::vector<SurfaceMesh> solids;
  while (solids.size() < count) solids.push_back(next());
  return solids;
}

SurfaceMesh RandomSolids::next_of_all_kinds() {
  switch (below(8)) {
    case 0:
      return turned(random_extrusion());
    case 1:
      return turned(random_hollow());
    case 2:
      return turned(side_by_side());
    case 3:
      return moved(quarter_turned(next()), {static_cast<double>(grid_side), 0, 0});
    default:
      return next();
  }
}

Vec3d RandomSolids::grid_point() {
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

double RandomSolids::coordinate() { return static_cast<double>(below(grid_side + 1)); }

double RandomSolids::length() { return 1 + static_cast<double>(below(3)); }

SurfaceMesh RandomSolids::random_box() {
  const Vec3d lo = grid_point();
  Vec3d hi = lo;
  for (std::size_t i = 0; i < 3; ++i) hi[i] += length();
  return below(2) == 0 ? box(lo, hi) : box_other_diagonals(lo, hi);
}

SurfaceMesh RandomSolids::random_octahedron() {
  const double radius = 1 + static_cast<double>(below(2));
  return octahedron(grid_point(), radius);
}

SurfaceMesh RandomSolids::random_tetrahedron() {
  for (;;) {
    const Vec3d a = grid_point(), b = grid_point(), c = grid_point(), d = grid_point();
    if (dot(cross(b - a, c - a), d - a) != 0) return tetrahedron(a, b, c, d);
  }
}

SurfaceMesh RandomSolids::random_prism() {
  for (;;) {
    const Vec3d a = grid_point(), b = grid_point(), c = grid_point();
    const double low = coordinate(), high = low + length();
    if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0) return prism({{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}, low, high);
  }
}

SurfaceMesh RandomSolids::random_extrusion() {
  const double a = length(), b = a + length(), c = b + length(), low = length(), high = low + length();
  const std::vector<Vec2d> l{{0, 0}, {b, 0}, {b, low}, {a, low}, {a, high}, {0, high}};
  const std::vector<Vec2d> u{{0, 0}, {c, 0}, {c, high}, {b, high}, {b, low}, {a, low}, {a, high}, {0, high}};
  const double height = length();
  const SurfaceMesh mesh = extrude(once_in(2) ? l : u, height);
  return moved(mesh, {0, 0, coordinate()});
}

SurfaceMesh RandomSolids::random_hollow() {
  // The cavity touches the walls in single points, or leaves a wall of thickness 1.
  const Vec3d lo = grid_point();
  if (once_in(2)) return joined({box(lo, lo + Vec3d{2, 2, 2}), inside_out(octahedron(lo + Vec3d{1, 1, 1}, 1))});
  return joined({box(lo, lo + Vec3d{4, 3, 3}), inside_out(box_other_diagonals(lo + Vec3d{1, 1, 1}, lo + Vec3d{3, 2, 2}))});
}

SurfaceMesh RandomSolids::side_by_side() {
  const SurfaceMesh left = next(), right = next();
  const double gap = static_cast<double>(below(2));
  return joined({left, moved(right, {highest_x(left) - lowest_x(right) + gap, 0, 0})});
}

SurfaceMesh RandomSolids::turned(SurfaceMesh mesh) {
  for (std::size_t turns = below(3); turns > 0; --turns) mesh = with_axes_turned(std::move(mesh));
  return mesh;
}

SurfaceMesh renumbered(const SurfaceMesh& mesh, RandomSource& random) {
  std::vector<std::size_t> place(mesh.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = i;
  random.shuffle(place);
  SurfaceMesh shuffled = mesh;
  for (std::size_t i = 0; i < place.size(); ++i) shuffled.points[place[i]] = mesh.points[i];
  for (Triangle& t : shuffled.triangles) {
    t = {VertexId(place[t[0].index()]), VertexId(place[t[1].index()]), VertexId(place[t[2].index()])};
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
  }
  random.shuffle(shuffled.triangles);
  return shuffled;
}

std::vector<SurfaceMesh> slightly_off(std::vector<SurfaceMesh> solids) {
  const AffineMap turn = compose(rotation(Axis::X, 31), rotation(Axis::Z, 17));
  for (SurfaceMesh& solid : solids) solid = transform(solid, turn);
  return solids;
}

}  // namespace mortise::test
