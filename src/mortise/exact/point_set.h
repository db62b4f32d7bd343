// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The points of one arrangement, input and made, each with one id; made points are known exactly by how they were made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "mortise/base/ids.h"
#include "mortise/exact/rung.h"
#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise {

using PointId = Id<struct PointTag>;
class BigFloat;
struct DoubleDouble;
template <class T>
struct Homogeneous;

/// Three input points that span a plane (not on one line).
using PlanePoints = std::array<PointId, 3>;
/// Two different input points.
using LinePoints = std::array<PointId, 2>;

/// Every position occurs once: two ids are equal exactly when the points are.
///
/// Made points refer to input points only. They are homogeneous (x, y, z, w) polynomials of the input coordinates: degree
/// (4, 3) for line x plane, (3, 2) for two coplanar lines, (7, 6) for three planes. Every answer is exact and climbs:
/// known by construction, filter on the nearest doubles, double-double with cached bounds, exact. Answers change nothing
/// and may be asked from several threads. A made point takes about 200 bytes, an input point 50.
class PointSet {
 public:
  PointSet();
  ~PointSet();
  PointSet(PointSet&&) noexcept;
  PointSet& operator=(PointSet&&) noexcept;

  void reserve(std::size_t points);

  /// The id of an input point: the same for equal coordinates (-0 equals +0; the first one's bits are kept). Finite only.
  /// All input points come before the first made one.
  PointId add_input(const Vec3d& p);

  /// The point where a line meets a plane that does not contain it and is not parallel to it.
  PointId add_line_plane(const LinePoints& line, const PlanePoints& plane);
  /// The point where two lines of one plane meet; their projections along `axis` are not parallel.
  PointId add_line_line(const LinePoints& first, const LinePoints& second, Axis axis);
  /// The one point common to three planes.
  PointId add_three_planes(const PlanePoints& p, const PlanePoints& q, const PlanePoints& r);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t input_count() const;
  [[nodiscard]] bool is_input(PointId p) const { return p.index() < input_count(); }

  /// The nearest double of every coordinate (ties to even).
  /// @throws Error{OutOfRange} (when the point is added) if a coordinate does not fit a double
  [[nodiscard]] const Vec3d& nearest(PointId p) const;
  /// Is `nearest` the point itself?
  [[nodiscard]] bool is_representable(PointId p) const;
  /// The input points it was made from: itself; four where the line through the first two meets the line through the others; five
  /// where that line meets the plane through the others; nine for three planes.
  [[nodiscard]] std::vector<PointId> definition(PointId p) const;

  /// Side of a plane, Positive where its normal points to (as orient3d).
  [[nodiscard]] Sign side_of_plane(const PlanePoints& plane, PointId p) const;
  /// Orientation of three points projected along `axis`.
  [[nodiscard]] Sign orient2d(PointId a, PointId b, PointId c, Axis axis) const;
  /// Sign of a[coordinate] - b[coordinate], coordinate 0, 1 or 2.
  [[nodiscard]] Sign compare(PointId a, PointId b, std::size_t coordinate) const;

  /// The same answers, and the rungs that gave them.
  [[nodiscard]] Answer explain_side_of_plane(const PlanePoints& plane, PointId p) const;
  [[nodiscard]] Answer explain_orient2d(PointId a, PointId b, PointId c, Axis axis) const;
  [[nodiscard]] Answer explain_compare(PointId a, PointId b, std::size_t coordinate) const;

  /// The point less an origin, within the error bounds that come with the numbers.
  [[nodiscard]] std::array<DoubleDouble, 3> near_offset(PointId p, const Vec3d& origin) const;
  /// The same exactly: offset / w, w > 0.
  [[nodiscard]] Homogeneous<BigFloat> exact_offset(PointId p, const Vec3d& origin) const;

 private:
  struct Storage;
  std::unique_ptr<Storage> storage_;
};

}  // namespace mortise
