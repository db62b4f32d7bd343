// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Points, segments and triangles that ask for small elements near them (paper 7.3, Fig. 19).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mortise/geom/vec.h"

namespace mortise {

/// How the strength of a source varies along it.
enum class StrengthOrder : std::uint8_t {
  Constant,   ///< strengths[0]
  Linear,     ///< between one value per corner
  Quadratic,  ///< also through the middles: of a segment strengths[2]; of a triangle strengths[3] .. [5] on edges 01, 12, 20
};

/// Elements of edge length S on the source, growing by the factor `growth` from one to the next away from it: in distance D from
/// its closest point S + D (growth - 1). (The paper prints "D n (f - 1)"; n is the asterisk of a footnote.)
struct SizeSource {
  std::uint8_t corner_count = 1;  ///< 1 point, 2 segment, 3 triangle; corners may coincide
  StrengthOrder order = StrengthOrder::Constant;
  std::array<Vec3d, 3> corners{};
  std::array<double, 6> strengths{};  ///< edge lengths; as many as the order says
  double radius = 0;                  ///< D counts from this distance on: a ball, a capsule, a rounded plate of strength S
  double growth = 1.2;                ///< at least 1; 1: the strength reaches everywhere
};

[[nodiscard]] SizeSource point_source(const Vec3d& at, double size, double growth);
[[nodiscard]] SizeSource segment_source(const Vec3d& a, const Vec3d& b, double size, double growth);
[[nodiscard]] SizeSource triangle_source(const Vec3d& a, const Vec3d& b, const Vec3d& c, double size, double growth);

/// How many of the strengths count.
[[nodiscard]] std::size_t strength_count(const SizeSource& source);

/// @throws Error{InvalidArgument} naming the first source that has a coordinate, radius, growth or strength that is not finite, a
///         strength that is not positive somewhere on it, a growth below 1, a negative radius, or no 1 to 3 corners
void check_sources(std::span<const SizeSource> sources);

}  // namespace mortise
