// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Model regions, faces, edges and vertices with what bounds what (paper 2.1, Fig. 4), and a mesh classified on them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mortise/base/ids.h"
#include "mortise/base/lists.h"

namespace mortise {

using ModelVertexId = Id<struct ModelVertexTag>;
using ModelEdgeId = Id<struct ModelEdgeTag>;
using ModelFaceId = Id<struct ModelFaceTag>;
using ModelRegionId = Id<struct ModelRegionTag>;
using LoopId = Id<struct LoopTag>;
using ShellId = Id<struct ShellTag>;

struct ModelEdge {
  ModelVertexId start, end;  ///< equal for a closed edge
  bool is_seam = false;      ///< made to open a face that has no natural boundary there; no crease
};

/// A model edge as part of a loop, the face on its left seen from in front of it.
struct EdgeUse {
  ModelEdgeId edge;
  bool is_reversed = false;
};

struct ModelLoop {
  ModelFaceId face;
  ModelVertexId start;  ///< where its first use starts; all there is of a loop that only touches a vertex
};

struct ModelFace {
  std::uint32_t genus = 0;                       ///< handles; 0 for pieces of a plane, a cylinder, a sphere
  ModelRegionId region_behind, region_in_front;  ///< equal for a sheet
};

/// One of the two sides of a face.
struct FaceSide {
  ModelFaceId face;
  bool is_front = false;
};

/// A face as a neighbour of an edge.
struct FaceUse {
  ModelFaceId face;
  bool is_reversed = false;  ///< as in the loop

  auto operator<=>(const FaceUse&) const = default;
};

/// The boundary representation: entities by number, and for each its neighbours one dimension down and up.
///
/// Region 0 is the space outside, which reaches to infinity. A shell is a connected set of sides of faces; a region has an outer
/// one, unless it is region 0, and one for each cavity and each sheet in it.
struct Brep {
  std::size_t vertex_count = 0;
  IdVector<ModelEdgeId, ModelEdge> edges;
  IdVector<ModelFaceId, ModelFace> faces;
  std::size_t region_count = 1;

  IdVector<LoopId, ModelLoop> loops;    ///< by face, ascending
  Lists<LoopId, EdgeUse> uses_of_loop;  ///< end to end
  Lists<ModelFaceId, LoopId> loops_of_face;
  IdVector<ShellId, ModelRegionId> region_of_shell;
  Lists<ShellId, FaceSide> sides_of_shell;
  Lists<ModelRegionId, ShellId> shells_of_region;
  Lists<ModelVertexId, ModelEdgeId> edges_of_vertex;  ///< ascending; a closed edge twice
  Lists<ModelEdgeId, FaceUse> faces_of_edge;          ///< a face as often as its loops use the edge; more than two are counterclockwise,
                                                      ///< looking against the edge, the lowest first
};

enum class EntityDimension : std::uint8_t { Vertex, Edge, Face, Region, None };

/// A model entity of any dimension, by its number among those of its dimension.
struct ModelEntity {
  EntityDimension dimension = EntityDimension::None;
  std::uint32_t id = 0;

  auto operator<=>(const ModelEntity&) const = default;
};

/// The ends of a mesh edge, the lower first.
[[nodiscard]] inline std::array<VertexId, 2> sorted_ends(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

/// What every entity of a mesh lies on. Only mesh edges on model edges are stored; all others lie on the face of their triangles.
struct Classification {
  IdVector<ModelVertexId, VertexId> mesh_vertex;  ///< per model vertex
  Lists<ModelEdgeId, VertexId> path;              ///< per model edge: mesh vertices from start to end
  std::vector<ModelFaceId> face_of_triangle;      ///< per triangle
  std::vector<ModelEntity> entity_of_vertex;      ///< per mesh vertex; None for one that no triangle uses
};

/// Several meshes of one model, before and after remeshing, have equal Breps, each with its own classification (Fig. 4).
struct ClassifiedBrep {
  Brep brep;
  Classification classification;
};

}  // namespace mortise
