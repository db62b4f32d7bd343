// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Points and vectors of three doubles; axes; axis-aligned boxes.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace mortise {

struct Vec3d {
  double x = 0, y = 0, z = 0;

  [[nodiscard]] constexpr double operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
  [[nodiscard]] constexpr double& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  /// Equal as numbers: -0 equals +0.
  constexpr bool operator==(const Vec3d&) const = default;
};

[[nodiscard]] constexpr Vec3d operator+(const Vec3d& a, const Vec3d& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] constexpr Vec3d operator-(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] constexpr Vec3d operator*(double s, const Vec3d& a) { return {s * a.x, s * a.y, s * a.z}; }
[[nodiscard]] constexpr double dot(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A coordinate axis. Projecting along X keeps (y, z), along Y (z, x), along Z (x, y): orientation is kept.
enum class Axis : unsigned char { X = 0, Y = 1, Z = 2 };

/// Closed axis-aligned box; default: empty.
struct Box3 {
  Vec3d lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec3d hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  [[nodiscard]] constexpr bool is_empty() const { return !(lo.x <= hi.x); }
  constexpr void extend(const Vec3d& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] < lo[i]) lo[i] = p[i];
      if (p[i] > hi[i]) hi[i] = p[i];
    }
  }
  constexpr void extend(const Box3& b) {
    if (b.is_empty()) return;
    extend(b.lo);
    extend(b.hi);
  }
};

/// From a point to the nearest of a box, 0 inside. NaN stays.
[[nodiscard]] constexpr double square_distance(const Box3& box, const Vec3d& p) {
  const auto outside = [](double lo, double hi, double x) { return x < lo ? lo - x : x > hi ? x - hi : x - x; };
  const Vec3d away{outside(box.lo.x, box.hi.x, p.x), outside(box.lo.y, box.hi.y, p.y), outside(box.lo.z, box.hi.z, p.z)};
  return dot(away, away);
}

/// Do two closed boxes share a point? All comparisons are made: branches would be guessed wrong.
[[nodiscard]] constexpr bool boxes_meet(const Box3& a, const Box3& b) {
  return (a.lo.x <= b.hi.x) & (b.lo.x <= a.hi.x) & (a.lo.y <= b.hi.y) & (b.lo.y <= a.hi.y) & (a.lo.z <= b.hi.z) & (b.lo.z <= a.hi.z);
}

}  // namespace mortise
