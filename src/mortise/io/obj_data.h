// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Texture coordinates and normals of OBJ texts: statements of their own, which the corners of faces name by number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// What the `vt`, or the `vn`, of a text say.
struct ObjValues {
  std::size_t components;
  std::vector<double> numbers;

  [[nodiscard]] std::size_t size() const { return numbers.size() / components; }
};

/// Appends the values an index names, as it is written: from 1, or negative and relative to those before; NaN where it names none.
void append_indexed(int index, std::size_t before, const ObjValues& values, std::vector<double>& numbers);

/// Is there any value?
[[nodiscard]] bool has_values(const DataChannel& channel);

/// The channels an OBJ text can hold, at corners.
[[nodiscard]] std::optional<DataChannel> uv_of(const SurfaceMesh& mesh);
[[nodiscard]] std::optional<DataChannel> normals_of(const SurfaceMesh& mesh);

/// Writes a statement for every different set of values, in the order of their first corners.
/// @return its number for each corner, from 1; 0 where a value is missing; empty without a channel
[[nodiscard]] std::vector<std::uint32_t> write_values(std::string_view keyword, const std::optional<DataChannel>& at_corners,
                                                      std::string& text);

/// Appends "/i/j", or as much of it as there is.
void append_indices(std::uint32_t texture, std::uint32_t normal, std::string& text);

}  // namespace mortise
