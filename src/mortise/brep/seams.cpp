// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Loops become single nodes of the graph of a piece. Its tree of shortest paths joins them; edges that neither the tree nor a
// spanning tree of the triangles uses close the shortest ways round handles (Eppstein 2003, Erickson and Whittlesey 2005).
#include "mortise/brep/seams.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

#include "mortise/base/sort_unique.h"
#include "mortise/geom/length.h"
#include "mortise/geom/lexicographic.h"

namespace mortise {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

using PieceId = Id<struct PieceTag>;

// What a piece is bounded by.
struct PieceLoops {
  std::vector<BoundaryId> loops;
  bool is_simple = true;  // no vertex is on loops twice
};

class SeamFinder {
 public:
  SeamFinder(const SurfaceMesh& mesh, const MeshTopology& topology, const FaceComponents& pieces, const FaceBoundaries& boundaries,
             const std::vector<std::uint8_t>& is_corner)
      : mesh_(mesh),
        topology_(topology),
        pieces_(pieces),
        boundaries_(boundaries),
        is_corner_(is_corner),
        node_of_(mesh.points.size(), none) {}

  [[nodiscard]] std::vector<MeshEdgeId> find(Seams seams, const std::vector<std::uint8_t>& may_open) {
    const std::vector<PieceLoops> loops = loops_of_pieces();
    std::vector<std::uint8_t> is_cut(pieces_.count, 0);
    for (std::size_t p = 0; p < loops.size(); ++p)
      is_cut[p] = may_open[p] != 0 && gets_seams(seams, loops[p], boundaries_.genus[p]) ? 1 : 0;
    const Lists<PieceId, FaceId> faces = faces_of(is_cut);
    for (std::size_t p = 0; p < loops.size(); ++p) {
      if (is_cut[p] != 0) cut(faces.of(PieceId(p)), loops[p].loops, boundaries_.genus[p]);
    }
    sort_unique(found_);
    return std::move(found_);
  }

 private:
  struct Step {
    double distance;
    std::uint32_t node;

    auto operator<=>(const Step&) const = default;
  };
  struct GraphEdge {
    MeshEdgeId edge;
    std::array<std::uint32_t, 2> nodes;
    double length;
  };
  using EdgePlace = Id<struct EdgePlaceTag>;
  using NodeId = Id<struct NodeTag>;

  static bool gets_seams(Seams seams, const PieceLoops& piece, std::uint32_t genus) {
    if (!piece.is_simple) return false;
    if (seams == Seams::Annulus) return genus == 0 && piece.loops.size() == 2;
    return genus > 0 || piece.loops.size() != 1;
  }

  [[nodiscard]] VertexId origin(HalfEdge h) const { return origin_of(mesh_, h); }

  [[nodiscard]] std::vector<PieceLoops> loops_of_pieces() const {
    std::vector<PieceLoops> result(pieces_.count);
    for (std::size_t b = 0; b < boundaries_.piece.size(); ++b) result[boundaries_.piece[b]].loops.emplace_back(b);
    for (const TouchedVertex& t : boundaries_.touched) result[t.piece].is_simple = false;
    std::vector<std::uint32_t> seen_by(mesh_.points.size(), none);
    for (std::uint32_t p = 0; p < result.size(); ++p) {
      for (const BoundaryId b : result[p].loops) {
        for (const HalfEdge h : boundaries_.half_edges.of(b)) {
          std::uint32_t& seen = seen_by[origin(h).index()];
          if (seen == p) result[p].is_simple = false;
          seen = p;
        }
      }
    }
    return result;
  }

  [[nodiscard]] Lists<PieceId, FaceId> faces_of(const std::vector<std::uint8_t>& is_cut) const {
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < pieces_.component_of.size(); ++f) {
      if (is_cut[pieces_.component_of[f]] != 0) faces.emplace_back(f);
    }
    return lists_of<PieceId, FaceId>(
        faces, pieces_.count, [&](FaceId f) { return PieceId(pieces_.component_of[f.index()]); }, [](FaceId f) { return f; });
  }

