// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reports as JavaScript objects; the fields are those of the command's JSON.
#pragma once

#include <emscripten/val.h>

#include <span>

#include "mortise/boolean/result.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::wasm {

/// The report on one mesh, equal positions welded. `milliseconds` is left to the caller.
[[nodiscard]] emscripten::val inspection_out(const SurfaceMesh& mesh);

/// Whether the triangles of a result are searched for self-intersections; if not, the report says null.
enum class Search { SelfIntersections, Nothing };

/// The report on a boolean. `milliseconds` is left to the caller.
/// @param half_spaces  positions of operands
[[nodiscard]] emscripten::val boolean_report_out(std::span<const SurfaceMesh* const> operands, std::span<const std::size_t> half_spaces,
                                                 const BooleanResult& result, const ResultRegions& regions, Search search);

}  // namespace mortise::wasm
