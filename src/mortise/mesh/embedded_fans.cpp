// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Finds fans whose faces all project along one axis with one sense, and go round their vertex once. Every face covers an angle
// of less than half a turn then; in a closed fan the angles add up to whole turns, so once round, no direction is covered twice.
#include "mortise/mesh/embedded_fans.h"

#include <array>

#include "mortise/exact/filters.h"

namespace mortise {
namespace {

constexpr std::array<Axis, 3> axes{Axis::X, Axis::Y, Axis::Z};

// Bit k: certainly counterclockwise seen along axis k; bit 3 + k: certainly clockwise.
using Senses = std::uint8_t;
constexpr Senses all_senses = 0b111111;

Senses senses_of(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
  unsigned senses = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const auto sign = filters::orient2d(a, b, c, axes[k]);
    if (sign) senses |= *sign == Sign::Positive ? 1U << k : 8U << k;
  }
  return static_cast<Senses>(senses);
}

// Per vertex the senses that all of its faces have.
std::vector<Senses> common_senses(const SurfaceMesh& mesh) {
  std::vector<Senses> common(mesh.points.size(), all_senses);
  for (const Triangle& t : mesh.triangles) {
    const Senses senses = senses_of(mesh, t);
    for (const VertexId v : t) common[v.index()] &= senses;
  }
  return common;
}

// Only vertices all of whose edges have two faces, one on each side, have closed fans.
void forget_open_fans(const SurfaceMesh& mesh, const MeshTopology& topology, std::vector<Senses>& common) {
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() == 2 && origin_of(mesh, uses[0]) != origin_of(mesh, uses[1])) continue;
    for (const VertexId v : topology.edges[e]) common[v.index()] = 0;
  }
}

unsigned lowest_bit(unsigned bits) {
  unsigned bit = 0;
  while (((bits >> bit) & 1U) == 0) ++bit;
  return bit;
}

}  // namespace

std::vector<std::uint8_t> find_embedded_fans(const SurfaceMesh& mesh, const MeshTopology& topology) {
  std::vector<Senses> common = common_senses(mesh);
  forget_open_fans(mesh, topology, common);
  std::vector<std::uint8_t> turns(mesh.points.size(), 0);  // up to 2
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const unsigned senses = common[t[i].index()];
      if (senses == 0) continue;
      const unsigned sense = lowest_bit(senses);
      // Going round counterclockwise, a ray from the vertex is crossed once per turn: from before it to it or beyond.
      const bool is_turned = sense >= 3;
      const std::size_t height = (sense % 3 + 2) % 3;
      const double level = mesh.points[t[i].index()][height];
      const double from = mesh.points[t[(i + (is_turned ? 2 : 1)) % 3].index()][height];
      const double to = mesh.points[t[(i + (is_turned ? 1 : 2)) % 3].index()][height];
      if (from < level && to >= level && turns[t[i].index()] < 2) ++turns[t[i].index()];
    }
  }
  for (std::uint8_t& t : turns) t = t == 1 ? 1 : 0;
  return turns;
}

}  // namespace mortise
