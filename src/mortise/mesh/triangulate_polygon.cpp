// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Ear clipping (Meisters 1975) on exact signs. A corner that is no ear becomes one only when a neighbour is clipped, so
// every corner is tested at most three times.
#include "mortise/mesh/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"

namespace mortise {
namespace {

struct Coordinates {
  std::size_t u, v;
};

/// The two coordinates a projection keeps.
Coordinates kept_by(Axis axis) { return {(static_cast<std::size_t>(axis) + 1) % 3, (static_cast<std::size_t>(axis) + 2) % 3}; }

bool are_equal(const Vec3d& a, const Vec3d& b, Coordinates c) { return a[c.u] == b[c.u] && a[c.v] == b[c.v]; }

bool is_less(const Vec3d& a, const Vec3d& b, Coordinates c) { return a[c.u] != b[c.u] ? a[c.u] < b[c.u] : a[c.v] < b[c.v]; }

bool ranges_meet(double a, double b, double c, double d) { return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b); }

bool segments_meet(std::array<Vec3d, 2> s, std::array<Vec3d, 2> t, Axis axis) {
  const Coordinates k = kept_by(axis);
  if (!ranges_meet(s[0][k.u], s[1][k.u], t[0][k.u], t[1][k.u]) || !ranges_meet(s[0][k.v], s[1][k.v], t[0][k.v], t[1][k.v])) return false;
  if (orient2d(s[0], s[1], t[0], axis) * orient2d(s[0], s[1], t[1], axis) == Sign::Positive) return false;
  return orient2d(t[0], t[1], s[0], axis) * orient2d(t[0], t[1], s[1], axis) != Sign::Positive;
}

/// Does the polygon turn back on itself at b, or stand still?
bool is_spike(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  const Coordinates k = kept_by(axis);
  if (are_equal(a, b, k) || are_equal(b, c, k)) return true;
  return orient2d(a, b, c, axis) == Sign::Zero && is_less(a, b, k) != is_less(b, c, k);
}

Box3 flat_box(const Vec3d& a, const Vec3d& b, Axis axis) {
  Box3 box;
  box.extend(a);
  box.extend(b);
  box.lo[static_cast<std::size_t>(axis)] = 0;
  box.hi[static_cast<std::size_t>(axis)] = 0;
  return box;
}

/// The largest component of the polygon's normal (Newell), with its sign. Scaled by a power of two: no overflow.
std::pair<Axis, Sign> dominant_axis(std::span<const Vec3d> corners) {
  double size = 0;
  for (const Vec3d& p : corners) size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  int exponent = 0;
  std::frexp(size, &exponent);
  const auto from_first = [&](std::size_t i) {
    const Vec3d& p = corners[i];
    return Vec3d{std::ldexp(p.x, -exponent - 1) - std::ldexp(corners[0].x, -exponent - 1),
                 std::ldexp(p.y, -exponent - 1) - std::ldexp(corners[0].y, -exponent - 1),
                 std::ldexp(p.z, -exponent - 1) - std::ldexp(corners[0].z, -exponent - 1)};
  };
  Vec3d normal;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) normal = normal + cross(from_first(i), from_first(i + 1));
  std::size_t largest = 2;
  for (const std::size_t i : {std::size_t{1}, std::size_t{0}}) {
    if (std::fabs(normal[i]) > std::fabs(normal[largest])) largest = i;
  }
  return {static_cast<Axis>(largest), normal[largest] < 0 ? Sign::Negative : Sign::Positive};
}

