// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// VTK's XML format for unstructured grids, text.
#pragma once

#include <string>
#include <string_view>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// Does the text begin as VTK's XML files do?
[[nodiscard]] bool is_vtu(std::string_view bytes);

/// The points, lines and polygons of an UnstructuredGrid whose arrays are text, its pieces one after the other; entities, groups and names
/// as read_vtk() takes them. Other arrays are read over, of any encoding.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_vtu", naming a line; ParseFailed too for volume and curved cells
[[nodiscard]] EntityMesh read_vtu(std::string_view text);

/// The mesh as an UnstructuredGrid of one piece with the arrays of write_vtk(); names of groups as VTK stores strings in text, the numbers
/// of their bytes with a 0 behind each string. read_vtu() gives back what read_vtk() does.
[[nodiscard]] std::string write_vtu(const EntityMesh& mesh);

}  // namespace mortise
