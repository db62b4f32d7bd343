// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The generated shapes as command lines and other languages ask for them.
#include "mortise/mesh/shape_by_name.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/mesh/shapes.h"

namespace mortise {
namespace {

using Numbers = std::span<const double>;

std::uint32_t count_from(double number) {
  constexpr double largest = 4294967295.0;
  if (number >= 0 && number <= largest && std::floor(number) == number) return static_cast<std::uint32_t>(number);
  throw Error(ErrorCode::InvalidArgument, "make_shape", "a count must be a whole number from 0 to 4294967295");
}

std::vector<Vec2d> polygon_from(Numbers numbers) {
  std::vector<Vec2d> polygon(numbers.size() / 2);
  for (std::size_t i = 0; i < polygon.size(); ++i) polygon[i] = {numbers[2 * i], numbers[2 * i + 1]};
  return polygon;
}

/// A shape with its number of numbers; 0: one and then any number of pairs.
struct NamedShape {
  std::string_view name;
  std::size_t number_count;
  SurfaceMesh (*make)(Numbers n);
};

constexpr std::array<NamedShape, 9> named_shapes{{
    {"box", 6,
     [](Numbers n) {
       return make_box({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
     }},
    {"sphere", 3, [](Numbers n) { return make_sphere(n[0], count_from(n[1]), count_from(n[2])); }},
    {"icosphere", 2, [](Numbers n) { return make_icosphere(n[0], count_from(n[1])); }},
    {"cylinder", 3, [](Numbers n) { return make_cylinder(n[0], n[1], count_from(n[2])); }},
    {"cone", 3, [](Numbers n) { return make_cone(n[0], n[1], count_from(n[2])); }},
    {"torus", 4, [](Numbers n) { return make_torus(n[0], n[1], count_from(n[2]), count_from(n[3])); }},
    {"grid_sheet", 4, [](Numbers n) { return make_grid_sheet(n[0], n[1], count_from(n[2]), count_from(n[3])); }},
    {"extrude", 0, [](Numbers n) { return extrude(polygon_from(n.subspan(1)), n[0]); }},
    {"revolve", 0, [](Numbers n) { return revolve(polygon_from(n.subspan(1)), count_from(n[0])); }},
}};

bool takes(const NamedShape& shape, std::size_t count) { return shape.number_count == 0 ? count % 2 == 1 : count == shape.number_count; }

}  // namespace

SurfaceMesh make_shape(std::string_view name, Numbers numbers) {
  for (const NamedShape& shape : named_shapes) {
    if (name != shape.name) continue;
    if (takes(shape, numbers.size())) return shape.make(numbers);
    throw Error(ErrorCode::InvalidArgument, "make_shape", "wrong number of parameters for a " + std::string(name));
  }
  throw Error(ErrorCode::InvalidArgument, "make_shape", "no shape has the name " + std::string(name));
}

}  // namespace mortise
