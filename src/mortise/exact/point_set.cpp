// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Points keyed by their nearest doubles; what lies between a point and its key decides what doubles cannot.
#include "mortise/exact/point_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/exact/big_float.h"
#include "mortise/exact/construction.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/equal_coordinates.h"
#include "mortise/exact/filters.h"
#include "mortise/exact/formulas.h"
#include "mortise/exact/point_table.h"
#include "mortise/exact/predicates.h"
#include "mortise/exact/rounding.h"

namespace mortise {

using Rounding = std::array<RoundedCoordinate, 3>;
using ThreePoints = std::array<PointId, 3>;

/// Arrays over all points (nearest) and over made points only (the others).
struct PointSet::Storage {
  std::vector<Vec3d> nearest;
  PointTable table;
  std::size_t input_count = 0;
  std::vector<Construction> constructions;
  std::vector<Rounding> roundings;
  std::vector<std::unique_ptr<const Homogeneous<BigFloat>>> hard;  // coordinates of the points double-double cannot tell from their nearest

  [[nodiscard]] bool is_input(PointId p) const { return p.index() < input_count; }
  [[nodiscard]] const Vec3d& position(PointId p) const { return nearest[p.index()]; }
  [[nodiscard]] const Construction& construction(PointId p) const { return constructions[p.index() - input_count]; }
  [[nodiscard]] const Rounding& rounding(PointId p) const { return roundings[p.index() - input_count]; }
  [[nodiscard]] const Vec3d& base(PointId p) const { return position(is_input(p) ? p : construction(p).points[0]); }

  [[nodiscard]] RoundedCoordinate rounded(PointId p, std::size_t coordinate) const {
    return is_input(p) ? RoundedCoordinate{position(p)[coordinate], 0, 0, Sign::Zero} : rounding(p)[coordinate];
  }

  [[nodiscard]] std::array<Vec3d, 9> defining_points(const Construction& construction) const;
  /// |nearest - coordinate| is at most 2^-53 of this.
  [[nodiscard]] double size_of_rounding(PointId p, std::size_t coordinate) const {
    if (is_input(p)) return 0;
    const RoundedCoordinate& r = rounding(p)[coordinate];
    return r.side == Sign::Zero ? 0 : std::fabs(r.nearest) + std::numeric_limits<double>::min();
  }
  [[nodiscard]] filters::NearPoint near_point(PointId p) const {
    return {position(p), {size_of_rounding(p, 0), size_of_rounding(p, 1), size_of_rounding(p, 2)}};
  }
  [[nodiscard]] filters::NearCoordinates near_coordinates(PointId p, std::size_t u, std::size_t v) const {
    return {position(p)[u], position(p)[v], size_of_rounding(p, u), size_of_rounding(p, v)};
  }

  [[nodiscard]] Homogeneous<BigFloat> exact_about(const Vec3d& origin, PointId p) const;
  [[nodiscard]] bool is_same(PointId p, const Construction& made, const Rounding& made_rounding) const;
  [[nodiscard]] PointId add_made(const Construction& construction);

  [[nodiscard]] bool is_known_in_plane(PointId p, const PlanePoints& plane) const;
  [[nodiscard]] bool is_known_on_line(PointId p, const LinePoints& line) const;
  [[nodiscard]] bool share_known_line(const ThreePoints& points) const;
  [[nodiscard]] bool share_known_planes(const ThreePoints& points) const;
  [[nodiscard]] bool has_transversal_to_line(const ThreePoints& points, std::span<const PlanePoints> shared) const;

