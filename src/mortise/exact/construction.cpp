// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Comparisons of ids and of doubles; no arithmetic.
#include "mortise/exact/construction.h"

#include <algorithm>
#include <utility>

namespace mortise {

namespace {

void sort_three(PlanePoints& p) {
  if (p[1] < p[0]) std::swap(p[0], p[1]);
  if (p[2] < p[1]) std::swap(p[1], p[2]);
  if (p[1] < p[0]) std::swap(p[0], p[1]);
}

void sort_two(LinePoints& p) {
  if (p[1] < p[0]) std::swap(p[0], p[1]);
}

}  // namespace

Construction Construction::line_plane(LinePoints line, PlanePoints plane) {
  sort_two(line);
  sort_three(plane);
  Construction result;
  result.points = {line[0], line[1], plane[0], plane[1], plane[2]};
  return result;
}

Construction Construction::line_line(LinePoints first, LinePoints second, Axis axis) {
  sort_two(first);
  sort_two(second);
  if (second < first) std::swap(first, second);
  Construction result;
  result.kind = Kind::LineLine;
  result.axis = axis;
  result.points = {first[0], first[1], second[0], second[1]};
  return result;
}

Construction Construction::three_planes(PlanePoints p, PlanePoints q, PlanePoints r) {
  for (PlanePoints* plane : {&p, &q, &r}) sort_three(*plane);
  if (q < p) std::swap(p, q);
  if (r < q) std::swap(q, r);
  if (q < p) std::swap(p, q);
  Construction result;
  result.kind = Kind::ThreePlanes;
  result.points = {p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]};
  return result;
}

PlanePoints Construction::plane(std::size_t i) const {
  const std::size_t first = kind == Kind::LinePlane ? 2 : 3 * i;
  return {points[first], points[first + 1], points[first + 2]};
}

bool Construction::is_made_on(const LinePoints& line) const {
  const auto is_line = [&](std::size_t i) {
    return (points[i] == line[0] && points[i + 1] == line[1]) || (points[i] == line[1] && points[i + 1] == line[0]);
  };
  return kind == Kind::LinePlane ? is_line(0) : kind == Kind::LineLine && (is_line(0) || is_line(2));
}

bool Construction::is_made_in(const PlanePoints& plane) const {
  const auto has = [&](std::size_t i) { return plane[0] == points[i] || plane[1] == points[i] || plane[2] == points[i]; };
  const auto has_line = [&](std::size_t i) { return has(i) && has(i + 1); };
  const auto is_plane = [&](std::size_t i) { return has_line(i) && has(i + 2); };
  if (kind == Kind::ThreePlanes) return is_plane(0) || is_plane(3) || is_plane(6);
  return has_line(0) || (kind == Kind::LineLine ? has_line(2) : is_plane(2));
}

std::optional<double> shared_coordinate(const Construction& construction, const std::array<Vec3d, 9>& points, std::size_t coordinate) {
  using Kind = Construction::Kind;
  const auto value = [&](std::size_t i) { return points[i][coordinate]; };
  const auto line = [&](std::size_t i) { return value(i) == value(i + 1); };
  const auto plane = [&](std::size_t i) { return line(i) && line(i + 1); };
  const Kind kind = construction.kind;
  if (kind == Kind::ThreePlanes ? plane(0) : line(0)) return value(0);
  if (kind == Kind::LineLine ? line(2) : kind == Kind::LinePlane && plane(2)) return value(2);
  if (kind == Kind::ThreePlanes && plane(3)) return value(3);
  if (kind == Kind::ThreePlanes && plane(6)) return value(6);
  return std::nullopt;
}

}  // namespace mortise
