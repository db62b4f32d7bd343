// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How a point was made, and what follows from that alone: which planes and lines it lies on, coordinates it shares.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "mortise/exact/point_set.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// A made point by the input points that define it, in an order that makes equal constructions equal.
struct Construction {
  enum class Kind : std::uint8_t {
    LinePlane,    ///< line points[0..1], plane points[2..4]
    LineLine,     ///< lines points[0..1] and points[2..3], projected along `axis`
    ThreePlanes,  ///< planes points[0..2], points[3..5], points[6..8]
  };
  Kind kind = Kind::LinePlane;
  Axis axis = Axis::X;
  std::array<PointId, 9> points;  ///< unused ones are invalid

  [[nodiscard]] static Construction line_plane(LinePoints line, PlanePoints plane);
  [[nodiscard]] static Construction line_line(LinePoints first, LinePoints second, Axis axis);
  [[nodiscard]] static Construction three_planes(PlanePoints p, PlanePoints q, PlanePoints r);

  /// Equal constructions make equal points; the converse does not hold. The axis does not matter to the point.
  bool operator==(const Construction& other) const { return kind == other.kind && points == other.points; }

  [[nodiscard]] std::size_t point_count() const { return kind == Kind::LinePlane ? 5 : kind == Kind::LineLine ? 4 : 9; }

  /// The lines and planes it was made from. Any two of the planes are transversal.
  [[nodiscard]] std::size_t line_count() const { return kind == Kind::LinePlane ? 1 : kind == Kind::LineLine ? 2 : 0; }
  [[nodiscard]] LinePoints line(std::size_t i) const { return {points[2 * i], points[2 * i + 1]}; }
  [[nodiscard]] std::size_t plane_count() const { return kind == Kind::LinePlane ? 1 : kind == Kind::LineLine ? 0 : 3; }
  [[nodiscard]] PlanePoints plane(std::size_t i) const;

  /// Was the point made from this line, or from this plane or a line through two of its points?
  [[nodiscard]] bool is_made_on(const LinePoints& line) const;
  [[nodiscard]] bool is_made_in(const PlanePoints& plane) const;
};

/// The coordinate that all points of a line or a plane of the construction share, if any: then it is the made point's.
[[nodiscard]] std::optional<double> shared_coordinate(const Construction& construction, const std::array<Vec3d, 9>& points,
                                                      std::size_t coordinate);

}  // namespace mortise
