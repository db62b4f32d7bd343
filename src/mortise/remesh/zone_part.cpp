// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/zone_part.h"

#include <algorithm>
#include <utility>

#include "mortise/mesh/select_faces.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

using Marks = std::vector<std::uint8_t>;

// Of the corners of triangles that are marked.
Marks mark_corners(const SurfaceMesh& mesh, const Marks& is_marked) {
  Marks marks(mesh.points.size(), 0);
  for (std::size_t t = 0; t < is_marked.size(); ++t) {
    if (is_marked[t] == 0) continue;
    for (const VertexId v : mesh.triangles[t]) marks[v.index()] = 1;
  }
  return marks;
}

// Copies triangles that touch the zone, and their vertices.
void copy_mesh(const SurfaceMesh& mesh, const FaceNormals& normals, const Marks& zone, ZonePart& part) {
  const Marks is_touched = mark_corners(mesh, zone);
  std::vector<FaceId> touching;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return is_touched[v.index()] != 0; })) continue;
    touching.emplace_back(t);
    part.zone.push_back(std::uint8_t{zone[t]});
    part.normals.normals.push_back(normals.normals[t]);
    if (!normals.planes.empty()) part.normals.planes.push_back(std::uint32_t{normals.planes[t]});
  }
  MeshPart selected = select_faces(mesh, touching);
  part.mesh = std::move(selected.mesh);
  part.triangles = std::move(selected.source_face);
  part.vertices = std::move(selected.source_vertex);
}

VertexId number_in(const ZonePart& part, VertexId v) {
  const auto at = std::lower_bound(part.vertices.begin(), part.vertices.end(), v);
  return at != part.vertices.end() && *at == v ? VertexId(static_cast<std::size_t>(at - part.vertices.begin())) : VertexId();
}

// Mesh edges of model edges that the part has, as far as they follow each other.
void find_pieces(const ClassifiedBrep& model, ZonePart& part) {
  const MeshTopology topology = build_topology(part.mesh);
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    bool is_open = false;
    ModelEdgeId last;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      const VertexId a = number_in(part, path[k]), b = a.is_valid() ? number_in(part, path[k + 1]) : VertexId();
      const bool is_there = b.is_valid() && find_edge(topology, a, b).is_valid();
      if (is_there && !is_open) last = part.pieces.push_back({ModelEdgeId(e), k, k});
      if (is_there) part.pieces[last].last = k + 1;
      is_open = is_there;
    }
  }
}

// Gives every vertex its entity in the part: model vertices are those of the whole, the ends of pieces, and what touches the part from an
// edge.
class PartClassifier {
 public:
  PartClassifier(const ClassifiedBrep& whole, ZonePart& part) : whole_(whole), part_(part), on_(part.model.classification) {}

  void run() {
    part_.model.brep.faces = whole_.brep.faces;
    for (const FaceId t : part_.triangles) on_.face_of_triangle.push_back(whole_.classification.face_of_triangle[t.index()]);
    for (const VertexId v : part_.vertices) {
      const ModelEntity& entity = whole_.classification.entity_of_vertex[v.index()];
      on_.entity_of_vertex.push_back(entity.dimension == EntityDimension::Face ? entity : ModelEntity{});
    }
    for (const PathPiece& piece : part_.pieces) add_piece(piece);
    for (std::size_t v = 0; v < part_.vertices.size(); ++v) {
      if (on_.entity_of_vertex[v].dimension == EntityDimension::None) vertex_at(VertexId(v));
    }
    part_.model.brep.vertex_count = on_.mesh_vertex.size();
  }

 private:
  void add_piece(const PathPiece& piece) {
    const std::span<const VertexId> path = whole_.classification.path.of(piece.edge);
    const auto id = static_cast<std::uint32_t>(part_.model.brep.edges.size());
    for (std::size_t k = piece.first; k <= piece.last; ++k) {
      const VertexId v = number_in(part_, path[k]);
      on_.path.items.push_back(v);
      if (k > piece.first && k < piece.last) on_.entity_of_vertex[v.index()] = {EntityDimension::Edge, id};
    }
    on_.path.close();
    const ModelVertexId start = vertex_at(number_in(part_, path[piece.first])), end = vertex_at(number_in(part_, path[piece.last]));
    part_.model.brep.edges.push_back({start, end, whole_.brep.edges[piece.edge].is_seam});
  }

  ModelVertexId vertex_at(VertexId v) {
    ModelEntity& entity = on_.entity_of_vertex[v.index()];
    if (entity.dimension != EntityDimension::Vertex) {
      entity = {EntityDimension::Vertex, static_cast<std::uint32_t>(on_.mesh_vertex.size())};
      on_.mesh_vertex.push_back(v);
    }
    return ModelVertexId(entity.id);
  }

  const ClassifiedBrep& whole_;
  ZonePart& part_;
  Classification& on_;
};

// What is not of the part, and where its vertices are in the whole.
struct Outside {
  std::vector<FaceId> triangles;
  std::vector<VertexId> new_vertex;  // per vertex of the whole
  std::size_t vertex_count = 0;      // that are not of the part
};

