// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/planar_delaunay.h"

#include <algorithm>
#include <cmath>

#include "mortise/exact/predicates.h"

namespace mortise {
namespace {

constexpr double certain = 1e-12;     // of a sine: more than rounding explains
constexpr int longest_walk = 100000;  // triangles; between model edges a walk may go round in a circle

}  // namespace

void PlanarDelaunay::enter_plane(const Vec3d& normal) {
  normal_ = normal;
  const Vec3d size{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  axis_ = size.x > size.y && size.x > size.z ? Axis::X : size.y > size.z ? Axis::Y : Axis::Z;
  facing_ = normal[static_cast<std::size_t>(axis_)] > 0 ? Sign::Positive : Sign::Negative;
}

Sign PlanarDelaunay::turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) const { return facing_ * orient2d(a, b, c, axis_); }

bool PlanarDelaunay::is_counterclockwise(FaceId t) const {
  const auto [a, b, c] = w_.mesh.triangle(t);
  return turn(at(a), at(b), at(c)) == Sign::Positive;
}

// ---- swaps ----------------------------------------------------------------------------------------------------------

// Inside the circle through the triangle of h = a -> b: the angles at its apex c and at d, which see the edge from both sides,
// are more than 180 degrees together.
bool PlanarDelaunay::is_in_circle(HalfEdge h, const Vec3d& d) const {
  const Vec3d &a = at(w_.mesh.origin(h)), &b = at(w_.mesh.target(h)), &c = at(w_.mesh.apex(h));
  const Vec3d ca = a - c, cb = b - c, da = a - d, db = b - d;
  const auto cosine = [&](const Vec3d& u, const Vec3d& v) { return dot(u, v) - dot(u, normal_) * dot(v, normal_); };
  const double sum = cosine(ca, cb) * dot(cross(db, da), normal_) + cosine(da, db) * dot(cross(ca, cb), normal_);
  return sum < 0 && sum * sum > certain * certain * (dot(ca, ca) * dot(cb, cb)) * (dot(da, da) * dot(db, db));
}

// Do both triangles of the other diagonal run the right way round?
bool PlanarDelaunay::may_swap(HalfEdge h) const {
  if (w_.mesh.is_on_model_edge(h)) return false;
  const VertexId c = w_.mesh.apex(h), d = w_.mesh.apex(w_.mesh.opposite(h));
  const Vec3d &a = at(w_.mesh.origin(h)), &b = at(w_.mesh.target(h));
  return turn(at(d), at(c), a) == Sign::Positive && turn(at(c), at(d), b) == Sign::Positive && !w_.mesh.are_neighbours(c, d);
}

void PlanarDelaunay::swap_edges(std::vector<HalfEdge> suspects) {
  while (!suspects.empty()) {
    const HalfEdge h = suspects.back();
    suspects.pop_back();
    if (!w_.mesh.has(h) || w_.mesh.is_on_model_edge(h)) continue;
    const HalfEdge t = w_.mesh.opposite(h);
    if (!is_in_circle(h, at(w_.mesh.apex(t))) || !may_swap(h)) continue;
    w_.mesh.swap_edge(h);
    for (const HalfEdge side : {h, t}) {
      suspects.push_back(next_in_face(side));
      suspects.push_back(previous_in_face(side));
    }
  }
}

// ---- removal --------------------------------------------------------------------------------------------------------

bool PlanarDelaunay::may_collapse(HalfEdge h, VertexId gone) const {
  const VertexId b = w_.mesh.target(h);
  bool is_fit = true;
  w_.mesh.for_each_leaving(gone, [&](HalfEdge g) {
    const VertexId x = w_.mesh.target(g), y = w_.mesh.apex(g);
    is_fit = is_fit && (x == b || y == b || turn(at(b), at(x), at(y)) == Sign::Positive);
  });
  return is_fit && w_.mesh.can_collapse(h, gone);
}

// Takes one edge from a vertex.
bool PlanarDelaunay::swap_one_round(VertexId v) {
  HalfEdge fit = no_half_edge;
  w_.mesh.for_each_leaving(v, [&](HalfEdge h) {
    if (fit == no_half_edge && may_swap(h)) fit = h;
  });
  if (fit != no_half_edge) w_.mesh.swap_edge(fit);
  return fit != no_half_edge;
}

bool PlanarDelaunay::try_remove(VertexId v) {
  do {
    HalfEdge fit = no_half_edge;
    std::vector<HalfEdge> round;
    w_.mesh.for_each_leaving(v, [&](HalfEdge h) {
      round.insert(round.end(), {h, next_in_face(h), previous_in_face(h)});
      if (fit == no_half_edge && may_collapse(h, v)) fit = h;
    });
    if (fit == no_half_edge) continue;
    count_change(w_);
    w_.mesh.collapse_edge(fit, v);
    swap_edges(std::move(round));
    return true;
  } while (swap_one_round(v));
  return false;
}

// ---- insertion ------------------------------------------------------------------------------------------------------

PlanarDelaunay::Place PlanarDelaunay::locate(FaceId from, const Vec3d& p) const {
  for (int step = 0; step < longest_walk; ++step) {
    HalfEdge on = no_half_edge, beyond = no_half_edge;
    bool is_inside = true;
    for (auto h = static_cast<HalfEdge>(3 * from.index()), end = h + 3; h < end; ++h) {
      const Sign side = turn(at(w_.mesh.origin(h)), at(w_.mesh.target(h)), p);
      if (side == Sign::Zero) on = h;
      if (side != Sign::Negative) continue;
      is_inside = false;
      if (!w_.mesh.is_on_model_edge(h)) beyond = h;
    }
    if (is_inside) return {from, on};
    if (beyond == no_half_edge) break;
    from = face_of(w_.mesh.opposite(beyond));
  }
  return {};
}

// Looks at all triangles whose circles hold the point: those that would give way to it.
bool PlanarDelaunay::has_room(FaceId in, const Vec3d& p, double room) {
  visits_.resize(w_.mesh.triangle_count(), 0);
  ++search_;
  std::vector<FaceId> cavity{in};
  visits_[in.index()] = search_;
  while (!cavity.empty()) {
    const auto first = static_cast<HalfEdge>(3 * cavity.back().index());
    cavity.pop_back();
    for (const HalfEdge h : {first, first + 1, first + 2}) {
      const Vec3d from = p - at(w_.mesh.origin(h)), along = at(w_.mesh.target(h)) - at(w_.mesh.origin(h));
      if (dot(from, from) < room * room) return false;
      if (w_.mesh.is_on_model_edge(h)) {
        const Vec3d across = cross(along, from);
        if (4 * dot(across, across) < room * room * dot(along, along)) return false;
        continue;
      }
      const HalfEdge beyond = w_.mesh.opposite(h);
      if (visits_[face_of(beyond).index()] == search_ || !is_in_circle(beyond, p)) continue;
      visits_[face_of(beyond).index()] = search_;
      cavity.push_back(face_of(beyond));
    }
  }
  return true;
}

VertexId PlanarDelaunay::try_insert(FaceId near_by, const Vec3d& p, double room) {
  const Place place = locate(near_by, p);
  if (!place.triangle.is_valid() || !has_room(place.triangle, p, room)) return {};
  count_change(w_);
  const std::uint32_t near = triangle_below(w_, w_.mesh.face(place.triangle), p, w_.mesh.references[place.triangle.index()], room);
  const VertexId v = place.on == no_half_edge ? w_.mesh.split_in_three(place.triangle, p) : w_.mesh.split_edge(place.on, p);
  add_values(w_, v, 0, near);
  std::vector<HalfEdge> opposite;
  w_.mesh.for_each_leaving(v, [&](HalfEdge h) { opposite.push_back(next_in_face(h)); });
  swap_edges(std::move(opposite));
  w_.mesh.for_each_leaving(v, [&](HalfEdge h) { w_.mesh.references[face_of(h).index()] = near; });
  return v;
}

}  // namespace mortise
