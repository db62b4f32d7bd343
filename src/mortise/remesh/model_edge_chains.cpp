// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/model_edge_chains.h"

#include <algorithm>

namespace mortise {
namespace {

/// A mesh edge on a model edge, seen from one of its ends.
struct Step {
  VertexId from, to;

  auto operator<=>(const Step&) const = default;
};

// Every mesh edge of a model edge, from both ends, sorted.
std::vector<std::vector<Step>> steps_of(const WorkingMesh& w) {
  std::vector<std::vector<Step>> steps(w.brep.edges.size());
  for (HalfEdge h = 0; h < w.mesh.half_edge_count(); ++h) {
    if (!w.mesh.has(h) || !w.mesh.is_on_model_edge(h) || !w.mesh.model_edge(h).is_valid() || !stands_for_edge(w.mesh, h)) continue;
    std::vector<Step>& on = steps[w.mesh.model_edge(h).index()];
    on.push_back({w.mesh.origin(h), w.mesh.target(h)});
    on.push_back({w.mesh.target(h), w.mesh.origin(h)});
  }
  for (std::vector<Step>& on : steps) std::sort(on.begin(), on.end());
  return steps;
}

// Vertex by vertex from a model vertex. A closed edge sets out towards the lower arc.
std::vector<VertexId> walk(const WorkingMesh& w, const std::vector<Step>& steps, VertexId start) {
  const auto from = [&](VertexId v) {
    return std::equal_range(steps.begin(), steps.end(), Step{v, {}}, [](const Step& a, const Step& b) { return a.from < b.from; });
  };
  const auto [first, end] = from(start);
  const auto arc_of = [&](const Step& step) { return w.arcs[step.to.index()]; };
  const bool is_closed = end - first == 2;
  std::vector<VertexId> chain{start, (is_closed && arc_of(first[1]) < arc_of(first[0]) ? first[1] : first[0]).to};
  while (2 * (chain.size() - 1) < steps.size()) {
    const auto here = from(chain.back()).first;
    chain.push_back(here[0].to == chain[chain.size() - 2] ? here[1].to : here[0].to);
  }
  return chain;
}

}  // namespace

IdVector<ModelEdgeId, std::vector<VertexId>> trace_chains(const WorkingMesh& w) {
  const std::vector<std::vector<Step>> steps = steps_of(w);
  std::vector<VertexId> vertex_of(w.brep.vertex_count);
  for (std::size_t v = 0; v < w.mesh.vertex_count(); ++v) {
    const ModelEntity& entity = w.mesh.entity(VertexId(v));
    if (entity.dimension == EntityDimension::Vertex) vertex_of[entity.id] = VertexId(v);
  }
  IdVector<ModelEdgeId, std::vector<VertexId>> chains(steps.size());
  for (std::size_t e = 0; e < steps.size(); ++e) {
    if (!steps[e].empty()) chains[ModelEdgeId(e)] = walk(w, steps[e], vertex_of[w.brep.edges[ModelEdgeId(e)].start.index()]);
  }
  return chains;
}

HalfEdge find_step(const WorkingMesh& w, VertexId a, VertexId b, ModelEdgeId edge) {
  HalfEdge found = no_half_edge;
  w.mesh.for_each_leaving(a, [&](HalfEdge h) {
    if (w.mesh.is_on_model_edge(h) && w.mesh.model_edge(h) == edge && w.mesh.target(h) == b) found = std::min(found, h);
    const HalfEdge back = previous_in_face(h);
    if (w.mesh.is_on_model_edge(back) && w.mesh.model_edge(back) == edge && w.mesh.origin(back) == b) found = std::min(found, back);
  });
  return found;
}

}  // namespace mortise
