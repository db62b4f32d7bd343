// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Wavefront OBJ: vertices, polygons, groups, objects, materials.
#pragma once

#include <string>
#include <string_view>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The mesh of an OBJ text, equal positions welded, polygons triangulated. The label of a face is its group, else its object, else
/// its material; `o` ends a group. Texture coordinates and normals are the corner data "uv" (of two components) and "normal"; a
/// corner whose index names none, or no finite numbers, has no value. Lines, points and free-form statements are read over.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_obj", each naming a line
[[nodiscard]] SurfaceMesh read_obj(std::string_view text);

/// The mesh as OBJ text, a group per run of triangles of one label; read_obj() gives back the same bits, labels, "uv" of two
/// components and "normal" of kind Normal. Other data are lost.
[[nodiscard]] std::string write_obj(const SurfaceMesh& mesh);

}  // namespace mortise
