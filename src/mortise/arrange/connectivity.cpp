// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Closedness by a sum of hashes, coincident faces by their lowest corners, parts by union-find.
#include "mortise/arrange/connectivity.h"

#include <algorithm>
#include <array>

#include "mortise/base/bits.h"
#include "mortise/base/union_find.h"

namespace mortise {
namespace {

// Corners of the faces, equal positions being one vertex: the lowest.
using WeldedCorners = std::array<std::uint32_t, 3>;

std::vector<WeldedCorners> weld_corners(const SurfaceMesh& mesh, std::span<const std::uint32_t> lowest) {
  std::vector<WeldedCorners> corners;
  corners.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) corners.push_back({lowest[t[0].index()], lowest[t[1].index()], lowest[t[2].index()]});
  return corners;
}

// 128 bits of a directed edge; the sum over all edges less that of their reverses is zero for a closed surface.
struct EdgeSum {
  std::uint64_t low = 0, high = 0;

  void add(std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = (std::uint64_t{from} << 32U) | to;
    low += mixed_bits(key);
    high += mixed_bits(key ^ 0x9e3779b97f4a7c15U);
  }
  void subtract(std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = (std::uint64_t{from} << 32U) | to;
    low -= mixed_bits(key);
    high -= mixed_bits(key ^ 0x9e3779b97f4a7c15U);
  }
};

bool is_closed(const SurfaceMesh& mesh, const std::vector<WeldedCorners>& corners) {
  EdgeSum sum;
  for (std::size_t f = 0; f < corners.size(); ++f) {
    if (!mesh.walls.empty() && mesh.walls[f] != 0) continue;
    const WeldedCorners& c = corners[f];
    for (std::size_t i = 0; i < 3; ++i) {
      sum.add(c[i], c[(i + 1) % 3]);
      sum.subtract(c[(i + 1) % 3], c[i]);
    }
  }
  return sum.low == 0 && sum.high == 0;
}

void number_parts(const std::vector<WeldedCorners>& corners, std::size_t vertex_count, Connectivity& connectivity) {
  constexpr std::uint32_t none = 0xffffffffU;
  UnionFind joined(vertex_count);
  for (const WeldedCorners& c : corners) {
    joined.join(c[0], c[1]);
    joined.join(c[1], c[2]);
  }
  std::vector<std::uint32_t> number(vertex_count, none);
  connectivity.part_of_face.reserve(corners.size());
  for (const WeldedCorners& c : corners) {
    std::uint32_t& part = number[joined.find(c[0])];
    if (part == none) part = connectivity.part_count++;
    connectivity.part_of_face.push_back(part);
  }
}

// Do two faces have the same three corners? Only faces with the same lowest corner are compared.
bool has_coincident_faces(std::vector<WeldedCorners> corners, std::size_t vertex_count) {
  std::vector<std::uint32_t> begin(vertex_count + 1, 0);
  for (WeldedCorners& c : corners) {
    std::sort(c.begin(), c.end());
    ++begin[c[0] + 1];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
  std::vector<std::array<std::uint32_t, 2>> others(corners.size());  // the two higher corners, grouped by the lowest
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const WeldedCorners& c : corners) others[next[c[0]]++] = {c[1], c[2]};
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (begin[v + 1] - begin[v] < 2) continue;
    const auto first = others.begin() + begin[v];
    const auto last = others.begin() + begin[v + 1];
    std::sort(first, last);
    if (std::adjacent_find(first, last) != last) return true;
  }
  return false;
}

}  // namespace

Connectivity find_connectivity(const SurfaceMesh& mesh, std::span<const std::uint32_t> lowest) {
  Connectivity connectivity;
  std::vector<WeldedCorners> corners = weld_corners(mesh, lowest);
  connectivity.is_closed = is_closed(mesh, corners);
  number_parts(corners, mesh.points.size(), connectivity);
  connectivity.has_coincident_faces = has_coincident_faces(std::move(corners), mesh.points.size());
  return connectivity;
}

}  // namespace mortise
