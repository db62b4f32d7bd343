// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A constrained triangulation of the hull, flooded from the left sides of the border.
#include "mortise/arrange/triangulate_region.h"

#include <algorithm>

#include "mortise/arrange/planar_triangulation.h"

namespace mortise {
namespace {

using LocalEdge = std::array<std::uint32_t, 2>;

// Marks the cells that can be reached from others without crossing a fixed edge.
std::vector<std::uint8_t> flood(const PlanarTriangulation& triangulation, std::vector<std::uint32_t> stack) {
  std::vector<std::uint8_t> is_reached(triangulation.cells().size(), 0);
  for (const std::uint32_t c : stack) is_reached[c] = 1;
  while (!stack.empty()) {
    const std::uint32_t c = stack.back();
    stack.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t next = triangulation.cells()[c].neighbour[i];
      if (next == PlanarTriangulation::none || triangulation.is_fixed(c, i) || is_reached[next] != 0) continue;
      is_reached[next] = 1;
      stack.push_back(next);
    }
  }
  return is_reached;
}

// The cells to the left of directed edges.
std::vector<std::uint32_t> cells_beside(const PlanarTriangulation& triangulation, const std::vector<LocalEdge>& sorted_border) {
  std::vector<std::uint32_t> beside;
  const auto& cells = triangulation.cells();
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!triangulation.is_fixed(c, i)) continue;
      const LocalEdge edge{cells[c].corner[i], cells[c].corner[(i + 1) % 3]};
      if (std::binary_search(sorted_border.begin(), sorted_border.end(), edge)) beside.push_back(c);
    }
  }
  return beside;
}

}  // namespace

std::vector<PlanePoints> triangulate_region(const PointSet& points, Axis axis, std::span<const LinePoints> border,
                                            std::span<const PointId> vertices) {
  std::vector<PointId> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end());
  const auto local = [&](PointId p) {
    return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), p) - sorted.begin());
  };
  std::vector<LocalEdge> directed, edges;
  for (const auto& [from, to] : border) {
    directed.push_back({local(from), local(to)});
    edges.push_back({std::min(local(from), local(to)), std::max(local(from), local(to))});
  }
  std::sort(directed.begin(), directed.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  const std::vector<std::uint64_t> lines(sorted.size(), 0);
  PlanarTriangulation triangulation(points, axis, sorted, lines);
  triangulation.recover_edges(edges);
  triangulation.improve();
  const std::vector<std::uint8_t> is_inside = flood(triangulation, cells_beside(triangulation, directed));
  std::vector<PlanePoints> triangles;
  for (std::size_t c = 0; c < is_inside.size(); ++c) {
    const auto& corner = triangulation.cells()[c].corner;
    if (is_inside[c] != 0) triangles.push_back({sorted[corner[0]], sorted[corner[1]], sorted[corner[2]]});
  }
  return triangles;
}

}  // namespace mortise
