// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Affine maps of meshes, always in the same order of operations.
#pragma once

#include <array>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The map p -> linear * p + offset. Default: the identity.
struct AffineMap {
  std::array<Vec3d, 3> linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows
  Vec3d offset;
};

[[nodiscard]] AffineMap scaling(const Vec3d& factors);
/// About a coordinate axis, counterclockwise seen against it; multiples of 90 degrees are exact.
[[nodiscard]] AffineMap rotation(Axis axis, double degrees);
[[nodiscard]] AffineMap translation(const Vec3d& offset);
/// In the coordinate plane across the axis.
[[nodiscard]] AffineMap mirroring(Axis axis);

/// The map that does `first`, then `second`; every entry is rounded.
[[nodiscard]] AffineMap compose(const AffineMap& first, const AffineMap& second);

/// Image of a point: each coordinate is ((a x + b y) + c z) + offset, rounded in this order; terms with a zero factor are
/// left out and a factor of one is no operation, so exact maps stay exact for all ranges.
[[nodiscard]] Vec3d apply(const AffineMap& map, const Vec3d& p);

/// The mesh of the images. A map that mirrors also turns every face over, so that outward stays outward. Vectors and normals go
/// along (transform_data).
/// @throws Error{InvalidArgument} if the map has no inverse or an entry is not finite; Error{OutOfRange} with the vertices
/// whose image is not finite, or naming the channel of such a vector
[[nodiscard]] SurfaceMesh transform(const SurfaceMesh& mesh, const AffineMap& map);

/// Data of a mesh moved by an invertible map. Vectors are multiplied by its linear part. Normals stay at right angles to what they
/// were at right angles to, on the same side of it, and keep their length: bit for bit when the map turns by multiples of 90
/// degrees, mirrors, scales alike in all directions or translates. All other values stay.
/// @throws Error{OutOfRange} naming the channel of a vector or normal whose image is not finite
void transform_data(const AffineMap& map, SurfaceMesh& mesh);

}  // namespace mortise
