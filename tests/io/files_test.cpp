// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files: written and read back; and every real mesh of the data folder with its known counts.
#include "mortise/io/files.h"

#include <algorithm>
#include <filesystem>
#include <random>

#include "io/io_support.h"
#include "io/known_meshes.h"
#include "mortise/io/formats.h"
#include "support/data.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A name for a file that nobody else uses.
std::string scratch_file() {
  return (std::filesystem::temp_directory_path() / ("mortise_" + std::to_string(std::random_device()()) + ".ply")).string();
}

bool skip_without_data() {
  if (data_folder()) return false;
  WARN("skipped: no folder of real meshes (set MORTISE_DATA)");
  return true;
}

/// Is there a row for this file in one of the tables of known files?
bool is_known(const std::string& file) {
  const auto names_it = [&file](const auto& known) { return known.file == file; };
  return std::any_of(known_meshes.begin(), known_meshes.end(), names_it) || std::any_of(known_errors.begin(), known_errors.end(), names_it);
}

}  // namespace

TEST_CASE("A mesh file is written and read back by its name") {
  const SurfaceMesh mesh = awkward_tetrahedron();
  const std::string file = scratch_file();
  write_mesh_file(file, mesh);
  const SurfaceMesh back = read_mesh_file(file);
  CHECK(read_file(file) == write_mesh(mesh, Format::PlyBinary));
  std::filesystem::remove(file);
  CHECK(point_bits(back) == point_bits(mesh));
  CHECK(back.triangles == mesh.triangles);
}

TEST_CASE("Files that cannot be opened are reported with their name") {
  const Error on_read = error_of([] { return read_mesh_file("no/such/folder/mesh.stl"); });
  CHECK(on_read.code == ErrorCode::FileFailed);
  CHECK(on_read.message.find("no/such/folder/mesh.stl") != std::string::npos);
  CHECK(error_of([] { return write_mesh_file("no/such/folder/mesh.stl", {}), 0; }).code == ErrorCode::FileFailed);
  CHECK(error_of([] { return write_mesh_file("mesh.dxf", {}), 0; }).code == ErrorCode::UnknownFormat);
}

TEST_CASE("Real meshes have the known numbers of vertices and triangles after the weld") {
  if (skip_without_data()) return;
  for (const KnownMesh& known : known_meshes) {
    CAPTURE(known.file);
    const SurfaceMesh mesh = read_data(known.file);
    CHECK(mesh.points.size() == known.vertices);
    CHECK(mesh.triangles.size() == known.triangles);
  }
}

TEST_CASE("Real files that are broken are refused with the line of the trouble") {
  if (skip_without_data()) return;
  for (const KnownError& known : known_errors) {
    CAPTURE(known.file);
    const std::string stage = "read_" + known.file.substr(known.file.size() - 3);
    check_error(known.code, stage, IdKind::Line, known.line, [&] { return read_data(known.file); });
  }
}

TEST_CASE("Every other real or synthetic mesh file is read") {
  if (skip_without_data()) return;
  std::size_t meshes = 0;
  for (const char* folder : {"aircraft", "cad", "car", "nasty", "nasty/synthetic", "primitives", "scans", "ship", "terrain"}) {
    for (const std::string& name : data_files(folder)) {
      const std::string file = std::string(folder) + "/" + name;
      if (is_known(file)) continue;
      CAPTURE(file);
      CHECK_NOTHROW(read_data(file));
      ++meshes;
    }
  }
  CHECK(meshes > 30);
}

TEST_CASE("Real meshes come back bit for bit from every format") {
  if (skip_without_data()) return;
  for (const char* file :
       {"ship/stack_funnel.obj", "cad/flange.stl", "terrain/turbine_site_terrain.off", "aircraft/ceasiom_wing_swept.stl"}) {
    const SurfaceMesh mesh = read_data(file);
    for (const Format format : {Format::Obj, Format::Off, Format::PlyAscii, Format::PlyBinary}) {
      CAPTURE(file, format_name(format));
      const SurfaceMesh back = read_mesh(write_mesh(mesh, format), "");
      CHECK(point_bits(back) == point_bits(mesh));
      CHECK(back.triangles == mesh.triangles);
    }
    const SurfaceMesh from_stl = read_mesh(write_mesh(mesh, Format::StlAscii), "");
    CHECK(corner_bits(from_stl) == corner_bits(mesh));
    CHECK(face_names(from_stl) == face_names(mesh));
  }
}
