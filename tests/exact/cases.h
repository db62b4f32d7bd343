// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random points of every nature the exact core has to answer for, and how a failing case is told.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "mortise/base/bits.h"
#include "mortise/exact/rung.h"
#include "mortise/geom/vec.h"

namespace mortise::test {

enum class Nature {
  Random,      ///< 53 bits in the unit cube
  Single,      ///< 24 bits, what an STL file holds
  Grid,        ///< integers of [-4, 4]: everything degenerate happens
  Flat,        ///< all in one slanted plane, exactly
  NearlyFlat,  ///< all in one plane but for rounding
  AxisFlat,    ///< one coordinate shared by most, the others 60 to 200 bits wide
  Wide,        ///< 60 to 200 bits from the largest to the smallest
  VeryWide,    ///< 2,000 bits
  Subnormal,   ///< small multiples of 2^-1074
  Huge,        ///< up to 2^1000
};
inline constexpr std::size_t nature_count = 10;
inline constexpr std::array<const char*, nature_count> nature_names{"random",    "single", "grid",      "flat",      "nearly flat",
                                                                    "axis flat", "wide",   "very wide", "subnormal", "huge"};

/// Seeded by a case number: a failing case is made again from its number alone.
class PointGenerator {
 public:
  explicit PointGenerator(std::uint64_t seed) : random_(seed), nature_(static_cast<Nature>(seed % nature_count)) {
    width_ = 60 + static_cast<int>(below(141));
    if (nature_ == Nature::VeryWide) {
      const double narrow = 200.0 + static_cast<double>(below(51));
      width_ = static_cast<int>(std::ldexp(narrow, static_cast<int>(below(4))));
    }
    scale_ = below(4) == 0 ? static_cast<int>(below(1900)) - 1000 : 0;
    origin_ = grid(1024);
    u_ = grid(1024);
    v_ = grid(1024);
    if (nature_ == Nature::NearlyFlat) origin_ = origin_ + cube(), u_ = u_ + cube(), v_ = v_ + cube();
    shared_axis_ = below(3);
    shared_ = spread();
  }

  [[nodiscard]] Nature nature() const { return nature_; }
  [[nodiscard]] std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  /// `count` points, some of which repeat a coordinate of an earlier one. Flat natures stay flat.
  [[nodiscard]] std::vector<Vec3d> points(std::size_t count) {
    std::vector<Vec3d> result;
    const bool may_repeat = nature_ != Nature::Flat && nature_ != Nature::NearlyFlat;
    while (result.size() < count) {
      Vec3d p = point();
      const std::size_t axis = below(12);
      if (may_repeat && axis < 3 && !result.empty()) p[axis] = result[below(result.size())][axis];
      result.push_back(p);
    }
    return result;
  }

 private:
  double unit() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }
  double integer(std::uint64_t size) { return static_cast<double>(random_() % (2 * size + 1)) - static_cast<double>(size); }
  Vec3d cube() { return {unit(), unit(), unit()}; }
  Vec3d grid(std::uint64_t size) { return {integer(size), integer(size), integer(size)}; }
  /// Braces at the calls fix the order in which the two factors are drawn.
  [[nodiscard]] Vec3d flat_point(const std::array<double, 2>& factors) const { return origin_ + factors[0] * u_ + factors[1] * v_; }
  /// A number of 1 to 53 bits with an exponent anywhere in the width.
  double spread() {
    const int drop = static_cast<int>(below(53));
    const double mantissa = std::floor(std::ldexp(unit(), 53 - drop));
    const double x = std::ldexp(mantissa, drop - 53 + static_cast<int>(below(static_cast<std::size_t>(width_ - 52))) - width_ / 2);
    return below(2) == 0 ? x : -x;
  }

  Vec3d point() {
    switch (nature_) {
      case Nature::Random:
        return cube();
      case Nature::Single:
        return {static_cast<float>(unit()), static_cast<float>(unit()), static_cast<float>(unit())};
      case Nature::Grid:
        return std::ldexp(1.0, scale_) * grid(4);
      case Nature::Flat:
        return std::ldexp(1.0, scale_ < -900 ? -1074 : scale_) * flat_point({integer(1024), integer(1024)});
      case Nature::NearlyFlat:
        return flat_point({unit(), unit()});
      case Nature::AxisFlat: {
        Vec3d p{spread(), spread(), spread()};
        if (below(8) != 0) p[shared_axis_] = shared_;
        return p;
      }
      case Nature::Wide:
      case Nature::VeryWide:
        return {spread(), spread(), spread()};
      case Nature::Subnormal:
        return 0x1p-1074 * grid(std::uint64_t{1} << (2 + below(40)));
      default:
        return 0x1p1000 * cube();
    }
  }

  std::mt19937_64 random_;
  Nature nature_;
  int width_ = 0;
  int scale_ = 0;
  Vec3d origin_, u_, v_;
  std::size_t shared_axis_ = 0;
  double shared_ = 0;
};

/// The case and its points, bit for bit.
[[nodiscard]] inline std::string describe(std::uint64_t seed, const std::vector<Vec3d>& points) {
  std::string text = "seed " + std::to_string(seed) + ", " + nature_names[seed % nature_count];
  std::array<char, 100> line{};
  for (const Vec3d& p : points) {
    std::snprintf(line.data(), line.size(), "\n  (%a, %a, %a)", p.x, p.y, p.z);
    text += line.data();
  }
  return text;
}

/// How often each rung answered.
class RungTally {
 public:
  void add(Rung rung) { ++counts_[static_cast<std::size_t>(rung)]; }
  [[nodiscard]] std::uint64_t of(Rung rung) const { return counts_[static_cast<std::size_t>(rung)]; }

  void print(const char* predicate) const {
    std::printf("%-28s construction %llu, filter %llu, double-double %llu, expansion %llu, big_float %llu\n", predicate, number(0),
                number(1), number(2), number(3), number(4));
  }

 private:
  [[nodiscard]] unsigned long long number(std::size_t i) const { return counts_[i]; }
  std::array<std::uint64_t, rung_count> counts_{};
};

}  // namespace mortise::test
