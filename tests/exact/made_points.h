// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A PointSet beside the same points in integers of any length.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/cases.h"
#include "exact/oracle.h"
#include "mortise/base/error.h"
#include "mortise/exact/formulas.h"
#include "mortise/exact/point_set.h"

namespace mortise::test {

enum class Form { LinePlane, LineLine, ThreePlanes };
inline constexpr std::array<const char*, 3> form_names{"line x plane", "line x line", "three planes"};

/// Input points and made points, each known to the set by its id and to the oracle by its place in `exact`.
class PointPair {
 public:
  explicit PointPair(const std::vector<Vec3d>& points) : scaled_(oracle::scaled(points)) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PointId id = set.add_input(points[i]);
      if (id.index() == exact.size()) exact.push_back({scaled_.positions[i], 1});
    }
  }

  PointSet set;
  std::vector<oracle::Point> exact;  ///< by PointId
  std::size_t made_twice = 0;        ///< how often a made point was there before

  [[nodiscard]] const oracle::Position& position(PointId input) const { return exact[input.index()].x; }
  [[nodiscard]] oracle::Plane plane(const PlanePoints& p) const { return oracle::plane(position(p[0]), position(p[1]), position(p[2])); }
  [[nodiscard]] double nearest(const oracle::Point& p, std::size_t i) const { return oracle::nearest(p.x[i], p.w, scaled_.exponent); }

  /// Is every coordinate its nearest double?
  [[nodiscard]] bool is_representable(const oracle::Point& p) const {
    bool result = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = nearest(p, i);
      const int exponent = std::min(oracle::lowest_exponent(x), scaled_.exponent);
      result = result && (p.x[i] << static_cast<unsigned>(scaled_.exponent - exponent)) == oracle::scaled(x, exponent) * p.w;
    }
    return result;
  }

  PointId random_point(PointGenerator& random) const { return PointId(random.below(set.size())); }
  PointId random_input(PointGenerator& random) const { return PointId(random.below(set.input_count())); }
  PlanePoints random_plane(PointGenerator& random) const { return {random_input(random), random_input(random), random_input(random)}; }

  /// Makes a point of random inputs, when they make one that fits a double, and checks its id. Nothing when they do not.
  std::optional<PointId> make(Form form, PointGenerator& random) {
    const LinePoints line{random_input(random), random_input(random)}, other_line{random_input(random), random_input(random)};
    const PlanePoints p = random_plane(random), q = random_plane(random), r = random_plane(random);
    if (form == Form::LinePlane) {
      const oracle::Plane plane_p = plane(p);
      if (oracle::is_zero(plane_p.normal)) return std::nullopt;
      return check(oracle::line_plane(position(line[0]), position(line[1]), plane_p), [&] { return set.add_line_plane(line, p); });
    }
    if (form == Form::ThreePlanes) {
      return check(oracle::three_planes(plane(p), plane(q), plane(r)), [&] { return set.add_three_planes(p, q, r); });
    }
    const auto axis = static_cast<Axis>(random.below(3));
    const auto [u, v] = kept_coordinates(axis);
    const std::array<oracle::Position, 4> ends{position(line[0]), position(line[1]), position(other_line[0]), position(other_line[1])};
    if (oracle::orient3d(ends[0], ends[1], ends[2], ends[3]) != Sign::Zero) return std::nullopt;
    return check(oracle::line_line(ends, u, v), [&] { return set.add_line_line(line, other_line, axis); });
  }

 private:
  template <class Add>
  std::optional<PointId> check(const oracle::Point& expected, Add&& add) {
    if (expected.w.is_zero()) return std::nullopt;
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i) fits = fits && std::isfinite(nearest(expected, i));
    try {
      const PointId id = add();
      if (!fits) throw std::logic_error("a coordinate beyond all doubles was accepted");
      std::size_t same = 0;
      while (same < exact.size() && !oracle::are_equal(exact[same], expected)) ++same;
      if (id.index() != same) throw std::logic_error("id " + std::to_string(id.value) + " instead of " + std::to_string(same));
      if (same == exact.size())
        exact.push_back(expected);
      else
        ++made_twice;
      return id;
    } catch (const Error& error) {
      if (fits || error.code != ErrorCode::OutOfRange) throw;
      return std::nullopt;
    }
  }

  oracle::Scaled scaled_;
};

/// Points for a case of this form. For two lines six of them lie in one plane: the points of a flat nature do already, of
/// others a coordinate is made equal.
[[nodiscard]] inline std::vector<Vec3d> points_for(Form form, PointGenerator& random, std::size_t count) {
  std::vector<Vec3d> points = random.points(count);
  if (form != Form::LineLine || random.nature() == Nature::Flat || random.nature() == Nature::Grid) return points;
  const std::size_t axis = random.below(3);
  for (std::size_t i = 0; i < 6; ++i) points[i][axis] = points[0][axis];
  return points;
}

}  // namespace mortise::test
