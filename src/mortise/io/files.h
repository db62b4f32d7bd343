// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes in files of the machine. Where there is no file system every call fails with FileFailed.
#pragma once

#include <string>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The bytes of a file.
/// @throws Error{FileFailed}
[[nodiscard]] std::string read_file(const std::string& path);

/// Replaces a file by these bytes.
/// @throws Error{FileFailed}; the file may then be incomplete
void write_file(const std::string& path, const std::string& bytes);

/// The mesh in a file, see read_mesh().
/// @throws Error{FileFailed} and what read_mesh() throws
[[nodiscard]] SurfaceMesh read_mesh_file(const std::string& path);

/// Writes a mesh in the format its name ends in, see format_from_path() and write_mesh().
/// @throws Error{FileFailed, UnknownFormat, OutOfRange}
void write_mesh_file(const std::string& path, const SurfaceMesh& mesh);

}  // namespace mortise
