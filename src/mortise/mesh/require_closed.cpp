// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Refuses meshes that bound nothing.
#include "mortise/mesh/require_closed.h"

#include <string>
#include <utility>
#include <vector>

#include "mortise/base/error.h"

namespace mortise {
namespace {

std::vector<std::uint32_t> pairs_of(const WeldedMesh& welded, const MeshTopology& topology, const std::vector<MeshEdgeId>& edges) {
  std::vector<std::uint32_t> pairs;
  for (const MeshEdgeId e : edges) {
    for (const VertexId v : topology.edges[e.index()]) pairs.push_back(welded.old_vertex[v.index()].value);
  }
  return pairs;
}

}  // namespace

void require_closed(const WeldedMesh& welded, const MeshTopology& topology, std::string_view stage) {
  std::vector<MeshEdgeId> open, twisted;
  for (const MeshEdgeId e : find_unbalanced_edges(welded.mesh, topology)) {
    (topology.uses_of(e).size() % 2 != 0 ? open : twisted).push_back(e);
  }
  if (!open.empty()) {
    throw Error(ErrorCode::NotClosed, stage, "the mesh is a sheet, not a solid: " + std::to_string(open.size()) + " open edges")
        .with_ids(IdKind::VertexPairs, pairs_of(welded, topology, open));
  }
  if (twisted.empty()) return;
  throw Error(ErrorCode::NotOriented, stage,
              "the mesh is not consistently oriented: faces run the same way along " + std::to_string(twisted.size()) + " edges")
      .with_ids(IdKind::VertexPairs, pairs_of(welded, topology, twisted));
}

}  // namespace mortise
