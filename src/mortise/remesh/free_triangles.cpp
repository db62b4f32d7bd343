// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/free_triangles.h"

#include <algorithm>
#include <array>
#include <span>

#include "mortise/base/sort_unique.h"
#include "mortise/base/union_find.h"
#include "mortise/brep/face_features.h"
#include "mortise/brep/model_queries.h"
#include "mortise/geom/box_tree.h"
#include "mortise/geom/length.h"
#include "mortise/geom/placed_triangle.h"
#include "mortise/mesh/measures.h"

namespace mortise {
namespace {

constexpr double shortest_edge = 0.7;   // of the size
constexpr double pieces_of_closed = 3;  // no closed model edge has fewer mesh edges
constexpr double sharpest_deg = 60 - 1e-9;
constexpr double way_over_gap = 2 + 1e-6;  // where two lines meet at 60 degrees, the way along them is twice the gap

/// A place on a feature, or a straight piece of one.
struct Obstacle {
  Vec3d from, to;
};

struct Search {
  const SurfaceMesh& mesh;
  const MeshTopology& topology;
  const ClassifiedBrep& model;
  const std::vector<double>& sizes;
  std::vector<std::uint8_t> is_feature;  // per mesh edge
  std::vector<Obstacle> obstacles;

  [[nodiscard]] const Vec3d& at(VertexId v) const { return mesh.points[v.index()]; }
  [[nodiscard]] double size(VertexId v) const { return sizes[v.index()]; }
};

Box3 box_round(const Vec3d& a, const Vec3d& b) {
  Box3 box;
  box.extend(a);
  box.extend(b);
  return box;
}

Box3 grown(const Vec3d& p, double by) { return {p - Vec3d{by, by, by}, p + Vec3d{by, by, by}}; }

Vec3d closest_on(const Obstacle& o, const Vec3d& p) {
  const PlacedTriangle placed = place_triangle({o.from, o.to, o.to}, o.from == o.to ? 1 : 2);
  return in_space(placed, closest_in(placed, p).at);
}

void add_path(Search& s, ModelEdgeId edge) {
  const std::span<const VertexId> path = s.model.classification.path.of(edge);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) s.obstacles.push_back({s.at(path[k]), s.at(path[k + 1])});
}

bool is_short(const Search& s, ModelEdgeId edge) {
  const std::span<const VertexId> path = s.model.classification.path.of(edge);
  double metric = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    metric += length(s.at(path[k + 1]) - s.at(path[k])) / ((s.size(path[k]) + s.size(path[k + 1])) / 2);
  const ModelEdge& ends = s.model.brep.edges[edge];
  return metric < shortest_edge * (ends.start == ends.end ? pieces_of_closed : 1);
}

void add_edges(Search& s, const std::vector<std::uint8_t>& frozen, Obstacles& count) {
  for (std::size_t e = 0; e < s.model.brep.edges.size(); ++e) {
    const ModelEdgeId edge(e);
    const bool is_frozen = !frozen.empty() && frozen[e] != 0;
    if (s.model.brep.edges[edge].is_seam || (!is_frozen && !is_short(s, edge))) continue;
    ++(is_frozen ? count.frozen_edges : count.short_edges);
    add_path(s, edge);
  }
}

// The half-edges that leave each model vertex; in their triangles the ones before them arrive there.
Lists<ModelVertexId, HalfEdge> corners_at_model_vertices(const Search& s) {
  const auto entity_at = [&](HalfEdge h) { return s.model.classification.entity_of_vertex[origin_of(s.mesh, h).index()]; };
  std::vector<HalfEdge> leaving;
  for (HalfEdge h = 0; h < 3 * s.mesh.triangles.size(); ++h) {
    if (entity_at(h).dimension == EntityDimension::Vertex) leaving.push_back(h);
  }
  return lists_of<ModelVertexId, HalfEdge>(
      leaving, s.model.brep.vertex_count, [&](HalfEdge h) { return ModelVertexId(entity_at(h).id); }, [](HalfEdge h) { return h; });
}

// The corners of one vertex in sectors: neighbours across edges that are no features belong together.
UnionFind sectors_of(const Search& s, std::span<const HalfEdge> corners) {
  std::vector<std::uint64_t> sides;  // edge, then corner
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    for (const HalfEdge h : {corners[i], next_in_face(next_in_face(corners[i]))}) {
      const MeshEdgeId e = s.topology.edge_of[h];
      if (e.is_valid() && s.is_feature[e.index()] == 0) sides.push_back(std::uint64_t{e.value} << 32 | i);
    }
  }
  std::sort(sides.begin(), sides.end());
  UnionFind sectors(corners.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i - 1] >> 32 == sides[i] >> 32) sectors.join(static_cast<std::uint32_t>(sides[i - 1]), static_cast<std::uint32_t>(sides[i]));
  }
  return sectors;
}

