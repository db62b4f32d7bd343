// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Self-crossings in big integers: coordinates become whole multiples of one power of two.
#include "support/self_crossing_oracle.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace mortise::oracle {
namespace {

namespace mp = boost::multiprecision;
/// Wide enough for products of seven coordinates of 140 bits.
using FixedInteger = mp::number<mp::cpp_int_backend<1024, 1024, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;
using AnyInteger = mp::number<mp::cpp_int_backend<>, mp::et_off>;

template <class Integer>
using Point = std::array<Integer, 3>;
template <class Integer>
using Corners = std::array<Point<Integer>, 3>;

struct Range {
  int lowest_bit = std::numeric_limits<int>::max();
  int highest_bit = std::numeric_limits<int>::min();
};

/// The positions of the lowest and highest bit any coordinate of a face has.
Range bit_range(const SurfaceMesh& mesh) {
  Range range;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = mesh.points[v.index()][i];
        if (x == 0) continue;
        int exponent = 0;
        auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::fabs(std::frexp(x, &exponent)), 53));
        int zeros = 0;
        for (; mantissa % 2 == 0; mantissa /= 2) ++zeros;
        range.highest_bit = std::max(range.highest_bit, exponent);
        range.lowest_bit = std::min(range.lowest_bit, exponent - 53 + zeros);
      }
    }
  }
  return range;
}

template <class Integer>
Integer on_grid(double x, int lowest_bit) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const Integer mantissa(static_cast<long long>(std::ldexp(fraction, 53)));
  const int shift = exponent - 53 - lowest_bit;
  if (x == 0) return Integer(0);
  return shift >= 0 ? Integer(mantissa << shift) : Integer(mantissa / (Integer(1) << -shift));
}

template <class Integer>
std::vector<Point<Integer>> points_on_grid(const SurfaceMesh& mesh, int lowest_bit) {
  std::vector<bool> is_used(mesh.points.size(), false);
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) is_used[v.index()] = true;
  }
  std::vector<Point<Integer>> points(mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!is_used[v]) continue;
    for (std::size_t i = 0; i < 3; ++i) points[v][i] = on_grid<Integer>(mesh.points[v][i], lowest_bit);
  }
  return points;
}

template <class Integer>
int sign_of(const Integer& x) {
  return x.sign();
}

template <class Integer>
Point<Integer> minus(const Point<Integer>& a, const Point<Integer>& b) {
  return {Integer(a[0] - b[0]), Integer(a[1] - b[1]), Integer(a[2] - b[2])};
}

template <class Integer>
Point<Integer> cross_product(const Point<Integer>& a, const Point<Integer>& b) {
  return {Integer(a[1] * b[2] - a[2] * b[1]), Integer(a[2] * b[0] - a[0] * b[2]), Integer(a[0] * b[1] - a[1] * b[0])};
}

template <class Integer>
Integer dot_product(const Point<Integer>& a, const Point<Integer>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Integer>
Point<Integer> normal_of(const Corners<Integer>& t) {
  return cross_product(minus(t[1], t[0]), minus(t[2], t[0]));
}

template <class Integer>
std::optional<std::size_t> nonzero_component(const Point<Integer>& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (p[i] != 0) return i;
  }
  return std::nullopt;
}

/// A number num / den, den > 0.
template <class Integer>
struct Fraction {
  Integer num, den;

  [[nodiscard]] bool operator<(const Fraction& other) const { return num * other.den < other.num * den; }
};

template <class Integer>
using Interval = std::pair<Fraction<Integer>, Fraction<Integer>>;

/// The coordinates, along one axis, of the points of a triangle on a plane; `heights` of the corners over that plane.
template <class Integer>
std::optional<Interval<Integer>> cut(const Corners<Integer>& t, const Point<Integer>& heights, std::size_t axis) {
  std::vector<Fraction<Integer>> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (heights[i] == 0) ends.push_back({t[i][axis], Integer(1)});
    if (sign_of(heights[i]) * sign_of(heights[j]) >= 0) continue;
    const Integer num = t[i][axis] * heights[j] - t[j][axis] * heights[i];
    const Integer den = heights[j] - heights[i];
    ends.push_back(den > 0 ? Fraction<Integer>{num, den} : Fraction<Integer>{Integer(-num), Integer(-den)});
  }
  if (ends.empty()) return std::nullopt;
  const auto [lo, hi] = std::minmax_element(ends.begin(), ends.end());
  return Interval<Integer>{*lo, *hi};
}

template <class Integer>
bool has_both_signs(const Point<Integer>& heights) {
  const auto [lo, hi] = std::minmax_element(heights.begin(), heights.end());
  return *lo < 0 && *hi > 0;
}

/// Two triangles and the corners they share by index.
template <class Integer>
struct Pair {
  Corners<Integer> a, b;
  std::vector<Point<Integer>> shared;
};

