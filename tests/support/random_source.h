// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random numbers that are the same for the same seed with every compiler: only the bits of the engine are used.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "mortise/geom/vec.h"

namespace mortise::test {

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// A whole number in [0, bound).
  [[nodiscard]] std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() >> 32) % bound; }
  [[nodiscard]] bool once_in(std::size_t times) { return below(times) == 0; }
  [[nodiscard]] double between(double lo, double hi) { return lo + (hi - lo) * std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  /// Between 2^low and 2^high, every power of two equally often.
  [[nodiscard]] double octaves(int low, int high) {
    const int exponent = low + static_cast<int>(below(static_cast<std::size_t>(high - low)));
    return std::ldexp(between(1, 2), exponent);
  }
  /// A whole number from lo to hi, small ones as often as large ones; 0 < lo <= hi.
  [[nodiscard]] std::size_t size(std::size_t lo, std::size_t hi) {
    int doublings = 0;
    while ((lo << doublings) < hi) ++doublings;
    const auto drawn = doublings == 0 ? lo : static_cast<std::size_t>(static_cast<double>(lo) * octaves(0, doublings));
    return drawn < hi ? drawn : hi;
  }
  [[nodiscard]] Vec3d point(double lo, double hi) {
    const double x = between(lo, hi), y = between(lo, hi), z = between(lo, hi);
    return {x, y, z};
  }
  /// A vector of length 1, rounded; all directions alike.
  [[nodiscard]] Vec3d direction() {
    for (;;) {
      const Vec3d p = point(-1, 1);
      if (const double square = dot(p, p); square > 0.01 && square <= 1) return (1 / std::sqrt(square)) * p;
    }
  }
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mortise::test
