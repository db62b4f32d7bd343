// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/model_edge_chains.h"

#include <algorithm>
#include <array>

namespace mortise {
namespace {}  // namespace

IdVector<ModelEdgeId, std::vector<VertexId>> trace_chains(const WorkingMesh& w) {
  const std::size_t edge_count = w.brep.edges.size();
  std::vector<std::vector<std::array<VertexId, 2>>> steps(edge_count);
  for (HalfEdge h = 0; h < w.mesh.half_edge_count(); ++h) {
    if (w.mesh.has(h) && w.mesh.is_on_model_edge(h) && stands_for_edge(w.mesh, h)) {
      const ArcRange range = arcs_of(w, h);
      const std::array<VertexId, 2> ends{w.mesh.origin(h), w.mesh.target(h)};
      steps[w.mesh.model_edge(h).index()].push_back(range.origin <= range.target ? ends : std::array{ends[1], ends[0]});
    }
  }
  IdVector<ModelEdgeId, std::vector<VertexId>> chains(edge_count);
  for (std::size_t e = 0; e < edge_count; ++e) {
    const auto arc_of = [&](VertexId v) { return w.mesh.is_inside_edge(v) ? w.arcs[v.index()] : 0; };
    std::sort(steps[e].begin(), steps[e].end(), [&](const auto& a, const auto& b) { return arc_of(a[0]) < arc_of(b[0]); });
    std::vector<VertexId>& chain = chains[ModelEdgeId(e)];
    for (const auto& step : steps[e]) chain.push_back(step[0]);
    if (!steps[e].empty()) chain.push_back(steps[e].back()[1]);
  }
  return chains;
}

HalfEdge find_step(const WorkingMesh& w, VertexId a, VertexId b, ModelEdgeId edge) {
  HalfEdge found = no_half_edge;
  w.mesh.for_each_leaving(a, [&](HalfEdge h) {
    if (w.mesh.is_on_model_edge(h) && w.mesh.model_edge(h) == edge && w.mesh.target(h) == b) found = std::min(found, h);
    const HalfEdge back = EditMesh::previous_in_face(h);
    if (w.mesh.is_on_model_edge(back) && w.mesh.model_edge(back) == edge && w.mesh.origin(back) == b) found = std::min(found, back);
  });
  return found;
}

}  // namespace mortise