  [[nodiscard]] std::optional<Sign> side_of_axis_plane(const PlanePoints& plane, PointId p) const;
  [[nodiscard]] DoubleDouble near_side_of_plane(const PlanePoints& plane, PointId p) const;
  [[nodiscard]] Sign exact_side_of_plane(const PlanePoints& plane, PointId p) const;
  [[nodiscard]] DoubleDouble near_orient2d(const ThreePoints& points, Axis axis) const;
  [[nodiscard]] Sign exact_orient2d(ThreePoints points, Axis axis) const;
};

namespace {

bool contains(const PlanePoints& plane, PointId p) { return plane[0] == p || plane[1] == p || plane[2] == p; }

template <class Range, class Holds>
bool all_of(const Range& range, Holds&& holds) {
  return std::all_of(range.begin(), range.end(), holds);
}

/// Nothing when both coordinates lie on the same side of the same double and double-double cannot tell them apart.
std::optional<Sign> compare_rounded(const RoundedCoordinate& a, const RoundedCoordinate& b) {
  if (a.nearest != b.nearest) return a.nearest < b.nearest ? Sign::Negative : Sign::Positive;
  if (a.side != b.side) return a.side < b.side ? Sign::Negative : Sign::Positive;
  if (a.side == Sign::Zero) return Sign::Zero;
  return certain_sign(a.value() - b.value());
}

/// Both about one origin.
Sign compare_exact(const Homogeneous<BigFloat>& a, const Homogeneous<BigFloat>& b, std::size_t coordinate) {
  return (a.offset[coordinate] * b.w - b.offset[coordinate] * a.w).sign();
}

/// base + offset / w about another origin.
Homogeneous<BigFloat> about(const Vec3d& origin, const Vec3d& base, Homogeneous<BigFloat> point) {
  const Triple<BigFloat> shift = scaled(point.w, difference<BigFloat>(base, origin));
  for (std::size_t i = 0; i < 3; ++i) point.offset[i] = shift[i] + point.offset[i];
  return point;
}

}  // namespace

// ------------------------------------------------------------------------------------------------ what a point is

std::array<Vec3d, 9> PointSet::Storage::defining_points(const Construction& construction) const {
  std::array<Vec3d, 9> points;
  for (std::size_t i = 0; i < construction.point_count(); ++i) points[i] = position(construction.points[i]);
  return points;
}

Homogeneous<BigFloat> PointSet::Storage::exact_about(const Vec3d& origin, PointId p) const {
  if (is_input(p)) return {difference<BigFloat>(position(p), origin), BigFloat(1)};
  const auto& known = hard[p.index() - input_count];
  return about(origin, base(p), known ? *known : exact_point(construction(p), defining_points(construction(p))));
}

bool PointSet::Storage::is_same(PointId p, const Construction& made, const Rounding& made_rounding) const {
  if (!is_input(p) && construction(p) == made) return true;
  bool is_certain = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto order = compare_rounded(made_rounding[i], rounded(p, i));
    if (order && *order != Sign::Zero) return false;
    is_certain = is_certain && order;
  }
  if (is_certain) return true;
  const Vec3d& origin = position(made.points[0]);
  const Homogeneous<BigFloat> a = exact_point(made, defining_points(made));
  const Homogeneous<BigFloat> b = exact_about(origin, p);
  return compare_exact(a, b, 0) == Sign::Zero && compare_exact(a, b, 1) == Sign::Zero && compare_exact(a, b, 2) == Sign::Zero;
}

PointId PointSet::Storage::add_made(const Construction& construction) {
  RoundedPoint rounded_point = round_point(construction, defining_points(construction));
  const Rounding& rounding = rounded_point.coordinates;
  const Vec3d key{rounding[0].nearest, rounding[1].nearest, rounding[2].nearest};
  const PointId known = table.find(nearest, key, [&](PointId p) { return is_same(p, construction, rounding); });
  if (known.is_valid()) return known;
  nearest.push_back(key);
  constructions.push_back(construction);
  roundings.push_back(rounding);
  const bool is_nearest = all_of(rounding, [](const RoundedCoordinate& r) { return r.side == Sign::Zero; });
  hard.push_back(is_nearest ? nullptr : std::move(rounded_point.exact));
  table.insert_last(nearest);
  return PointId(nearest.size() - 1);
}

// ---------------------------------------------------------------------------------------- known by construction

bool PointSet::Storage::is_known_in_plane(PointId p, const PlanePoints& plane) const {
  return is_input(p) ? contains(plane, p) : construction(p).is_made_in(plane);
}

bool PointSet::Storage::is_known_on_line(PointId p, const LinePoints& line) const {
  return is_input(p) ? p == line[0] || p == line[1] : construction(p).is_made_on(line);
}

/// Is one of the points made on a line that the other two are known to lie on?
bool PointSet::Storage::share_known_line(const ThreePoints& points) const {
  for (const PointId p : points) {
    for (std::size_t i = 0; !is_input(p) && i < construction(p).line_count(); ++i) {
      const LinePoints line = construction(p).line(i);
      if (all_of(points, [&](PointId q) { return is_known_on_line(q, line); })) return true;
    }
  }
  return false;
}

/// Are the points known to lie in two transversal planes?
bool PointSet::Storage::share_known_planes(const ThreePoints& points) const {
  const auto hold_all = [&](const PlanePoints& plane) { return all_of(points, [&](PointId q) { return is_known_in_plane(q, plane); }); };
  std::array<PlanePoints, 9> shared;
  std::size_t count = 0;
  for (const PointId p : points) {
    const std::size_t first_of_p = count;
    for (std::size_t i = 0; !is_input(p) && i < construction(p).plane_count(); ++i) {
      const PlanePoints plane = construction(p).plane(i);
      if (hold_all(plane)) shared[count++] = plane;
    }
    if (count >= first_of_p + 2) return true;
  }
  return has_transversal_to_line(points, {shared.data(), count});
}

