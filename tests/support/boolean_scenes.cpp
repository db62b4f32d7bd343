// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Solids of a few triangles each, and the table of small scenes.
#include "support/boolean_scenes.h"

#include <algorithm>

#include "support/boolean_oracle.h"

namespace mortise::test {
namespace {

std::vector<Vec3d> box_corners(const Vec3d& lo, const Vec3d& hi) {
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < 8; ++i)
    points.push_back({(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z});
  return points;
}

constexpr std::size_t box_sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

SurfaceMesh box_split_from(const Vec3d& lo, const Vec3d& hi, std::size_t first) {
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& side : box_sides) {
    triangles.push_back({side[first], side[first + 1], side[(first + 2) % 4]});
    triangles.push_back({side[first], side[(first + 2) % 4], side[(first + 3) % 4]});
  }
  return make_mesh(box_corners(lo, hi), triangles);
}

template <class Map>
SurfaceMesh mapped(SurfaceMesh mesh, const Map& map) {
  for (Vec3d& p : mesh.points) p = map(p);
  return mesh;
}

}  // namespace

SurfaceMesh make_mesh(const std::vector<Vec3d>& points, const std::vector<std::array<std::size_t, 3>>& triangles) {
  SurfaceMesh mesh;
  mesh.points = points;
  for (const auto& t : triangles) mesh.triangles.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  return mesh;
}

SurfaceMesh box(const Vec3d& lo, const Vec3d& hi) { return box_split_from(lo, hi, 0); }

SurfaceMesh box_other_diagonals(const Vec3d& lo, const Vec3d& hi) { return box_split_from(lo, hi, 1); }

