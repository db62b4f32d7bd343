// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// From half-edge to half-edge round the vertices between them; corners passed on the way tell which vertices are touched.
#include "mortise/brep/face_boundaries.h"

#include <algorithm>

namespace mortise {
namespace {

std::uint32_t piece_of(const FaceComponents& pieces, HalfEdge h) { return pieces.component_of[face_of(h).index()]; }

/// Calls pass(h) for every half-edge h whose corner the walk passes.
template <class Pass>
void walk_boundaries(const HalfEdgesAcross& across, const FaceComponents& pieces, FaceBoundaries& boundaries, Pass pass) {
  boundaries.half_edges = {};
  boundaries.piece.clear();
  std::vector<std::uint8_t> is_walked(across.size(), 0);
  for (HalfEdge start = 0; start < across.size(); ++start) {
    if (across[start] != no_half_edge || is_walked[start] != 0) continue;
    HalfEdge h = start;
    do {
      is_walked[h] = 1;
      boundaries.half_edges.items.push_back(h);
      h = next_in_face(h);
      pass(h);
      while (across[h] != no_half_edge) {
        h = next_in_face(across[h]);
        pass(h);
      }
    } while (h != start);
    boundaries.half_edges.close();
    boundaries.piece.push_back(piece_of(pieces, start));
  }
}

class BoundaryFinder {
 public:
  BoundaryFinder(const SurfaceMesh& mesh, const HalfEdgesAcross& across, const FaceComponents& pieces)
      : mesh_(mesh),
        across_(across),
        pieces_(pieces),
        corner_count_(mesh.points.size(), 0),
        corner_(mesh.points.size(), no_half_edge),
        closed_fans_(pieces.count, 0) {}

  [[nodiscard]] FaceBoundaries find() {
    count_corners();
    walk_boundaries(across_, pieces_, result_, [this](HalfEdge h) {
      const std::size_t v = origin_of(mesh_, h).index();
      --corner_count_[v];
      corner_[v] = no_half_edge;
    });
    walk_round_vertices();
    find_touched();
    measure_genus();
    return std::move(result_);
  }

 private:
  void count_corners() {
    for (HalfEdge h = 0; h < across_.size(); ++h) {
      const std::size_t v = origin_of(mesh_, h).index();
      ++corner_count_[v];
      corner_[v] = h;
    }
  }

  // Vertices without features. One fan is the rule.
  void walk_round_vertices() {
    for (std::size_t v = 0; v < corner_.size(); ++v) {
      if (corner_[v] == no_half_edge) continue;
      std::uint32_t corners = 0;
      HalfEdge corner = corner_[v];
      do {
        ++corners;
        corner = next_in_face(across_[corner]);
      } while (corner != corner_[v]);
      if (corners != corner_count_[v]) continue;
      corner_count_[v] = 0;
      ++closed_fans_[piece_of(pieces_, corner)];
    }
  }

  // What is left: fans at vertices that have others too, each found from its lowest corner.
  void find_touched() {
    if (std::all_of(corner_count_.begin(), corner_count_.end(), [](std::uint32_t count) { return count == 0; })) return;
    for (HalfEdge h = 0; h < across_.size(); ++h) {
      const VertexId v = origin_of(mesh_, h);
      if (corner_count_[v.index()] == 0) continue;
      HalfEdge lowest = h;
      if (!is_closed_fan(h, lowest) || lowest != h) continue;
      result_.touched.push_back({v, piece_of(pieces_, h)});
    }
    std::sort(result_.touched.begin(), result_.touched.end());
  }

  [[nodiscard]] bool is_closed_fan(HalfEdge h, HalfEdge& lowest) const {
    HalfEdge corner = h;
    do {
      lowest = std::min(lowest, corner);
      if (across_[corner] == no_half_edge) return false;
      corner = next_in_face(across_[corner]);
    } while (corner != h);
    return true;
  }

  // From V - E + F = 2 - 2 genus - boundaries. At a boundary there are as many corners as edges.
  void measure_genus() {
    std::vector<std::int64_t> twice_characteristic(pieces_.count, 0), boundaries(pieces_.count, 0);
    for (std::size_t p = 0; p < pieces_.count; ++p) twice_characteristic[p] = 2 * std::int64_t{closed_fans_[p]};
    for (const std::uint32_t p : pieces_.component_of) --twice_characteristic[p];  // 2 F - 3 F
    for (const HalfEdge h : result_.half_edges.items) ++twice_characteristic[piece_of(pieces_, h)];
    for (const std::uint32_t p : result_.piece) ++boundaries[p];
    for (const TouchedVertex& t : result_.touched) ++boundaries[t.piece];
    for (std::size_t p = 0; p < pieces_.count; ++p) {
      result_.genus.push_back(static_cast<std::uint32_t>((2 - twice_characteristic[p] / 2 - boundaries[p]) / 2));
    }
  }

  const SurfaceMesh& mesh_;
  const HalfEdgesAcross& across_;
  const FaceComponents& pieces_;
  std::vector<std::uint32_t> corner_count_;  // per vertex: corners not passed yet
  std::vector<HalfEdge> corner_;             // per vertex without features: a half-edge that starts there
  std::vector<std::uint32_t> closed_fans_;   // per piece: vertices inside it
  FaceBoundaries result_;
};

}  // namespace

HalfEdgesAcross half_edges_across(const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature) {
  HalfEdgesAcross across(topology.edge_of.size(), no_half_edge);
  for (std::size_t e = 0; e < is_feature.size(); ++e) {
    if (is_feature[e] != 0) continue;
    const auto uses = topology.uses_of(MeshEdgeId(e));
    across[uses[0]] = uses[1];
    across[uses[1]] = uses[0];
  }
  return across;
}

FaceBoundaries find_face_boundaries(const SurfaceMesh& mesh, const HalfEdgesAcross& across, const FaceComponents& pieces) {
  return BoundaryFinder(mesh, across, pieces).find();
}

void walk_again(const HalfEdgesAcross& across, const FaceComponents& pieces, const std::vector<std::uint8_t>& opened,
                FaceBoundaries& boundaries) {
  walk_boundaries(across, pieces, boundaries, [](HalfEdge) {});
  for (std::size_t p = 0; p < opened.size(); ++p) {
    if (opened[p] != 0) boundaries.genus[p] = 0;
  }
}

}  // namespace mortise