/// A plane that cuts the line of a point, and a plane that holds this line, are transversal.
bool PointSet::Storage::has_transversal_to_line(const ThreePoints& points, std::span<const PlanePoints> shared) const {
  for (const PointId p : points) {
    if (is_input(p) || construction(p).kind != Construction::Kind::LinePlane) continue;
    const LinePoints line = construction(p).line(0);
    const PlanePoints cut = construction(p).plane(0);
    const bool is_cut_shared = std::find(shared.begin(), shared.end(), cut) != shared.end();
    const auto holds_line = [&](const PlanePoints& plane) { return contains(plane, line[0]) && contains(plane, line[1]); };
    if (is_cut_shared && std::any_of(shared.begin(), shared.end(), holds_line)) return true;
  }
  return false;
}

// ------------------------------------------------------------------------------------------------- side of a plane

/// A plane of one coordinate only asks for a comparison.
std::optional<Sign> PointSet::Storage::side_of_axis_plane(const PlanePoints& plane, PointId p) const {
  const Vec3d &a = position(plane[0]), &b = position(plane[1]), &c = position(plane[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] != b[i] || a[i] != c[i]) continue;
    const auto order = compare_rounded(rounded(p, i), {a[i], 0, 0, Sign::Zero});
    return *order * mortise::orient2d(a, b, c, static_cast<Axis>(i));
  }
  return std::nullopt;
}

DoubleDouble PointSet::Storage::near_side_of_plane(const PlanePoints& plane, PointId p) const {
  const Vec3d& a = position(plane[0]);
  Triple<DoubleDouble> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = rounded(p, i).value() - DoubleDouble{a[i], 0, 0};
  return dot(normal<DoubleDouble>(a, position(plane[1]), position(plane[2])), d);
}

Sign PointSet::Storage::exact_side_of_plane(const PlanePoints& plane, PointId p) const {
  const Vec3d& a = position(plane[0]);
  return dot(normal<BigFloat>(a, position(plane[1]), position(plane[2])), exact_about(a, p).offset).sign();
}

Answer PointSet::explain_side_of_plane(const PlanePoints& plane, PointId p) const {
  const Storage& s = *storage_;
  if (s.is_known_in_plane(p, plane)) return {Sign::Zero, Rung::Construction};
  const Vec3d &a = s.position(plane[0]), &b = s.position(plane[1]), &c = s.position(plane[2]);
  if (s.is_input(p)) return explain_orient3d(a, b, c, s.position(p));
  if (const auto sign = filters::orient3d(a, b, c, s.near_point(p))) return {*sign, Rung::Filter};
  if (const auto sign = s.side_of_axis_plane(plane, p)) return {*sign, Rung::Construction};
  if (const auto sign = certain_sign(s.near_side_of_plane(plane, p))) return {*sign, Rung::DoubleDouble};
  return {s.exact_side_of_plane(plane, p), Rung::BigFloat};
}

// ------------------------------------------------------------------------------------------ order and orientation

DoubleDouble PointSet::Storage::near_orient2d(const ThreePoints& points, Axis axis) const {
  const auto [u, v] = kept_coordinates(axis);
  const auto from_first = [&](std::size_t i, std::size_t coordinate) {
    return rounded(points[i], coordinate).value() - rounded(points[0], coordinate).value();
  };
  return determinant(from_first(1, u), from_first(1, v), from_first(2, u), from_first(2, v));
}

/// An input point becomes the origin: then two of the three terms vanish.
Sign PointSet::Storage::exact_orient2d(ThreePoints points, Axis axis) const {
  const auto [u, v] = kept_coordinates(axis);
  std::rotate(points.begin(), std::find_if(points.begin(), points.end() - 1, [&](PointId p) { return is_input(p); }), points.end());
  const Vec3d& origin = base(points[0]);
  const Homogeneous<BigFloat> b = exact_about(origin, points[1]);
  const Homogeneous<BigFloat> c = exact_about(origin, points[2]);
  if (is_input(points[0])) return determinant(b.offset[u], b.offset[v], c.offset[u], c.offset[v]).sign();
  const Homogeneous<BigFloat> a = exact_about(origin, points[0]);
  const Triple<BigFloat> bc = cross(Triple<BigFloat>{b.offset[u], b.offset[v], b.w}, Triple<BigFloat>{c.offset[u], c.offset[v], c.w});
  return dot(Triple<BigFloat>{a.offset[u], a.offset[v], a.w}, bc).sign();
}

