// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Adjacency of a surface mesh, and what follows from it: open and crowded edges, balance, components, pinches, genus.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mortise/base/union_find.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

using MeshEdgeId = Id<struct MeshEdgeTag>;  ///< edge of one MeshTopology

/// Half-edge 3 f + k runs along face f from its corner k to the next corner.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge no_half_edge = 0xffffffffU;

[[nodiscard]] inline FaceId face_of(HalfEdge h) { return FaceId(h / 3); }
[[nodiscard]] inline HalfEdge next_in_face(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
[[nodiscard]] inline HalfEdge previous_in_face(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
[[nodiscard]] inline VertexId origin_of(const SurfaceMesh& mesh, HalfEdge h) { return mesh.triangles[h / 3][h % 3]; }

/// The unordered edges of a mesh and the half-edges that use them.
struct MeshTopology {
  std::vector<std::array<VertexId, 2>> edges;  ///< [0] < [1], sorted
  std::vector<std::uint32_t> use_begin;        ///< edges + 1 offsets into uses
  std::vector<HalfEdge> uses;                  ///< per edge ascending
  std::vector<MeshEdgeId> edge_of;             ///< per half-edge; invalid where a face repeats a vertex

  [[nodiscard]] std::span<const HalfEdge> uses_of(MeshEdgeId e) const {
    return std::span<const HalfEdge>(uses).subspan(use_begin[e.index()], use_begin[e.index() + 1] - use_begin[e.index()]);
  }
};

/// Needs indices in range. O(n log k) for at most k faces round a vertex.
[[nodiscard]] MeshTopology build_topology(const SurfaceMesh& mesh);

/// The edge between two vertices; invalid when there is none. O(log n).
[[nodiscard]] MeshEdgeId find_edge(const MeshTopology& topology, VertexId a, VertexId b);

/// Uses that run from the lower to the higher vertex, less those that run back.
[[nodiscard]] int balance_of(const SurfaceMesh& mesh, const MeshTopology& topology, MeshEdgeId e);

/// Edges with exactly one use.
[[nodiscard]] std::vector<MeshEdgeId> find_boundary_edges(const MeshTopology& topology);
/// Edges with more than two uses.
[[nodiscard]] std::vector<MeshEdgeId> find_non_manifold_edges(const MeshTopology& topology);
/// Edges whose balance is not zero. None: the surface is closed.
[[nodiscard]] std::vector<MeshEdgeId> find_unbalanced_edges(const SurfaceMesh& mesh, const MeshTopology& topology);
/// Edges of exactly two faces that run the same way along it. None: the surface is oriented.
[[nodiscard]] std::vector<MeshEdgeId> find_inconsistent_edges(const SurfaceMesh& mesh, const MeshTopology& topology);

/// A partition of the faces; components are numbered by their lowest face.
struct FaceComponents {
  std::vector<std::uint32_t> component_of;  ///< per face
  std::uint32_t count = 0;
};

/// The sets of faces as components.
[[nodiscard]] FaceComponents number_components(UnionFind& faces);
/// Faces connected through shared vertices.
[[nodiscard]] FaceComponents connect_by_vertices(const SurfaceMesh& mesh);
/// Faces connected through shared edges, with any number of faces on them.
[[nodiscard]] FaceComponents connect_by_edges(const SurfaceMesh& mesh, const MeshTopology& topology);

/// Vertices whose faces are not all connected through edges at the vertex; ascending.
[[nodiscard]] std::vector<VertexId> find_non_manifold_vertices(const SurfaceMesh& mesh, const MeshTopology& topology);

/// A mesh taken apart where it touches itself.
struct SplitPinches {
  SurfaceMesh mesh;              ///< the same faces; vertices in the order of `source`
  std::vector<VertexId> source;  ///< per new vertex, ascending: the vertex it is a copy of
  FaceComponents shells;
};

/// Copies vertices until every edge has at most two faces and every vertex one fan.
///
/// At an edge with more faces, those that bound one wedge of the inside stay together (exact radial order): bodies that
/// touch along an edge come apart. Faces left over where an edge is not balanced are open there. Vertices without faces go.
[[nodiscard]] SplitPinches split_pinches(const SurfaceMesh& mesh, const MeshTopology& topology);

/// Sum of the genus of all shells of a closed mesh none of whose faces repeats a vertex.
[[nodiscard]] std::int64_t genus_of(const SplitPinches& split);

/// Sum of the genus of all shells after splitting pinches; nothing unless the surface is closed. Faces that repeat a
/// vertex do not count.
[[nodiscard]] std::optional<std::int64_t> genus_of(const SurfaceMesh& mesh, const MeshTopology& topology);

}  // namespace mortise
