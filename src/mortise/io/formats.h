// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The file formats as one choice: told from name and content, read and written as bytes. No file system here.
#pragma once

#include <string>
#include <string_view>

#include "mortise/io/entity_mesh.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

enum class Format : unsigned char {
  Obj,
  Off,
  PlyBinary,
  PlyAscii,
  StlBinary,
  StlAscii,
  Glb,
  Msh41,
  Msh22,
  Vtk,
  Vtu,
  Medit,
  Abaqus,
  Nastran
};

/// "obj", "off", "ply", "ply-ascii", "stl", "stl-ascii", "glb", "msh", "msh22", "vtk", "vtu", "mesh", "inp", "bdf".
[[nodiscard]] std::string_view format_name(Format format);

/// The format `format_name` gives this name; the plain extension means the binary kind, or the newest version.
/// @throws Error{UnknownFormat}
[[nodiscard]] Format format_from_name(std::string_view name);

/// The format to write a file of this name in, by its extension in any case; ".nas" is bdf.
/// @throws Error{UnknownFormat}
[[nodiscard]] Format format_from_path(std::string_view path);

/// Can files of the format be read? All but glb, inp and bdf, which are written only.
[[nodiscard]] bool is_readable_format(Format format);

/// Is it a format of analysis programs, which keep entities of models and groups? msh, msh22, vtk, vtu, mesh, inp and bdf.
[[nodiscard]] bool is_analysis_format(Format format);

/// The format of a file that can be read: by its content where that is certain, else by the extension of its name (which may be empty),
/// else by the first word of an OBJ statement.
/// @throws Error{UnknownFormat}
[[nodiscard]] Format detect_format(std::string_view name, std::string_view bytes);

/// Does the format keep coordinates as float32 only?
[[nodiscard]] bool is_float32_format(Format format);

/// The mesh in a file, in whatever format it is: equal positions welded, polygons triangulated, names of groups or solids as labels
/// (surface_mesh_of).
/// @throws Error{UnknownFormat, ParseFailed, NotFinite, OutOfRange, BadIndex} naming a line or a byte
[[nodiscard]] SurfaceMesh read_mesh(std::string_view bytes, std::string_view name);

/// The bytes of a file with this mesh; formats of analysis programs get a face for each label (entity_mesh_of).
/// @throws Error{OutOfRange} when a float32 format cannot hold a coordinate, or a format so many triangles
[[nodiscard]] std::string write_mesh(const SurfaceMesh& mesh, Format format);

/// What the file of an analysis program holds, points that are equal as they are; of other formats entity_mesh_of(read_mesh()).
/// @throws what read_mesh() throws
[[nodiscard]] EntityMesh read_entity_mesh(std::string_view bytes, std::string_view name);

/// The bytes of a file with as much of this mesh as the format holds: its own header says what. Formats that are not of analysis programs
/// get surface_mesh_of() it. The mesh is sound: indices in range, tags and memberships as EntityMesh says.
/// @throws what write_mesh() throws
[[nodiscard]] std::string write_entity_mesh(const EntityMesh& mesh, Format format);

}  // namespace mortise
