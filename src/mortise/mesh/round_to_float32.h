// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh a format of float32 coordinates can hold.
#pragma once

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The mesh with every coordinate rounded to the nearest float32 and what that made of its faces cleaned up.
///
/// Vertices that fell on one position are one, faces that lost a corner are gone, and a face left without area gives its longest edge
/// another diagonal where the two faces there allow it. A closed mesh stays closed. Nothing is proven: inspect() the result. Data become
/// corner data; their values are not rounded.
/// @throws Error{OutOfRange} naming the vertices with a coordinate no float32 holds, and what validate() throws
/// O(n log n)
[[nodiscard]] SurfaceMesh round_to_float32(const SurfaceMesh& mesh);

}  // namespace mortise
