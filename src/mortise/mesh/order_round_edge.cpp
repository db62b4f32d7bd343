// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Half-planes compared by orientations of their points.
#include "mortise/mesh/order_round_edge.h"

#include <algorithm>
#include <optional>
#include <span>

#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

/// Order of half-planes counterclockwise about the edge from u to v, from the first one that has a direction.
class RadialOrder {
 public:
  RadialOrder(const SurfaceMesh& mesh, const std::array<VertexId, 2>& edge, std::span<const HalfEdge> uses)
      : mesh_(mesh), u_(mesh.points[edge[0].index()]), v_(mesh.points[edge[1].index()]) {
    for (const HalfEdge h : uses) {
      reference_ = apex_of(h);
      axis_ = projection_axis(u_, v_, reference_);
      if (axis_) break;
    }
  }

  [[nodiscard]] bool comes_before(HalfEdge a, HalfEdge b) const {
    const int sector_a = sector_of(a);
    const int sector_b = sector_of(b);
    if (sector_a != sector_b) return sector_a < sector_b;
    const Sign turn = sector_a % 2 == 0 ? Sign::Zero : orient3d(u_, v_, apex_of(a), apex_of(b));
    return turn == Sign::Zero ? a < b : turn == Sign::Positive;
  }

 private:
  [[nodiscard]] const Vec3d& apex_of(HalfEdge h) const { return mesh_.points[origin_of(mesh_, next_in_face(next_in_face(h))).index()]; }

  /// 0: along the reference, or without a direction; 1: less than half a turn on; 2: opposite; 3: more than half a turn.
  [[nodiscard]] int sector_of(HalfEdge h) const {
    if (!axis_) return 0;
    const Sign side = orient3d(u_, v_, reference_, apex_of(h));
    if (side != Sign::Zero) return side == Sign::Positive ? 1 : 3;
    return orient2d(u_, v_, apex_of(h), *axis_) == -orient2d(u_, v_, reference_, *axis_) ? 2 : 0;
  }

  const SurfaceMesh& mesh_;
  Vec3d u_, v_, reference_;
  std::optional<Axis> axis_;
};

}  // namespace

void sort_round_edge(const SurfaceMesh& mesh, const std::array<VertexId, 2>& edge, std::vector<HalfEdge>& half_edges) {
  const RadialOrder order(mesh, edge, half_edges);
  std::sort(half_edges.begin(), half_edges.end(), [&](HalfEdge a, HalfEdge b) { return order.comes_before(a, b); });
}

}  // namespace mortise