template <class Integer>
Meeting meet_on_line(const Pair<Integer>& pair, const Point<Integer>& heights_a, const Point<Integer>& heights_b, std::size_t axis) {
  const auto cut_a = cut(pair.a, heights_a, axis);
  const auto cut_b = cut(pair.b, heights_b, axis);
  if (!cut_a || !cut_b) return Meeting::Apart;
  const Fraction<Integer> lo = std::max(cut_a->first, cut_b->first);
  const Fraction<Integer> hi = std::min(cut_a->second, cut_b->second);
  if (hi < lo) return Meeting::Apart;
  if (!pair.shared.empty()) {
    Integer shared_lo = pair.shared.front()[axis];
    Integer shared_hi = shared_lo;
    for (const Point<Integer>& p : pair.shared) {
      shared_lo = std::min(shared_lo, p[axis]);
      shared_hi = std::max(shared_hi, p[axis]);
    }
    if (!(lo < Fraction<Integer>{shared_lo, Integer(1)}) && !(Fraction<Integer>{shared_hi, Integer(1)} < hi)) return Meeting::Apart;
  }
  return lo < hi && has_both_signs(heights_a) && has_both_signs(heights_b) ? Meeting::Crossing : Meeting::Touching;
}

/// Orientation of three points of one plane; `dropped`: a coordinate in which its normal is not zero.
template <class Integer>
int turn(const Point<Integer>& a, const Point<Integer>& b, const Point<Integer>& c, std::size_t dropped) {
  const std::size_t u = (dropped + 1) % 3;
  const std::size_t v = (dropped + 2) % 3;
  return sign_of(Integer((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])));
}

template <class Integer>
bool is_in_triangle(const Point<Integer>& p, const Corners<Integer>& t, std::size_t dropped) {
  bool has_left = false;
  bool has_right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = turn(t[i], t[(i + 1) % 3], p, dropped);
    has_left = has_left || side > 0;
    has_right = has_right || side < 0;
  }
  return !has_left || !has_right;
}

template <class Integer>
bool edges_cross(const Corners<Integer>& a, std::size_t i, const Corners<Integer>& b, std::size_t k, std::size_t dropped) {
  const auto& [p, q] = std::pair(a[i], a[(i + 1) % 3]);
  const auto& [r, s] = std::pair(b[k], b[(k + 1) % 3]);
  return turn(p, q, r, dropped) * turn(p, q, s, dropped) < 0 && turn(r, s, p, dropped) * turn(r, s, q, dropped) < 0;
}

/// Where no edges cross, the common part is spanned by corners of one that lie in the other.
template <class Integer>
Meeting meet_in_plane(const Pair<Integer>& pair, std::size_t dropped) {
  for (std::size_t i = 0; i < 9; ++i) {
    if (edges_cross(pair.a, i / 3, pair.b, i % 3, dropped)) return Meeting::Overlap;
  }
  std::vector<Point<Integer>> common;
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_in_triangle(pair.a[i], pair.b, dropped)) common.push_back(pair.a[i]);
    if (is_in_triangle(pair.b[i], pair.a, dropped)) common.push_back(pair.b[i]);
  }
  std::sort(common.begin(), common.end());
  common.erase(std::unique(common.begin(), common.end()), common.end());
  for (std::size_t i = 2; i < common.size(); ++i) {
    if (turn(common[0], common[1], common[i], dropped) != 0) return Meeting::Overlap;
  }
  const bool is_shared_only = std::all_of(common.begin(), common.end(), [&](const Point<Integer>& p) {
    return std::find(pair.shared.begin(), pair.shared.end(), p) != pair.shared.end();
  });
  return is_shared_only ? Meeting::Apart : Meeting::Touching;
}

template <class Integer>
Meeting meet(const Pair<Integer>& pair) {
  const Point<Integer> normal_a = normal_of(pair.a);
  const Point<Integer> normal_b = normal_of(pair.b);
  Point<Integer> heights_a, heights_b;
  for (std::size_t i = 0; i < 3; ++i) {
    heights_a[i] = dot_product(normal_b, minus(pair.a[i], pair.b[0]));
    heights_b[i] = dot_product(normal_a, minus(pair.b[i], pair.a[0]));
  }
  const auto axis = nonzero_component(cross_product(normal_a, normal_b));
  if (axis) return meet_on_line(pair, heights_a, heights_b, *axis);
  return heights_a[0] == 0 ? meet_in_plane(pair, *nonzero_component(normal_a)) : Meeting::Apart;
}

bool has_vertex(const Triangle& t, VertexId v) { return std::find(t.begin(), t.end(), v) != t.end(); }

/// Are all corners of `t` that `plane` does not share strictly on one side of it, for certain?
bool is_certainly_aside(const SurfaceMesh& mesh, const Triangle& plane, const Triangle& t) {
  const Vec3d& o = mesh.points[plane[0].index()];
  const Vec3d u = mesh.points[plane[1].index()] - o;
  const Vec3d v = mesh.points[plane[2].index()] - o;
  int side = 0;
  for (const VertexId corner : t) {
    if (has_vertex(plane, corner)) continue;
    const Vec3d w = mesh.points[corner.index()] - o;
    const double terms[] = {u.x * v.y * w.z, u.y * v.z * w.x, u.z * v.x * w.y, -(u.x * v.z * w.y), -(u.y * v.x * w.z), -(u.z * v.y * w.x)};
    double sum = 0;
    double sizes = 0;
    for (const double term : terms) {
      sum += term;
      sizes += std::fabs(term);
    }
    if (!(std::fabs(sum) > 1e-13 * sizes && std::fabs(sum) > 1e-250)) return false;
    if (!std::isfinite(sizes)) return false;
    const int corner_side = sum > 0 ? 1 : -1;
    if (side != 0 && side != corner_side) return false;
    side = corner_side;
  }
  return side != 0;
}