  void cut(std::span<const FaceId> faces, const std::vector<BoundaryId>& loops, std::uint32_t genus) {
    number_nodes(faces, loops);
    collect_edges(faces);
    const bool is_closed = loops.empty();
    grow_tree(is_closed ? poles().first : 0);
    is_seam_.assign(edges_.size(), 0);
    for (std::uint32_t loop = 1; loop < loops.size(); ++loop) mark_way_to_root(loop);
    if (genus > 0) {
      cut_handles(faces);
      drop_dead_ends();
    } else if (is_closed) {
      mark_way_to_root(poles().second);
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (is_seam_[i] != 0) found_.push_back(edges_[i].edge);
    }
    for (const FaceId f : faces) {
      for (const VertexId v : mesh_.triangles[f.index()]) node_of_[v.index()] = none;
    }
  }

  void number_nodes(std::span<const FaceId> faces, const std::vector<BoundaryId>& loops) {
    loop_count_ = static_cast<std::uint32_t>(loops.size());
    vertex_of_node_.assign(loops.size(), VertexId());
    for (std::uint32_t loop = 0; loop < loops.size(); ++loop) {
      for (const HalfEdge h : boundaries_.half_edges.of(loops[loop])) node_of_[origin(h).index()] = loop;
    }
    for (const FaceId f : faces) {
      for (const VertexId v : mesh_.triangles[f.index()]) {
        if (node_of_[v.index()] != none) continue;
        node_of_[v.index()] = static_cast<std::uint32_t>(vertex_of_node_.size());
        vertex_of_node_.push_back(v);
      }
    }
  }

  // Edges inside the piece. One that leaves a loop where there is no corner is longer than any way through the others.
  void collect_edges(std::span<const FaceId> faces) {
    edges_.clear();
    double total = 0;
    for (const FaceId f : faces) {
      for (HalfEdge h = 3 * f.value; h < 3 * f.value + 3; ++h) {
        const MeshEdgeId e = topology_.edge_of[h];
        const auto uses = topology_.uses_of(e);
        const bool is_inside = uses.size() == 2 && uses[0] == h && pieces_.component_of[face_of(uses[1]).index()] == piece_of(f);
        if (!is_inside) continue;  // loops are simple: with the piece on both sides an edge is on none of them
        const VertexId a = origin(h), b = origin(next_in_face(h));
        edges_.push_back({e, {node_of_[a.index()], node_of_[b.index()]}, length(mesh_.points[b.index()] - mesh_.points[a.index()])});
        total += edges_.back().length;
      }
    }
    for (GraphEdge& edge : edges_) {
      for (const VertexId v : topology_.edges[edge.edge.index()]) {
        if (node_of_[v.index()] < loop_count_ && is_corner_[v.index()] == 0) edge.length += total;
      }
    }
  }

  [[nodiscard]] std::uint32_t piece_of(FaceId f) const { return pieces_.component_of[f.index()]; }

