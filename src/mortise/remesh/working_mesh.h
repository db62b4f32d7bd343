// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the passes of the remesher share: the mesh under change, the one it came from, the sizes wanted, and what changes are fit.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/remesh/edit_mesh.h"
#include "mortise/remesh/reference_surface.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

inline constexpr double coarse_before_front = 4;  ///< in units of the size: inside faces that the front will mesh anew

/// Every vertex on the entity it had, every new one put on one.
struct WorkingMesh {
  /// @param zone  per triangle: 1 when it may change; empty: all may
  WorkingMesh(const SurfaceMesh& given, const ClassifiedBrep& model, const FaceNormals& normals, const SizingProxy& sizing,
              const std::vector<std::uint8_t>& zone);

  EditMesh mesh;
  ReferenceSurface reference;
  const Brep& brep;
  const SizingProxy* proxy;
  std::vector<double> sizes;         ///< per vertex: the size wanted there
  std::vector<double> arcs;          ///< per vertex inside a model edge: the length from its start
  std::vector<std::uint32_t> nears;  ///< per vertex inside a face: a triangle of the reference close by

  ProgressCallback progress;  ///< called now and then while it changes
  double fraction = 0;        ///< of the whole call done
  std::uint32_t changes = 0;

  double coarseness = 1;  ///< edges are made this many times as long as the sizes say, in faces that are made coarse at all
  IdVector<ModelFaceId, std::uint8_t> stays_fine;  ///< per model face: 1 when it is not

  IdVector<ModelFaceId, std::uint8_t> awaits_front;  ///< per model face: 1 when it is to be meshed anew: till then it is coarse inside
  IdVector<ModelFaceId, std::uint8_t> is_done;       ///< per model face: 1 when only its vertices may still move

  std::vector<std::uint8_t> is_frozen;  ///< per triangle, at first of the given mesh: outside the zone; beyond its end none is
  std::vector<std::uint8_t> is_fixed;   ///< per vertex likewise: of a frozen triangle, or a tip

  [[nodiscard]] double coarseness_at_edges_of(ModelFaceId face) const { return stays_fine[face] != 0 ? 1 : coarseness; }
  [[nodiscard]] double coarseness_of(ModelFaceId face) const {
    return std::max(coarseness_at_edges_of(face), awaits_front[face] != 0 ? coarse_before_front : 1);
  }
  [[nodiscard]] double coarseness_beside(HalfEdge h) const { return coarseness_of(mesh.face(face_of(h))); }
  [[nodiscard]] bool may_change(FaceId t) const {
    return (t.index() >= is_frozen.size() || is_frozen[t.index()] == 0) && is_done[mesh.face(t)] == 0;
  }
  [[nodiscard]] bool may_move(VertexId v) const { return v.index() >= is_fixed.size() || is_fixed[v.index()] == 0; }
  [[nodiscard]] bool may_move_in_face(VertexId v) const { return mesh.is_inside_face(v) && may_move(v); }
};

/// To be called for every change: reports progress after some thousands.
/// @throws Error{Cancelled}
void count_change(WorkingMesh& w);

/// May all triangles of an edge change?
[[nodiscard]] bool may_split(const WorkingMesh& w, HalfEdge h);

/// Length of an edge in units of the size wanted along it (the integral of 1 / h for sizes that vary linearly, by Simpson's rule).
[[nodiscard]] double metric_length(const WorkingMesh& w, VertexId a, VertexId b);
[[nodiscard]] inline double metric_length(const WorkingMesh& w, HalfEdge h) { return metric_length(w, w.mesh.origin(h), w.mesh.target(h)); }

/// One of the half-edges of every mesh edge, always the same: the lowest.
[[nodiscard]] bool stands_for_edge(const EditMesh& mesh, HalfEdge h);

/// Splits an edge inside a face at the place of the face closest to its middle, or at the middle where a triangle would turn over.
VertexId split_at_middle(WorkingMesh& w, HalfEdge h);
/// Splits an edge on a model edge at this length along it.
VertexId split_at_arc(WorkingMesh& w, HalfEdge h, double arc);

/// Takes in a vertex that is new in the mesh: its size, and where it lies.
/// @param arc, near  as in WorkingMesh
void add_values(WorkingMesh& w, VertexId v, double arc, std::uint32_t near);

/// Could the diagonal of the other two corners take the place of an edge inside a face: no fold, no stray from the surface, no such edge
/// elsewhere?
[[nodiscard]] bool is_swap_fit(const WorkingMesh& w, HalfEdge h);
/// Would that lower the largest angle (Fig. 21)?
[[nodiscard]] bool swap_lowers_angle(const WorkingMesh& w, HalfEdge h);

/// Could an end of an edge go to the other with no triangle turned over or worse than they were, and no edge longer than this?
[[nodiscard]] bool is_collapse_fit(const WorkingMesh& w, HalfEdge h, VertexId gone, double longest);

/// The point of a face a vertex inside it goes to when it is moved to a point beside.
[[nodiscard]] SurfacePlace place_on_face(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double size);
/// Is a point of what would be the surface further from its face than a coarse mesh may be?
[[nodiscard]] bool strays(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double size);
/// The triangle of the reference below a point beside a face.
[[nodiscard]] std::uint32_t triangle_below(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double size);
/// Moves a vertex inside a face.
void move_vertex(WorkingMesh& w, VertexId v, const SurfacePlace& place);

}  // namespace mortise
