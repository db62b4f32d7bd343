// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How two triangles meet, from signs of orient3d and orient2d. No shared vertex: intervals on the common line (Guigue and
// Devillers 2003); one shared vertex: directions along that line, which follow from the signs already known.
#include <array>
#include <utility>

#include "mortise/exact/sides_of_plane.h"
#include "mortise/mesh/find_self_crossings.h"

namespace mortise {
namespace {

using Corners = std::array<Vec3d, 3>;
using Signs = std::array<Sign, 3>;

/// Corners turned so that the shared ones come first, in the order of the face.
struct AlignedPair {
  Corners a, b;
  int shared = 0;
};

bool has_vertex(const Triangle& t, VertexId v) { return t[0] == v || t[1] == v || t[2] == v; }

int count_shared(const Triangle& a, const Triangle& b) {
  return static_cast<int>(has_vertex(b, a[0])) + static_cast<int>(has_vertex(b, a[1])) + static_cast<int>(has_vertex(b, a[2]));
}

/// The rotation of `t` that begins with its shared vertices, at most two.
Corners align(const SurfaceMesh& mesh, const Triangle& t, const Triangle& other, int shared) {
  const auto begins_shared = [&](std::size_t i) { return has_vertex(other, t[i]) && (shared == 1 || has_vertex(other, t[(i + 1) % 3])); };
  std::size_t first = 0;
  while (shared > 0 && !begins_shared(first)) ++first;
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.points[t[(first + i) % 3].index()];
  return corners;
}

/// Sides of the corners from `first` on to the plane; those before it lie in it.
Signs sides_of(const Corners& plane, const Corners& corners, int first) {
  const SidesOfPlane sides(plane[0], plane[1], plane[2]);
  Signs signs{Sign::Zero, Sign::Zero, Sign::Zero};
  for (auto i = static_cast<std::size_t>(first); i < 3; ++i) signs[i] = sides.of(corners[i]);
  return signs;
}

bool has(const Signs& signs, Sign sign) { return signs[0] == sign || signs[1] == sign || signs[2] == sign; }

/// Are there corners on both sides, so that the triangle crosses the plane in its inside?
bool straddles(const Signs& signs) { return has(signs, Sign::Positive) && has(signs, Sign::Negative); }

bool is_on_one_side(const Signs& signs) { return !has(signs, Sign::Zero) && !straddles(signs); }

// --- in one plane ---

/// The triangle, counterclockwise after projection.
Corners turn_counterclockwise(Corners corners, Axis axis) {
  if (orient2d(corners[0], corners[1], corners[2], axis) == Sign::Negative) std::swap(corners[1], corners[2]);
  return corners;
}

/// What the three edge lines of `a` tell about `b`.
struct Separation {
  bool strict = false;  ///< a line has all of b strictly outside
  bool weak = false;    ///< a line has no corner of b inside
};

Separation separate(const Corners& a, const Corners& b, Axis axis) {
  Separation separation;
  for (std::size_t i = 0; i < 3; ++i) {
    Signs signs;
    for (std::size_t k = 0; k < 3; ++k) signs[k] = orient2d(a[i], a[(i + 1) % 3], b[k], axis);
    if (has(signs, Sign::Positive)) continue;
    separation.weak = true;
    if (!has(signs, Sign::Zero)) separation.strict = true;
  }
  return separation;
}

/// Do p and q, on one line with `from`, lie on the same side of it?
bool is_same_direction(const Vec3d& from, const Vec3d& p, const Vec3d& q) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (p[i] != from[i]) return q[i] != from[i] && (p[i] > from[i]) == (q[i] > from[i]);
  }
  return false;
}

/// Does an edge of `a` from the shared corner run along one of `b`?
bool runs_along(const AlignedPair& pair, Axis axis) {
  for (std::size_t i = 1; i < 3; ++i) {
    for (std::size_t k = 1; k < 3; ++k) {
      if (orient2d(pair.a[0], pair.a[i], pair.b[k], axis) == Sign::Zero && is_same_direction(pair.a[0], pair.a[i], pair.b[k])) return true;
    }
  }
  return false;
}

PairMeeting classify_coplanar(const AlignedPair& pair) {
  const std::optional<Axis> axis = projection_axis(pair.a[0], pair.a[1], pair.a[2]);
  if (!axis || pair.shared == 3) return PairMeeting::CoplanarOverlap;
  const Corners a = turn_counterclockwise(pair.a, *axis);
  const Corners b = turn_counterclockwise(pair.b, *axis);
  const Separation by_a = separate(a, b, *axis);
  if (by_a.strict) return PairMeeting::Apart;
  const Separation by_b = separate(b, a, *axis);
  if (by_b.strict) return PairMeeting::Apart;
  if (!by_a.weak && !by_b.weak) return PairMeeting::CoplanarOverlap;
  if (pair.shared == 2) return PairMeeting::Apart;
  if (pair.shared == 1) return runs_along(pair, *axis) ? PairMeeting::Touching : PairMeeting::Apart;
  return PairMeeting::Touching;
}

