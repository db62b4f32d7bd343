// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Nastran bulk data (.bdf, .nas), for writing.
#pragma once

#include <string>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// The points as GRID* in large fields and the triangles as CTRIA3, the tag of their face as property. `$HMNAME COMP` comments name the
/// faces that are in a group, by the first; a group of faces is a further comment with their properties, one of edges or vertices a SET1
/// with its nodes and its name in a comment. Regions, boundaries, line and point elements are left out. Coordinates have at most 16
/// characters, all a field holds: about 11 to 15 digits.
/// @throws Error{OutOfRange} from "write_nastran": more nodes or elements, or a higher tag, than the 8 digits of a field hold
[[nodiscard]] std::string write_nastran(const EntityMesh& mesh);

}  // namespace mortise