struct FaceBox {
  std::array<double, 3> lo, hi;
};

std::vector<FaceBox> boxes_of(const SurfaceMesh& mesh) {
  std::vector<FaceBox> boxes;
  for (const Triangle& t : mesh.triangles) {
    FaceBox box;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = mesh.points[t[0].index()][i];
      const double b = mesh.points[t[1].index()][i];
      const double c = mesh.points[t[2].index()][i];
      box.lo[i] = std::min({a, b, c});
      box.hi[i] = std::max({a, b, c});
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// The axis along which faces are shortest, taken together and measured by the whole.
std::size_t sweep_axis(const std::vector<FaceBox>& boxes) {
  std::array<double, 3> share{};
  for (std::size_t i = 0; i < 3; ++i) {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    double sum = 0;
    for (const FaceBox& box : boxes) {
      lo = std::min(lo, box.lo[i] / 4);
      hi = std::max(hi, box.hi[i] / 4);
      sum += box.hi[i] / 4 - box.lo[i] / 4;
    }
    share[i] = hi > lo ? sum / (hi - lo) : std::numeric_limits<double>::infinity();
  }
  return static_cast<std::size_t>(std::min_element(share.begin(), share.end()) - share.begin());
}

/// Calls visit for every pair of faces whose boxes meet.
template <class Visit>
void sweep(const std::vector<FaceBox>& boxes, Visit visit) {
  const std::size_t axis = sweep_axis(boxes);
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return boxes[i].lo[axis] < boxes[j].lo[axis]; });
  std::vector<std::uint32_t> open;
  for (const std::uint32_t face : order) {
    const FaceBox& box = boxes[face];
    std::size_t kept = 0;
    for (const std::uint32_t other : open) {
      if (boxes[other].hi[axis] < box.lo[axis]) continue;
      open[kept++] = other;
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      const bool meets_u = boxes[other].lo[u] <= box.hi[u] && box.lo[u] <= boxes[other].hi[u];
      const bool meets_v = boxes[other].lo[v] <= box.hi[v] && box.lo[v] <= boxes[other].hi[v];
      if (meets_u && meets_v) visit(std::min(face, other), std::max(face, other));
    }
    open.resize(kept);
    open.push_back(face);
  }
}

template <class Integer>
std::vector<bool> find_flat(const SurfaceMesh& mesh, const std::vector<Point<Integer>>& points) {
  std::vector<bool> is_flat;
  for (const Triangle& t : mesh.triangles) {
    is_flat.push_back(!nonzero_component(normal_of<Integer>({points[t[0].index()], points[t[1].index()], points[t[2].index()]})));
  }
  return is_flat;
}

template <class Integer>
std::vector<MeetingPair> find_pairs(const SurfaceMesh& mesh, int lowest_bit) {
  const std::vector<Point<Integer>> points = points_on_grid<Integer>(mesh, lowest_bit);
  const std::vector<bool> is_flat = find_flat(mesh, points);
  std::vector<MeetingPair> pairs;
  sweep(boxes_of(mesh), [&](std::uint32_t face_a, std::uint32_t face_b) {
    const Triangle& a = mesh.triangles[face_a];
    const Triangle& b = mesh.triangles[face_b];
    if (is_flat[face_a] || is_flat[face_b] || is_certainly_aside(mesh, a, b) || is_certainly_aside(mesh, b, a)) return;
    Pair<Integer> pair;
    for (std::size_t i = 0; i < 3; ++i) {
      pair.a[i] = points[a[i].index()];
      pair.b[i] = points[b[i].index()];
      if (has_vertex(b, a[i])) pair.shared.push_back(pair.a[i]);
    }
    const Meeting meeting = meet(pair);
    if (meeting != Meeting::Apart) pairs.push_back({face_a, face_b, meeting});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

std::vector<MeetingPair> self_crossings(const SurfaceMesh& mesh) {
  constexpr int fixed_bits = 140;
  const Range range = bit_range(mesh);
  if (range.lowest_bit > range.highest_bit) return {};
  if (range.highest_bit - range.lowest_bit <= fixed_bits) return find_pairs<FixedInteger>(mesh, range.lowest_bit);
  return find_pairs<AnyInteger>(mesh, range.lowest_bit);
}

std::vector<std::uint32_t> faces_without_area(const SurfaceMesh& mesh) {
  const std::vector<bool> is_flat = find_flat(mesh, points_on_grid<AnyInteger>(mesh, std::min(bit_range(mesh).lowest_bit, 0)));
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < is_flat.size(); ++f) {
    if (is_flat[f]) faces.push_back(f);
  }
  return faces;
}

}  // namespace mortise::oracle