SurfaceMesh tetrahedron(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const int side = oracle::orient3d(oracle::exact(a), oracle::exact(b), oracle::exact(c), oracle::exact(d));
  const std::vector<Vec3d> points = side < 0 ? std::vector{a, b, c, d} : std::vector{b, a, c, d};
  return make_mesh(points, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

SurfaceMesh prism(const std::vector<std::array<double, 2>>& polygon, double low, double high) {
  const std::size_t n = polygon.size();
  std::vector<Vec3d> points;
  for (const double z : {low, high}) {
    for (const auto& p : polygon) points.push_back({p[0], p[1], z});
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    triangles.push_back({0, i + 1, i});
    triangles.push_back({n, n + i, n + i + 1});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.push_back({i, j, n + j});
    triangles.push_back({i, n + j, n + i});
  }
  return make_mesh(points, triangles);
}

SurfaceMesh octahedron(const Vec3d& centre, double radius) {
  const SurfaceMesh unit = make_mesh({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                                     {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
  return moved(scaled(unit, radius), centre);
}

SurfaceMesh joined(const std::vector<SurfaceMesh>& parts) {
  SurfaceMesh whole;
  for (const SurfaceMesh& part : parts) {
    const std::size_t offset = whole.points.size();
    whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
    for (const Triangle& t : part.triangles) {
      whole.triangles.push_back({VertexId(t[0].index() + offset), VertexId(t[1].index() + offset), VertexId(t[2].index() + offset)});
    }
  }
  return whole;
}

SurfaceMesh soup_of(const SurfaceMesh& mesh) {
  SurfaceMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const std::size_t n = soup.points.size();
    for (const VertexId v : t) soup.points.push_back(mesh.points[v.index()]);
    soup.triangles.push_back({VertexId(n), VertexId(n + 1), VertexId(n + 2)});
  }
  return soup;
}

SurfaceMesh inside_out(SurfaceMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

SurfaceMesh moved(SurfaceMesh mesh, const Vec3d& offset) {
  return mapped(std::move(mesh), [&](const Vec3d& p) { return p + offset; });
}

SurfaceMesh scaled(SurfaceMesh mesh, double factor) {
  return mapped(std::move(mesh), [&](const Vec3d& p) { return factor * p; });
}

SurfaceMesh with_axes_turned(SurfaceMesh mesh) {
  return mapped(std::move(mesh), [](const Vec3d& p) { return Vec3d{p.z, p.x, p.y}; });
}

SurfaceMesh quarter_turned(SurfaceMesh mesh) {
  return mapped(std::move(mesh), [](const Vec3d& p) { return Vec3d{-p.y, p.x, p.z}; });
}

std::vector<const SurfaceMesh*> pointers_to(const std::vector<SurfaceMesh>& meshes) {
  std::vector<const SurfaceMesh*> pointers;
  for (const SurfaceMesh& mesh : meshes) pointers.push_back(&mesh);
  return pointers;
}

BooleanResult evaluate(Operation operation, const std::vector<SurfaceMesh>& operands) {
  return evaluate_boolean(operation, pointers_to(operands));
}

std::vector<Scene> small_scenes() {
  const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
  const SurfaceMesh crossed = box_other_diagonals({0, 0, 0}, {1, 1, 1});
  const SurfaceMesh tet = tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3});
  const SurfaceMesh wedge = prism({{{0, 0}, {4, 1}, {1, 4}}}, 0, 2);
  return {
      {"two boxes crossing at a corner", {unit, box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5})}},
      {"two boxes crossing at thirds", {box({0, 0, 0}, {3, 3, 3}), moved(scaled(unit, 0.1), {2.95, 1.3, 0.7})}},
      {"two tetrahedra through one another", {tet, tetrahedron({2, 2, 2}, {-1, 0.25, 0.5}, {0.5, -1, 0.25}, {0.25, 0.5, -1})}},
      {"octahedron through a box side", {unit, octahedron({1, 0.5, 0.5}, 0.375)}},
      {"octahedron corner on a box side", {unit, octahedron({0.5, 0.5, 1.25}, 0.25)}},
      {"octahedron corner at the box middle", {unit, octahedron({0.5, 0.5, 1.0}, 0.5)}},
      {"the same box", {unit, unit}},
      {"the same box with other diagonals", {unit, crossed}},
      {"boxes sharing a face", {unit, moved(unit, {1, 0, 0})}},
      {"boxes sharing a face with other diagonals", {unit, moved(crossed, {1, 0, 0})}},
      {"boxes sharing an edge", {unit, moved(unit, {1, 1, 0})}},
      {"boxes sharing a corner", {unit, moved(unit, {1, 1, 1})}},
      {"a half face inside a face", {unit, box_other_diagonals({1, 0.25, 0.25}, {1.5, 0.75, 0.75})}},
      {"a shifted half face", {unit, box_other_diagonals({1, 0.3, 0.2}, {2, 1.3, 1.2})}},
      {"coplanar sides, overlapping", {unit, moved(crossed, {0.5, 0, 0})}},
      {"coplanar sides, shifted along them", {unit, moved(crossed, {0.5, 0.25, 0})}},
      {"box in a corner of a box", {unit, box({0, 0, 0}, {0.5, 0.5, 0.5})}},
      {"box in the middle of a box", {unit, box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75})}},
      {"box on the inside of a face", {unit, box({0.25, 0.25, 0}, {0.75, 0.75, 0.5})}},
      {"a bar through a box", {unit, box({0.25, 0.25, -1}, {0.75, 0.75, 2})}},
      {"a bar flush with both ends", {unit, box({0.25, 0.25, 0}, {0.75, 0.75, 1})}},
      {"a bar through an edge", {unit, box({0.75, 0.75, -1}, {1.25, 1.25, 2})}},
      {"apart", {unit, moved(unit, {3, 0, 0})}},
      {"apart by one ulp", {unit, box({1.0000000000000002, 0, 0}, {2, 1, 1})}},
      {"overlapping by one ulp", {unit, box({0.99999999999999989, 0.5, 0.25}, {2, 1.5, 1.25})}},
      {"edge across an edge, from outside", {unit, tetrahedron({0.5, 0.5, 1.5}, {1.5, 0.5, 0.5}, {2, 0.25, 2}, {2, 0.75, 2.5})}},
      {"edge across an edge, going in", {unit, tetrahedron({0.5, 0.5, 1.5}, {1.5, 0.5, 0.5}, {0.25, 0.25, 0.5}, {0.5, 0.75, 0.125})}},
      {"edge along a face", {unit, tetrahedron({0.2, 0.5, 1}, {0.8, 0.5, 1}, {0.5, 0.2, 2}, {0.5, 0.8, 2})}},
      {"corner on a face", {unit, tetrahedron({0.5, 0.5, 1}, {0.3, 0.3, 2}, {0.7, 0.3, 2}, {0.5, 0.7, 2})}},
      {"corner on an edge", {unit, tetrahedron({0.5, 1, 1}, {0.3, 1.3, 2}, {0.7, 1.3, 2}, {0.5, 1.7, 2})}},
      {"a wedge and a box", {wedge, box({0.5, 0.5, 1}, {2, 3, 5})}},
      {"two wedges", {wedge, prism({{{3, 3}, {-1, 2}, {2, -1}}}, 0, 2)}},
      {"three boxes crossing", {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}), box({0.5, 1.5, -1}, {1.5, 2.5, 4})}},
      {"three boxes, one plane", {box({0, 0, 0}, {2, 2, 1}), box_other_diagonals({1, 1, 0}, {3, 3, 1}), box({0.5, 0.5, 0}, {2.5, 1.5, 1})}},
      {"three boxes, one plane from both sides",
       {box({0, 0, 0}, {2, 2, 1}), box_other_diagonals({1, 1, 1}, {3, 3, 2}), box({0.5, 0.5, 1}, {1.5, 2.5, 3})}},
      {"three boxes round an edge", {unit, moved(unit, {1, 0, 0}), moved(unit, {0, 1, 0})}},
      {"three tetrahedra",
       {tet, tetrahedron({2, 2, 2}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}),
        tetrahedron({1, -1, 0.5}, {0.5, 2, 0.25}, {2, 1, -1}, {0.75, 0.5, 2})}},
      {"two crossing boxes inside a third", {box({0, 0, 0}, {9, 9, 9}), box({1, 1, 1}, {4, 4, 4}), box({3, 3, 3}, {6, 5, 5})}},
      {"a box in a cavity", {joined({box({0, 0, 0}, {9, 9, 9}), inside_out(box({1, 1, 1}, {8, 8, 8}))}), box({3, 3, 3}, {5, 5, 5})}},
      {"a box across a cavity", {joined({box({0, 0, 0}, {9, 9, 9}), inside_out(box({1, 1, 1}, {8, 8, 8}))}), box({4, 4, 4}, {5, 5, 12})}},
      {"a box filling a cavity",
       {joined({box({0, 0, 0}, {9, 9, 9}), inside_out(box({1, 1, 1}, {8, 8, 8}))}), box_other_diagonals({1, 1, 1}, {8, 8, 8})}},
  };
}

}  // namespace mortise::test
