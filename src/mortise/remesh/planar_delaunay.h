// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangles of model faces in planes, Delaunay between model edges while vertices come and go (Lawson 1977; Bowyer 1981; Watson 1981).
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/exact/sign.h"
#include "mortise/remesh/working_mesh.h"

namespace mortise {

/// Works on one plane after the other. Its triangles are counterclockwise at first and stay so, exactly, seen along an axis the plane has
/// area along; which of two diagonals is better is decided in doubles, in the plane's own metric, beyond all rounding: swaps end.
class PlanarDelaunay {
 public:
  explicit PlanarDelaunay(WorkingMesh& w) : w_(w) {}

  /// @param normal  of length 1; triangles are counterclockwise seen against it
  void enter_plane(const Vec3d& normal);

  [[nodiscard]] bool is_counterclockwise(FaceId t) const;

  /// Swaps edges, and those round them, until no circle through a triangle holds the apex across one of its edges that may be swapped.
  /// @param suspects  half-edges; those that are gone or lie on model edges are left out
  void swap_edges(std::vector<HalfEdge> suspects);

  /// Takes a vertex inside a face out, if that can be.
  bool try_remove(VertexId v);

  /// A new vertex; an invalid one when the point cannot be seen from the triangle, when it has a vertex closer than `room` or a
  /// model edge closer than half of that.
  /// @param near_by  a triangle of the face
  [[nodiscard]] VertexId try_insert(FaceId near_by, const Vec3d& p, double room);

 private:
  /// The triangle a point lies in, and the edge of it it lies on, if it does; an invalid one beyond a model edge.
  struct Place {
    FaceId triangle;
    HalfEdge on = no_half_edge;
  };

  [[nodiscard]] const Vec3d& at(VertexId v) const { return w_.mesh.points[v.index()]; }
  [[nodiscard]] Sign turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;
  [[nodiscard]] bool is_in_circle(HalfEdge h, const Vec3d& d) const;
  [[nodiscard]] bool may_swap(HalfEdge h) const;
  [[nodiscard]] bool may_collapse(HalfEdge h, VertexId gone) const;
  bool swap_one_round(VertexId v);
  [[nodiscard]] Place locate(FaceId from, const Vec3d& p) const;
  [[nodiscard]] bool has_room(FaceId in, const Vec3d& p, double room);

  WorkingMesh& w_;
  Vec3d normal_;
  Axis axis_ = Axis::Z;
  Sign facing_ = Sign::Positive;       // of the normal along the axis
  std::vector<std::uint32_t> visits_;  // per triangle: the last search that came by
  std::uint32_t search_ = 0;
};

}  // namespace mortise
