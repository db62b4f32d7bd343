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

namespace mortise::wasm {
namespace {

using emscripten::val;

val make(const std::string& name, const val& numbers) {
  return answer([&] {
    std::vector<double> parameters(numbers["length"].as<std::size_t>());
    copy_in<double>(numbers, parameters);
    return mesh_out(make_shape(name, parameters));
  });
}

Axis axis_of(const Vec3d& unit) { return unit.x != 0 ? Axis::X : unit.y != 0 ? Axis::Y : Axis::Z; }

/// @param v  factors, degrees in x, an offset, or the unit vector of an axis
AffineMap map_of_step(const std::string& name, const Vec3d& v) {
  if (name == "scale") return scaling(v);
  if (name == "rotateX") return rotation(Axis::X, v.x);
  if (name == "rotateY") return rotation(Axis::Y, v.x);
  if (name == "rotateZ") return rotation(Axis::Z, v.x);
  if (name == "translate") return translation(v);
  if (name == "mirror") return mirroring(axis_of(v));
  throw Error(ErrorCode::InvalidArgument, "transform", "no step has the name " + name);
}

/// @param steps  arrays [name, x, y, z]
AffineMap map_of(const val& steps) {
  AffineMap map;
  const std::size_t count = steps["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    const val step = steps[i];
    const Vec3d v{step[1].as<double>(), step[2].as<double>(), step[3].as<double>()};
    map = compose(map, map_of_step(step[0].as<std::string>(), v));
  }
  return map;
}

val transform_mesh(const val& mesh, const val& steps) {
  return answer([&] { return mesh_out(transform(mesh_in(mesh), map_of(steps))); });
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
