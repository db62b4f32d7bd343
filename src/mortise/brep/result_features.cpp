// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Facets of one group at one place, and the edges between others.
#include "mortise/brep/result_features.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "mortise/base/error.h"
#include "mortise/base/sort_unique.h"
#include "mortise/mesh/topology.h"

namespace mortise {

std::vector<std::uint32_t> group_by_operands(const Provenance& provenance) {
  std::map<std::vector<std::uint32_t>, std::uint32_t> number;
  std::vector<std::uint32_t> groups, operands;
  for (std::size_t t = 0; t < provenance.source_operand.size(); ++t) {
    operands.clear();
    for_each_source(provenance, FaceId(t), [&](const FacetOrigin& s) { operands.push_back(s.operand); });
    sort_unique(operands);
    groups.push_back(number.emplace(operands, static_cast<std::uint32_t>(number.size())).first->second);
  }
  return groups;
}

std::vector<std::array<VertexId, 2>> find_graph_edges(const SurfaceMesh& mesh, const Provenance& provenance) {
  if (provenance.source_operand.size() != mesh.triangles.size())
    throw Error(ErrorCode::InvalidArgument, "find_graph_edges", "there is not one source per triangle");
  const std::vector<std::uint32_t> groups = group_by_operands(provenance);
  const auto mark_of = [&](HalfEdge h) {
    const std::size_t t = face_of(h).index();
    const auto of_facet = [t](const auto& marks) { return marks.empty() ? 0U : static_cast<std::uint32_t>(marks[t]); };
    return std::tuple(groups[t], of_facet(provenance.category), of_facet(provenance.covering), of_facet(provenance.covering_front));
  };
  const MeshTopology topology = build_topology(mesh);
  std::vector<std::array<VertexId, 2>> edges;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(MeshEdgeId(e));
    if (std::any_of(uses.begin(), uses.end(), [&](HalfEdge h) { return mark_of(h) != mark_of(uses[0]); }))
      edges.push_back(topology.edges[e]);
  }
  return edges;
}

}  // namespace mortise
