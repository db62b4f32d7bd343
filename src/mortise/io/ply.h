// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Polygon File Format: a header that describes its own columns, then text or binary rows.
#pragma once

#include <string>
#include <string_view>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The mesh of a PLY file of any of the three encodings, equal positions welded, polygons triangulated. Numbers of the
/// vertices become corner data: nx, ny, nz "normal"; s, t or u, v or texture_u, texture_v "uv"; red, green, blue and perhaps alpha "color",
/// from 0 to 1; others channels of their own names. What is no finite number is no value. Properties and elements other than these, the
/// corners and the faces' integers `wall` (SurfaceMesh::walls) and `label` are read over; without faces the mesh has points only. A label
/// is one of the names that comments `label 0 NAME`, `label 1 NAME`, ... of the header give; without these it means nothing.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_ply", naming a line of header and text, a byte of binary rows
[[nodiscard]] SurfaceMesh read_ply(std::string_view bytes);

/// Does the header of this PLY file promise text rows?
[[nodiscard]] bool is_ascii_ply(std::string_view bytes);

/// The mesh as text PLY with doubles, walls and labels as properties of the faces, names of labels as comments; read_ply() gives back the
/// same bits. Data are properties of the vertices, which are copied where corners differ (corners_to_vertices); colours have a byte for
/// each component.
[[nodiscard]] std::string write_ply_ascii(const SurfaceMesh& mesh);

/// The same as little-endian PLY.
[[nodiscard]] std::string write_ply_binary(const SurfaceMesh& mesh);

}  // namespace mortise
