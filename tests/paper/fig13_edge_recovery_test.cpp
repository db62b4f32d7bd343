// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Paper 5.1, Fig. 13: seven points of a chain in a face, edges of the chain that the points alone do not give, and their recovery.
#include <algorithm>

#include "mortise/arrange/planar_triangulation.h"
#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// The corners of the master face, then the seven points of the chain in order.
const std::vector<std::array<double, 2>> places{{0, 0},  {16, 0},  {0, 16}, {5.5, 1.25}, {1, 1},
                                                {10, 3}, {5, 2.5}, {1, 4},  {8, 6},      {4.5, 5.75}};

constexpr std::uint32_t first_of_chain = 3, last_of_chain = 9;

struct MasterFace {
  MasterFace() {
    for (const auto& p : places) vertices.push_back(points.add_input({p[0], p[1], 2}));
  }
  PointSet points;
  std::vector<PointId> vertices;
  std::vector<std::uint64_t> lines = std::vector<std::uint64_t>(places.size(), 0);
  [[nodiscard]] PlanarTriangulation triangulate() const { return {points, Axis::Z, vertices, lines}; }
};

bool has_edge(const PlanarTriangulation& triangulation, std::uint32_t a, std::uint32_t b) {
  return std::any_of(triangulation.cells().begin(), triangulation.cells().end(), [&](const PlanarTriangulation::Cell& cell) {
    return std::count(cell.corner.begin(), cell.corner.end(), a) == 1 && std::count(cell.corner.begin(), cell.corner.end(), b) == 1;
  });
}

std::vector<std::uint32_t> missing_edges(const PlanarTriangulation& triangulation) {
  std::vector<std::uint32_t> missing;
  for (std::uint32_t i = first_of_chain; i < last_of_chain; ++i) {
    if (!has_edge(triangulation, i, i + 1)) missing.push_back(i);
  }
  return missing;
}

/// Sum of the doubled areas; exact for these coordinates.
double doubled_area(const PlanarTriangulation& triangulation) {
  double sum = 0;
  for (const auto& cell : triangulation.cells()) {
    const auto &a = places[cell.corner[0]], &b = places[cell.corner[1]], &c = places[cell.corner[2]];
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    CHECK(area > 0);
    sum += area;
  }
  return sum;
}

}  // namespace

TEST_CASE("Fig. 13b: two edges of the chain are missing when only its points are inserted") {
  const MasterFace face;
  PlanarTriangulation triangulation = face.triangulate();
  triangulation.improve();
  CHECK(missing_edges(triangulation).size() == 2);
}

TEST_CASE("Fig. 13c: swaps recover the missing edges inside the master face") {
  const MasterFace face;
  PlanarTriangulation triangulation = face.triangulate();
  triangulation.improve();
  for (std::uint32_t i = first_of_chain; i < last_of_chain; ++i) triangulation.recover_edge(i, i + 1);
  CHECK(missing_edges(triangulation).empty());
  CHECK(triangulation.cells().size() == 1 + 2 * 7);
  CHECK(doubled_area(triangulation) == 256);
}

TEST_CASE("Fig. 13: the recovered edges stay when the shape is improved afterwards, whatever their order") {
  const MasterFace face;
  for (const bool backward : {false, true}) {
    PlanarTriangulation triangulation = face.triangulate();
    for (std::uint32_t k = 0; k < 6; ++k) {
      const std::uint32_t i = backward ? last_of_chain - 1 - k : first_of_chain + k;
      triangulation.recover_edge(i, i + 1);
    }
    triangulation.improve();
    CHECK(missing_edges(triangulation).empty());
    CHECK(doubled_area(triangulation) == 256);
  }
}

TEST_CASE("Fig. 13: a face crossed by a fence contains every edge of it") {
  // Six upright faces over the chain pass through the master face.
  std::vector<Vec3d> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = first_of_chain; i <= last_of_chain; ++i) {
    points.push_back({places[i][0], places[i][1], 0});
    points.push_back({places[i][0], places[i][1], 4});
  }
  for (std::size_t i = 0; i + 2 < points.size(); i += 2) {
    triangles.push_back({i, i + 2, i + 3});
    triangles.push_back({i, i + 3, i + 1});
  }
  const SurfaceMesh master = make_mesh({{0, 0, 2}, {16, 0, 2}, {0, 16, 2}}, {{0, 1, 2}});
  const Arrangement scene({master, make_mesh(points, triangles)});
  const auto corner_count = [&](FacetId f, std::size_t place) {
    const PlanePoints& c = scene.facets.corners[f];
    return std::count(c.begin(), c.end(), scene.point_at({places[place][0], places[place][1], 2}));
  };
  for (std::size_t i = first_of_chain; i < last_of_chain; ++i) {
    // Each diagonal of the fence crosses z = 2 in the middle of its segment, which is therefore in two pieces.
    const PointId middle = scene.point_at({(places[i][0] + places[i + 1][0]) / 2, (places[i][1] + places[i + 1][1]) / 2, 2});
    REQUIRE(middle.is_valid());
    for (const std::size_t end : {i, i + 1}) {
      std::size_t facets = 0;
      for (const FacetId f : scene.facets_of(scene.face(0, 0))) {
        const PlanePoints& c = scene.facets.corners[f];
        facets += corner_count(f, end) == 1 && std::count(c.begin(), c.end(), middle) == 1 ? 1 : 0;
      }
      CHECK(facets == 2);
    }
  }
  CHECK(faults_of_facets(scene) == "");
}
