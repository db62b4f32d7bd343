// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Copies between JavaScript's typed arrays and the library's plain arrays. Only copies cross the border.
#pragma once

#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mortise/geom/plane.h"
#include "mortise/geom/vec.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::wasm {

/// A new Float64Array, Uint32Array or Uint8Array of JavaScript, according to the type of the numbers.
template <class T>
[[nodiscard]] emscripten::val copy_out(std::span<const T> numbers) {
  return emscripten::val(emscripten::typed_memory_view(numbers.size(), numbers.data())).template call<emscripten::val>("slice");
}

template <class T>
[[nodiscard]] emscripten::val copy_out(const std::vector<T>& numbers) {
  return copy_out(std::span<const T>(numbers));
}

/// Fills `numbers` from a typed array of the same length; JavaScript converts float32 to double.
template <class T>
void copy_in(const emscripten::val& array, std::span<T> numbers) {
  emscripten::val(emscripten::typed_memory_view(numbers.size(), numbers.data())).template call<void>("set", array);
}

/// A Uint32Array of a number per item.
template <class Items, class NumberOf>
[[nodiscard]] emscripten::val numbers_out(const Items& items, NumberOf number_of) {
  std::vector<std::uint32_t> numbers;
  for (const auto& item : items) numbers.push_back(static_cast<std::uint32_t>(number_of(item)));
  return copy_out(numbers);
}

template <class Ids>
[[nodiscard]] emscripten::val ids_out(const Ids& ids) {
  return numbers_out(ids, [](const auto& id) { return id.value; });
}

/// The numbers of a typed array.
template <class T>
[[nodiscard]] std::vector<T> numbers_in(const emscripten::val& array) {
  std::vector<T> numbers(array["length"].as<std::size_t>());
  copy_in<T>(array, numbers);
  return numbers;
}

/// Three numbers per point.
[[nodiscard]] emscripten::val points_out(const std::vector<Vec3d>& points);
[[nodiscard]] std::vector<Vec3d> points_in(const emscripten::val& array);

/// Two numbers per pair.
[[nodiscard]] emscripten::val pairs_out(const std::vector<std::array<std::uint32_t, 2>>& pairs);

/// An array of JavaScript strings.
[[nodiscard]] std::vector<std::string> strings_in(const emscripten::val& array);
[[nodiscard]] emscripten::val strings_out(const std::vector<std::string>& strings);

/// The valid mesh of {positions, triangles?, walls?, diagonals?, faceLabels?, labelNames?, vertexData?, cornerData?}, typed arrays of the
/// right length; data are arrays of {name, components, kind, values}. Without triangles every three points are one.
/// @throws what validate() throws
[[nodiscard]] SurfaceMesh mesh_in(const emscripten::val& object);

/// {positions, triangles, walls?, diagonals?, faceLabels?, labelNames?, vertexData?, cornerData?}; data are {components, values, kind?} by
/// name.
[[nodiscard]] emscripten::val mesh_out(const SurfaceMesh& mesh);

/// The plane of [nx, ny, nz, d], a Float64Array.
[[nodiscard]] Plane plane_in(const emscripten::val& numbers);

/// The bytes of a Uint8Array.
[[nodiscard]] std::string bytes_in(const emscripten::val& array);

/// A Uint8Array.
[[nodiscard]] emscripten::val bytes_out(const std::string& bytes);

}  // namespace mortise::wasm
