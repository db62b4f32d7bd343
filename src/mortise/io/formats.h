// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The file formats as one choice: told from name and content, read and written as bytes. No file system here.
#pragma once

#include <string>
#include <string_view>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

enum class Format : unsigned char { Obj, Off, PlyBinary, PlyAscii, StlBinary, StlAscii };

/// "obj", "off", "ply", "ply-ascii", "stl", "stl-ascii".
[[nodiscard]] std::string_view format_name(Format format);

/// The format `format_name` gives this name; the plain extension means the binary kind.
/// @throws Error{UnknownFormat}
[[nodiscard]] Format format_from_name(std::string_view name);

/// The format to write a file of this name in, by its extension in any case.
/// @throws Error{UnknownFormat}
[[nodiscard]] Format format_from_path(std::string_view path);

/// The format of a file: by its content where that is certain, else by the extension of its name (which may be empty), else by the first
/// word of an OBJ statement.
/// @throws Error{UnknownFormat}
[[nodiscard]] Format detect_format(std::string_view name, std::string_view bytes);

/// Does the format keep coordinates as float32 only?
[[nodiscard]] bool is_float32_format(Format format);

/// The mesh in a file, in whatever format it is: equal positions welded, polygons triangulated, names of groups or solids as labels.
/// @throws Error{UnknownFormat, ParseFailed, NotFinite, OutOfRange, BadIndex} naming a line or a byte
[[nodiscard]] SurfaceMesh read_mesh(std::string_view bytes, std::string_view name);

/// The bytes of a file with this mesh.
/// @throws Error{OutOfRange} when a float32 format cannot hold a coordinate
[[nodiscard]] std::string write_mesh(const SurfaceMesh& mesh, Format format);

}  // namespace mortise