Outside find_outside(const ZonePart& part, const ChangedPart& changed, const SurfaceMesh& mesh) {
  Outside outside;
  outside.new_vertex.resize(mesh.points.size());
  std::size_t next = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (next < part.triangles.size() && part.triangles[next].index() == t) {
      ++next;
      continue;
    }
    outside.triangles.emplace_back(t);
    for (const VertexId v : mesh.triangles[t]) outside.new_vertex[v.index()] = VertexId(0);
  }
  for (const VertexId v : part.vertices) outside.new_vertex[v.index()] = VertexId();
  for (VertexId& v : outside.new_vertex) {
    if (v.is_valid()) v = VertexId(outside.vertex_count++);
  }
  for (std::size_t v = 0; v < part.vertices.size(); ++v) {
    const VertexId now = changed.new_vertex[v];
    if (now.is_valid()) outside.new_vertex[part.vertices[v].index()] = VertexId(outside.vertex_count + now.index());
  }
  return outside;
}

// The entity of the whole that is the one of the part.
ModelEntity entity_in_whole(const ZonePart& part, const ClassifiedBrep& model, const ModelEntity& entity) {
  if (entity.dimension == EntityDimension::Edge) return {EntityDimension::Edge, part.pieces[ModelEdgeId(entity.id)].edge.value};
  if (entity.dimension != EntityDimension::Vertex) return entity;
  const VertexId v = part.model.classification.mesh_vertex[ModelVertexId(entity.id)];
  return model.classification.entity_of_vertex[part.vertices[v.index()].index()];
}

// Paths with the pieces as they are now.
Lists<ModelEdgeId, VertexId> paths_with_pieces(const ZonePart& part, const ChangedPart& changed, const Outside& outside,
                                               const ClassifiedBrep& model) {
  Lists<ModelEdgeId, VertexId> paths;
  std::size_t next = 0;
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 0; k < path.size(); ++k) {
      const bool starts_piece =
          next < part.pieces.size() && part.pieces[ModelEdgeId(next)].edge.index() == e && part.pieces[ModelEdgeId(next)].first == k;
      if (!starts_piece) {
        paths.items.push_back(outside.new_vertex[path[k].index()]);
        continue;
      }
      for (const VertexId v : changed.classification.path.of(ModelEdgeId(next))) paths.items.emplace_back(outside.vertex_count + v.index());
      k = part.pieces[ModelEdgeId(next++)].last;
    }
    paths.close();
  }
  return paths;
}

}  // namespace

ZonePart cut_out(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals, const std::vector<std::uint8_t>& zone) {
  ZonePart part;
  copy_mesh(mesh, normals, zone, part);
  find_pieces(model, part);
  PartClassifier(model, part).run();
  return part;
}

PutBack put_back(const ZonePart& part, const ChangedPart& changed, const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  Outside outside = find_outside(part, changed, mesh);
  PutBack whole;
  Classification& on = whole.classification;
  whole.mesh.points.resize(outside.vertex_count);
  on.entity_of_vertex.resize(outside.vertex_count);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const VertexId now = outside.new_vertex[v];
    if (!now.is_valid() || now.index() >= outside.vertex_count) continue;
    whole.mesh.points[now.index()] = mesh.points[v];
    on.entity_of_vertex[now.index()] = model.classification.entity_of_vertex[v];
  }
  whole.mesh.points.insert(whole.mesh.points.end(), changed.mesh.points.begin(), changed.mesh.points.end());
  for (const ModelEntity& entity : changed.classification.entity_of_vertex)
    on.entity_of_vertex.push_back(entity_in_whole(part, model, entity));
  whole.mesh.triangles.reserve(outside.triangles.size() + changed.mesh.triangles.size());
  on.face_of_triangle.reserve(outside.triangles.size() + changed.mesh.triangles.size());
  for (const FaceId t : outside.triangles) {
    const auto& [a, b, c] = mesh.triangles[t.index()];
    whole.mesh.triangles.push_back({outside.new_vertex[a.index()], outside.new_vertex[b.index()], outside.new_vertex[c.index()]});
    on.face_of_triangle.push_back(model.classification.face_of_triangle[t.index()]);
  }
  const auto shifted = [&](VertexId v) { return VertexId(outside.vertex_count + v.index()); };
  for (const auto& [a, b, c] : changed.mesh.triangles) whole.mesh.triangles.push_back({shifted(a), shifted(b), shifted(c)});
  const std::vector<ModelFaceId>& faces = changed.classification.face_of_triangle;
  on.face_of_triangle.insert(on.face_of_triangle.end(), faces.begin(), faces.end());
  for (const VertexId v : model.classification.mesh_vertex) on.mesh_vertex.push_back(v.is_valid() ? outside.new_vertex[v.index()] : v);
  on.path = paths_with_pieces(part, changed, outside, model);
  whole.outside = std::move(outside.triangles);
  return whole;
}

}  // namespace mortise
