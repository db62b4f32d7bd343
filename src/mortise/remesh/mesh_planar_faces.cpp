// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A front that runs inwards from the model edges round a face (Rebay 1993): triangles beside finished ones get the vertex that finishes
// them. Points further off than the middle of the circle round a triangle are not asked for (Üngör 2004).
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mortise/base/sort_unique.h"
#include "mortise/geom/length.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/planar_delaunay.h"
#include "mortise/remesh/triangle_shape.h"

namespace mortise {
namespace {

constexpr double small_enough = 1.3;  // a circumradius, of that of the equilateral triangle: both set the mean edge to the size
constexpr double least_room = 0.8;    // between vertices, of the size
constexpr double one_over_sqrt_3 = 0.5773502691896258;

std::array<HalfEdge, 3> sides_of(FaceId t) {
  const auto first = static_cast<HalfEdge>(3 * t.index());
  return {first, first + 1, first + 2};
}

class Front {
 public:
  explicit Front(WorkingMesh& w) : w_(w), delaunay_(w) {}

  bool try_mesh(const std::vector<FaceId>& triangles) {
    Vec3d sum;
    for (const FaceId t : triangles) {
      const auto [a, b, c] = w_.mesh.triangle(t);
      sum = sum + area_vector(at(a), at(b), at(c));
    }
    normal_ = 1 / length(sum) * sum;
    coarseness_ = w_.coarseness_at_edges_of(w_.mesh.face(triangles.front()));
    delaunay_.enter_plane(normal_);
    const auto is_fit = [&](FaceId t) { return delaunay_.is_counterclockwise(t); };
    if (!std::all_of(triangles.begin(), triangles.end(), is_fit)) return false;
    clear(triangles);
    for (const FaceId t : triangles) {
      if (w_.mesh.has(t)) judge(t);
    }
    advance();
    return true;
  }

 private:
  [[nodiscard]] const Vec3d& at(VertexId v) const { return w_.mesh.points[v.index()]; }
  [[nodiscard]] double size_of(VertexId v) const { return coarseness_ * w_.sizes[v.index()]; }

  // Leaves the vertices on model edges and model vertices.
  void clear(const std::vector<FaceId>& triangles) {
    std::vector<HalfEdge> sides;
    std::vector<VertexId> inside;
    for (const FaceId t : triangles) {
      for (const HalfEdge h : sides_of(t)) {
        sides.push_back(h);
        if (w_.may_move_in_face(w_.mesh.origin(h))) inside.push_back(w_.mesh.origin(h));
      }
    }
    sort_unique(inside);
    delaunay_.swap_edges(std::move(sides));
    for (const VertexId v : inside) delaunay_.try_remove(v);
  }

  // The newest first: rows of equal triangles go on as they began.
  void advance() {
    while (!open_.empty()) {
      const FaceId t = open_.back();
      open_.pop_back();
      is_open_[t.index()] = 0;
      if (is_finished_[t.index()] == 0) work_on(t);
    }
  }

  void judge(FaceId t) {
    is_finished_.resize(w_.mesh.triangle_count(), 0);
    is_open_.resize(w_.mesh.triangle_count(), 0);
    const auto [a, b, c] = w_.mesh.triangle(t);
    const double edges = length(at(b) - at(a)) * length(at(c) - at(b)) * length(at(a) - at(c));
    const double radius = edges / (2 * length(area_vector(at(a), at(b), at(c)))), size = (size_of(a) + size_of(b) + size_of(c)) / 3;
    is_finished_[t.index()] = 0;
    if (radius <= small_enough * one_over_sqrt_3 * size)
      finish(t);
    else
      open(t);
  }

  void open(FaceId t) {
    if (is_finished_[t.index()] != 0 || is_open_[t.index()] != 0) return;
    is_open_[t.index()] = 1;
    open_.push_back(t);
  }

  void finish(FaceId t) {
    is_finished_[t.index()] = 1;
    for (const HalfEdge h : sides_of(t)) {
      if (!w_.mesh.is_on_model_edge(h)) open(face_of(w_.mesh.opposite(h)));
    }
  }

  [[nodiscard]] bool is_front(HalfEdge h) const {
    return w_.mesh.is_on_model_edge(h) || is_finished_[face_of(w_.mesh.opposite(h)).index()] != 0;
  }

  // One that no point is found for stays as it is. Away from the front nothing is done yet.
  void work_on(FaceId t) {
    bool is_beside_front = false;
    for (const HalfEdge h : sides_of(t)) {
      if (!is_front(h)) continue;
      is_beside_front = true;
      const VertexId v = try_point_over(h);
      if (!v.is_valid()) continue;
      std::vector<FaceId> round;
      w_.mesh.for_each_leaving(v, [&](HalfEdge g) { round.push_back(face_of(g)); });
      for (const FaceId u : round) judge(u);
      return;
    }
    if (is_beside_front) finish(t);
  }

  //       c               c
  //      / \             /|\         p makes a triangle over the edge as large as an equilateral one of the size there,
  //     /   \    ->     / p \        no further in than the middle of the circle
  //    /     \         //   \\ .
  //   a-------b       a-------b
  VertexId try_point_over(HalfEdge h) {
    const VertexId a = w_.mesh.origin(h), b = w_.mesh.target(h), c = w_.mesh.apex(h);
    const Vec3d along = at(b) - at(a), to_a = at(a) - at(c), to_b = at(b) - at(c);
    const double half = length(along) / 2, to_middle = half * dot(to_a, to_b) / length(cross(to_a, to_b));
    if (!(to_middle > 0)) return {};
    const auto over = [&](double size) {
      const double radius = std::max(one_over_sqrt_3 * size, half);
      const double height = std::min(radius + std::sqrt(radius * radius - half * half), to_middle);
      return 0.5 * (at(a) + at(b)) + height / (2 * half) * cross(normal_, along);
    };
    const double beside = (size_of(a) + size_of(b)) / 2, size = (beside + coarseness_ * w_.proxy->size_at(over(beside))) / 2;
    return delaunay_.try_insert(face_of(h), over(size), least_room * size);
  }

  WorkingMesh& w_;
  PlanarDelaunay delaunay_;
  Vec3d normal_;
  double coarseness_ = 1;
  std::vector<std::uint8_t> is_finished_, is_open_;  // per triangle
  std::vector<FaceId> open_;
};

}  // namespace

void await_front(WorkingMesh& w) {
  for (std::size_t f = 0; f < w.brep.faces.size(); ++f) w.awaits_front[ModelFaceId(f)] = w.reference.is_plane(ModelFaceId(f)) ? 1 : 0;
  for (std::size_t t = 0; t < w.is_frozen.size(); ++t) {
    if (w.is_frozen[t] != 0) w.awaits_front[w.mesh.face(FaceId(t))] = 0;
  }
}

void mesh_planar_faces(WorkingMesh& w) {
  IdVector<ModelFaceId, std::vector<FaceId>> triangles(w.brep.faces.size());
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
    if (w.mesh.has(FaceId(t))) triangles[w.mesh.face(FaceId(t))].emplace_back(t);
  }
  Front front(w);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const ModelFaceId face(f);
    if (w.awaits_front[face] == 0 || triangles[face].empty()) continue;
    w.awaits_front[face] = 0;
    w.is_done[face] = front.try_mesh(triangles[face]) ? 1 : 0;
  }
}

}  // namespace mortise
