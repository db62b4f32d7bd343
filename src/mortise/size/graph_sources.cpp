// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/graph_sources.h"

#include <algorithm>

#include "mortise/base/error.h"
#include "mortise/base/lists.h"
#include "mortise/base/sort_unique.h"
#include "mortise/base/union_find.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

using GraphEdge = std::array<VertexId, 2>;

std::vector<GraphEdge> sorted_edges(std::size_t point_count, std::span<const GraphEdge> edges) {
  std::vector<GraphEdge> sorted;
  std::vector<std::uint32_t> bad;
  for (const auto& [a, b] : edges) {
    if (a.index() >= point_count || b.index() >= point_count) bad.insert(bad.end(), {a.value, b.value});
    sorted.push_back({std::min(a, b), std::max(a, b)});
  }
  if (!bad.empty())
    throw Error(ErrorCode::InvalidArgument, "sizing", "an edge ends at a point that is not there").with_ids(IdKind::VertexPairs, bad);
  sort_unique(sorted);
  return sorted;
}

// Edges joined where two and no more meet.
UnionFind join_chains(const std::vector<GraphEdge>& edges, std::size_t point_count) {
  struct End {
    VertexId vertex;
    std::uint32_t edge;
  };
  std::vector<End> ends;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (const VertexId v : edges[e]) ends.push_back({v, e});
  }
  const auto edges_of = lists_of<VertexId, std::uint32_t>(
      ends, point_count, [](const End& end) { return end.vertex; }, [](const End& end) { return end.edge; });
  UnionFind chains(edges.size());
  for (std::size_t v = 0; v < point_count; ++v) {
    const auto here = edges_of.of(VertexId(v));
    if (here.size() == 2) chains.join(here[0], here[1]);
  }
  return chains;
}

}  // namespace

std::vector<SizeSource> sources_of_graph(std::span<const Vec3d> points, std::span<const GraphEdge> edges, double growth) {
  struct Chain {
    double length = 0;
    double edge_count = 0;
  };
  const std::vector<GraphEdge> sorted = sorted_edges(points.size(), edges);
  UnionFind chain_of = join_chains(sorted, points.size());
  std::vector<Chain> chains(sorted.size());
  const auto point = [&](VertexId v) { return points[v.index()]; };
  for (std::uint32_t e = 0; e < sorted.size(); ++e) {
    Chain& chain = chains[chain_of.find(e)];
    chain.length += length(point(sorted[e][1]) - point(sorted[e][0]));
    ++chain.edge_count;
  }
  std::vector<SizeSource> sources;
  for (std::uint32_t e = 0; e < sorted.size(); ++e) {
    const Chain& chain = chains[chain_of.find(e)];
    const double spacing = chain.length / chain.edge_count;
    if (spacing > 0) sources.push_back(segment_source(point(sorted[e][0]), point(sorted[e][1]), spacing, growth));
  }
  return sources;
}

}  // namespace mortise
