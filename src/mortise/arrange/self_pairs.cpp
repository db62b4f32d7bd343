// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A pair is left out when a plane keeps its faces apart with room to spare. Planes are found in doubles, by Gilbert's algorithm (1966);
// any plane proves what it proves, so only the room has to be bounded.
#include "mortise/arrange/self_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/geom/box_tree.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Of the largest coordinate: far more than the rounding of a map that is not extreme, far less than the details of a model. It is also
// 2^14 units in the last place of that coordinate, so that the rounding of what is computed here disappears in it.
constexpr double relative_slack = 0x1p-38;
constexpr std::size_t most_pairs_per_face = 4;

double largest_coordinate(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const Vec3d& p : mesh.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return largest;
}

class PairFinder {
 public:
  PairFinder(const SurfaceMesh& mesh, std::span<const std::uint32_t> lowest, double slack) : mesh_(mesh), slack_(slack) {
    corners_.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) corners_.push_back({lowest[t[0].index()], lowest[t[1].index()], lowest[t[2].index()]});
  }

  [[nodiscard]] SelfPairs find() {
    const BoxTree tree(boxes_of_faces(mesh_, 2 * slack_));
    SelfPairs result{slack_, {}, true};
    const std::size_t most_pairs = most_pairs_per_face * corners_.size();
    for_each_meeting_pair_within(tree, [&](std::uint32_t f, std::uint32_t g) {
      if (result.pairs.size() <= most_pairs && !are_kept_apart(corners_[f], corners_[g])) result.pairs.push_back({f, g});
    });
    if (result.pairs.size() > most_pairs) return {};
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;

  [[nodiscard]] const Vec3d& at(std::uint32_t v) const { return mesh_.points[v]; }

  // Do the faces meet in their shared corners only, with room to spare?
  [[nodiscard]] bool are_kept_apart(Corners f, Corners g) const {
    if (repeats(f) || repeats(g)) return true;  // dropped wherever they are
    std::size_t shared = 0;                     // shared corners come first
    for (std::size_t i = 0; i < 3; ++i) {
      const auto same = std::find(g.begin(), g.end(), f[i]);
      if (same == g.end()) continue;
      std::swap(f[i], f[shared]);
      std::iter_swap(same, g.begin() + static_cast<std::ptrdiff_t>(shared));
      ++shared;
    }
    if (shared == 0) return is_gap_between(f, g);
    if (shared == 1) return touch_in_first_corner(f, g);
    return shared == 2 && touch_in_first_edge(f, g);
  }

  static bool repeats(const Corners& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; }

  [[nodiscard]] bool is_gap_between(const Corners& f, const Corners& g) const {
    std::array<Vec3d, 9> steps;
    for (std::size_t i = 0; i < 9; ++i) steps[i] = at(f[i / 3]) - at(g[i % 3]);
    return is_half_space_round(steps);
  }

  [[nodiscard]] bool touch_in_first_corner(const Corners& f, const Corners& g) const {
    const Vec3d& apex = at(f[0]);
    return is_half_space_round(std::array{at(f[1]) - apex, at(f[2]) - apex, apex - at(g[1]), apex - at(g[2])});
  }

  // Is there a direction along which each of the steps goes farther than both its ends can move?
  template <std::size_t count>
  [[nodiscard]] bool is_half_space_round(const std::array<Vec3d, count>& steps) const {
    constexpr int most_rounds = 32;
    Vec3d n = steps[0];
    for (int round = 0; round < most_rounds; ++round) {
      const Vec3d* shortest = &steps[0];
      for (const Vec3d& s : steps) {
        if (dot(n, s) < dot(n, *shortest)) shortest = &s;
      }
      if (dot(n, *shortest) > 3 * slack_ * length(n)) return true;
      const Vec3d back = n - *shortest;
      const double along = dot(n, back), square = dot(back, back);
      if (!(along > 0) || !(square > 0)) return false;
      n = n - std::min(1.0, along / square) * back;
    }
    return false;
  }

  // Is there a plane through the shared edge that has the third corners on different sides, with room for it to turn with its ends?
  [[nodiscard]] bool touch_in_first_edge(const Corners& f, const Corners& g) const {
    const Vec3d edge = at(f[1]) - at(f[0]);
    const double edge_length = length(edge);
    if (!(edge_length > 128 * slack_)) return false;
    const Vec3d to_f = at(f[2]) - at(f[0]), to_g = at(g[2]) - at(g[0]);
    const Vec3d up_f = across(to_f, edge), up_g = across(to_g, edge);
    const double height_f = length(up_f), height_g = length(up_g);
    if (!(height_f > 0) || !(height_g > 0)) return false;
    const Vec3d n = across((1 / height_f) * up_f - (1 / height_g) * up_g, edge);
    const double room = 3 * slack_ * length(n), tilt = 2 * std::fabs(dot(n, edge)) / edge_length;
    const auto needed_by = [&](double reach) { return room * (1 + reach / edge_length) + tilt * reach; };
    return dot(n, to_f) > needed_by(length(to_f)) && -dot(n, to_g) > needed_by(length(to_g));
  }

  // The part of a vector at right angles to the edge.
  static Vec3d across(const Vec3d& v, const Vec3d& edge) { return v - (dot(v, edge) / dot(edge, edge)) * edge; }

  const SurfaceMesh& mesh_;
  double slack_;
  std::vector<Corners> corners_;
};

