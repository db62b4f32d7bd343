// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The header of a PLY file.
#include "mortise/io/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_ply";

using TypeName = std::pair<std::string_view, PlyType>;
constexpr std::array<TypeName, 16> type_names{{{"char", PlyType::Int8},
                                               {"int8", PlyType::Int8},
                                               {"uchar", PlyType::Uint8},
                                               {"uint8", PlyType::Uint8},
                                               {"short", PlyType::Int16},
                                               {"int16", PlyType::Int16},
                                               {"ushort", PlyType::Uint16},
                                               {"uint16", PlyType::Uint16},
                                               {"int", PlyType::Int32},
                                               {"int32", PlyType::Int32},
                                               {"uint", PlyType::Uint32},
                                               {"uint32", PlyType::Uint32},
                                               {"float", PlyType::Float32},
                                               {"float32", PlyType::Float32},
                                               {"double", PlyType::Float64},
                                               {"float64", PlyType::Float64}}};

PlyType read_type(std::string_view word, const TextPlace& place) {
  const auto known = std::find_if(type_names.begin(), type_names.end(), [word](const TypeName& entry) { return entry.first == word; });
  if (known == type_names.end()) fail_at_line(ErrorCode::ParseFailed, place, "the property has no type this format knows");
  return known->second;
}

PlyType read_integer_type(std::string_view word, const TextPlace& place) {
  const PlyType type = read_type(word, place);
  if (!is_ply_integer(type)) fail_at_line(ErrorCode::ParseFailed, place, "the length of a list must be an integer");
  return type;
}

PlyEncoding read_encoding(std::string_view rest, const TextPlace& place) {
  const std::string_view encoding = take_word(rest);
  if (encoding == "ascii") return PlyEncoding::Ascii;
  if (encoding == "binary_little_endian") return PlyEncoding::LittleEndian;
  if (encoding == "binary_big_endian") return PlyEncoding::BigEndian;
  fail_at_line(ErrorCode::ParseFailed, place, "the encoding is neither ascii, binary_little_endian nor binary_big_endian");
}

PlyElement read_element(std::string_view rest, const TextPlace& place) {
  PlyElement element;
  element.name = take_word(rest);
  element.count = read_count(take_word(rest), place, "the number of elements");
  return element;
}

PlyProperty read_property(std::string_view rest, const TextPlace& place) {
  PlyProperty property;
  std::string_view word = take_word(rest);
  if (word == "list") {
    property.is_list = true;
    property.count_type = read_integer_type(take_word(rest), place);
    word = take_word(rest);
  }
  property.type = read_type(word, place);
  property.name = take_word(rest);
  if (property.name.empty()) fail_at_line(ErrorCode::ParseFailed, place, "the property has no name");
  return property;
}

/// Keeps the name in a comment `label NUMBER NAME` when it is the next one.
void read_comment(std::string_view rest, PlyHeader& header) {
  if (take_word(rest) != "label") return;
  if (take_word(rest) == std::to_string(header.label_names.size())) header.label_names.push_back(one_line_name(rest));
}

/// Reads one line of the header; false behind "end_header".
bool read_header_line(const LineReader& lines, PlyHeader& header, bool& has_format) {
  std::string_view rest = lines.line();
  const std::string_view keyword = take_word(rest);
  if (keyword == "end_header") return false;
  if (keyword == "obj_info" || keyword.empty()) return true;
  if (keyword == "comment") {
    read_comment(rest, header);
  } else if (keyword == "format") {
    header.encoding = read_encoding(rest, lines.place());
    has_format = true;
  } else if (keyword == "element") {
    header.elements.push_back(read_element(rest, lines.place()));
  } else if (keyword == "property" && !header.elements.empty()) {
    header.elements.back().properties.push_back(read_property(rest, lines.place()));
  } else {
    fail_at_line(ErrorCode::ParseFailed, lines.place(), "the header line is none of format, element, property, comment, end_header");
  }
  return true;
}

/// A header whose lines end in a single CR ends in a single CR: a binary row may begin with the byte of LF.
std::size_t end_of_header(std::string_view bytes, std::size_t offset) {
  const bool has_lone_cr = bytes.size() > 4 && bytes[3] == '\r' && bytes[4] != '\n';
  return has_lone_cr && bytes[offset - 1] == '\n' ? offset - 1 : offset;
}

}  // namespace

std::size_t ply_type_size(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
      return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
      return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      break;
  }
  return 8;
}

bool is_ply_integer(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

bool has_ply_magic(std::string_view bytes) {
  return bytes.size() > 3 && bytes.substr(0, 3) == "ply" && (bytes[3] == '\n' || bytes[3] == '\r' || bytes[3] == ' ' || bytes[3] == '\t');
}

PlyHeader read_ply_header(std::string_view bytes) {
  LineReader lines(bytes, stage_name);
  if (!lines.next() || !has_ply_magic(bytes))
    fail_at_line(ErrorCode::ParseFailed, {stage_name, 1}, "a PLY file begins with the line 'ply'");
  PlyHeader header;
  bool has_format = false;
  do {
    if (!lines.next()) fail_at_line(ErrorCode::ParseFailed, lines.place(), "the file ends before 'end_header'");
  } while (read_header_line(lines, header, has_format));
  if (!has_format) fail_at_line(ErrorCode::ParseFailed, lines.place(), "the header has no line 'format'");
  header.size = end_of_header(bytes, lines.offset());
  header.line_count = lines.place().line;
  return header;
}

}  // namespace mortise
