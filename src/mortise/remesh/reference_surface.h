// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh as it was given: what every new vertex is put back on, face by face and model edge by model edge.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/brep/face_normals.h"
#include "mortise/geom/box_tree.h"
#include "mortise/geom/placed_triangle.h"

namespace mortise {

/// A point of a model face.
struct SurfacePlace {
  Vec3d point;
  std::uint32_t triangle = 0;  ///< of the reference
};

class ReferenceSurface {
 public:
  /// Copies what it needs of the mesh.
  ReferenceSurface(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals);

  /// A point of a model face no other point near it is closer to; one of the closest of the whole face where that is further than `within`.
  /// @param near  a triangle of the face to begin at
  [[nodiscard]] SurfacePlace locate(ModelFaceId face, const Vec3d& p, std::uint32_t near, double within = 0) const;

  /// Is a point of a face this close, on the way to the one locate finds near it?
  [[nodiscard]] bool is_within(const Vec3d& p, std::uint32_t near, double distance) const;

  /// Of length 1, or zero when it has none.
  [[nodiscard]] const Vec3d& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  [[nodiscard]] bool is_plane(ModelFaceId face) const { return faces_[face].is_plane; }

  [[nodiscard]] double length(ModelEdgeId edge) const { return arcs_.of(edge).back(); }
  /// The point of a model edge at a length from its start, 0 .. length(edge).
  [[nodiscard]] Vec3d point_at(ModelEdgeId edge, double arc) const;
  /// Lengths from the start of the edge to the vertices of its path.
  [[nodiscard]] std::span<const double> arcs(ModelEdgeId edge) const { return arcs_.of(edge); }

 private:
  struct Face {
    std::vector<std::uint32_t> triangles;
    BoxTree tree;
    bool is_plane = false;
  };

  /// The closest place of one triangle.
  struct Foot {
    SurfacePlace place;
    double square = 0;  ///< of the distance
    bool is_inside = false;
    std::uint8_t edge = 0;  ///< as in ClosestPlace
  };

  [[nodiscard]] bool lies_in_plane(const Face& face) const;
  [[nodiscard]] Foot foot_on(std::uint32_t triangle, const Vec3d& p) const;
  /// From triangle to triangle as long as one beside it is closer, and no further than to one this close.
  [[nodiscard]] Foot walk(const Vec3d& p, std::uint32_t from, double enough_square = -1) const;
  [[nodiscard]] Foot closest_across_edge(const Foot& from, const Vec3d& p) const;
  [[nodiscard]] Foot closest_round_corner(const Foot& from, const Vec3d& p) const;
  [[nodiscard]] Foot closest_of(const Face& face, const Vec3d& p, const Foot& start) const;

  std::vector<Vec3d> points_;
  std::vector<Triangle> triangles_;
  std::vector<PlacedTriangle> placed_;  ///< per triangle
  std::vector<Vec3d> normals_;          ///< per triangle
  std::vector<HalfEdge> opposite_;      ///< per half-edge: that of the other triangle of the face; itself where the face ends
  IdVector<ModelFaceId, Face> faces_;
  Lists<ModelEdgeId, VertexId> paths_;
  Lists<ModelEdgeId, double> arcs_;
};

}  // namespace mortise
