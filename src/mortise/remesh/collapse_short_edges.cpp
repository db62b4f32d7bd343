// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <queue>
#include <vector>

#include "mortise/remesh/passes.h"

namespace mortise {
namespace {

/// An edge as it was when it was queued. The shortest comes first, of equal ones the lowest half-edge.
struct QueuedEdge {
  double length = 0;
  HalfEdge half_edge = 0;
  VertexId origin, target;

  bool operator<(const QueuedEdge& other) const { return length != other.length ? length > other.length : half_edge > other.half_edge; }
};

class EdgeCollapser {
 public:
  EdgeCollapser(WorkingMesh& w, double shortest, double longest) : w_(w), shortest_(shortest), longest_(longest) {}

  void run() {
    for (HalfEdge h = 0; h < w_.mesh.half_edge_count(); ++h) {
      if (w_.mesh.has(h) && stands_for_edge(w_.mesh, h)) push(h);
    }
    while (!queue_.empty()) {
      const QueuedEdge next = queue_.top();
      queue_.pop();
      const HalfEdge h = next.half_edge;
      const bool is_same = w_.mesh.has(h) && w_.mesh.origin(h) == next.origin && w_.mesh.target(h) == next.target;
      if (is_same && !w_.mesh.is_on_model_edge(h) && !try_collapse(h, next.origin)) try_collapse(h, next.target);
    }
  }

 private:
  void push(HalfEdge h) {
    if (w_.mesh.is_on_model_edge(h)) return;
    const double length = metric_length(w_, h);
    if (length < shortest_) queue_.push({length, h, w_.mesh.origin(h), w_.mesh.target(h)});
  }

  bool try_collapse(HalfEdge h, VertexId gone) {
    if (!is_collapse_fit(w_, h, gone, longest_)) return false;
    const VertexId stays = w_.mesh.other_end(h, gone);
    w_.mesh.collapse_edge(h, gone);
    w_.mesh.for_each_leaving(stays, [&](HalfEdge g) { push(g); });
    return true;
  }

  WorkingMesh& w_;
  double shortest_, longest_;
  std::priority_queue<QueuedEdge> queue_;
};

}  // namespace

void collapse_short_edges(WorkingMesh& w, double shortest, double longest) { EdgeCollapser(w, shortest, longest).run(); }

}  // namespace mortise