/// A polygon that loses its ears.
class EarClipper {
 public:
  EarClipper(std::span<const Vec3d> corners, Axis axis, Sign turn) : corners_(corners), axis_(axis), turn_(turn) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    next_.resize(n);
    previous_.resize(n);
    is_convex_.resize(n);
    was_rejected_.resize(n, false);
    for (std::uint32_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      is_convex_[i] = turn_at(i) == turn_;
      if (!is_convex_[i]) blockers_.push_back(i);
    }
  }

  std::vector<std::array<std::uint32_t, 3>> clip_all() {
    std::size_t left = corners_.size();
    std::size_t rejected_in_turn = 0;
    std::uint32_t i = 1;
    triangles_.reserve(left - 2);
    while (left > 3) {
      if (!is_ear(i) && ++rejected_in_turn < left) {
        i = next_[i];
        continue;
      }
      if (rejected_in_turn == left) i = find_convex(i);
      clip(i);
      --left;
      rejected_in_turn = 0;
      i = next_[next_[i]];
    }
    triangles_.push_back({previous_[i], i, next_[i]});
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] Sign turn_at(std::uint32_t i) const { return orient2d(corners_[previous_[i]], corners_[i], corners_[next_[i]], axis_); }

  [[nodiscard]] bool is_ear(std::uint32_t i) {
    if (!is_convex_[i] || was_rejected_[i]) return false;
    was_rejected_[i] = is_blocked(i);
    return !was_rejected_[i];
  }

  /// Does the closed triangle at i hold another corner? If it does, it holds one that is not convex.
  [[nodiscard]] bool is_blocked(std::uint32_t i) const {
    const std::uint32_t p = previous_[i];
    const std::uint32_t n = next_[i];
    Box3 box = flat_box(corners_[p], corners_[i], axis_);
    box.extend(flat_box(corners_[n], corners_[n], axis_));
    return std::any_of(blockers_.begin(), blockers_.end(), [&](std::uint32_t b) {
      if (is_convex_[b] || b == p || b == n || !boxes_meet(box, flat_box(corners_[b], corners_[b], axis_))) return false;
      return is_inside(p, i, b) && is_inside(i, n, b) && is_inside(n, p, b);
    });
  }
  [[nodiscard]] bool is_inside(std::uint32_t from, std::uint32_t to, std::uint32_t b) const {
    return orient2d(corners_[from], corners_[to], corners_[b], axis_) != -turn_;
  }

  /// For a polygon that meets itself: a convex corner from i on, or i.
  [[nodiscard]] std::uint32_t find_convex(std::uint32_t i) const {
    std::uint32_t k = i;
    do {
      if (is_convex_[k]) return k;
      k = next_[k];
    } while (k != i);
    return i;
  }

  /// Cuts corner i off; its links stay, so that the walk can go on from it.
  void clip(std::uint32_t i) {
    const std::uint32_t p = previous_[i];
    const std::uint32_t n = next_[i];
    triangles_.push_back({p, i, n});
    next_[p] = n;
    previous_[n] = p;
    is_convex_[i] = true;  // no longer a blocker
    for (const std::uint32_t k : {p, n}) {
      was_rejected_[k] = false;
      const bool is_blocker = !is_convex_[k];
      is_convex_[k] = turn_at(k) == turn_;
      if (!is_convex_[k] && !is_blocker) blockers_.push_back(k);
    }
    if (++clipped_ % 64 == 0) drop_convex_blockers();
  }

  void drop_convex_blockers() {
    blockers_.erase(std::remove_if(blockers_.begin(), blockers_.end(), [&](std::uint32_t b) { return is_convex_[b]; }), blockers_.end());
  }

  std::span<const Vec3d> corners_;
  Axis axis_;
  Sign turn_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint32_t> blockers_;  ///< every corner left that is not convex, and some that are
  std::vector<bool> is_convex_, was_rejected_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::size_t clipped_ = 0;
};

/// Which way a simple polygon turns: as at its lexicographically first corner.
Sign turn_of(std::span<const Vec3d> corners, Axis axis) {
  const auto first =
      std::min_element(corners.begin(), corners.end(), [&](const Vec3d& a, const Vec3d& b) { return is_less(a, b, kept_by(axis)); });
  const auto i = static_cast<std::size_t>(first - corners.begin());
  return orient2d(corners[(i + corners.size() - 1) % corners.size()], corners[i], corners[(i + 1) % corners.size()], axis);
}

}  // namespace

bool is_simple_polygon(std::span<const Vec3d> corners, Axis axis) {
  const std::size_t n = corners.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (is_spike(corners[i], corners[(i + 1) % n], corners[(i + 2) % n], axis)) return false;
  }
  if (n == 3) return true;
  const auto edges_meet = [&](std::size_t i, std::size_t j) {
    if ((i + 1) % n == j || (j + 1) % n == i) return false;
    return segments_meet({corners[i], corners[(i + 1) % n]}, {corners[j], corners[(j + 1) % n]}, axis);
  };
  if (n == 4) return !edges_meet(0, 2) && !edges_meet(1, 3);
  std::vector<Box3> boxes(n);
  for (std::size_t i = 0; i < n; ++i) boxes[i] = flat_box(corners[i], corners[(i + 1) % n], axis);
  bool is_simple = true;
  for_each_meeting_pair_within(BoxTree(boxes), [&](std::uint32_t i, std::uint32_t j) { is_simple = is_simple && !edges_meet(i, j); });
  return is_simple;
}

PolygonTriangulation triangulate_polygon(std::span<const Vec3d> corners) {
  if (corners.size() < 3) return {{}, false};
  const auto [axis, newell_turn] = dominant_axis(corners);
  const bool is_simple = is_simple_polygon(corners, axis);
  if (corners.size() == 3) return {{{0, 1, 2}}, is_simple};
  EarClipper clipper(corners, axis, is_simple ? turn_of(corners, axis) : newell_turn);
  return {clipper.clip_all(), is_simple};
}

}  // namespace mortise
