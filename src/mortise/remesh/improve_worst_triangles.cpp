// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mortise/base/trig.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/triangle_shape.h"

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

std::vector<WorstTriangle> worst_triangles(const WorkingMesh& w, double limit) {
  std::vector<WorstTriangle> worst;
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
    if (!w.mesh.has(FaceId(t)) || !w.may_change(FaceId(t))) continue;
    const double cosine = sharpest(w, FaceId(t));
    if (cosine > limit) worst.push_back({cosine, FaceId(t)});
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

// The sharpest corner of the triangles round a vertex, as its cosine, if that were elsewhere.
double sharpest_round(const WorkingMesh& w, VertexId v, const Vec3d& p) {
  double cosine = -1;
  w.mesh.for_each_leaving(
      v, [&](HalfEdge h) { cosine = std::max(cosine, greatest_cosine(p, at(w, w.mesh.target(h)), at(w, w.mesh.apex(h)))); });
  return cosine;
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
  return after < sharpest_round(w, gone, at(w, gone)) - least_gain;
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
bool try_move(WorkingMesh& w, VertexId v) {
  if (!w.mesh.is_inside_face(v) || !w.may_move(v)) return false;
  const Vec3d from = at(w, v);
  const ModelFaceId face(w.mesh.entity(v).id);
  std::uint32_t near = 0;
  std::vector<VertexId> ring;
  w.mesh.for_each_leaving(v, [&](HalfEdge h) {
    near = w.mesh.references[face_of(h).index()];
    ring.push_back(w.mesh.target(h));
  });
  double best = sharpest_round(w, v, from);
  Vec3d best_place = from;
  for (const VertexId x : ring) {
    for (const double step : {0.2, 0.08, 0.02, -0.02, -0.08, -0.2}) {
      const Vec3d beside = from + step * (at(w, x) - from);
      if (!(sharpest_round(w, v, beside) < best - least_gain)) continue;
      const Vec3d place = w.reference.project(face, beside, near).point;
      const double cosine = sharpest_round(w, v, place);
      if (!(cosine < best - least_gain) || ball_quality(w, v, place) < 0) continue;
      best = cosine;
      best_place = place;
    }
  }
  if (best_place == from) return false;
  w.mesh.points[v.index()] = best_place;
  w.sizes[v.index()] = w.proxy.size_at(best_place);
  return true;
}

}  // namespace

void improve_worst_triangles(WorkingMesh& w, double least_angle_deg, double longest) {
  const double limit = trig::cos_deg(least_angle_deg);
  for (const WorstTriangle& worst : worst_triangles(w, limit)) {
    const FaceId t = worst.triangle;
    if (!w.mesh.has(t) || !(sharpest(w, t) > limit)) continue;
    if (try_swap(w, t, longest) || try_collapse(w, t, longest)) continue;
    for (const VertexId v : w.mesh.triangle(t)) try_move(w, v);
  }
}

}  // namespace mortise
