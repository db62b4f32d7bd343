// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The polygons in which a plane cuts a closed mesh.
#pragma once

#include <vector>

#include "mortise/geom/plane.h"
#include "mortise/geom/vec.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

struct Section {
  /// Closed polygons without repetition of the first point, the inside on their left seen from the front of the plane: outer
  /// boundaries run counterclockwise, holes clockwise. In the order of the lowest faces they cut.
  std::vector<std::vector<Vec3d>> polygons;
  std::vector<double> areas;  ///< per polygon, negative for holes
  double area = 0;            ///< of the whole section
};

/// The section of a closed mesh just behind a plane, moved into it: a face that lies in the plane counts where the inside is
/// behind it, so that a box has the area of its top at the height of its top and none at that of its bottom.
///
/// A polygon has a point for each edge it crosses and each vertex it meets; polygons of bodies that touch stay apart, and what
/// has no area is left out. Which side a vertex lies on is decided exactly; each new point is the nearest double of the exact
/// one, vertices in the plane keep their bits. Where the mesh crosses itself, polygons do. Labels and data are left out.
/// @throws what validate() throws; Error{InvalidArgument} if the plane is not finite or has no normal; Error{NotClosed} and
/// Error{NotOriented} naming vertex pairs; Error{OutOfRange} if a point does not fit a double
/// O(n log n) in faces.
[[nodiscard]] Section slice(const SurfaceMesh& mesh, const Plane& plane);

}  // namespace mortise
