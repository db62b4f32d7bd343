// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Tables read in both directions; measures of pieces of the mesh.
#include "mortise/brep/model_queries.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "mortise/base/error.h"
#include "mortise/base/sort_unique.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"

namespace mortise {
namespace {

void require(const Brep& brep, const ModelEntity& entity) {
  if (entity.dimension < EntityDimension::None && entity.id < entity_count(brep, entity.dimension)) return;
  throw Error(ErrorCode::InvalidArgument, "model", "the model has no " + entity_name(entity));
}

// Edges of a face, as often as its loops use them.
template <class Visit>
void for_each_use(const Brep& brep, ModelFaceId face, Visit visit) {
  for (const LoopId l : brep.loops_of_face.of(face)) {
    for (const EdgeUse& use : brep.uses_of_loop.of(l)) visit(use);
  }
}

template <class Visit>
void for_each_side(const Brep& brep, ModelRegionId region, Visit visit) {
  for (const ShellId s : brep.shells_of_region.of(region)) {
    for (const FaceSide& side : brep.sides_of_shell.of(s)) visit(side);
  }
}

// Adds the mesh on entities, the lower ones first; duplicates go at the end.
class MeshCollector {
 public:
  explicit MeshCollector(const ModelView& view) : view_(view), brep_(view.model.brep), on_(view.model.classification) {}

  [[nodiscard]] MeshEntities collect(const ModelEntity& entity, Extent extent) {
    if (extent == Extent::Closure) add_boundary(entity);
    if (entity.dimension == EntityDimension::Vertex) found_.vertices.push_back(on_.mesh_vertex[ModelVertexId(entity.id)]);
    if (entity.dimension == EntityDimension::Edge) add_edge(ModelEdgeId(entity.id));
    if (entity.dimension == EntityDimension::Face) add_face(ModelFaceId(entity.id));
    sort_unique(found_.vertices);
    sort_unique(found_.edges);
    sort_unique(found_.triangles);
    return std::move(found_);
  }

 private:
  void add_boundary(const ModelEntity& entity) {
    if (entity.dimension == EntityDimension::Edge) add_ends(ModelEdgeId(entity.id));
    if (entity.dimension == EntityDimension::Face) add_loops(ModelFaceId(entity.id));
    if (entity.dimension != EntityDimension::Region) return;
    for_each_side(brep_, ModelRegionId(entity.id), [&](const FaceSide& side) {
      add_loops(side.face);
      add_face(side.face);
    });
  }

  void add_ends(ModelEdgeId e) {
    const auto path = on_.path.of(e);
    found_.vertices.push_back(path.front());
    found_.vertices.push_back(path.back());
  }

  void add_edge(ModelEdgeId e) {
    const auto path = on_.path.of(e);
    found_.vertices.insert(found_.vertices.end(), path.begin() + 1, path.end() - 1);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) found_.edges.push_back(sorted_ends(path[i], path[i + 1]));
  }

  void add_loops(ModelFaceId f) {
    for (const LoopId l : brep_.loops_of_face.of(f)) found_.vertices.push_back(on_.mesh_vertex[brep_.loops[l].start]);
    for_each_use(brep_, f, [&](const EdgeUse& use) {
      add_ends(use.edge);
      add_edge(use.edge);
    });
  }

  void add_face(ModelFaceId f) {
    const std::vector<std::array<VertexId, 2>> boundary = boundary_edges(f);
    for (const FaceId t : view_.triangles_of_face.of(f)) {
      found_.triangles.push_back(t);
      const Triangle& corners = view_.mesh.triangles[t.index()];
      for (std::size_t k = 0; k < 3; ++k) {
        if (on_.entity_of_vertex[corners[k].index()] == ModelEntity{EntityDimension::Face, f.value}) found_.vertices.push_back(corners[k]);
        const std::array<VertexId, 2> edge = sorted_ends(corners[k], corners[(k + 1) % 3]);
        if (!std::binary_search(boundary.begin(), boundary.end(), edge)) found_.edges.push_back(edge);
      }
    }
  }

  [[nodiscard]] std::vector<std::array<VertexId, 2>> boundary_edges(ModelFaceId f) const {
    std::vector<std::array<VertexId, 2>> edges;
    for_each_use(brep_, f, [&](const EdgeUse& use) {
      const auto path = on_.path.of(use.edge);
      for (std::size_t i = 0; i + 1 < path.size(); ++i) edges.push_back(sorted_ends(path[i], path[i + 1]));
    });
    sort_unique(edges);
    return edges;
  }