// --- in different planes ---

/// Along the common line, with sign: +1 where a triangle runs from its first corner along (its normal) x (the other's).
int direction_from_first(const Signs& sides) {
  const int difference = static_cast<int>(sides[1]) - static_cast<int>(sides[2]);
  return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

/// The first corner is shared: each triangle has on the common line that corner, or a segment from it.
PairMeeting classify_at_corner(const Signs& sides_a, const Signs& sides_b) {
  const bool a_is_point = sides_a[1] == sides_a[2];
  const bool b_is_point = sides_b[1] == sides_b[2];
  if (a_is_point || b_is_point) return PairMeeting::Apart;
  // the two cross products point against each other, so equal signs are opposite directions
  if (direction_from_first(sides_a) == direction_from_first(sides_b)) return PairMeeting::Apart;
  return straddles(sides_a) && straddles(sides_b) ? PairMeeting::Crossing : PairMeeting::Touching;
}

/// Turns the corners so that the first is alone on the positive side, or alone on the plane with the others below; returns
/// whether the other plane must be turned over for that.
bool put_lone_corner_first(Corners& corners, const Signs& sides) {
  const auto is_alone = [&](std::size_t i, Sign side) {
    const Sign next = sides[(i + 1) % 3];
    const Sign last = sides[(i + 2) % 3];
    if (sides[i] == side) return next != side && last != side;
    return sides[i] == Sign::Zero && next == -side && last == -side;
  };
  for (const Sign side : {Sign::Positive, Sign::Negative}) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_alone(i, side)) continue;
      corners = {corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]};
      return side == Sign::Negative;
    }
  }
  return false;
}

/// No corner is shared: compares the two intervals on the common line.
PairMeeting classify_intervals(AlignedPair pair, const Signs& sides_a, const Signs& sides_b) {
  const bool turn_b = put_lone_corner_first(pair.a, sides_a);
  const bool turn_a = put_lone_corner_first(pair.b, sides_b);
  if (turn_b) std::swap(pair.b[1], pair.b[2]);
  if (turn_a) std::swap(pair.a[1], pair.a[2]);
  const Sign first = orient3d(pair.a[0], pair.a[1], pair.b[0], pair.b[1]);
  if (first == Sign::Positive) return PairMeeting::Apart;
  const Sign second = orient3d(pair.a[0], pair.a[2], pair.b[2], pair.b[0]);
  if (second == Sign::Positive) return PairMeeting::Apart;
  const bool share_segment = first != Sign::Zero && second != Sign::Zero;
  return share_segment && straddles(sides_a) && straddles(sides_b) ? PairMeeting::Crossing : PairMeeting::Touching;
}

/// One corner of each triangle is not on the shared edge.
PairMeeting classify_at_edge(const AlignedPair& pair) {
  return orient3d(pair.a[0], pair.a[1], pair.a[2], pair.b[2]) == Sign::Zero ? classify_coplanar(pair) : PairMeeting::Apart;
}

PairMeeting classify_general(const AlignedPair& pair) {
  const Signs sides_b = sides_of(pair.a, pair.b, pair.shared);
  const bool b_misses_plane = pair.shared == 1 ? sides_b[1] == sides_b[2] && sides_b[1] != Sign::Zero : is_on_one_side(sides_b);
  if (b_misses_plane) return PairMeeting::Apart;
  if (sides_b == Signs{Sign::Zero, Sign::Zero, Sign::Zero}) return classify_coplanar(pair);
  const Signs sides_a = sides_of(pair.b, pair.a, pair.shared);
  if (pair.shared == 1) return classify_at_corner(sides_a, sides_b);
  return is_on_one_side(sides_a) ? PairMeeting::Apart : classify_intervals(pair, sides_a, sides_b);
}

}  // namespace

PairMeeting classify_meeting(const SurfaceMesh& mesh, FaceId a, FaceId b) {
  const Triangle& triangle_a = mesh.triangles[a.index()];
  const Triangle& triangle_b = mesh.triangles[b.index()];
  const int shared = count_shared(triangle_a, triangle_b);
  if (shared == 3) return PairMeeting::CoplanarOverlap;
  const AlignedPair pair{align(mesh, triangle_a, triangle_b, shared), align(mesh, triangle_b, triangle_a, shared), shared};
  return shared == 2 ? classify_at_edge(pair) : classify_general(pair);
}

}  // namespace mortise
