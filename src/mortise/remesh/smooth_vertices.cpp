// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "mortise/remesh/passes.h"
#include "mortise/remesh/vertex_ball.h"

namespace mortise {
namespace {

constexpr double least_step = 0.002;  // in units of the size: vertices that would go less stay

// Would a triangle of a coarse mesh cut something off?
bool leaves_face(const WorkingMesh& w, const VertexBall& ball, ModelFaceId face, const Vec3d& p, double size) {
  return std::any_of(ball.triangles().begin(), ball.triangles().end(),
                     [&](const VertexBall::BallTriangle& t) { return strays(w, face, 1.0 / 3 * (p + t.x + t.y), t.near, size); });
}

void smooth_vertex(WorkingMesh& w, VertexBall& ball, VertexId v, double good_enough) {
  ball.gather(w, v);
  const Vec3d from = w.mesh.points[v.index()], step = ball.centre() - from;
  const double size = w.sizes[v.index()], least = least_step * size;
  if (!(dot(step, step) > least * least)) return;
  const ModelFaceId face(w.mesh.entity(v).id);
  const double quality = std::clamp(ball.quality_at(from), 0.0, good_enough);
  const bool is_coarse = w.coarseness_of(face) > 1;
  SurfacePlace place;
  const double fraction = fit_fraction([&](double f) {
    place = place_on_face(w, face, from + f * step, w.nears[v.index()], size);
    if (!(ball.quality_at(place.point) >= quality)) return false;
    return !is_coarse || !leaves_face(w, ball, face, place.point, size) || leaves_face(w, ball, face, from, size);
  });
  if (fraction > 0) move_vertex(w, v, place);
}

}  // namespace

std::vector<VertexId> vertices_inside_faces(const WorkingMesh& w) {
  std::vector<VertexId> vertices;
  for (std::size_t i = 0; i < w.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (w.mesh.has(v) && w.may_move_in_face(v)) vertices.push_back(v);
  }
  return vertices;
}

void smooth_vertices(WorkingMesh& w, const std::vector<VertexId>& vertices, double good_enough) {
  VertexBall ball;
  for (const VertexId v : vertices) smooth_vertex(w, ball, v, good_enough);
}

void settle_on_reference(WorkingMesh& w) {
  for (std::size_t i = 0; i < w.mesh.triangle_count(); ++i) {
    const FaceId t(i);
    if (!w.mesh.has(t) || !w.may_change(t)) continue;
    const auto [a, b, c] = w.mesh.triangle(t);
    const Vec3d middle = 1.0 / 3 * (w.mesh.points[a.index()] + w.mesh.points[b.index()] + w.mesh.points[c.index()]);
    w.mesh.references[i] = triangle_below(w, w.mesh.face(t), middle, w.mesh.references[i], w.sizes[a.index()]);
  }
}

}  // namespace mortise