  const ModelView& view_;
  const Brep& brep_;
  const Classification& on_;
  MeshEntities found_;
};

SurfaceMesh surface_of(const ModelView& view, std::span<const FaceId> triangles) {
  SurfaceMesh surface;
  for (const FaceId t : triangles) {
    const std::size_t first = surface.points.size();
    for (const VertexId v : view.mesh.triangles[t.index()]) surface.points.push_back(view.mesh.points[v.index()]);
    surface.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  }
  return surface;
}

double length_of(const ModelView& view, ModelEdgeId e) {
  const auto path = view.model.classification.path.of(e);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    sum += length(view.mesh.points[path[i + 1].index()] - view.mesh.points[path[i].index()]);
  }
  return sum;
}

// The boundary of a region, looking out; sheets inside it have no part in its volume.
double volume_of(const ModelView& view, ModelRegionId region) {
  SurfaceMesh boundary;
  for_each_side(view.model.brep, region, [&](const FaceSide& side) {
    const ModelFace& face = view.model.brep.faces[side.face];
    if (face.region_behind == face.region_in_front) return;
    const SurfaceMesh part = surface_of(view, view.triangles_of_face.of(side.face));
    const std::size_t first = boundary.points.size();
    boundary.points.insert(boundary.points.end(), part.points.begin(), part.points.end());
    for (Triangle t : part.triangles) {
      for (VertexId& v : t) v = VertexId(first + v.index());
      if (side.is_front) std::swap(t[1], t[2]);
      boundary.triangles.push_back(t);
    }
  });
  return enclosed_volume(boundary);
}

Vec3d closest_on_segment(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const Vec3d along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? dot(p - a, along) / square : 0;
  return t <= 0 ? a : t >= 1 ? b : a + t * along;
}

// Straight below where barycentric coordinates say so, else on the closest side.
Vec3d closest_on_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
  const Vec3d ab = b - a, ac = c - a, normal = cross(ab, ac);
  const double square = dot(normal, normal);
  if (square > 0) {
    const double v = dot(cross(p - a, ac), normal) / square, w = dot(cross(ab, p - a), normal) / square;
    if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
  }
  Vec3d best = closest_on_segment(a, b, p);
  for (const Vec3d& q : {closest_on_segment(b, c, p), closest_on_segment(c, a, p)}) {
    if (length(q - p) < length(best - p)) best = q;
  }
  return best;
}

void take_if_closer(const Vec3d& point, const Vec3d& to, FaceId triangle, ClosestPoint& closest) {
  const double distance = length(point - to);
  if (distance < closest.distance) closest = {point, distance, triangle};
}

}  // namespace

std::string entity_name(const ModelEntity& entity) {
  static constexpr std::array<const char*, 5> names{"vertex", "edge", "face", "region", "entity of no dimension"};
  return std::string(names[static_cast<std::size_t>(entity.dimension)]) + " " + std::to_string(entity.id);
}

std::size_t entity_count(const Brep& brep, EntityDimension dimension) {
  switch (dimension) {
    case EntityDimension::Vertex:
      return brep.vertex_count;
    case EntityDimension::Edge:
      return brep.edges.size();
    case EntityDimension::Face:
      return brep.faces.size();
    case EntityDimension::Region:
      return brep.region_count;
    default:
      return 0;
  }
}

std::vector<ModelEntity> entities_below(const Brep& brep, const ModelEntity& entity) {
  require(brep, entity);
  std::vector<ModelEntity> below;
  if (entity.dimension == EntityDimension::Edge) {
    const ModelEdge& edge = brep.edges[ModelEdgeId(entity.id)];
    for (const ModelVertexId v : {edge.start, edge.end}) below.push_back({EntityDimension::Vertex, v.value});
  }
  if (entity.dimension == EntityDimension::Face)
    for_each_use(brep, ModelFaceId(entity.id), [&](const EdgeUse& use) { below.push_back({EntityDimension::Edge, use.edge.value}); });
  if (entity.dimension == EntityDimension::Region)
    for_each_side(brep, ModelRegionId(entity.id), [&](const FaceSide& side) { below.push_back({EntityDimension::Face, side.face.value}); });
  sort_unique(below);
  return below;
}

