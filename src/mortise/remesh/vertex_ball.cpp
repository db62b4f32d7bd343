// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/vertex_ball.h"

#include <algorithm>
#include <cmath>

#include "mortise/remesh/triangle_shape.h"

namespace mortise {
namespace {

// The circumcentre; of an obtuse triangle the centroid, for that lies inside.
Vec3d centre_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, bc = c - b, ca = a - c;
  const double angle_a = -dot(ab, ca), angle_b = -dot(ab, bc), angle_c = -dot(bc, ca);
  if (!(angle_a > 0 && angle_b > 0 && angle_c > 0)) return 1.0 / 3 * (a + b + c);
  const double wa = dot(bc, bc) * angle_a, wb = dot(ca, ca) * angle_b, wc = dot(ab, ab) * angle_c, sum = wa + wb + wc;
  return 1 / sum * (wa * a + wb * b + wc * c);
}

}  // namespace

void VertexBall::gather(const WorkingMesh& w, VertexId v) {
  triangles_.clear();
  vertex_ = w.mesh.points[v.index()];
  w.mesh.for_each_leaving(v, [&](HalfEdge h) {
    const VertexId x = w.mesh.target(h), y = w.mesh.apex(h);
    const std::uint32_t near = w.mesh.references[face_of(h).index()];
    triangles_.push_back({w.mesh.points[x.index()], w.mesh.points[y.index()], w.reference.normal(near),
                          w.sizes[v.index()] + w.sizes[x.index()] + w.sizes[y.index()], near});
  });
}

double VertexBall::quality_at(const Vec3d& p) const {
  double least_square = 1, its_edges_square = 12;  // of the mean ratio: 12 square / edges^2
  for (const BallTriangle& t : triangles_) {
    const Vec3d to_x = t.x - p, to_y = t.y - p, across = t.y - t.x, area = cross(to_x, to_y);
    const double square = dot(area, area), edges = dot(to_x, to_x) + dot(to_y, to_y) + dot(across, across), edges_square = edges * edges;
    if (!(12 * square > flat_mean_ratio * flat_mean_ratio * edges_square)) return -1;
    const double along = dot(area, t.normal);
    const bool faces_alike = along > 0 && along * along > cosine_of_most_turn * cosine_of_most_turn * square;
    if (!faces_alike && !(t.normal == Vec3d{})) return -1;
    if (square * its_edges_square < least_square * edges_square) {
      least_square = square;
      its_edges_square = edges_square;
    }
  }
  return std::sqrt(12 * least_square / its_edges_square);
}

double VertexBall::sharpest_at(const Vec3d& p) const {
  double cosine = -1;
  for (const BallTriangle& t : triangles_) cosine = std::max(cosine, greatest_cosine(p, t.x, t.y));
  return cosine;
}

Vec3d VertexBall::centre() const {
  Vec3d sum, normal;
  double weights = 0;
  for (const BallTriangle& t : triangles_) {
    const Vec3d area = area_vector(vertex_, t.x, t.y);
    const double weight = std::sqrt(dot(area, area)) / (t.sizes * t.sizes);
    sum = sum + weight * (centre_of(vertex_, t.x, t.y) - vertex_);
    weights += weight;
    normal = normal + area;
  }
  if (!(weights > 0)) return vertex_;
  const Vec3d step = 1 / weights * sum;
  const double square = dot(normal, normal);
  return square > 0 ? vertex_ + step - dot(step, normal) / square * normal : vertex_;
}

}  // namespace mortise
