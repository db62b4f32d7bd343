// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Takes a mesh apart where it touches itself: pairs the faces round crowded edges, then joins corners.
#include <algorithm>
#include <utility>

#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/order_round_edge.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/wedge_partners.h"

namespace mortise {
namespace {

using HalfEdgePair = std::pair<HalfEdge, HalfEdge>;

/// Pairs the faces that bound one wedge of the inside. Going round the edge counterclockwise, a face that runs against it
/// enters the inside and a face that runs along it leaves: pairs are matching brackets, cyclically.
void pair_by_wedges(const SurfaceMesh& mesh, const MeshTopology& topology, MeshEdgeId e, std::vector<HalfEdgePair>& pairs) {
  const std::span<const HalfEdge> uses = topology.uses_of(e);
  const std::array<VertexId, 2>& edge = topology.edges[e.index()];
  std::vector<HalfEdge> round(uses.begin(), uses.end());
  sort_round_edge(mesh, edge, round);
  std::vector<HalfEdge> entered;
  std::vector<bool> is_paired(round.size(), false);
  for (std::size_t step = 0; step < 2 * round.size(); ++step) {
    const std::size_t i = step % round.size();
    const bool leaves = origin_of(mesh, round[i]) == edge[0];
    if (!leaves && step < round.size()) entered.push_back(round[i]);
    if (!leaves || is_paired[i] || entered.empty()) continue;
    pairs.emplace_back(entered.back(), round[i]);
    entered.pop_back();
    is_paired[i] = true;
  }
}

/// The half-edges that stay joined: two that run against each other.
std::vector<HalfEdgePair> pair_half_edges(const SurfaceMesh& mesh, const MeshTopology& topology) {
  std::vector<HalfEdgePair> pairs;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const HalfEdge> uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() > 2) {
      pair_by_wedges(mesh, topology, MeshEdgeId(e), pairs);
    } else if (uses.size() == 2) {
      pairs.emplace_back(uses[0], uses[1]);
    }
  }
  return pairs;
}

/// Joins the corners at both ends of every pair: a set is then one fan of faces.
UnionFind join_corners(const SurfaceMesh& mesh, std::span<const HalfEdgePair> pairs) {
  UnionFind corners(3 * mesh.triangles.size());
  for (const auto& [g, h] : pairs) {
    const bool run_the_same_way = origin_of(mesh, g) == origin_of(mesh, h);
    corners.join(g, run_the_same_way ? h : next_in_face(h));
    corners.join(next_in_face(g), run_the_same_way ? next_in_face(h) : h);
  }
  return corners;
}

FaceComponents connect_by_pairs(std::size_t face_count, std::span<const HalfEdgePair> pairs) {
  UnionFind faces(face_count);
  for (const auto& [g, h] : pairs) faces.join(face_of(g).value, face_of(h).value);
  return number_components(faces);
}

/// The same mesh without the faces that repeat a vertex: they do not change any balance.
SurfaceMesh drop_repeating_faces(const SurfaceMesh& mesh) {
  SurfaceMesh kept;
  kept.points = mesh.points;
  for (const Triangle& triangle : mesh.triangles) {
    if (!repeats_vertex(triangle)) kept.triangles.push_back(triangle);
  }
  return kept;
}

}  // namespace

std::vector<VertexId> find_non_manifold_vertices(const SurfaceMesh& mesh, const MeshTopology& topology) {
  std::vector<HalfEdgePair> pairs;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const HalfEdge> uses = topology.uses_of(MeshEdgeId(e));
    for (std::size_t i = 1; i < uses.size(); ++i) pairs.emplace_back(uses[0], uses[i]);
  }
  UnionFind corners = join_corners(mesh, pairs);
  std::vector<std::uint32_t> fans(mesh.points.size(), 0);
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    if (corners.find(c) == c) ++fans[origin_of(mesh, c).index()];
  }
  std::vector<VertexId> vertices;
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (fans[v] > 1) vertices.push_back(VertexId(v));
  }
  return vertices;
}

std::vector<HalfEdge> find_wedge_partners(const SurfaceMesh& mesh, const MeshTopology& topology) {
  std::vector<HalfEdge> partner(3 * mesh.triangles.size(), no_partner);
  for (const auto& [g, h] : pair_half_edges(mesh, topology)) {
    partner[g] = h;
    partner[h] = g;
  }
  return partner;
}

SplitPinches split_pinches(const SurfaceMesh& mesh, const MeshTopology& topology) {
  const std::vector<HalfEdgePair> pairs = pair_half_edges(mesh, topology);
  UnionFind corners = join_corners(mesh, pairs);
  std::vector<std::pair<VertexId, std::uint32_t>> fans;  // vertex, lowest corner
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    if (corners.find(c) == c) fans.emplace_back(origin_of(mesh, c), c);
  }
  std::sort(fans.begin(), fans.end());

  SplitPinches split;
  split.mesh = {{}, mesh.triangles, mesh.face_labels, mesh.label_names, mesh.walls, mesh.diagonals, {}, mesh.corner_data};
  std::vector<VertexId> vertex_of_fan(corners.size());
  for (const auto& [vertex, corner] : fans) {
    vertex_of_fan[corner] = VertexId(split.source.size());
    split.source.push_back(vertex);
    split.mesh.points.push_back(mesh.points[vertex.index()]);
  }
  for (std::uint32_t c = 0; c < corners.size(); ++c) split.mesh.triangles[c / 3][c % 3] = vertex_of_fan[corners.find(c)];
  split.mesh.vertex_data = select_vertex_data(mesh.vertex_data, split.source);
  split.shells = connect_by_pairs(mesh.triangles.size(), pairs);
  return split;
}

std::int64_t genus_of(const SplitPinches& split) {
  const auto faces = static_cast<std::int64_t>(split.mesh.triangles.size());
  const auto vertices = static_cast<std::int64_t>(split.source.size());
  const std::int64_t euler = vertices - 3 * faces / 2 + faces;  // every edge has two uses
  return split.shells.count - euler / 2;
}

std::optional<std::int64_t> genus_of(const SurfaceMesh& mesh, const MeshTopology& topology) {
  if (!find_unbalanced_edges(mesh, topology).empty()) return std::nullopt;
  if (std::any_of(mesh.triangles.begin(), mesh.triangles.end(), repeats_vertex)) {
    const SurfaceMesh kept = drop_repeating_faces(mesh);
    return genus_of(kept, build_topology(kept));
  }
  return genus_of(split_pinches(mesh, topology));
}

}  // namespace mortise
