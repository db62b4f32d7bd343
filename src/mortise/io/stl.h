// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Stereolithography: triangles without shared vertices, as text or as 50-byte records of float32.
#pragma once

#include <string>
#include <string_view>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Do these bytes have exactly the length their triangle count asks for? Decides before a leading "solid" does: some exporters
/// begin binary files with that word.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

/// Does the text begin with the word "solid" and go on with a facet or the end of the solid?
[[nodiscard]] bool is_ascii_stl(std::string_view bytes);

/// The mesh of a text or binary STL, equal positions welded. Names of solids become labels; normals and the two attribute bytes
/// of binary triangles are read over.
/// @throws Error{ParseFailed, NotFinite, OutOfRange} from "read_stl", naming a line of a text and a byte of a binary file
[[nodiscard]] SurfaceMesh read_stl(std::string_view bytes);

/// The mesh as STL text: a solid per run of triangles of one label; read_stl() gives back every corner bit for bit.
[[nodiscard]] std::string write_stl_ascii(const SurfaceMesh& mesh);

/// The mesh as binary STL: corners rounded to float32, labels lost.
/// @throws Error{OutOfRange} from "write_stl" when a coordinate does not fit a float; the id is the vertex
[[nodiscard]] std::string write_stl_binary(const SurfaceMesh& mesh);

}  // namespace mortise
