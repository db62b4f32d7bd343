// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reports as JavaScript objects; the fields are those of the command's JSON.
#pragma once

#include <emscripten/val.h>

#include <span>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::wasm {

/// The report on one mesh, equal positions welded. `milliseconds` is left to the caller.
[[nodiscard]] emscripten::val inspection_out(const SurfaceMesh& mesh);

/// Whether the triangles of a result are searched for self-intersections; if not, the report says null.
enum class Search { SelfIntersections, Nothing };

/// A boolean: what it was asked, and its answer.
struct EvaluatedCall {
  std::span<const SurfaceMesh* const> operands;
  const BooleanOptions& options;
  const BooleanResult& result;
  const ResultRegions& regions;
};

/// The report on a boolean. `milliseconds` is left to the caller.
[[nodiscard]] emscripten::val boolean_report_out(const EvaluatedCall& call, Search search);

}  // namespace mortise::wasm