  // Of a closed piece: the nodes of its lexicographically lowest and highest points.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> poles() const {
    const auto [low, high] = std::minmax_element(vertex_of_node_.begin(), vertex_of_node_.end(), [&](VertexId a, VertexId b) {
      const Vec3d &p = mesh_.points[a.index()], &q = mesh_.points[b.index()];
      return p == q ? a < b : is_lexicographically_less(p, q);
    });
    return {node_of_[low->index()], node_of_[high->index()]};
  }

  void grow_tree(std::uint32_t root) {
    const Lists<NodeId, EdgePlace> round = edges_round_nodes();
    distance_.assign(vertex_of_node_.size(), std::numeric_limits<double>::infinity());
    way_.assign(vertex_of_node_.size(), none);
    distance_[root] = 0;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> todo;
    todo.push({0, root});
    while (!todo.empty()) {
      const Step step = todo.top();
      todo.pop();
      if (step.distance > distance_[step.node]) continue;
      for (const EdgePlace place : round.of(NodeId(step.node))) {
        const GraphEdge& edge = edges_[place.index()];
        const std::uint32_t next = edge.nodes[0] == step.node ? edge.nodes[1] : edge.nodes[0];
        const double distance = step.distance + edge.length;
        if (distance >= distance_[next]) continue;
        distance_[next] = distance;
        way_[next] = place.value;
        todo.push({distance, next});
      }
    }
  }

  [[nodiscard]] Lists<NodeId, EdgePlace> edges_round_nodes() const {
    std::vector<std::pair<NodeId, EdgePlace>> ends;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (const std::uint32_t node : edges_[i].nodes) ends.emplace_back(NodeId(node), EdgePlace(i));
    }
    return lists_of<NodeId, EdgePlace>(
        ends, vertex_of_node_.size(), [](const auto& end) { return end.first; }, [](const auto& end) { return end.second; });
  }

  void mark_way_to_root(std::uint32_t node) {
    while (way_[node] != none) {
      const std::uint32_t place = way_[node];
      is_seam_[place] = 1;
      const auto& ends = edges_[place].nodes;
      node = ends[0] == node ? ends[1] : ends[0];
    }
  }

  // Triangles are joined over edges outside the tree, the farthest first; those that join nothing go round handles.
  void cut_handles(std::span<const FaceId> faces) {
    std::vector<std::uint8_t> is_in_tree(edges_.size(), 0);
    for (const std::uint32_t place : way_) {
      if (place != none) is_in_tree[place] = 1;
    }
    std::vector<std::pair<double, std::uint32_t>> others;
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const GraphEdge& edge = edges_[i];
      if (is_in_tree[i] == 0) others.emplace_back(-(distance_[edge.nodes[0]] + distance_[edge.nodes[1]] + edge.length), i);
    }
    std::sort(others.begin(), others.end());
    UnionFind joined(faces.size());
    const auto place_of = [&](HalfEdge h) {
      return static_cast<std::uint32_t>(std::lower_bound(faces.begin(), faces.end(), face_of(h)) - faces.begin());
    };
    for (const auto& [_, i] : others) {
      const auto uses = topology_.uses_of(edges_[i].edge);
      const std::uint32_t a = place_of(uses[0]), b = place_of(uses[1]);
      if (joined.find(a) != joined.find(b)) {
        joined.join(a, b);
        continue;
      }
      is_seam_[i] = 1;
      for (const std::uint32_t node : edges_[i].nodes) mark_way_to_root(node);
    }
  }

  // Ways to the root that all handles share lead nowhere in a closed piece.
  void drop_dead_ends() {
    const Lists<NodeId, EdgePlace> round = edges_round_nodes();
    const auto seams_at = [&](std::uint32_t node) {
      const auto here = round.of(NodeId(node));
      return std::count_if(here.begin(), here.end(), [&](EdgePlace i) { return is_seam_[i.index()] != 0; });
    };
    for (std::uint32_t node = loop_count_; node < vertex_of_node_.size(); ++node) {
      std::uint32_t end = node;
      while (end >= loop_count_ && seams_at(end) == 1) {
        const auto here = round.of(NodeId(end));
        const EdgePlace last = *std::find_if(here.begin(), here.end(), [&](EdgePlace i) { return is_seam_[i.index()] != 0; });
        is_seam_[last.index()] = 0;
        const auto& ends = edges_[last.index()].nodes;
        end = ends[0] == end ? ends[1] : ends[0];
      }
    }
  }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  const FaceComponents& pieces_;
  const FaceBoundaries& boundaries_;
  const std::vector<std::uint8_t>& is_corner_;
  std::vector<MeshEdgeId> found_;

  // Of the piece at hand. Nodes are its loops, then the vertices inside it.
  std::vector<std::uint32_t> node_of_;  // per mesh vertex
  std::vector<VertexId> vertex_of_node_;
  std::uint32_t loop_count_ = 0;
  std::vector<GraphEdge> edges_;
  std::vector<double> distance_;       // from the root
  std::vector<std::uint32_t> way_;     // per node: the edge towards the root
  std::vector<std::uint8_t> is_seam_;  // per edge
};

}  // namespace

std::vector<MeshEdgeId> find_seams(Seams seams, const SurfaceMesh& mesh, const MeshTopology& topology, const FaceComponents& pieces,
                                   const FaceBoundaries& boundaries, const std::vector<std::uint8_t>& is_corner,
                                   const std::vector<std::uint8_t>& may_open) {
  if (seams == Seams::None) return {};
  return SeamFinder(mesh, topology, pieces, boundaries, is_corner).find(seams, may_open);
}

}  // namespace mortise
