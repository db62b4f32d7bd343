// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <deque>
#include <vector>

#include "mortise/remesh/passes.h"

namespace mortise {

void swap_edges(WorkingMesh& w) {
  std::vector<std::uint8_t> is_queued(w.mesh.half_edge_count(), 0);
  std::deque<HalfEdge> queue;
  const auto push = [&](HalfEdge h) {
    if (w.mesh.is_on_model_edge(h)) return;
    const HalfEdge lowest = std::min(h, w.mesh.opposite(h));
    if (is_queued[lowest] != 0) return;
    is_queued[lowest] = 1;
    queue.push_back(lowest);
  };
  for (HalfEdge h = 0; h < w.mesh.half_edge_count(); ++h) {
    if (w.mesh.has(h)) push(h);
  }
  while (!queue.empty()) {
    const HalfEdge h = queue.front();
    queue.pop_front();
    is_queued[h] = 0;
    if (!swap_lowers_angle(w, h)) continue;
    const HalfEdge t = w.mesh.opposite(h);
    count_change(w);
    w.mesh.swap_edge(h);
    for (const HalfEdge side : {h, t}) {
      push(next_in_face(side));
      push(previous_in_face(side));
    }
  }
}

}  // namespace mortise
