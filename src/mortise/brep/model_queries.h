// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What one asks of a model: neighbours, parts of the mesh, measures, closest points.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"
#include "mortise/mesh/topology.h"

namespace mortise {

/// "face 3".
[[nodiscard]] std::string entity_name(const ModelEntity& entity);

/// How many entities of a dimension there are; region 0 is one.
[[nodiscard]] std::size_t entity_count(const Brep& brep, EntityDimension dimension);

/// The entities one dimension lower on the boundary of one, ascending: faces of a region, edges of a face, vertices of an edge.
/// @throws Error{InvalidArgument} when there is no such entity; so do all functions of this header
[[nodiscard]] std::vector<ModelEntity> entities_below(const Brep& brep, const ModelEntity& entity);
/// The entities one dimension higher that one is on the boundary of, ascending.
[[nodiscard]] std::vector<ModelEntity> entities_above(const Brep& brep, const ModelEntity& entity);

/// Per region: 1 for one that lies in front of every face that bounds it, as a cavity in a solid does. What walls of the mesh bound is no
/// void, and a sheet inside a region does not bound it.
[[nodiscard]] std::vector<std::uint8_t> find_voids(const SurfaceMesh& mesh, const ClassifiedBrep& model);

/// Per mesh edge: 1 where a model edge is that is no seam.
[[nodiscard]] std::vector<std::uint8_t> mark_model_edges(const MeshTopology& topology, const ClassifiedBrep& model);

/// A model with its mesh, and the triangles of every face. Refers to both.
struct ModelView {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  Lists<ModelFaceId, FaceId> triangles_of_face;  ///< ascending
};

[[nodiscard]] ModelView view_of(const SurfaceMesh& mesh, const ClassifiedBrep& model);

enum class Extent {
  Interior,  ///< what is classified on the entity itself
  Closure,   ///< that, and on its boundary
};

/// Entities of a mesh, ascending.
struct MeshEntities {
  std::vector<VertexId> vertices;
  std::vector<std::array<VertexId, 2>> edges;  ///< [0] < [1]
  std::vector<FaceId> triangles;
};

/// The part of the mesh on an entity. The inside of a region has none.
[[nodiscard]] MeshEntities mesh_on(const ModelView& view, const ModelEntity& entity, Extent extent);

/// The box round the mesh on an entity and its boundary; that of region 0 round all its faces.
[[nodiscard]] Box3 bounding_box(const ModelView& view, const ModelEntity& entity);

/// Length of an edge, area of a face, volume of a region without what lies in its cavities; 0 for a vertex, infinity for region 0.
[[nodiscard]] double measure(const ModelView& view, const ModelEntity& entity);

struct ClosestPoint {
  Vec3d point;
  double distance = 0;
  FaceId triangle;  ///< of a face or region; invalid for edges and vertices
};

/// The point of an entity that is closest to another, to a few units in the last place of its distance; of a region the closest of
/// its boundary. Where several are, the one of the lowest triangle or the first along the edge.
/// O(n) in the mesh on the entity.
[[nodiscard]] ClosestPoint closest_point(const ModelView& view, const ModelEntity& entity, const Vec3d& to);

/// The normal of the triangle of a face that is closest to a point; length 1, or zero when it has no area.
[[nodiscard]] Vec3d normal_near(const ModelView& view, ModelFaceId face, const Vec3d& to);

}  // namespace mortise
