// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The steps of a transformation as JavaScript writes them.
#include "steps.h"

#include <string>

#include "mortise/base/error.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

Axis axis_of(const Vec3d& unit) { return unit.x != 0 ? Axis::X : unit.y != 0 ? Axis::Y : Axis::Z; }

AffineMap map_of_matrix(const val& step) {
  const auto entry = [&](std::size_t row, std::size_t column) { return step[1 + 4 * column + row].as<double>(); };
  if (entry(3, 0) != 0 || entry(3, 1) != 0 || entry(3, 2) != 0 || entry(3, 3) != 1)
    throw Error(ErrorCode::InvalidArgument, "transform", "the last row of the matrix must be 0 0 0 1");
  AffineMap map;
  for (std::size_t row = 0; row < 3; ++row) {
    map.linear[row] = {entry(row, 0), entry(row, 1), entry(row, 2)};
    map.offset[row] = entry(row, 3);
  }
  return map;
}

AffineMap map_of_step(const val& step) {
  const std::string name = step[0].as<std::string>();
  if (name == "matrix") return map_of_matrix(step);
  const Vec3d v{step[1].as<double>(), step[2].as<double>(), step[3].as<double>()};
  if (name == "scale") return scaling(v);
  if (name == "rotateX") return rotation(Axis::X, v.x);
  if (name == "rotateY") return rotation(Axis::Y, v.x);
  if (name == "rotateZ") return rotation(Axis::Z, v.x);
  if (name == "translate") return translation(v);
  if (name == "mirror") return mirroring(axis_of(v));
  throw Error(ErrorCode::InvalidArgument, "transform", "no step has the name " + name);
}

}  // namespace

AffineMap map_of_steps(const val& steps) {
  AffineMap map;
  const std::size_t count = steps["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) map = compose(map, map_of_step(steps[i]));
  return map;
}

}  // namespace mortise::wasm
