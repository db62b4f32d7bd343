// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lengths, areas, volumes and angles, accurate far from the origin and at any scale.
#pragma once

#include <array>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

// Coordinates are first scaled by powers of two; differences and sums are double-double, in the order of the faces. For
// finite coordinates no result is NaN, and it is infinite only when the true one does not fit a double.
// Faces without area are welcome. Indices in range.

[[nodiscard]] double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// The angles at a, b and c; 0 at a corner that equals another.
[[nodiscard]] std::array<double, 3> triangle_angles_deg(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// The box round the vertices that faces use; empty without faces.
[[nodiscard]] Box3 bounding_box(const SurfaceMesh& mesh);

/// The signed volume a closed surface encloses, positive when it is oriented outwards. Of an open one: that of the cones
/// from the centre of its box. Its sign is exact.
[[nodiscard]] double enclosed_volume(const SurfaceMesh& mesh);

struct AngleRange {
  double min_deg = 0;
  double max_deg = 0;
};

struct FaceMeasures {
  double area = 0;    ///< of all faces together
  AngleRange angles;  ///< smallest and largest of any face; zeros without faces
};

[[nodiscard]] FaceMeasures measure_faces(const SurfaceMesh& mesh);

/// The sum of the areas of the faces.
[[nodiscard]] inline double surface_area(const SurfaceMesh& mesh) { return measure_faces(mesh).area; }

}  // namespace mortise
