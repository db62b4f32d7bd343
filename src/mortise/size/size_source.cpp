// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/size_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mortise/base/error.h"
#include "mortise/size/placed_source.h"

namespace mortise {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

bool is_finite(double x) { return std::fabs(x) <= largest; }
bool is_finite(const Vec3d& p) { return is_finite(p.x) && is_finite(p.y) && is_finite(p.z); }

// Empty when there is none.
std::string fault_of(const SizeSource& source) {
  if (source.corner_count < 1 || source.corner_count > 3) return "has " + std::to_string(source.corner_count) + " corners, not 1 to 3";
  if (!std::all_of(source.corners.begin(), source.corners.begin() + source.corner_count, [](const Vec3d& p) { return is_finite(p); }))
    return "has a corner that is not finite";
  if (!is_finite(source.radius) || source.radius < 0) return "has a radius that is negative or not finite";
  if (!is_finite(source.growth) || source.growth < 1) return "has a growth that is below 1 or not finite";
  const std::size_t count = strength_count(source);
  if (!std::all_of(source.strengths.begin(), source.strengths.begin() + count, [](double s) { return is_finite(s) && s > 0; }))
    return "has a size that is not a positive number";
  const PlacedSource placed = place_source(source);
  if (!(placed.least > 0)) return "has sizes that fall below zero between those given";
  if (is_too_thin_to_vary(placed)) return "is a triangle without area: its size cannot vary; take segments";
  return {};
}

SizeSource source_of(std::uint8_t corner_count, const std::array<Vec3d, 3>& corners, double size, double growth) {
  SizeSource source;
  source.corner_count = corner_count;
  source.corners = corners;
  source.strengths[0] = size;
  source.growth = growth;
  return source;
}

}  // namespace

SizeSource point_source(const Vec3d& at, double size, double growth) { return source_of(1, {at, {}, {}}, size, growth); }

SizeSource segment_source(const Vec3d& a, const Vec3d& b, double size, double growth) { return source_of(2, {a, b, {}}, size, growth); }

SizeSource triangle_source(const Vec3d& a, const Vec3d& b, const Vec3d& c, double size, double growth) {
  return source_of(3, {a, b, c}, size, growth);
}

std::size_t strength_count(const SizeSource& source) {
  if (source.order == StrengthOrder::Constant || source.corner_count == 1) return 1;
  if (source.order == StrengthOrder::Linear) return source.corner_count;
  return source.corner_count == 2 ? 3 : 6;
}

void check_sources(std::span<const SizeSource> sources) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string fault = fault_of(sources[i]);
    if (!fault.empty()) throw Error(ErrorCode::InvalidArgument, "sizing_proxy", "source " + std::to_string(i) + " " + fault);
  }
}

}  // namespace mortise
