// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A size source in axes of its own, where its closest point takes few operations and slivers do no harm.
#pragma once

#include "mortise/geom/placed_triangle.h"
#include "mortise/size/size_source.h"

namespace mortise {

struct PlacedSource {
  PlacedTriangle shape;
  std::array<double, 6> polynomial{};  ///< the strength: p0 + p1 x + p2 y + p3 xx + p4 xy + p5 yy
  bool is_constant = true;
  double least = 0;     ///< strength anywhere on it
  double steepest = 0;  ///< slope of the strength anywhere on it
  double radius = 0;
  double rate = 0;  ///< growth - 1
};

/// @param source  a checked one
[[nodiscard]] PlacedSource place_source(const SizeSource& source);

/// Is it a triangle lower than 1e-6 of its longest edge, with a strength that is not constant?
[[nodiscard]] bool is_too_thin_to_vary(const PlacedSource& source);

/// The size a source asks for at a point.
[[nodiscard]] double size_from(const PlacedSource& source, const Vec3d& p);

/// size_from changes by no more than this times the way between two points, apart from rounding.
[[nodiscard]] double slope_of(const PlacedSource& source);

}  // namespace mortise
