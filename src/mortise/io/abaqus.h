// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Abaqus input files (.inp), for writing.
#pragma once

#include <string>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// The points as *NODE and the triangles as *ELEMENT of type S3, an element set FACE_7 for each face by its tag. A group of faces is an
/// *ELSET, and a *SURFACE on the positive side, of its name; one of edges or vertices an *NSET. Names are made legal: other characters than
/// letters, digits, "_" and "-" become "_", "G_" comes before one that does not begin with a letter, at most 80 characters are kept, and
/// one that is taken, in any case, gets "_2" and so on; a comment gives the name as it was when that changed it. Regions, boundaries, line
/// and point elements are left out. Coordinates have at most 20 characters, all a field holds: most are bit for bit.
[[nodiscard]] std::string write_abaqus(const EntityMesh& mesh);

}  // namespace mortise
