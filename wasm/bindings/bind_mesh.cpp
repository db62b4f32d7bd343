// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes without booleans: shapes, transforms, reports.
#include <emscripten/bind.h>

#include <array>
#include <string>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "mortise/mesh/round_to_float32.h"
#include "mortise/mesh/shape_by_name.h"
#include "mortise/mesh/transform.h"
#include "report.h"
#include "steps.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

val make(const std::string& name, const val& numbers) {
  return answer([&] { return mesh_out(make_shape(name, numbers_in<double>(numbers))); });
}

val transform_mesh(const val& mesh, const val& steps) {
  return answer([&] { return mesh_out(transform(mesh_in(mesh), map_of_steps(steps))); });
}

val round_mesh(const val& mesh) {
  return answer([&] { return mesh_out(round_to_float32(mesh_in(mesh))); });
}

val inspect_mesh(const val& mesh) {
  return answer([&] { return inspection_out(mesh_in(mesh)); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_mesh) {
  emscripten::function("makeShape", &make);
  emscripten::function("transformMesh", &transform_mesh);
  emscripten::function("roundToFloat32", &round_mesh);
  emscripten::function("inspectMesh", &inspect_mesh);
}

}  // namespace mortise::wasm