Answer PointSet::explain_orient2d(PointId a, PointId b, PointId c, Axis axis) const {
  const Storage& s = *storage_;
  if (a == b || b == c || c == a) return {Sign::Zero, Rung::Construction};
  if (s.is_input(a) && s.is_input(b) && s.is_input(c)) {
    return mortise::explain_orient2d(s.position(a), s.position(b), s.position(c), axis);
  }
  const auto [u, v] = kept_coordinates(axis);
  const auto sign_of_near = filters::orient2d(s.near_coordinates(a, u, v), s.near_coordinates(b, u, v), s.near_coordinates(c, u, v));
  if (sign_of_near) return {*sign_of_near, Rung::Filter};
  const ThreePoints points{a, b, c};
  if (s.share_known_line(points) || s.share_known_planes(points)) return {Sign::Zero, Rung::Construction};
  const auto compare_near = [&](std::size_t i, std::size_t j, std::size_t coordinate) {
    return compare_rounded(s.rounded(points[i], coordinate), s.rounded(points[j], coordinate));
  };
  if (const auto sign = orient2d_of_equal_coordinates(axis, compare_near)) return {*sign, Rung::Construction};
  if (const auto sign = certain_sign(s.near_orient2d(points, axis))) return {*sign, Rung::DoubleDouble};
  return {s.exact_orient2d(points, axis), Rung::BigFloat};
}

Answer PointSet::explain_compare(PointId a, PointId b, std::size_t coordinate) const {
  const Storage& s = *storage_;
  if (a == b) return {Sign::Zero, Rung::Construction};
  const RoundedCoordinate x = s.rounded(a, coordinate), y = s.rounded(b, coordinate);
  const bool is_beside = x.nearest != y.nearest || x.side != y.side || x.side == Sign::Zero;
  if (const auto sign = compare_rounded(x, y)) return {*sign, is_beside ? Rung::Filter : Rung::DoubleDouble};
  const Vec3d& origin = s.base(a);
  return {compare_exact(s.exact_about(origin, a), s.exact_about(origin, b), coordinate), Rung::BigFloat};
}

// ------------------------------------------------------------------------------------------------ the public class

PointSet::PointSet() : storage_(std::make_unique<Storage>()) {}
PointSet::~PointSet() = default;
PointSet::PointSet(PointSet&&) noexcept = default;
PointSet& PointSet::operator=(PointSet&&) noexcept = default;

void PointSet::reserve(std::size_t points) {
  storage_->nearest.reserve(points);
  storage_->table.rebuild(storage_->nearest, points);
}

PointId PointSet::add_input(const Vec3d& p) {
  Storage& s = *storage_;
  MORTISE_CHECK(s.constructions.empty(), "an input point after a made one");
  const PointId known = s.table.find(s.nearest, p, [](PointId) { return true; });
  if (known.is_valid()) return known;
  s.nearest.push_back(p);
  s.input_count = s.nearest.size();
  s.table.insert_last(s.nearest);
  return PointId(s.input_count - 1);
}

PointId PointSet::add_line_plane(const LinePoints& line, const PlanePoints& plane) {
  return storage_->add_made(Construction::line_plane(line, plane));
}

PointId PointSet::add_line_line(const LinePoints& first, const LinePoints& second, Axis axis) {
  return storage_->add_made(Construction::line_line(first, second, axis));
}

PointId PointSet::add_three_planes(const PlanePoints& p, const PlanePoints& q, const PlanePoints& r) {
  return storage_->add_made(Construction::three_planes(p, q, r));
}

std::size_t PointSet::size() const { return storage_->nearest.size(); }

std::size_t PointSet::input_count() const { return storage_->input_count; }

const Vec3d& PointSet::nearest(PointId p) const { return storage_->position(p); }

bool PointSet::is_representable(PointId p) const {
  const Storage& s = *storage_;
  if (s.is_input(p)) return true;
  return all_of(s.rounding(p), [](const RoundedCoordinate& r) { return r.side == Sign::Zero; });
}

std::vector<PointId> PointSet::definition(PointId p) const {
  if (is_input(p)) return {p};
  const Construction& made = storage_->construction(p);
  return {made.points.data(), made.points.data() + made.point_count()};
}

std::array<DoubleDouble, 3> PointSet::near_offset(PointId p, const Vec3d& origin) const {
  std::array<DoubleDouble, 3> offset;
  for (std::size_t i = 0; i < 3; ++i) offset[i] = storage_->rounded(p, i).value() - DoubleDouble{origin[i], 0, 0};
  return offset;
}

Homogeneous<BigFloat> PointSet::exact_offset(PointId p, const Vec3d& origin) const { return storage_->exact_about(origin, p); }

Sign PointSet::side_of_plane(const PlanePoints& plane, PointId p) const { return explain_side_of_plane(plane, p).sign; }

Sign PointSet::orient2d(PointId a, PointId b, PointId c, Axis axis) const { return explain_orient2d(a, b, c, axis).sign; }

Sign PointSet::compare(PointId a, PointId b, std::size_t coordinate) const { return explain_compare(a, b, coordinate).sign; }

}  // namespace mortise
