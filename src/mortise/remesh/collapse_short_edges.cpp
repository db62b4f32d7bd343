// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/edge_queue.h"
#include "mortise/remesh/passes.h"

namespace mortise {
namespace {

class EdgeCollapser {
 public:
  EdgeCollapser(WorkingMesh& w, double shortest, double longest, double most_gone)
      : w_(w), shortest_(shortest), longest_(longest), left_(most_gone) {}

  void run() {
    for (HalfEdge h = 0; h < w_.mesh.half_edge_count(); ++h) {
      if (w_.mesh.has(h) && !w_.mesh.is_on_model_edge(h) && h < w_.mesh.opposite(h)) push(h);
    }
    for (HalfEdge h = queue_.pop(w_.mesh); h != no_half_edge && left_ > 0; h = queue_.pop(w_.mesh)) {
      const VertexId origin = w_.mesh.origin(h), target = w_.mesh.target(h);
      if (!try_collapse(h, origin)) try_collapse(h, target);
    }
  }

 private:
  void push(HalfEdge h) {
    if (w_.mesh.is_on_model_edge(h) || !w_.may_change(face_of(h))) return;
    const double length = metric_length(w_, h), least = shortest_ * w_.coarseness_beside(h);
    if (length < least) queue_.push(w_.mesh, h, least / length);
  }

  bool try_collapse(HalfEdge h, VertexId gone) {
    if (!is_collapse_fit(w_, h, gone, longest_ * w_.coarseness_beside(h))) return false;
    const VertexId stays = w_.mesh.other_end(h, gone);
    count_change(w_);
    w_.mesh.collapse_edge(h, gone);
    left_ -= 2;
    w_.mesh.for_each_leaving(stays, [&](HalfEdge g) { push(g); });
    return true;
  }

  WorkingMesh& w_;
  double shortest_, longest_, left_;  // left_: triangles that may still go
  EdgeQueue queue_;
};

}  // namespace

void collapse_short_edges(WorkingMesh& w, double shortest, double longest, double most_gone) {
  EdgeCollapser(w, shortest, longest, most_gone).run();
}

}  // namespace mortise
