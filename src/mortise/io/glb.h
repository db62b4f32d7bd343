// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Binary glTF 2.0, for viewers and engines: written, not read.
#pragma once

#include <string>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The mesh as one node with a primitive and a material for every label that a triangle has, named as the label. Primitives share their
/// vertices, so the surface stays closed across labels; vertices without triangles are left out.
///
/// Coordinates are rounded to float32 and otherwise as they are: glTF's own up is y. Data "normal" (3 components), "uv" (2, the second
/// turned over, glTF's images begin at the top) and "color" (3 or 4, from 0 to 1) of vertices or corners go along, vertices copied where
/// corners differ; 0 where there is no value, the normal of the triangle where a normal has none. Without normals viewers shade flat.
/// @throws Error{OutOfRange} from "write_glb" when a coordinate does not fit a float, naming the vertices, or the file its 32-bit length;
///         what validate() throws
[[nodiscard]] std::string write_glb(const SurfaceMesh& mesh);

}  // namespace mortise
