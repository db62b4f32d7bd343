// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Corners by what meets there; then paths from corner to corner.
#include "mortise/brep/trace_edges.h"

#include <algorithm>

#include "mortise/base/trig.h"
#include "mortise/geom/length.h"
#include "mortise/geom/lexicographic.h"

namespace mortise {
namespace {

VertexId other_end(const MeshTopology& topology, MeshEdgeId e, VertexId v) {
  const auto& ends = topology.edges[e.index()];
  return ends[0] == v ? ends[1] : ends[0];
}

class CornerFinder {
 public:
  CornerFinder(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features, const FeaturesRound& round,
               const FaceComponents& pieces, double edge_angle_deg, std::vector<std::uint8_t>& is_corner)
      : mesh_(mesh),
        topology_(topology),
        features_(features),
        round_(round),
        pieces_(pieces),
        least_cosine_(trig::cos_deg(edge_angle_deg)),
        is_corner_(is_corner) {}

  void look_at(VertexId v) {
    const auto edges = round_.of(v);
    if (edges.empty()) return;
    if (edges.size() != 2 || !continues(v, edges[0], edges[1])) is_corner_[v.index()] = 1;
  }

  // Features without a corner are boundaries on all sides.
  void anchor(std::span<const HalfEdge> boundary) {
    VertexId lowest = origin_of(mesh_, boundary[0]);
    for (const HalfEdge h : boundary) {
      const VertexId v = origin_of(mesh_, h);
      if (is_corner_[v.index()] != 0) return;
      const Vec3d &p = mesh_.points[v.index()], &q = mesh_.points[lowest.index()];
      if (p == q ? v < lowest : is_lexicographically_less(p, q)) lowest = v;
    }
    is_corner_[lowest.index()] = 1;
  }

 private:
  [[nodiscard]] bool continues(VertexId v, MeshEdgeId e, MeshEdgeId other) const {
    const bool is_seam = features_.is_seam[e.index()] != 0;
    if (is_seam != (features_.is_seam[other.index()] != 0)) return false;
    return have_same_pieces(topology_.uses_of(e), topology_.uses_of(other)) && (is_seam || !turns(v, e, other));
  }

  [[nodiscard]] bool have_same_pieces(std::span<const HalfEdge> uses, std::span<const HalfEdge> other) const {
    if (uses.size() != other.size()) return false;
    if (uses.size() == 2) return std::minmax(piece_of(uses[0]), piece_of(uses[1])) == std::minmax(piece_of(other[0]), piece_of(other[1]));
    return sorted_pieces(uses) == sorted_pieces(other);
  }

  [[nodiscard]] std::uint32_t piece_of(HalfEdge h) const { return pieces_.component_of[face_of(h).index()]; }

  [[nodiscard]] std::vector<std::uint32_t> sorted_pieces(std::span<const HalfEdge> uses) const {
    std::vector<std::uint32_t> pieces;
    for (const HalfEdge h : uses) pieces.push_back(piece_of(h));
    std::sort(pieces.begin(), pieces.end());
    return pieces;
  }

  [[nodiscard]] Vec3d from(VertexId v, MeshEdgeId e) const {
    const Vec3d along = mesh_.points[other_end(topology_, e, v).index()] - mesh_.points[v.index()];
    return (1 / length(along)) * along;
  }

  [[nodiscard]] bool turns(VertexId v, MeshEdgeId e, MeshEdgeId other) const { return -dot(from(v, e), from(v, other)) < least_cosine_; }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  const FeatureEdges& features_;
  const FeaturesRound& round_;
  const FaceComponents& pieces_;
  double least_cosine_;
  std::vector<std::uint8_t>& is_corner_;
};

class EdgeTracer {
 public:
  EdgeTracer(const MeshTopology& topology, const FeaturesRound& round, const std::vector<std::uint8_t>& is_corner)
      : topology_(topology), round_(round), is_corner_(is_corner) {
    result_.edge_of.resize(topology.edges.size());
  }

  [[nodiscard]] TracedEdges trace(const std::vector<std::uint8_t>& is_feature) {
    for (std::size_t e = 0; e < is_feature.size(); ++e) {
      if (is_feature[e] != 0 && !result_.edge_of[e].is_valid()) trace_through(MeshEdgeId(e));
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_corner(VertexId v) const { return is_corner_[v.index()] != 0; }

  [[nodiscard]] MeshEdgeId other_edge(VertexId v, MeshEdgeId e) const {
    const auto edges = round_.of(v);
    return edges[0] == e ? edges[1] : edges[0];
  }

  // The whole path that an edge is on.
  void trace_through(MeshEdgeId e) {
    VertexId start = topology_.edges[e.index()][0];
    while (!is_corner(start)) {
      e = other_edge(start, e);
      start = other_end(topology_, e, start);
    }
    const auto id = ModelEdgeId(result_.path.size());
    path_.assign(1, start);
    while (true) {
      result_.edge_of[e.index()] = id;
      path_.push_back(other_end(topology_, e, path_.back()));
      if (is_corner(path_.back())) break;
      e = other_edge(path_.back(), e);
    }
    const bool is_closed = path_.front() == path_.back();
    if (is_closed ? path_[path_.size() - 2] < path_[1] : path_.back() < path_.front()) std::reverse(path_.begin(), path_.end());
    result_.path.items.insert(result_.path.items.end(), path_.begin(), path_.end());
    result_.path.close();
  }

  const MeshTopology& topology_;
  const FeaturesRound& round_;
  const std::vector<std::uint8_t>& is_corner_;
  std::vector<VertexId> path_;
  TracedEdges result_;
};

}  // namespace

std::vector<std::uint8_t> find_corners(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features,
                                       const FeaturesRound& round, const FaceComponents& pieces, const FaceBoundaries& boundaries,
                                       double edge_angle_deg) {
  std::vector<std::uint8_t> is_corner(mesh.points.size(), 0);
  CornerFinder finder(mesh, topology, features, round, pieces, edge_angle_deg, is_corner);
  for (const TouchedVertex& t : boundaries.touched) is_corner[t.vertex.index()] = 1;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) finder.look_at(VertexId(v));
  for (std::size_t b = 0; b < boundaries.piece.size(); ++b) finder.anchor(boundaries.half_edges.of(BoundaryId(b)));
  return is_corner;
}

void add_corners_on_seams(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features, const FeaturesRound& round,
                          const FaceComponents& pieces, const std::vector<MeshEdgeId>& seams, std::vector<std::uint8_t>& is_corner) {
  constexpr double any_angle_deg = 180;  // other features do not turn more than they did
  CornerFinder finder(mesh, topology, features, round, pieces, any_angle_deg, is_corner);
  for (const MeshEdgeId seam : seams) {
    for (const VertexId v : topology.edges[seam.index()]) finder.look_at(v);
  }
}

TracedEdges trace_edges(const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature, const FeaturesRound& round,
                        const std::vector<std::uint8_t>& is_corner) {
  return EdgeTracer(topology, round, is_corner).trace(is_feature);
}

}  // namespace mortise
