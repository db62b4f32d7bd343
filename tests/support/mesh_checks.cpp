// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Closedness, Euler characteristic and volume of a mesh, by maps and rationals.
#include "support/mesh_checks.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "mortise/base/bits.h"
#include "support/boolean_oracle.h"

namespace mortise::test {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

template <class Visit>
void for_each_directed_edge(const SurfaceMesh& mesh, Visit visit) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) visit(t[k].value, t[(k + 1) % 3].value);
  }
}

std::array<std::uint64_t, 3> bits_of(const Vec3d& p) {
  return {cast_bits<std::uint64_t>(p.x), cast_bits<std::uint64_t>(p.y), cast_bits<std::uint64_t>(p.z)};
}

}  // namespace

bool is_balanced(const SurfaceMesh& mesh) {
  std::map<Edge, int> balance;
  for_each_directed_edge(mesh, [&](std::uint32_t u, std::uint32_t v) {
    if (u < v) ++balance[{u, v}];
    if (u > v) --balance[{v, u}];
  });
  return std::all_of(balance.begin(), balance.end(), [](const auto& entry) { return entry.second == 0; });
}

std::int64_t euler_characteristic(const SurfaceMesh& mesh) {
  std::set<std::uint32_t> vertices;
  std::set<Edge> edges;
  for_each_directed_edge(mesh, [&](std::uint32_t u, std::uint32_t v) {
    vertices.insert(u);
    edges.insert({std::min(u, v), std::max(u, v)});
  });
  return static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(edges.size()) +
         static_cast<std::int64_t>(mesh.triangles.size());
}

double exactly_summed_volume(const SurfaceMesh& mesh) { return oracle::nearest_double(oracle::volume(mesh)); }

bool has_same_bits(const SurfaceMesh& a, const SurfaceMesh& b) {
  const auto same_bits = [](const Vec3d& p, const Vec3d& q) { return bits_of(p) == bits_of(q); };
  return a.triangles == b.triangles && std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same_bits);
}

std::optional<Error> error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

}  // namespace mortise::test
