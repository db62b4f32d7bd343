// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What lies behind a plane, as an operand.
#pragma once

#include "mortise/geom/plane.h"
#include "mortise/geom/vec.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A tetrahedron that holds all of a box that lies behind the plane: face 0 lies in the plane, the others and all four vertices
/// outside the box.
///
/// The plane of face 0 is that of three doubles next to the given plane: the plane itself when it is at right angles to an
/// axis or its numbers are few bits long, else within a few units in the last place of the size of the box.
/// @throws Error{InvalidArgument} if the plane is not finite or has no normal, or the box is empty; Error{OutOfRange} if a
/// vertex does not fit a double
[[nodiscard]] SurfaceMesh make_half_space(const Plane& plane, const Box3& box);

}  // namespace mortise
