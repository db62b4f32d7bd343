// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The generated shapes as command lines and other languages ask for them.
#pragma once

#include <span>
#include <string_view>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The shape of the function make_NAME, extrude or revolve: "box", "sphere", "icosphere", "cylinder", "cone", "torus", "grid_sheet",
/// "extrude", "revolve".
///
/// @param numbers  the function's parameters in their order, points as their coordinates; of extrude and revolve the height or the
/// steps come first, then the polygon
/// @throws Error{InvalidArgument} for an unknown name, a wrong number of numbers, a count that is not a whole number, and what the
/// shape itself refuses
[[nodiscard]] SurfaceMesh make_shape(std::string_view name, std::span<const double> numbers);

}  // namespace mortise
