// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Junctions of several operands -> edges -> chains.
#include "mortise/boolean/intersection_graph.h"

#include <algorithm>

#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"

namespace mortise {
namespace {

bool has_several_operands(const OperandFaces& faces, std::span<const FacetSource> sources) {
  return std::any_of(sources.begin(), sources.end(),
                     [&](const FacetSource& s) { return faces.operand[s.face] != faces.operand[sources.front().face]; });
}

bool meets_other_operand(const OperandFaces& faces, const Facets& facets, std::span<const FacetAtEdge> around) {
  const OperandId first = faces.operand[around.front().face];
  return std::any_of(around.begin(), around.end(), [&](const FacetAtEdge& f) {
    return faces.operand[f.face] != first || has_several_operands(faces, facets.sources_of(f.facet));
  });
}

// Two facets that would be one piece of surface, did not the operand that names their front cross itself and run both ways.
bool continue_each_other_turned(const OperandFaces& faces, const Facets& facets, std::span<const FacetAtEdge> around) {
  if (around.size() != 2 || around[0].is_forward != around[1].is_forward) return false;
  std::vector<Jump> turned = jumps_of(faces, facets, around[0].facet);
  for (Jump& j : turned) j.change = -j.change;
  return turned == jumps_of(faces, facets, around[1].facet) &&
         walls_of(faces, facets, around[0].facet) == walls_of(faces, facets, around[1].facet);
}

// Points of the graph: ends of its edges, and contact points where facets of several operands meet but none coincide.
std::vector<PointId> points_of_graph(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets,
                                     std::span<const std::array<PointId, 2>> edges) {
  enum class Met : std::uint8_t { NoContact, Nothing, OneOperand, SeveralOperands, Area };
  std::vector<Met> met(faces.points.size(), Met::NoContact);
  std::vector<OperandId> operand(faces.points.size());
  for (const PointId p : map.contact_points) met[p.index()] = Met::Nothing;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto sources = facets.sources_of(FacetId(i));
    const bool is_shared = has_several_operands(faces, sources);
    const OperandId k = faces.operand[sources.front().face];
    for (const PointId p : facets.corners[FacetId(i)]) {
      Met& m = met[p.index()];
      if (m == Met::NoContact) continue;
      if (m == Met::Nothing) operand[p.index()] = k;
      m = std::max(m, is_shared ? Met::Area : operand[p.index()] == k ? Met::OneOperand : Met::SeveralOperands);
    }
  }
  std::vector<PointId> points;
  for (const PointId p : map.contact_points) {
    if (met[p.index()] == Met::SeveralOperands) points.push_back(p);
  }
  for (const auto& edge : edges) points.insert(points.end(), edge.begin(), edge.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Follows chains through points of degree two.
class ChainTracer {
 public:
  explicit ChainTracer(IntersectionGraph& graph) : graph_(graph), first_(graph.points.size() + 1, 0), used_(graph.edges.size(), 0) {
    for (const auto& [p, q] : graph.edges) {
      ++first_[p + 1];
      ++first_[q + 1];
    }
    for (std::size_t i = 0; i < graph.points.size(); ++i) first_[i + 1] += first_[i];
    edge_at_.resize(2 * graph.edges.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
      for (const std::uint32_t p : graph.edges[e]) edge_at_[next[p]++] = e;
    }
  }

  void trace() {
    std::vector<std::vector<std::uint32_t>> open;
    for (std::uint32_t p = 0; p < graph_.points.size(); ++p) {
      if (degree(p) == 2) continue;
      for (std::uint32_t i = first_[p]; i < first_[p + 1]; ++i) {
        if (used_[edge_at_[i]] != 0) continue;
        std::vector<std::uint32_t> chain = follow(p, edge_at_[i]);
        (chain.front() == chain.back() ? graph_.chains : open).push_back(std::move(chain));
      }
    }
    for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
      if (used_[e] == 0) graph_.chains.push_back(follow(graph_.edges[e][0], e));
    }
    graph_.closed_loops = static_cast<std::uint32_t>(graph_.chains.size());
    graph_.open_chains = static_cast<std::uint32_t>(open.size());
    graph_.chains.insert(graph_.chains.end(), open.begin(), open.end());
  }

 private:
  [[nodiscard]] std::uint32_t degree(std::uint32_t p) const { return first_[p + 1] - first_[p]; }

  std::vector<std::uint32_t> follow(std::uint32_t start, std::uint32_t edge) {
    std::vector<std::uint32_t> chain{start};
    while (true) {
      used_[edge] = 1;
      const auto& ends = graph_.edges[edge];
      chain.push_back(ends[0] == chain.back() ? ends[1] : ends[0]);
      const std::uint32_t p = chain.back();
      if (p == start || degree(p) != 2) return chain;
      edge = edge_at_[first_[p]] == edge ? edge_at_[first_[p] + 1] : edge_at_[first_[p]];
    }
  }

  IntersectionGraph& graph_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> edge_at_;
  std::vector<std::uint8_t> used_;
};

}  // namespace

IntersectionGraph build_intersection_graph(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets,
                                           const Patches& patches) {
  std::vector<std::array<PointId, 2>> edges;
  for (const Junction& j : patches.junctions) {
    const auto around = patches.facets_round(j);
    if (meets_other_operand(faces, facets, around) && !continue_each_other_turned(faces, facets, around)) edges.push_back({j.u, j.v});
  }
  const std::vector<PointId> points = points_of_graph(faces, map, facets, edges);
  const auto number = [&](PointId p) {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
  };
  IntersectionGraph graph;
  for (const PointId p : points) graph.points.push_back(faces.points.nearest(p));
  for (const auto& [u, v] : edges) graph.edges.push_back({number(u), number(v)});
  ChainTracer(graph).trace();
  return graph;
}

ContactMeasure measure_contact(const OperandFaces& faces, const Facets& facets, const IntersectionGraph& graph) {
  ContactMeasure measure;
  std::vector<std::uint8_t> is_on_edge(graph.points.size(), 0);
  for (const auto& [p, q] : graph.edges) {
    is_on_edge[p] = is_on_edge[q] = 1;
    measure.length += length(graph.points[q] - graph.points[p]);
  }
  measure.points = static_cast<std::uint64_t>(std::count(is_on_edge.begin(), is_on_edge.end(), 0));
  SurfaceMesh coincident;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!has_several_operands(faces, facets.sources_of(FacetId(i)))) continue;
    const std::size_t first = coincident.points.size();
    for (const PointId p : facets.corners[FacetId(i)]) coincident.points.push_back(faces.points.nearest(p));
    coincident.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  }
  measure.area = surface_area(coincident);
  return measure;
}

}  // namespace mortise
