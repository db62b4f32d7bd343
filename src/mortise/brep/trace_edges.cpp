// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Corners by what meets there; paths from corner to corner, then round what has no corner.
#include "mortise/brep/trace_edges.h"

#include <algorithm>

#include "mortise/base/trig.h"
#include "mortise/brep/feature_edges.h"
#include "mortise/geom/length.h"
#include "mortise/geom/lexicographic.h"

namespace mortise {
namespace {

class CornerFinder {
 public:
  CornerFinder(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features, const FaceComponents& pieces,
               double edge_angle_deg)
      : mesh_(mesh), topology_(topology), features_(features), pieces_(pieces), least_cosine_(trig::cos_deg(edge_angle_deg)) {}

  [[nodiscard]] std::vector<std::uint8_t> find(const FaceBoundaries& boundaries) const {
    const std::size_t count = mesh_.points.size();
    std::vector<std::uint8_t> is_corner(count, 0);
    for (const TouchedVertex& t : boundaries.touched) is_corner[t.vertex.index()] = 1;
    const Lists<VertexId, MeshEdgeId> round = edges_round_vertices(topology_, features_.is_feature, count);
    for (std::size_t v = 0; v < count; ++v) {
      const auto edges = round.of(VertexId(v));
      if (edges.empty()) continue;
      if (edges.size() != 2 || !continues(VertexId(v), edges[0], edges[1])) is_corner[v] = 1;
    }
    return is_corner;
  }

 private:
  [[nodiscard]] bool continues(VertexId v, MeshEdgeId e, MeshEdgeId other) const {
    const bool is_seam = features_.is_seam[e.index()] != 0;
    if (is_seam != (features_.is_seam[other.index()] != 0)) return false;
    return pieces_at(e) == pieces_at(other) && (is_seam || !turns(v, e, other));
  }

  [[nodiscard]] std::vector<std::uint32_t> pieces_at(MeshEdgeId e) const {
    std::vector<std::uint32_t> pieces;
    for (const HalfEdge h : topology_.uses_of(e)) pieces.push_back(pieces_.component_of[face_of(h).index()]);
    std::sort(pieces.begin(), pieces.end());
    return pieces;
  }

  [[nodiscard]] Vec3d from(VertexId v, MeshEdgeId e) const {
    const auto& ends = topology_.edges[e.index()];
    const Vec3d along = mesh_.points[(ends[0] == v ? ends[1] : ends[0]).index()] - mesh_.points[v.index()];
    return (1 / length(along)) * along;
  }

  [[nodiscard]] bool turns(VertexId v, MeshEdgeId e, MeshEdgeId other) const { return -dot(from(v, e), from(v, other)) < least_cosine_; }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  const FeatureEdges& features_;
  const FaceComponents& pieces_;
  double least_cosine_;
};

class EdgeTracer {
 public:
  EdgeTracer(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature,
             std::vector<std::uint8_t> is_corner)
      : mesh_(mesh), topology_(topology), round_(edges_round_vertices(topology, is_feature, mesh.points.size())) {
    result_.is_corner = std::move(is_corner);
    result_.edge_of.resize(topology.edges.size());
    for (std::size_t e = 0; e < is_feature.size(); ++e) {
      if (is_feature[e] != 0) features_.emplace_back(e);
    }
  }

  [[nodiscard]] TracedEdges trace() {
    add_anchors();
    for (const MeshEdgeId e : features_) {
      if (!result_.edge_of[e.index()].is_valid()) trace_through(e);
    }
    return std::move(result_);
  }

 private:
  struct Walk {
    std::vector<VertexId> path;  // from the far end of the edge on
    std::vector<MeshEdgeId> edges;
  };

  [[nodiscard]] bool is_corner(VertexId v) const { return result_.is_corner[v.index()] != 0; }
  [[nodiscard]] VertexId other_end(MeshEdgeId e, VertexId v) const {
    const auto& ends = topology_.edges[e.index()];
    return ends[0] == v ? ends[1] : ends[0];
  }

  // Along an edge away from one of its ends, to a corner or all the way round.
  [[nodiscard]] Walk walk(VertexId start, MeshEdgeId first) const {
    Walk walk{{start}, {}};
    MeshEdgeId e = first;
    while (true) {
      walk.edges.push_back(e);
      const VertexId v = other_end(e, walk.path.back());
      walk.path.push_back(v);
      if (is_corner(v) || v == start) return walk;
      const auto edges = round_.of(v);
      e = edges[0] == e ? edges[1] : edges[0];
    }
  }

  // A corner on every closed path that has none.
  void add_anchors() {
    std::vector<std::uint8_t> is_seen(result_.edge_of.size(), 0);
    const auto see = [&](const Walk& walked) {
      for (const MeshEdgeId e : walked.edges) is_seen[e.index()] = 1;
    };
    for (std::size_t v = 0; v < result_.is_corner.size(); ++v) {
      if (!is_corner(VertexId(v))) continue;
      for (const MeshEdgeId e : round_.of(VertexId(v))) {
        if (is_seen[e.index()] == 0) see(walk(VertexId(v), e));
      }
    }
    for (const MeshEdgeId e : features_) {
      if (is_seen[e.index()] != 0) continue;
      const Walk round = walk(topology_.edges[e.index()][0], e);
      see(round);
      result_.is_corner[lowest(round.path).index()] = 1;
    }
  }

  [[nodiscard]] VertexId lowest(const std::vector<VertexId>& path) const {
    return *std::min_element(path.begin(), path.end(), [&](VertexId a, VertexId b) {
      const Vec3d &p = mesh_.points[a.index()], &q = mesh_.points[b.index()];
      return p == q ? a < b : is_lexicographically_less(p, q);
    });
  }

  // The whole path that an edge is on.
  void trace_through(MeshEdgeId e) {
    VertexId start = topology_.edges[e.index()][0];
    MeshEdgeId first = e;
    if (!is_corner(start)) {
      const Walk back = walk(start, other_edge(start, e));
      start = back.path.back();
      first = back.edges.back();
    }
    Walk path = walk(start, first);
    const std::size_t last = path.path.size() - 1;
    const bool is_closed = path.path.front() == path.path.back();
    if (is_closed ? path.path[last - 1] < path.path[1] : path.path.back() < path.path.front())
      std::reverse(path.path.begin(), path.path.end());
    result_.path.items.insert(result_.path.items.end(), path.path.begin(), path.path.end());
    const ModelEdgeId id = result_.path.close();
    for (const MeshEdgeId on_path : path.edges) result_.edge_of[on_path.index()] = id;
  }

  [[nodiscard]] MeshEdgeId other_edge(VertexId v, MeshEdgeId e) const {
    const auto edges = round_.of(v);
    return edges[0] == e ? edges[1] : edges[0];
  }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  Lists<VertexId, MeshEdgeId> round_;
  std::vector<MeshEdgeId> features_;
  TracedEdges result_;
};

}  // namespace

std::vector<std::uint8_t> find_corners(const SurfaceMesh& mesh, const MeshTopology& topology, const FeatureEdges& features,
                                       const FaceComponents& pieces, const FaceBoundaries& boundaries, double edge_angle_deg) {
  return CornerFinder(mesh, topology, features, pieces, edge_angle_deg).find(boundaries);
}

TracedEdges trace_edges(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<std::uint8_t>& is_feature,
                        std::vector<std::uint8_t> is_corner) {
  return EdgeTracer(mesh, topology, is_feature, std::move(is_corner)).trace();
}

}  // namespace mortise