std::size_t count_sharp(const Search& s, std::span<const HalfEdge> corners) {
  UnionFind sectors = sectors_of(s, corners);
  std::vector<double> sum(corners.size(), 0);
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const Triangle& t = s.mesh.triangles[corners[i] / 3];
    sum[sectors.find(i)] += triangle_angles_deg(s.at(t[0]), s.at(t[1]), s.at(t[2]))[corners[i] % 3];
  }
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < corners.size(); ++i) count += sectors.find(i) == i && sum[i] < sharpest_deg ? 1 : 0;
  return count;
}

void add_sharp_corners(Search& s, Obstacles& count) {
  const Lists<ModelVertexId, HalfEdge> corners = corners_at_model_vertices(s);
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const std::size_t sharp = count_sharp(s, corners.of(ModelVertexId(v)));
    if (sharp == 0) continue;
    const Vec3d& at = s.at(s.model.classification.mesh_vertex[ModelVertexId(v)]);
    s.obstacles.push_back({at, at});
    count.sharp_corners += sharp;
  }
}

// Is another part of the features near? Then both places are obstacles.
bool add_close_parts(Search& s, FaceFeatures& features, const FeaturePlace& place, double size) {
  bool is_any = false;
  for (const ClosePart& part : features.parts_close_to(place, size, way_over_gap * size)) {
    if (part.way <= way_over_gap * part.gap) continue;
    s.obstacles.push_back({part.at, part.at});
    is_any = true;
  }
  if (is_any) s.obstacles.push_back({place.at, place.at});
  return is_any;
}

std::size_t add_close_features(Search& s, FaceFeatures& f) {
  std::size_t count = 0;
  for (const VertexId v : f.vertices()) count += add_close_parts(s, f, f.at_vertex(v), s.size(v)) ? 1 : 0;
  for (std::uint32_t i = 0; i < f.pieces().size(); ++i) {
    const auto& [a, b] = f.pieces()[i];
    count += add_close_parts(s, f, f.on_piece(i, 0.5), (s.size(a) + s.size(b)) / 2) ? 1 : 0;
  }
  return count;
}

void add_close_features(Search& s, Obstacles& count) {
  for (const std::vector<ModelEdgeId>& edges : edges_of_faces(s.model)) {
    FaceFeatures features(s.mesh, s.model, edges);
    count.close_features += add_close_features(s, features);
  }
}

std::vector<std::uint8_t> find_free(const Search& s) {
  std::vector<Box3> boxes;
  for (const Obstacle& o : s.obstacles) boxes.push_back(box_round(o.from, o.to));
  const BoxTree tree(boxes);
  std::vector<std::uint8_t> is_near(s.mesh.points.size(), 0), is_free;
  for (std::size_t v = 0; v < is_near.size(); ++v) {
    const Vec3d& p = s.mesh.points[v];
    tree.for_each_meeting(grown(p, s.sizes[v]), [&](std::uint32_t i) {
      if (is_near[v] == 0 && length(closest_on(s.obstacles[i], p) - p) <= s.sizes[v]) is_near[v] = 1;
    });
  }
  for (const Triangle& t : s.mesh.triangles)
    is_free.push_back(std::any_of(t.begin(), t.end(), [&](VertexId v) { return is_near[v.index()] != 0; }) ? 0 : 1);
  return is_free;
}

}  // namespace

FreeTriangles find_free_triangles(const SurfaceMesh& mesh, const MeshTopology& topology, const ClassifiedBrep& model,
                                  const std::vector<double>& sizes, const std::vector<std::uint8_t>& frozen_edges) {
  Search search{mesh, topology, model, sizes, mark_model_edges(topology, model), {}};
  FreeTriangles result;
  add_edges(search, frozen_edges, result.obstacles);
  add_sharp_corners(search, result.obstacles);
  add_close_features(search, result.obstacles);
  result.is_free = find_free(search);
  return result;
}

}  // namespace mortise
