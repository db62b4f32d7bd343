// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "mortise/remesh/model_edge_chains.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/vertex_ball.h"

namespace mortise {
namespace {

using Chain = std::vector<VertexId>;

constexpr int sweeps = 3;
constexpr double longest_step = 1.5;  // even steps are between 0.71 and 1.42
constexpr double longest_beside = 4;  // of the other edges at its end, in units of the size: split again in their face

// n with length in [sqrt(n (n - 1)), sqrt(n (n + 1))).
std::size_t step_count(double length, bool is_closed) {
  const auto n = static_cast<std::size_t>(std::floor((1 + std::sqrt(1 + 4 * length * length)) / 2));
  return std::max<std::size_t>(n, is_closed ? 3 : 1);
}

bool try_collapse(WorkingMesh& w, ModelEdgeId edge, VertexId from, VertexId to, double longest) {
  const HalfEdge h = find_step(w, from, to, edge);
  if (h == no_half_edge || !is_collapse_fit(w, h, from, longest)) return false;
  w.mesh.collapse_edge(h, from);
  return true;
}

// Lengths from the start along the curve, and in units of the size.
struct ChainMeasure {
  std::vector<double> arcs, metric;

  // The arc at a metric length.
  [[nodiscard]] double arc_at(double length) const {
    const auto after = static_cast<std::size_t>(std::upper_bound(metric.begin(), metric.end(), length) - metric.begin());
    if (after == 0) return arcs.front();
    if (after == metric.size()) return arcs.back();
    const double t = (length - metric[after - 1]) / (metric[after] - metric[after - 1]);
    return arcs[after - 1] + t * (arcs[after] - arcs[after - 1]);
  }
};

ChainMeasure measure(const WorkingMesh& w, ModelEdgeId edge, const Chain& chain) {
  ChainMeasure m{{w.mesh.is_inside_edge(chain[0]) ? w.arcs[chain[0].index()] : 0}, {0}};
  for (std::size_t k = 1; k < chain.size(); ++k) {
    m.arcs.push_back(w.mesh.is_inside_edge(chain[k]) ? w.arcs[chain[k].index()] : w.reference.length(edge));
    m.metric.push_back(m.metric.back() + metric_length(w, chain[k - 1], chain[k]));
  }
  return m;
}

/// Where the vertices of a chain are among equal steps.
struct ChainPlaces {
  std::vector<double> exact;
  std::vector<std::size_t> nearest;
};

ChainPlaces places_of(const ChainMeasure& m, std::size_t count) {
  ChainPlaces places;
  for (const double length : m.metric) {
    places.exact.push_back(length / m.metric.back() * static_cast<double>(count));
    places.nearest.push_back(static_cast<std::size_t>(std::floor(places.exact.back() + 0.5)));
  }
  return places;
}

// Of vertices that are nearest to the same place all but one go, where they can.
Chain collapse_steps(WorkingMesh& w, ModelEdgeId edge, const Chain& chain, const ChainPlaces& places, double longest) {
  Chain kept{chain.front()};
  std::size_t last = 0;  // of kept, in the chain
  const auto miss = [&](std::size_t k) { return std::fabs(places.exact[k] - static_cast<double>(places.nearest[k])); };
  for (std::size_t k = 1; k < chain.size(); ++k) {
    if (places.nearest[k] == places.nearest[last]) {
      const bool last_may_go = last > 0, may_go = k + 1 < chain.size(), last_first = last_may_go && (!may_go || miss(last) > miss(k));
      const auto drop_last = [&] { return last_may_go && try_collapse(w, edge, chain[last], chain[k], longest); };
      const auto drop_this = [&] { return may_go && try_collapse(w, edge, chain[k], chain[last], longest); };
      if (!last_first && drop_this()) continue;
      if (drop_last())
        kept.pop_back();
      else if (last_first && drop_this())
        continue;
    }
    kept.push_back(chain[k]);
    last = k;
  }
  return kept;
}

// Between vertices that are several places apart come new ones.
Chain split_steps(WorkingMesh& w, ModelEdgeId edge, const Chain& chain, const ChainMeasure& m, const ChainPlaces& places) {
  Chain finer{chain.front()};
  for (std::size_t k = 1; k < chain.size(); ++k) {
    for (std::size_t parts = places.nearest[k] - std::min(places.nearest[k], places.nearest[k - 1]), part = 1; part < parts; ++part) {
      const double arc = m.arcs[k - 1] + (m.arcs[k] - m.arcs[k - 1]) * static_cast<double>(part) / static_cast<double>(parts);
      finer.push_back(split_at_arc(w, find_step(w, finer.back(), chain[k], edge), arc));
    }
    finer.push_back(chain[k]);
  }
  return finer;
}

// Where vertices could not go to their places.
void split_long_steps(WorkingMesh& w, ModelEdgeId edge, const Chain& chain, double longest) {
  const ChainMeasure m = measure(w, edge, chain);
  for (std::size_t k = 1; k < chain.size(); ++k) {
    if (m.metric[k] - m.metric[k - 1] > longest)
      split_at_arc(w, find_step(w, chain[k - 1], chain[k], edge), (m.arcs[k - 1] + m.arcs[k]) / 2);
  }
}

// By the front, before long: till then triangles may be as bad as they like.
bool are_all_replaced(const WorkingMesh& w, VertexId v) {
  bool are_all = true;
  w.mesh.for_each_leaving(v, [&](HalfEdge h) { are_all = are_all && w.awaits_front[w.mesh.face(face_of(h))] != 0; });
  return are_all;
}

void space_evenly(WorkingMesh& w, VertexBall& ball, ModelEdgeId edge, const Chain& chain) {
  const ChainMeasure m = measure(w, edge, chain);
  const std::size_t count = chain.size() - 1;
  for (std::size_t k = 1; k < count; ++k) {
    const VertexId v = chain[k];
    const double from = w.arcs[v.index()], to = m.arc_at(m.metric.back() * static_cast<double>(k) / static_cast<double>(count));
    const auto arc = [&](double fraction) { return from + fraction * (to - from); };
    ball.gather(w, v);
    const double least = are_all_replaced(w, v) ? 0 : std::clamp(ball.quality_at(w.mesh.points[v.index()]), 0.0, 0.3);
    const double fraction = fit_fraction([&](double f) { return ball.quality_at(w.reference.point_at(edge, arc(f))) >= least; });
    if (fraction == 0) continue;
    w.arcs[v.index()] = arc(fraction);
    w.mesh.points[v.index()] = w.reference.point_at(edge, arc(fraction));
    w.sizes[v.index()] = w.proxy->size_at(w.mesh.points[v.index()]);
  }
}

// The least of the faces at a mesh edge.
double coarseness_round(const WorkingMesh& w, HalfEdge h) {
  double least = w.coarseness;
  w.mesh.for_each_use(h, [&](HalfEdge u) { least = std::min(least, w.coarseness_at_edges_of(w.mesh.face(face_of(u)))); });
  return least;
}

// Between ends that stay.
void resample(WorkingMesh& w, ModelEdgeId edge, const Chain& chain) {
  const double coarseness = coarseness_round(w, find_step(w, chain[0], chain[1], edge));
  const ChainMeasure given = measure(w, edge, chain);
  const std::size_t count = step_count(given.metric.back() / coarseness, chain.front() == chain.back());
  const Chain fewer = collapse_steps(w, edge, chain, places_of(given, count), longest_beside * coarseness);
  const ChainMeasure measured = measure(w, edge, fewer);
  const Chain even = split_steps(w, edge, fewer, measured, places_of(measured, count));
  VertexBall ball;
  for (int k = 0; k < sweeps; ++k) space_evenly(w, ball, edge, even);
  split_long_steps(w, edge, even, longest_step * coarseness);
}

// The parts of a chain between vertices that may not move, but those along triangles that may not change.
std::vector<Chain> parts_in_zone(const WorkingMesh& w, ModelEdgeId edge, const Chain& chain) {
  std::vector<Chain> parts;
  Chain part;
  for (const VertexId v : chain) {
    part.push_back(v);
    if (part.size() == 1 || (w.may_move(v) && v != chain.back())) continue;
    if (part.size() > 2 || may_split(w, find_step(w, part[0], part[1], edge))) parts.push_back(part);
    part = {v};
  }
  return parts;
}

}  // namespace

void resample_model_edges(WorkingMesh& w) {
  const IdVector<ModelEdgeId, Chain> chains = trace_chains(w);
  for (std::size_t e = 0; e < chains.size(); ++e) {
    for (const Chain& part : parts_in_zone(w, ModelEdgeId(e), chains[ModelEdgeId(e)])) resample(w, ModelEdgeId(e), part);
  }
}

}  // namespace mortise
