// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The file formats as one choice.
#include "mortise/io/formats.h"

#include <array>

#include "mortise/base/error.h"
#include "mortise/io/obj.h"
#include "mortise/io/off.h"
#include "mortise/io/ply.h"
#include "mortise/io/ply_header.h"
#include "mortise/io/stl.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "detect_format";
constexpr std::size_t probe_size = 1024;

constexpr std::array all_formats{Format::Obj, Format::Off, Format::PlyBinary, Format::PlyAscii, Format::StlBinary, Format::StlAscii};

std::string_view extension(std::string_view path) {
  const std::size_t dot = path.find_last_of("./\\");
  return dot == std::string_view::npos || path[dot] != '.' ? std::string_view() : path.substr(dot + 1);
}

std::string_view first_word(std::string_view bytes) {
  LineReader lines(bytes.substr(0, probe_size), stage_name);
  if (!lines.next_content()) return {};
  std::string_view rest = lines.line();
  return take_word(rest);
}

bool ends_with_off(std::string_view word) { return word.size() >= 3 && word.size() <= 7 && word.substr(word.size() - 3) == "OFF"; }

bool is_obj_keyword(std::string_view word) {
  for (const std::string_view known : {"v", "vn", "vt", "f", "g", "o", "s", "mtllib", "usemtl"}) {
    if (word == known) return true;
  }
  return false;
}

/// Looks for the format with this extension; false when there is none.
bool find_by_extension(std::string_view path, Format& format) {
  for (const Format candidate : all_formats) {
    if (!equals_ignoring_case(extension(path), format_name(candidate))) continue;
    format = candidate;
    return true;
  }
  return false;
}

}  // namespace

std::string_view format_name(Format format) {
  switch (format) {
    case Format::Obj:
      return "obj";
    case Format::Off:
      return "off";
    case Format::PlyBinary:
      return "ply";
    case Format::PlyAscii:
      return "ply-ascii";
    case Format::StlBinary:
      return "stl";
    case Format::StlAscii:
      break;
  }
  return "stl-ascii";
}

Format format_from_name(std::string_view name) {
  for (const Format format : all_formats) {
    if (name == format_name(format)) return format;
  }
  throw Error(ErrorCode::UnknownFormat, "format_from_name", "the formats are obj, off, ply, ply-ascii, stl and stl-ascii");
}

Format format_from_path(std::string_view path) {
  Format format{};
  if (find_by_extension(path, format)) return format;
  throw Error(ErrorCode::UnknownFormat, "format_from_path", "the name does not end in .obj, .off, .ply or .stl");
}

Format detect_format(std::string_view name, std::string_view bytes) {
  if (has_ply_magic(bytes)) return is_ascii_ply(bytes) ? Format::PlyAscii : Format::PlyBinary;
  if (is_binary_stl(bytes)) return Format::StlBinary;
  const std::string_view word = first_word(bytes);
  if (ends_with_off(word)) return Format::Off;
  if (is_ascii_stl(bytes)) return Format::StlAscii;
  Format format{};
  if (find_by_extension(name, format)) return format;
  if (is_obj_keyword(word)) return Format::Obj;
  throw Error(ErrorCode::UnknownFormat, stage_name, "neither the name nor the content tells one of the formats obj, off, ply and stl");
}

bool is_float32_format(Format format) { return format == Format::StlBinary; }

SurfaceMesh read_mesh(std::string_view bytes, std::string_view name) {
  switch (detect_format(name, bytes)) {
    case Format::Obj:
      return read_obj(bytes);
    case Format::Off:
      return read_off(bytes);
    case Format::PlyBinary:
    case Format::PlyAscii:
      return read_ply(bytes);
    case Format::StlBinary:
    case Format::StlAscii:
      break;
  }
  return read_stl(bytes);
}

std::string write_mesh(const SurfaceMesh& mesh, Format format) {
  switch (format) {
    case Format::Obj:
      return write_obj(mesh);
    case Format::Off:
      return write_off(mesh);
    case Format::PlyBinary:
      return write_ply_binary(mesh);
    case Format::PlyAscii:
      return write_ply_ascii(mesh);
    case Format::StlBinary:
      return write_stl_binary(mesh);
    case Format::StlAscii:
      break;
  }
  return write_stl_ascii(mesh);
}

}  // namespace mortise