std::vector<ModelEntity> entities_above(const Brep& brep, const ModelEntity& entity) {
  require(brep, entity);
  std::vector<ModelEntity> above;
  if (entity.dimension == EntityDimension::Vertex) {
    for (const ModelEdgeId e : brep.edges_of_vertex.of(ModelVertexId(entity.id))) above.push_back({EntityDimension::Edge, e.value});
  }
  if (entity.dimension == EntityDimension::Edge) {
    for (const FaceUse& use : brep.faces_of_edge.of(ModelEdgeId(entity.id))) above.push_back({EntityDimension::Face, use.face.value});
  }
  if (entity.dimension == EntityDimension::Face) {
    const ModelFace& face = brep.faces[ModelFaceId(entity.id)];
    for (const ModelRegionId r : {face.region_behind, face.region_in_front}) above.push_back({EntityDimension::Region, r.value});
  }
  sort_unique(above);
  return above;
}

std::vector<std::uint8_t> find_voids(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  const Brep& brep = model.brep;
  std::vector<std::uint8_t> is_void(brep.region_count, 0);
  for (const ModelFace& face : brep.faces) is_void[face.region_in_front.index()] = 1;
  is_void[0] = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const ModelFace& face = brep.faces[model.classification.face_of_triangle[t]];
    if (face.region_behind == face.region_in_front) continue;
    is_void[face.region_behind.index()] = 0;
    if (!mesh.walls.empty() && mesh.walls[t] != 0) is_void[face.region_in_front.index()] = 0;
  }
  return is_void;
}

std::vector<std::uint8_t> mark_model_edges(const MeshTopology& topology, const ClassifiedBrep& model) {
  std::vector<std::uint8_t> is_marked(topology.edges.size(), 0);
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    if (model.brep.edges[ModelEdgeId(e)].is_seam) continue;
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 0; k + 1 < path.size(); ++k) is_marked[find_edge(topology, path[k], path[k + 1]).index()] = 1;
  }
  return is_marked;
}

ModelView view_of(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  const std::vector<ModelFaceId>& face_of = model.classification.face_of_triangle;
  std::vector<FaceId> triangles;
  for (std::size_t t = 0; t < face_of.size(); ++t) triangles.emplace_back(t);
  return {mesh, model,
          lists_of<ModelFaceId, FaceId>(
              triangles, model.brep.faces.size(), [&](FaceId t) { return face_of[t.index()]; }, [](FaceId t) { return t; })};
}

MeshEntities mesh_on(const ModelView& view, const ModelEntity& entity, Extent extent) {
  require(view.model.brep, entity);
  return MeshCollector(view).collect(entity, extent);
}

Box3 bounding_box(const ModelView& view, const ModelEntity& entity) {
  Box3 box;
  for (const VertexId v : mesh_on(view, entity, Extent::Closure).vertices) box.extend(view.mesh.points[v.index()]);
  return box;
}

double measure(const ModelView& view, const ModelEntity& entity) {
  require(view.model.brep, entity);
  switch (entity.dimension) {
    case EntityDimension::Edge:
      return length_of(view, ModelEdgeId(entity.id));
    case EntityDimension::Face:
      return surface_area(surface_of(view, view.triangles_of_face.of(ModelFaceId(entity.id))));
    case EntityDimension::Region:
      return entity.id == 0 ? std::numeric_limits<double>::infinity() : volume_of(view, ModelRegionId(entity.id));
    default:
      return 0;
  }
}

ClosestPoint closest_point(const ModelView& view, const ModelEntity& entity, const Vec3d& to) {
  const MeshEntities on = mesh_on(view, entity, Extent::Closure);
  const auto position = [&](VertexId v) { return view.mesh.points[v.index()]; };
  ClosestPoint closest{{}, std::numeric_limits<double>::infinity(), {}};
  if (entity.dimension == EntityDimension::Vertex) take_if_closer(position(on.vertices.front()), to, {}, closest);
  if (entity.dimension == EntityDimension::Edge) {
    const auto path = view.model.classification.path.of(ModelEdgeId(entity.id));
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      take_if_closer(closest_on_segment(position(path[i]), position(path[i + 1]), to), to, {}, closest);
    }
  }
  for (const FaceId t : on.triangles) {
    const Triangle& corners = view.mesh.triangles[t.index()];
    take_if_closer(closest_on_triangle(position(corners[0]), position(corners[1]), position(corners[2]), to), to, t, closest);
  }
  return closest;
}

Vec3d normal_near(const ModelView& view, ModelFaceId face, const Vec3d& to) {
  const ClosestPoint closest = closest_point(view, {EntityDimension::Face, face.value}, to);
  const Triangle& t = view.mesh.triangles[closest.triangle.index()];
  const Vec3d a = view.mesh.points[t[0].index()], b = view.mesh.points[t[1].index()], c = view.mesh.points[t[2].index()];
  const Vec3d normal = cross(b - a, c - a);
  const double size = length(normal);
  return size > 0 ? (1 / size) * normal : normal;
}

}  // namespace mortise
