// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Object File Format: "OFF", counts, vertices, polygons; one of each per line.
#pragma once

#include <string>
#include <string_view>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The mesh of an OFF text, equal positions welded, polygons triangulated. The prefixes ST, C and N, colours and comments are
/// read over; the format has no labels.
/// @throws Error{ParseFailed, NotFinite, OutOfRange, BadIndex} from "read_off", each naming a line
[[nodiscard]] SurfaceMesh read_off(std::string_view text);

/// The mesh as OFF text; read_off() gives back the same bits. Labels are lost.
[[nodiscard]] std::string write_off(const SurfaceMesh& mesh);

}  // namespace mortise
