// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements with which properties follow, and how they are encoded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mortise {

enum class PlyEncoding : unsigned char { Ascii, LittleEndian, BigEndian };

enum class PlyType : unsigned char { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

[[nodiscard]] std::size_t ply_type_size(PlyType type);
[[nodiscard]] bool is_ply_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;  ///< of the value, or of the items of a list
  bool is_list = false;
  PlyType count_type = PlyType::Uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::uint32_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> label_names{};  ///< of comments `label 0 NAME`, `label 1 NAME`, ... in this order
  std::size_t size = 0;                    ///< bytes up to the first row
  std::uint32_t line_count = 0;            ///< lines up to the first row
};

/// Does the file begin with the line "ply"?
[[nodiscard]] bool has_ply_magic(std::string_view bytes);

/// The header of a PLY file.
/// @throws Error{ParseFailed} from "read_ply" with the line
[[nodiscard]] PlyHeader read_ply_header(std::string_view bytes);

}  // namespace mortise
