// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An oracle for booleans in exact rationals, by brute force: it shares no code with the exact, arrange and boolean folders.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::oracle {

using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using RationalPoint = std::array<Rational, 3>;
using Corners = std::array<Vec3d, 3>;

/// The value of a finite double, exactly.
[[nodiscard]] Rational exact(double value);
[[nodiscard]] RationalPoint exact(const Vec3d& point);

/// The double nearest to a rational, ties to even; infinite beyond the range of doubles.
[[nodiscard]] double nearest_double(const Rational& value);
[[nodiscard]] Vec3d nearest_double(const RationalPoint& point);

/// Sign of ((b - a) x (c - a)) . (d - a).
[[nodiscard]] int orient3d(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d);

[[nodiscard]] Corners corners_of(const SurfaceMesh& mesh, std::size_t face);

/// How often the surface winds round a point, by counting what a ray meets; nothing when the point lies on the surface.
[[nodiscard]] std::optional<int> winding_number(const SurfaceMesh& mesh, const RationalPoint& point);

/// Volume enclosed by a closed surface, as a sum of signed tetrahedra.
[[nodiscard]] Rational volume(const SurfaceMesh& mesh);
/// The same over other positions of the vertices, one per vertex.
[[nodiscard]] Rational volume(const SurfaceMesh& mesh, const std::vector<RationalPoint>& positions);

/// Volume common to all operands, each with winding 0 or 1 everywhere: every solid is a sum of signed tetrahedra, and
/// tetrahedra are clipped by one another. At least one operand; small ones only.
[[nodiscard]] Rational common_volume(std::span<const SurfaceMesh* const> operands);

/// Volume of a boolean of operands with winding 0 or 1, from common volumes by inclusion and exclusion; up to six operands.
[[nodiscard]] Rational boolean_volume(Operation operation, std::span<const SurfaceMesh* const> operands);

/// A point a cut makes, and the doubles it must become.
struct MadePoint {
  RationalPoint position;
  Vec3d rounded;
};

/// Every point where faces of the scene meet that is no corner of both: edges through faces, crossing coplanar edges,
/// and triples of faces; one entry per exact point, sorted by the rounded coordinates. Corners lying on other faces are
/// among them. Faces of one operand are intersected with one another only when `self` is set.
[[nodiscard]] std::vector<MadePoint> made_points(std::span<const SurfaceMesh* const> operands, bool self = false);

/// The only points that the faces meeting at a vertex allow: the common point of their planes where these determine it,
/// otherwise the points of all their planes where an edge of one of them crosses a plane, or an edge, of another.
/// Faces of `touching` may be crossed too, but the point need not lie on them. Edges that pass far from the vertex (a
/// millionth of their length, in doubles) are left out to save time. Exact duplicates once.
[[nodiscard]] std::vector<RationalPoint> points_determined_by(const Vec3d& vertex, const std::vector<Corners>& faces,
                                                              const std::vector<Corners>& touching = {});

/// The same without asking that the point lies on all of them: every point that three of the planes, or an edge and a
/// plane, determine and whose doubles are those of the vertex. A vertex that stands for several made points has several.
[[nodiscard]] std::vector<RationalPoint> points_determined_by_some(const Vec3d& vertex, const std::vector<Corners>& faces);

}  // namespace mortise::oracle
