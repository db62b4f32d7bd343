// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// VTK's legacy format, text.
#pragma once

#include <string>
#include <string_view>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// Does the text begin as files of VTK's legacy format do?
[[nodiscard]] bool is_vtk(std::string_view bytes);

/// The points, lines and polygons of PolyData or an UnstructuredGrid in text, versions 1 to 5.1; polygons cut into triangles. The entity of
/// a cell is its value in the array `entity` (or CellEntityIds, gmsh:geometrical, medit:ref), its group that in `group` (or gmsh:physical);
/// without the first the groups are the entities. Names of groups come from the field data (write_vtk). Other arrays are read over.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_vtk", naming a line; ParseFailed too for volume and curved cells
[[nodiscard]] EntityMesh read_vtk(std::string_view text);

/// The mesh as an UnstructuredGrid of version 3.0 with cell arrays `entity` and `group`, the tags of a cell's entity and of its first group
/// (0: none). The field data hold the arrays group_dimensions, group_tags and group_names, and entity_groups: dimension and tag of an
/// entity, place of its group. Boundaries, and entities that have neither elements nor groups, are lost, regions too; read_vtk() gives back
/// the rest, every coordinate bit for bit.
[[nodiscard]] std::string write_vtk(const EntityMesh& mesh);

}  // namespace mortise
