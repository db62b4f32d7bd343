// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mortise/base/sort_unique.h"
#include "mortise/base/trig.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/triangle_shape.h"
#include "mortise/remesh/vertex_ball.h"

namespace mortise {
namespace {

constexpr double least_gain = 1e-6;  // of a cosine

const Vec3d& at(const WorkingMesh& w, VertexId v) { return w.mesh.points[v.index()]; }

double sharpest(const WorkingMesh& w, FaceId t) {
  const auto [a, b, c] = w.mesh.triangle(t);
  return greatest_cosine(at(w, a), at(w, b), at(w, c));
}

struct WorstTriangle {
  double cosine = 0;
  FaceId triangle;
};

std::vector<WorstTriangle> worst_of(const WorkingMesh& w, const std::vector<FaceId>& triangles, double limit) {
  std::vector<WorstTriangle> worst;
  for (const FaceId t : triangles) {
    if (!w.mesh.has(t) || !w.may_change(t)) continue;
    const double cosine = sharpest(w, t);
    if (cosine > limit) worst.push_back({cosine, t});
  }
  std::sort(worst.begin(), worst.end(), [](const WorstTriangle& a, const WorstTriangle& b) {
    return a.cosine != b.cosine ? a.cosine > b.cosine : a.triangle < b.triangle;
  });
  return worst;
}

// The half-edges of a triangle by length, ascending.
std::array<HalfEdge, 3> by_length(const WorkingMesh& w, FaceId t) {
  const auto first = static_cast<HalfEdge>(3 * t.index());
  std::array<HalfEdge, 3> sides{first, first + 1, first + 2};
  std::stable_sort(sides.begin(), sides.end(), [&](HalfEdge a, HalfEdge b) { return metric_length(w, a) < metric_length(w, b); });
  return sides;
}

bool swap_dulls(const WorkingMesh& w, HalfEdge h, double longest) {
  if (w.mesh.is_on_model_edge(h)) return false;
  const HalfEdge t = w.mesh.opposite(h);
  const VertexId c = w.mesh.apex(h), d = w.mesh.apex(t);
  const Vec3d &a = at(w, w.mesh.origin(h)), &b = at(w, w.mesh.target(h));
  if (c == d || metric_length(w, c, d) > longest) return false;
  const double before = std::max(greatest_cosine(a, b, at(w, c)), greatest_cosine(b, a, at(w, d)));
  const double after = std::max(greatest_cosine(at(w, d), at(w, c), a), greatest_cosine(at(w, c), at(w, d), b));
  return after < before - least_gain && is_swap_fit(w, h);
}

bool try_swap(WorkingMesh& w, FaceId t, double longest) {
  const std::array<HalfEdge, 3> sides = by_length(w, t);
  for (const HalfEdge h : {sides[2], sides[1], sides[0]}) {
    if (!swap_dulls(w, h, longest)) continue;
    w.mesh.swap_edge(h);
    return true;
  }
  return false;
}

// Is the sharpest corner of the triangles of the end that goes duller afterwards?
bool collapse_dulls(const WorkingMesh& w, HalfEdge h, VertexId gone) {
  const VertexId stays = w.mesh.other_end(h, gone);
  double after = -1;
  w.mesh.for_each_leaving(gone, [&](HalfEdge g) {
    const VertexId x = w.mesh.target(g), y = w.mesh.apex(g);
    if (x != stays && y != stays) after = std::max(after, greatest_cosine(at(w, stays), at(w, x), at(w, y)));
  });
  double before = -1;
  w.mesh.for_each_leaving(
      gone, [&](HalfEdge g) { before = std::max(before, greatest_cosine(at(w, gone), at(w, w.mesh.target(g)), at(w, w.mesh.apex(g)))); });
  return after < before - least_gain;
}

bool try_collapse(WorkingMesh& w, FaceId t, double longest) {
  const HalfEdge h = by_length(w, t)[0];
  if (w.mesh.is_on_model_edge(h)) return false;
  for (const VertexId gone : {w.mesh.origin(h), w.mesh.target(h)}) {
    if (!is_collapse_fit(w, h, gone, longest) || !collapse_dulls(w, h, gone)) continue;
    w.mesh.collapse_edge(h, gone);
    return true;
  }
  return false;
}

// Tries steps towards and away from its neighbours that make the sharpest corner round a vertex duller.
void try_move(WorkingMesh& w, VertexBall& ball, VertexId v) {
  if (!w.may_move_in_face(v)) return;
  ball.gather(w, v);
  const Vec3d from = at(w, v);
  const ModelFaceId face(w.mesh.entity(v).id);
  double sharpest = ball.sharpest_at(from);
  SurfacePlace best{from, w.nears[v.index()]};
  for (const VertexBall::BallTriangle& t : ball.triangles()) {
    for (const double step : {0.2, 0.08, 0.02, -0.02, -0.08, -0.2}) {
      const Vec3d beside = from + step * (t.x - from);
      if (!(ball.sharpest_at(beside) < sharpest - least_gain)) continue;
      const SurfacePlace place = place_on_face(w, face, beside, w.nears[v.index()], w.sizes[v.index()]);
      const double cosine = ball.sharpest_at(place.point);
      if (!(cosine < sharpest - least_gain) || ball.quality_at(place.point) < 0) continue;
      sharpest = cosine;
      best = place;
    }
  }
  if (!(best.point == from)) move_vertex(w, v, best);
}

void mend(WorkingMesh& w, VertexBall& ball, FaceId t, double longest) {
  if (try_swap(w, t, longest) || try_collapse(w, t, longest)) return;
  for (const VertexId v : w.mesh.triangle(t)) try_move(w, ball, v);
}

// With their neighbours, sorted.
std::vector<VertexId> widened(const WorkingMesh& w, const std::vector<VertexId>& vertices) {
  std::vector<VertexId> wider = vertices;
  for (const VertexId v : vertices) {
    if (w.mesh.has(v)) w.mesh.for_each_neighbour(v, [&](VertexId x) { wider.push_back(x); });
  }
  sort_unique(wider);
  return wider;
}

std::vector<VertexId> movable_of(const WorkingMesh& w, std::vector<VertexId> vertices) {
  std::erase_if(vertices, [&](VertexId v) { return !w.mesh.has(v) || !w.may_move_in_face(v); });
  return vertices;
}

std::vector<FaceId> triangles_round(const WorkingMesh& w, const std::vector<VertexId>& vertices) {
  std::vector<FaceId> triangles;
  for (const VertexId v : vertices) {
    if (w.mesh.has(v)) w.mesh.for_each_leaving(v, [&](HalfEdge h) { triangles.push_back(face_of(h)); });
  }
  sort_unique(triangles);
  return triangles;
}

}  // namespace

void improve_worst_triangles(WorkingMesh& w, double least_angle_deg, double longest, std::uint32_t rounds) {
  const double limit = trig::cos_deg(least_angle_deg);
  VertexBall ball;
  std::vector<FaceId> suspects;
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) suspects.emplace_back(t);
  for (std::uint32_t round = 0; round < rounds; ++round) {
    std::vector<VertexId> touched;
    for (const WorstTriangle& worst : worst_of(w, suspects, limit)) {
      const FaceId t = worst.triangle;
      if (!w.mesh.has(t) || !(sharpest(w, t) > limit)) continue;
      for (const VertexId v : w.mesh.triangle(t)) touched.push_back(v);
      mend(w, ball, t, longest);
    }
    touched = widened(w, widened(w, touched));
    if (round + 2 < rounds) smooth_vertices(w, movable_of(w, touched), 0);
    suspects = triangles_round(w, touched);
  }
}

}  // namespace mortise
