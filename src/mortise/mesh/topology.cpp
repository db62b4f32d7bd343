// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Adjacency by a counting sort on the lower vertex of every edge, and the questions it answers at once.
#include "mortise/mesh/topology.h"

#include <algorithm>
#include <limits>

namespace mortise {
namespace {

/// A use of an edge, seen from the lower vertex.
struct UpwardUse {
  std::uint32_t high;
  HalfEdge half_edge;

  auto operator<=>(const UpwardUse&) const = default;
};

VertexId target_of(const SurfaceMesh& mesh, HalfEdge h) { return origin_of(mesh, next_in_face(h)); }

bool is_loop(const SurfaceMesh& mesh, HalfEdge h) { return origin_of(mesh, h) == target_of(mesh, h); }

std::uint32_t low_end(const SurfaceMesh& mesh, HalfEdge h) { return std::min(origin_of(mesh, h), target_of(mesh, h)).value; }

HalfEdge half_edge_count(const SurfaceMesh& mesh) { return static_cast<HalfEdge>(3 * mesh.triangles.size()); }

/// Uses grouped by lower vertex; `begin` gets vertices + 1 offsets.
std::vector<UpwardUse> group_by_low_end(const SurfaceMesh& mesh, std::vector<std::uint32_t>& begin) {
  begin.assign(mesh.points.size() + 1, 0);
  for (HalfEdge h = 0; h < half_edge_count(mesh); ++h) {
    if (!is_loop(mesh, h)) ++begin[low_end(mesh, h) + 1];
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) begin[v + 1] += begin[v];
  std::vector<UpwardUse> uses(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (HalfEdge h = 0; h < half_edge_count(mesh); ++h) {
    if (is_loop(mesh, h)) continue;
    const std::uint32_t high = std::max(origin_of(mesh, h), target_of(mesh, h)).value;
    uses[next[low_end(mesh, h)]++] = {high, h};
  }
  return uses;
}

template <class Keep>
std::vector<MeshEdgeId> edges_where(const MeshTopology& topology, Keep keep) {
  std::vector<MeshEdgeId> kept;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (keep(MeshEdgeId(e))) kept.push_back(MeshEdgeId(e));
  }
  return kept;
}

}  // namespace

MeshTopology build_topology(const SurfaceMesh& mesh) {
  MeshTopology topology;
  topology.edge_of.resize(half_edge_count(mesh));
  std::vector<std::uint32_t> begin;
  std::vector<UpwardUse> uses = group_by_low_end(mesh, begin);
  topology.uses.reserve(uses.size());
  topology.edges.reserve(uses.size() / 2 + 1);  // all of a closed mesh
  topology.use_begin.reserve(uses.size() / 2 + 2);
  for (std::uint32_t low = 0; low < mesh.points.size(); ++low) {
    std::sort(uses.begin() + begin[low], uses.begin() + begin[low + 1]);
    for (std::uint32_t i = begin[low]; i < begin[low + 1]; ++i) {
      if (i == begin[low] || uses[i].high != uses[i - 1].high) {
        topology.edges.push_back({VertexId(low), VertexId(uses[i].high)});
        topology.use_begin.push_back(i);
      }
      topology.uses.push_back(uses[i].half_edge);
      topology.edge_of[uses[i].half_edge] = MeshEdgeId(topology.edges.size() - 1);
    }
  }
  topology.use_begin.push_back(static_cast<std::uint32_t>(uses.size()));
  return topology;
}

MeshEdgeId find_edge(const MeshTopology& topology, VertexId a, VertexId b) {
  const std::array<VertexId, 2> ends{std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), ends);
  if (found == topology.edges.end() || *found != ends) return {};
  return MeshEdgeId(static_cast<std::size_t>(found - topology.edges.begin()));
}

int balance_of(const SurfaceMesh& mesh, const MeshTopology& topology, MeshEdgeId e) {
  int balance = 0;
  for (const HalfEdge h : topology.uses_of(e)) balance += origin_of(mesh, h) == topology.edges[e.index()][0] ? 1 : -1;
  return balance;
}

std::vector<MeshEdgeId> find_boundary_edges(const MeshTopology& topology) {
  return edges_where(topology, [&](MeshEdgeId e) { return topology.uses_of(e).size() == 1; });
}

std::vector<MeshEdgeId> find_non_manifold_edges(const MeshTopology& topology) {
  return edges_where(topology, [&](MeshEdgeId e) { return topology.uses_of(e).size() > 2; });
}

std::vector<MeshEdgeId> find_unbalanced_edges(const SurfaceMesh& mesh, const MeshTopology& topology) {
  return edges_where(topology, [&](MeshEdgeId e) { return balance_of(mesh, topology, e) != 0; });
}

std::vector<MeshEdgeId> find_inconsistent_edges(const SurfaceMesh& mesh, const MeshTopology& topology) {
  return edges_where(topology, [&](MeshEdgeId e) { return topology.uses_of(e).size() == 2 && balance_of(mesh, topology, e) != 0; });
}

FaceComponents number_components(UnionFind& faces) {
  FaceComponents components;
  components.component_of.resize(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const std::uint32_t lowest = faces.find(f);
    components.component_of[f] = lowest == f ? components.count++ : components.component_of[lowest];
  }
  return components;
}

FaceComponents connect_by_vertices(const SurfaceMesh& mesh) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  UnionFind faces(mesh.triangles.size());
  std::vector<std::uint32_t> first_face(mesh.points.size(), none);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const VertexId v : mesh.triangles[f]) {
      if (first_face[v.index()] == none) first_face[v.index()] = f;
      faces.join(first_face[v.index()], f);
    }
  }
  return number_components(faces);
}

FaceComponents connect_by_edges(const SurfaceMesh& mesh, const MeshTopology& topology) {
  UnionFind faces(mesh.triangles.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const HalfEdge> uses = topology.uses_of(MeshEdgeId(e));
    for (const HalfEdge h : uses) faces.join(face_of(uses[0]).value, face_of(h).value);
  }
  return number_components(faces);
}

}  // namespace mortise
