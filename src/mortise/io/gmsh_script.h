// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What Gmsh needs to fill the regions of a surface mesh with tetrahedra.
#pragma once

#include <string>
#include <string_view>

#include "mortise/io/entity_mesh.h"

namespace mortise {

/// A surface in MSH 4.1, and a script that reads it and says which faces bound which volume: `gmsh regions.geo -3` meshes them, faces
/// between regions shared, names as physical groups. Gmsh meshes no region that an MSH file itself defines.
struct GmshProject {
  std::string mesh;
  std::string script;
};

/// @param mesh_file  the name the mesh will have, beside the script; double quotes in names become single ones
[[nodiscard]] GmshProject write_gmsh_project(const EntityMesh& mesh, std::string_view mesh_file);

}  // namespace mortise
