// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "mortise/remesh/passes.h"
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

// Where the triangles of a vertex would have it, in the plane at right angles to their normals.
Vec3d wanted_place(const WorkingMesh& w, VertexId v) {
  const Vec3d& p = w.mesh.points[v.index()];
  Vec3d sum, normal;
  double weights = 0;
  w.mesh.for_each_leaving(v, [&](HalfEdge h) {
    const VertexId x_id = w.mesh.target(h), y_id = w.mesh.apex(h);
    const Vec3d &x = w.mesh.points[x_id.index()], &y = w.mesh.points[y_id.index()];
    const Vec3d area = area_vector(p, x, y);
    const double size = w.sizes[v.index()] + w.sizes[x_id.index()] + w.sizes[y_id.index()];
    const double weight = std::sqrt(dot(area, area)) / (size * size);
    sum = sum + weight * (centre_of(p, x, y) - p);
    weights += weight;
    normal = normal + area;
  });
  if (!(weights > 0)) return p;
  const Vec3d step = 1 / weights * sum;
  const double square = dot(normal, normal);
  return square > 0 ? p + step - dot(step, normal) / square * normal : p;
}

}  // namespace

void smooth_vertices(WorkingMesh& w, double good_enough) {
  for (std::size_t i = 0; i < w.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (!w.mesh.has(v) || !w.mesh.is_inside_face(v) || !w.may_move(v)) continue;
    const Vec3d from = w.mesh.points[i], to = wanted_place(w, v);
    const ModelFaceId face(w.mesh.entity(v).id);
    std::uint32_t near = 0;
    w.mesh.for_each_leaving(v, [&](HalfEdge h) { near = w.mesh.references[face_of(h).index()]; });
    const auto place = [&](double fraction) { return w.reference.project(face, from + fraction * (to - from), near).point; };
    const double fraction = fit_fraction(w, v, std::clamp(ball_quality(w, v, from), 0.0, good_enough), place);
    if (fraction == 0) continue;
    w.mesh.points[i] = place(fraction);
    w.sizes[i] = w.proxy.size_at(w.mesh.points[i]);
  }
}

void settle_on_reference(WorkingMesh& w) {
  for (std::size_t i = 0; i < w.mesh.triangle_count(); ++i) {
    const FaceId t(i);
    if (!w.mesh.has(t) || !w.may_change(t)) continue;
    const auto [a, b, c] = w.mesh.triangle(t);
    const Vec3d middle = 1.0 / 3 * (w.mesh.points[a.index()] + w.mesh.points[b.index()] + w.mesh.points[c.index()]);
    w.mesh.references[i] = w.reference.locate(w.mesh.face(t), middle, w.mesh.references[i]).triangle;
  }
}

}  // namespace mortise
