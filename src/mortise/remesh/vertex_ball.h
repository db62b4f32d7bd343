// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The triangles round a vertex, taken out of the mesh to try places for it.
#pragma once

#include <vector>

#include "mortise/remesh/working_mesh.h"

namespace mortise {

class VertexBall {
 public:
  /// Takes the triangles round another vertex.
  void gather(const WorkingMesh& w, VertexId v);

  /// The least mean ratio with the vertex at a point; -1 when a triangle would face away from the reference there.
  [[nodiscard]] double quality_at(const Vec3d& p) const;
  /// The cosine of the sharpest corner with the vertex at a point.
  [[nodiscard]] double sharpest_at(const Vec3d& p) const;
  /// Where the triangles would have it: the mean of their circumcentres, of obtuse ones of the centroids, weighted with areas in units of
  /// the size, in the plane at right angles to their normals.
  [[nodiscard]] Vec3d centre() const;

  struct BallTriangle {
    Vec3d x, y;          ///< the other corners in turn
    Vec3d normal;        ///< of the reference
    double sizes;        ///< the sum of those of all three corners
    std::uint32_t near;  ///< the triangle of the reference below it
  };
  [[nodiscard]] const std::vector<BallTriangle>& triangles() const { return triangles_; }

 private:
  Vec3d vertex_;
  std::vector<BallTriangle> triangles_;
};

/// How far a vertex goes: all the way to a place, half or a quarter of it, or not at all.
/// @param is_fit  fraction of the way -> may it go there?
template <class IsFit>
[[nodiscard]] double fit_fraction(IsFit is_fit) {
  for (const double fraction : {1.0, 0.5, 0.25}) {
    if (is_fit(fraction)) return fraction;
  }
  return 0;
}

}  // namespace mortise
