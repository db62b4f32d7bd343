// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Gmsh's mesh files: MSH 2.2 and 4.1, text.
#pragma once

#include <string>
#include <string_view>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// Does the text begin with a section of a Gmsh mesh?
[[nodiscard]] bool is_msh(std::string_view bytes);

/// Is that a mesh of version 2?
[[nodiscard]] bool is_msh22(std::string_view bytes);

/// The points, lines, triangles and quadrangles of a text file of version 2 to 2.2 or 4.1; points ascending by the numbers of their nodes,
/// elements of version 4.1 by their own, polygons cut into triangles. In version 2.2 an entity with copies of its elements in several
/// groups belongs to all of them; one whose elements are in different groups becomes an entity for each, the further ones with tags that
/// are free. Other sections are read over.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_msh", naming a line; ParseFailed too for volume and curved
/// elements
[[nodiscard]] EntityMesh read_msh(std::string_view bytes);

/// The mesh as MSH 2.2: elements of an entity in several groups once for each. Boundaries, regions and entities without elements are lost,
/// as double quotes in names are, which become single ones. read_msh() gives back the rest, every coordinate bit for bit.
[[nodiscard]] std::string write_msh22(const EntityMesh& mesh);

/// The mesh as MSH 4.1, all of it but double quotes in names, which become single ones, and the order of entities. Elements have numbers
/// in the order of the mesh, so that read_msh() gives back that order. Gmsh itself saves only entities of groups when there is any group.
[[nodiscard]] std::string write_msh41(const EntityMesh& mesh);

}  // namespace mortise
