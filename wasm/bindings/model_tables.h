// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The tables of models, out and back in.
#pragma once

#include <emscripten/val.h>

#include "mortise/brep/model_queries.h"

namespace mortise::wasm {

/// The arrays of ModelTables.
[[nodiscard]] emscripten::val tables_out(const ModelView& view);

/// The model with these tables; measures and voids are not looked at.
/// @param object  what tables_out gave
/// @throws Error{InvalidArgument} when they are not those of a model of this mesh
[[nodiscard]] ClassifiedBrep tables_in(const emscripten::val& object, const SurfaceMesh& mesh);

}  // namespace mortise::wasm
