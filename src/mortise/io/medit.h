// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// MEDIT's mesh format (.mesh), text: what mmg, tetgen and others read and write.
#pragma once

#include <string>
#include <string_view>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// Does the text begin as MEDIT files do?
[[nodiscard]] bool is_medit(std::string_view bytes);

/// Vertices, edges, triangles and quadrilaterals of a text, references as tags of entities; 0 and below stand for an entity without a tag.
/// A corner is a point element in the entity its vertex refers to. In two dimensions z is 0. Names of groups come from comments
/// (write_medit). Other lists of numbers are read over.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_medit", naming a line; ParseFailed too for volume and curved
/// elements
[[nodiscard]] EntityMesh read_medit(std::string_view text);

/// The mesh with entities as references, point elements as corners, lines as edges and ridges. The format has no place for names: each
/// entity in a group is a comment line `# group DIMENSION REFERENCE TAG NAME`, the group's tag and name. Boundaries, regions and entities
/// without elements or groups are lost; so are further point elements at one vertex, and the order of the groups. read_medit() gives back
/// the rest, every coordinate bit for bit.
[[nodiscard]] std::string write_medit(const EntityMesh& mesh);

}  // namespace mortise