using Rows = std::array<Vec3d, 3>;

// The largest sum of absolute values in a row.
double norm(const Rows& m) {
  double largest = 0;
  for (const Vec3d& row : m) largest = std::max(largest, std::fabs(row.x) + std::fabs(row.y) + std::fabs(row.z));
  return largest;
}

Rows near_inverse(const Rows& m) {
  const Vec3d a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
  const double scale = 1 / dot(m[0], a);
  return {{scale * Vec3d{a.x, b.x, c.x}, scale * Vec3d{a.y, b.y, c.y}, scale * Vec3d{a.z, b.z, c.z}}};
}

Rows identity_less_product(const Rows& p, const Rows& q) {
  Rows r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r[i][j] = (i == j ? 1 : 0) - (p[i].x * q[0][j] + p[i].y * q[1][j] + p[i].z * q[2][j]);
    }
  }
  return r;
}

// At least the norm of the inverse. With B near the inverse of A and R = 1 - B A, it is (1 - R)^-1 B.
double bound_of_inverse(const Rows& linear) {
  const Rows inverse = near_inverse(linear);
  const double product = norm(inverse) * norm(linear);
  if (!(product < 0x1p40)) return infinity;  // beyond it the rounding of R might count; also what is not a number
  return norm(identity_less_product(inverse, linear)) < 0.25 ? 2 * norm(inverse) : infinity;
}

}  // namespace

std::vector<Box3> boxes_of_faces(const SurfaceMesh& mesh, double margin) {
  const Vec3d room{margin, margin, margin};
  std::vector<Box3> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    Box3 box;
    for (const VertexId v : t) box.extend(mesh.points[v.index()]);
    boxes.push_back({box.lo - room, box.hi + room});
  }
  return boxes;
}

SelfPairs find_self_pairs(const SurfaceMesh& mesh, std::span<const std::uint32_t> lowest) {
  const double largest = largest_coordinate(mesh);
  if (!(largest > 0x1p-200 && largest < 0x1p200)) return {};  // products of four lengths fit
  return PairFinder(mesh, lowest, relative_slack * largest).find();
}

double rounding_seen_in_mesh(const AffineMap& map, const Box3& box) {
  // Every term is rounded at most four times, by 2^-53 of the sum of all; and what denormal numbers lose.
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = std::fabs(map.offset[i]);
    for (std::size_t j = 0; j < 3; ++j) sum += std::fabs(map.linear[i][j]) * std::max(std::fabs(box.lo[j]), std::fabs(box.hi[j]));
    largest = std::max(largest, 0x1p-50 * sum + 0x1p-1060);
  }
  const double bound = 2 * bound_of_inverse(map.linear) * largest;  // of a coordinate; of the length with the factor of 2 > sqrt(3)
  return bound >= 0 ? bound : infinity;
}

}  // namespace mortise
