// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "mortise/remesh/edge_queue.h"
#include "mortise/remesh/passes.h"

namespace mortise {
namespace {

constexpr double longest_median = 0.95;  // of the length of its edge: 0.87 where that is the longest of the triangle

class EdgeSplitter {
 public:
  EdgeSplitter(WorkingMesh& w, double longest, double most_new) : w_(w), longest_(longest), left_(most_new) {}

  void run() {
    for (HalfEdge h = 0; h < w_.mesh.half_edge_count(); ++h) {
      if (w_.mesh.has(h) && !w_.mesh.is_on_model_edge(h) && h < w_.mesh.opposite(h)) push(h);
    }
    for (HalfEdge h = queue_.pop(w_.mesh); h != no_half_edge && left_ > 0; h = queue_.pop(w_.mesh)) {
      if (makes_shorter(h)) split(h);
    }
  }

 private:
  void push(HalfEdge h) {
    if (w_.mesh.is_on_model_edge(h)) return;
    const double length = metric_length(w_, h), most = longest_ * w_.coarseness_beside(h);
    if (length > most && may_split(w_, h)) queue_.push(w_.mesh, h, length / most);
  }

  // Edges that stay may have other half-edges after a change beside them.
  void push_triangle(HalfEdge h) {
    push(h);
    push(next_in_face(h));
    push(previous_in_face(h));
  }

  // Beside a longer model edge the new edges may be as long as this one: then splits would not come to an end.
  [[nodiscard]] bool makes_shorter(HalfEdge h) const {
    const VertexId a = w_.mesh.origin(h), b = w_.mesh.target(h);
    const Vec3d middle = 0.5 * (w_.mesh.points[a.index()] + w_.mesh.points[b.index()]);
    const Vec3d along = w_.mesh.points[b.index()] - w_.mesh.points[a.index()];
    bool is_shorter = true;
    w_.mesh.for_each_use(h, [&](HalfEdge u) {
      const Vec3d across = w_.mesh.points[w_.mesh.apex(u).index()] - middle;
      is_shorter = is_shorter && dot(across, across) < longest_median * longest_median * dot(along, along);
    });
    return is_shorter;
  }

  void split(HalfEdge h) {
    left_ -= 2;
    const VertexId m = split_at_middle(w_, h);
    SmallList<HalfEdge, 4> leaving;
    w_.mesh.for_each_leaving(m, [&](HalfEdge g) { leaving.push_back(g); });
    for (const HalfEdge g : leaving) push_triangle(g);
    for (const HalfEdge g : leaving) swap_opposite(next_in_face(g));
  }

  void swap_opposite(HalfEdge h) {
    if (!swap_lowers_angle(w_, h)) return;
    const HalfEdge t = w_.mesh.opposite(h);
    // No swap makes an edge too long that was not: splits come to an end.
    if (metric_length(w_, w_.mesh.apex(h), w_.mesh.apex(t)) > std::max(longest_ * w_.coarseness_beside(h), metric_length(w_, h))) return;
    w_.mesh.swap_edge(h);
    push_triangle(h);
    push_triangle(t);
  }

  WorkingMesh& w_;
  double longest_, left_;  // left_: triangles that may still be made
  EdgeQueue queue_;
};

}  // namespace

void split_long_edges(WorkingMesh& w, double longest, double most_new) { EdgeSplitter(w, longest, most_new).run(); }

}  // namespace mortise
