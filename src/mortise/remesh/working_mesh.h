// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the passes of the remesher share: the mesh under change, the one it came from, the sizes wanted, and what changes are fit.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/remesh/edit_mesh.h"
#include "mortise/remesh/reference_surface.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

/// Every vertex on the entity it had, every new one put on one.
struct WorkingMesh {
  /// @param zone  per triangle: 1 when it may change; empty: all may
  WorkingMesh(const SurfaceMesh& given, const ClassifiedBrep& model, const FaceNormals& normals, const SizingProxy& sizing,
              const std::vector<std::uint8_t>& zone);

  EditMesh mesh;
  ReferenceSurface reference;
  const Brep& brep;
  const SizingProxy& proxy;
  std::vector<double> sizes;  ///< per vertex: the size wanted there
  std::vector<double> arcs;   ///< per vertex inside a model edge: the length from its start

  std::vector<std::uint8_t> is_frozen;  ///< per triangle of the given mesh: outside the zone; no new one ever is
  std::vector<std::uint8_t> is_fixed;   ///< per vertex of the given mesh: of a frozen triangle

  [[nodiscard]] bool may_change(FaceId t) const { return t.index() >= is_frozen.size() || is_frozen[t.index()] == 0; }
  [[nodiscard]] bool may_move(VertexId v) const { return v.index() >= is_fixed.size() || is_fixed[v.index()] == 0; }
};

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

/// Could the diagonal of the other two corners take the place of an edge inside a face: no fold, no stray from the surface, no such edge
/// elsewhere?
[[nodiscard]] bool is_swap_fit(const WorkingMesh& w, HalfEdge h);
/// Would that lower the largest angle (Fig. 21)?
[[nodiscard]] bool swap_lowers_angle(const WorkingMesh& w, HalfEdge h);

/// Could an end of an edge go to the other with no triangle turned over or worse than they were, and no edge longer than this?
[[nodiscard]] bool is_collapse_fit(const WorkingMesh& w, HalfEdge h, VertexId gone, double longest);

/// The least mean ratio of the triangles round a vertex, as if it were at a point; -1 when one of them would face away from the reference
/// there.
[[nodiscard]] double ball_quality(const WorkingMesh& w, VertexId v, const Vec3d& at);

/// Moves a vertex as far towards a place as leaves its triangles no worse; all, half or a quarter of the way.
/// @param place_of  fraction of the way -> the point on its entity
template <class PlaceOf>
[[nodiscard]] double fit_fraction(const WorkingMesh& w, VertexId v, double least_quality, PlaceOf place_of) {
  for (const double fraction : {1.0, 0.5, 0.25}) {
    if (ball_quality(w, v, place_of(fraction)) >= least_quality) return fraction;
  }
  return 0;
}

}  // namespace mortise
