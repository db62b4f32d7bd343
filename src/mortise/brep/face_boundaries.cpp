// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// From half-edge to half-edge round the vertices between them; corners passed on the way tell which vertices are touched.
#include "mortise/brep/face_boundaries.h"

#include <algorithm>

namespace mortise {
namespace {

constexpr HalfEdge none = 0xffffffffU;

class BoundaryFinder {
 public:
  BoundaryFinder(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature,
                 const FaceComponents& pieces)
      : mesh_(mesh),
        topology_(topology),
        is_feature_(is_feature),
        pieces_(pieces),
        corner_count_(mesh.points.size(), 0),
        first_(mesh.points.size(), none),
        closed_fans_(pieces.count, 0) {}

  [[nodiscard]] FaceBoundaries find() {
    count_corners();
    walk_boundaries();
    walk_round_vertices();
    find_touched();
    measure_genus();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_boundary(HalfEdge h) const { return is_feature_[topology_.edge_of[h].index()] != 0; }
  [[nodiscard]] std::uint32_t piece_of(HalfEdge h) const { return pieces_.component_of[face_of(h).index()]; }
  [[nodiscard]] HalfEdge half_edge_count() const { return static_cast<HalfEdge>(topology_.edge_of.size()); }

  [[nodiscard]] HalfEdge opposite(HalfEdge h) const {
    const auto uses = topology_.uses_of(topology_.edge_of[h]);
    return uses[0] == h ? uses[1] : uses[0];
  }

  void count_corners() {
    for (HalfEdge h = 0; h < half_edge_count(); ++h) {
      const std::size_t v = origin_of(mesh_, h).index();
      ++corner_count_[v];
      if (first_[v] == none) first_[v] = h;
    }
  }

  // The boundary half-edge that starts where h ends, and the corners between them.
  [[nodiscard]] HalfEdge next_boundary(HalfEdge h) {
    HalfEdge next = next_in_face(h);
    std::uint32_t& corners = corner_count_[origin_of(mesh_, next).index()];
    --corners;
    while (!is_boundary(next)) {
      next = next_in_face(opposite(next));
      --corners;
    }
    return next;
  }

  void walk_boundaries() {
    std::vector<std::uint8_t> is_walked(half_edge_count(), 0);
    for (HalfEdge start = 0; start < half_edge_count(); ++start) {
      if (is_walked[start] != 0 || !is_boundary(start)) continue;
      HalfEdge h = start;
      do {
        is_walked[h] = 1;
        result_.half_edges.items.push_back(h);
        h = next_boundary(h);
      } while (h != start);
      result_.half_edges.close();
      result_.piece.push_back(piece_of(start));
      for (const HalfEdge passed : result_.half_edges.of(BoundaryId(result_.piece.size() - 1))) {
        first_[origin_of(mesh_, passed).index()] = none;
      }
    }
  }

  // Corners all round the origin of h, which no boundary reaches there.
  template <class Visit>
  void for_each_corner_round(HalfEdge h, Visit visit) const {
    HalfEdge corner = h;
    do {
      visit(corner);
      corner = opposite(next_in_face(next_in_face(corner)));
    } while (corner != h);
  }

  // Vertices without features. One fan is the rule.
  void walk_round_vertices() {
    for (std::size_t v = 0; v < first_.size(); ++v) {
      if (first_[v] == none) continue;
      std::uint32_t corners = 0;
      for_each_corner_round(first_[v], [&](HalfEdge) { ++corners; });
      if (corners != corner_count_[v]) continue;
      corner_count_[v] = 0;
      ++closed_fans_[piece_of(first_[v])];
    }
  }

  // What is left: fans at vertices that have others too, each found from its lowest corner.
  void find_touched() {
    for (HalfEdge h = 0; h < half_edge_count(); ++h) {
      const VertexId v = origin_of(mesh_, h);
      if (corner_count_[v.index()] == 0) continue;
      HalfEdge lowest = h;
      if (!is_closed_fan(h, lowest) || lowest != h) continue;
      result_.touched.push_back({v, piece_of(h)});
    }
    std::sort(result_.touched.begin(), result_.touched.end());
  }

  [[nodiscard]] bool is_closed_fan(HalfEdge h, HalfEdge& lowest) const {
    HalfEdge corner = h;
    do {
      lowest = std::min(lowest, corner);
      const HalfEdge before = next_in_face(next_in_face(corner));
      if (is_boundary(before)) return false;
      corner = opposite(before);
    } while (corner != h);
    return true;
  }

  // From V - E + F = 2 - 2 genus - boundaries. At a boundary there are as many corners as edges.
  void measure_genus() {
    std::vector<std::int64_t> twice_characteristic(pieces_.count, 0), boundaries(pieces_.count, 0);
    for (std::size_t p = 0; p < pieces_.count; ++p) twice_characteristic[p] = 2 * std::int64_t{closed_fans_[p]};
    for (const std::uint32_t p : pieces_.component_of) --twice_characteristic[p];  // 2 F - 3 F
    for (const HalfEdge h : result_.half_edges.items) ++twice_characteristic[piece_of(h)];
    for (const std::uint32_t p : result_.piece) ++boundaries[p];
    for (const TouchedVertex& t : result_.touched) ++boundaries[t.piece];
    for (std::size_t p = 0; p < pieces_.count; ++p) {
      result_.genus.push_back(static_cast<std::uint32_t>((2 - twice_characteristic[p] / 2 - boundaries[p]) / 2));
    }
  }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  const std::vector<std::uint8_t>& is_feature_;
  const FaceComponents& pieces_;
  std::vector<std::uint32_t> corner_count_;  // per vertex: corners not passed yet
  std::vector<HalfEdge> first_;              // per vertex without features: a half-edge that starts there
  std::vector<std::uint32_t> closed_fans_;   // per piece: vertices inside it
  FaceBoundaries result_;
};

}  // namespace

FaceBoundaries find_face_boundaries(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature,
                                    const FaceComponents& pieces) {
  return BoundaryFinder(mesh, topology, is_feature, pieces).find();
}

}  // namespace mortise
