// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Mesh files as bytes.
#include <emscripten/bind.h>

#include <string>

#include "arrays.h"
#include "border.h"
#include "mortise/io/formats.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

/// @param name  of the file, may be empty
val read_mesh_bytes(const val& bytes, const std::string& name) {
  return answer([&] { return mesh_out(read_mesh(bytes_in(bytes), name)); });
}

val write_mesh_bytes(const val& mesh, const std::string& format) {
  return answer([&] { return bytes_out(write_mesh(mesh_in(mesh), format_from_name(format))); });
}

/// The format a file of this name is written in.
val format_of_path(const std::string& path) {
  return answer([&] { return val(std::string(format_name(format_from_path(path)))); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_files) {
  emscripten::function("readMesh", &read_mesh_bytes);
  emscripten::function("writeMesh", &write_mesh_bytes);
  emscripten::function("formatOfPath", &format_of_path);
}

}  // namespace mortise::wasm
