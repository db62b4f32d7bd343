// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The regions leave the mesh and become volumes of the script.
#include "mortise/io/gmsh_script.h"

#include <algorithm>

#include "mortise/io/msh.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

std::string quoted(std::string_view text) {
  std::string result(text);
  std::replace(result.begin(), result.end(), '"', '\'');
  return '"' + result + '"';
}

// The other names move up.
EntityMesh without_regions(const EntityMesh& mesh) {
  EntityMesh surface = mesh;
  surface.entities[3].clear();
  std::vector<std::uint32_t> place;
  surface.names.clear();
  for (const PhysicalName& name : mesh.names) {
    place.push_back(static_cast<std::uint32_t>(surface.names.size()));
    if (name.dimension != 3) surface.names.push_back(name);
  }
  for (std::vector<MeshEntity>& entities : surface.entities) {
    for (MeshEntity& entity : entities) {
      for (std::uint32_t& name : entity.names) name = place[name];
    }
  }
  return surface;
}

std::string volume_statements(const MeshEntity& region) {
  const std::string tag = std::to_string(region.tag);
  std::string faces;
  for (const std::int32_t face : region.boundary) faces.append(faces.empty() ? "" : ", ").append(std::to_string(face));
  return "Surface Loop(" + tag + ") = {" + faces + "};\nVolume(" + tag + ") = {" + tag + "};\n";
}

std::string group_statement(const EntityMesh& mesh, std::uint32_t name) {
  std::string regions;
  for (const MeshEntity& region : mesh.entities[3]) {
    if (std::find(region.names.begin(), region.names.end(), name) == region.names.end()) continue;
    regions.append(regions.empty() ? "" : ", ").append(std::to_string(region.tag));
  }
  const PhysicalName& group = mesh.names[name];
  return "Physical Volume(" + quoted(one_line_name(spoken_name(group))) + ", " + std::to_string(group.tag) + ") = {" + regions + "};\n";
}

}  // namespace

GmshProject write_gmsh_project(const EntityMesh& mesh, std::string_view mesh_file) {
  std::string script = "Merge " + quoted(mesh_file) + ";\n";
  for (const MeshEntity& region : mesh.entities[3]) script += volume_statements(region);
  for (std::uint32_t n = 0; n < mesh.names.size(); ++n) {
    if (mesh.names[n].dimension == 3) script += group_statement(mesh, n);
  }
  return {write_msh41(without_regions(mesh)), script};
}

}  // namespace mortise
