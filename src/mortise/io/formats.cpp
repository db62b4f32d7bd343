// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The file formats as one choice.
#include "mortise/io/formats.h"

#include <array>

#include "mortise/base/error.h"
#include "mortise/io/abaqus.h"
#include "mortise/io/glb.h"
#include "mortise/io/medit.h"
#include "mortise/io/msh.h"
#include "mortise/io/nastran.h"
#include "mortise/io/obj.h"
#include "mortise/io/off.h"
#include "mortise/io/ply.h"
#include "mortise/io/ply_header.h"
#include "mortise/io/stl.h"
#include "mortise/io/text.h"
#include "mortise/io/vtk.h"
#include "mortise/io/vtu.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "detect_format";
constexpr std::size_t probe_size = 1024;

struct NamedFormat {
  Format format;
  std::string_view name;
};

constexpr std::array<NamedFormat, 14> all_formats{{{Format::Obj, "obj"},
                                                   {Format::Off, "off"},
                                                   {Format::PlyBinary, "ply"},
                                                   {Format::PlyAscii, "ply-ascii"},
                                                   {Format::StlBinary, "stl"},
                                                   {Format::StlAscii, "stl-ascii"},
                                                   {Format::Glb, "glb"},
                                                   {Format::Msh41, "msh"},
                                                   {Format::Msh22, "msh22"},
                                                   {Format::Vtk, "vtk"},
                                                   {Format::Vtu, "vtu"},
                                                   {Format::Medit, "mesh"},
                                                   {Format::Abaqus, "inp"},
                                                   {Format::Nastran, "bdf"}}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < all_formats.size(); ++i) {
    if (static_cast<std::size_t>(all_formats[i].format) != i) return false;
  }
  return true;
}
static_assert(is_in_order(), "format_name() looks up by number");

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
  const std::string_view found = equals_ignoring_case(extension(path), "nas") ? "bdf" : extension(path);
  for (const NamedFormat& candidate : all_formats) {
    if (!equals_ignoring_case(found, candidate.name)) continue;
    format = candidate.format;
    return true;
  }
  return false;
}

/// Looks for a format of analysis programs by the beginning of its files.
bool find_analysis_format(std::string_view bytes, Format& format) {
  if (is_msh(bytes)) {
    format = is_msh22(bytes) ? Format::Msh22 : Format::Msh41;
  } else if (is_vtk(bytes)) {
    format = Format::Vtk;
  } else if (is_vtu(bytes)) {
    format = Format::Vtu;
  } else if (is_medit(bytes)) {
    format = Format::Medit;
  } else {
    return false;
  }
  return true;
}

/// Reads a file of an analysis program.
EntityMesh read_analysis_mesh(std::string_view bytes, Format format) {
  switch (format) {
    case Format::Msh41:
    case Format::Msh22:
      return read_msh(bytes);
    case Format::Vtk:
      return read_vtk(bytes);
    case Format::Vtu:
      return read_vtu(bytes);
    default:
      return read_medit(bytes);
  }
}

std::string join_names() {
  std::string text;
  for (const NamedFormat& known : all_formats) {
    const bool is_last = &known == &all_formats.back();
    text.append(text.empty() ? "" : is_last ? " and " : ", ").append(known.name);
  }
  return text;
}

}  // namespace

std::string_view format_name(Format format) { return all_formats[static_cast<std::size_t>(format)].name; }

bool is_readable_format(Format format) { return format != Format::Glb && format != Format::Abaqus && format != Format::Nastran; }

bool is_analysis_format(Format format) { return format >= Format::Msh41; }

Format format_from_name(std::string_view name) {
  for (const NamedFormat& known : all_formats) {
    if (name == known.name) return known.format;
  }
  throw Error(ErrorCode::UnknownFormat, "format_from_name", "the formats are " + join_names());
}

Format format_from_path(std::string_view path) {
  Format format{};
  if (find_by_extension(path, format)) return format;
  throw Error(ErrorCode::UnknownFormat, "format_from_path",
              "the name does not end in .obj, .off, .ply, .stl, .glb, .msh, .vtk, .vtu, .mesh, .inp, .bdf or .nas");
}

Format detect_format(std::string_view name, std::string_view bytes) {
  if (has_ply_magic(bytes)) return is_ascii_ply(bytes) ? Format::PlyAscii : Format::PlyBinary;
  if (is_binary_stl(bytes)) return Format::StlBinary;
  const std::string_view word = first_word(bytes);
  if (ends_with_off(word)) return Format::Off;
  if (is_ascii_stl(bytes)) return Format::StlAscii;
  Format format{};
  if (find_analysis_format(bytes, format)) return format;
  if (find_by_extension(name, format)) {
    if (is_readable_format(format)) return format;
    throw Error(ErrorCode::UnknownFormat, stage_name, "files of the format " + std::string(format_name(format)) + " are written, not read");
  }
  if (is_obj_keyword(word)) return Format::Obj;
  throw Error(ErrorCode::UnknownFormat, stage_name,
              "neither the name nor the content tells one of the formats obj, off, ply, stl, msh, vtk, vtu and mesh");
}

bool is_float32_format(Format format) { return format == Format::StlBinary || format == Format::Glb; }

SurfaceMesh read_mesh(std::string_view bytes, std::string_view name) {
  const Format format = detect_format(name, bytes);
  switch (format) {
    case Format::Obj:
      return read_obj(bytes);
    case Format::Off:
      return read_off(bytes);
    case Format::PlyBinary:
    case Format::PlyAscii:
      return read_ply(bytes);
    case Format::StlBinary:
    case Format::StlAscii:
      return read_stl(bytes);
    default:
      return weld(surface_mesh_of(read_analysis_mesh(bytes, format))).mesh;
  }
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
      return write_stl_ascii(mesh);
    case Format::Glb:
      return write_glb(mesh);
    default:
      return write_entity_mesh(entity_mesh_of(mesh), format);
  }
}

EntityMesh read_entity_mesh(std::string_view bytes, std::string_view name) {
  const Format format = detect_format(name, bytes);
  return is_analysis_format(format) ? read_analysis_mesh(bytes, format) : entity_mesh_of(read_mesh(bytes, name));
}

std::string write_entity_mesh(const EntityMesh& mesh, Format format) {
  switch (format) {
    case Format::Msh41:
      return write_msh41(mesh);
    case Format::Msh22:
      return write_msh22(mesh);
    case Format::Vtk:
      return write_vtk(mesh);
    case Format::Vtu:
      return write_vtu(mesh);
    case Format::Medit:
      return write_medit(mesh);
    case Format::Abaqus:
      return write_abaqus(mesh);
    case Format::Nastran:
      return write_nastran(mesh);
    default:
      return write_mesh(surface_mesh_of(mesh), format);
  }
}

}  // namespace mortise
