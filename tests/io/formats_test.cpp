// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Telling formats apart; reading and writing through one door; damaged files never crash.
#include "mortise/io/formats.h"

#include <array>
#include <random>

#include "io/io_support.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr std::array all_formats{Format::Obj,   Format::Off,   Format::PlyBinary, Format::PlyAscii, Format::StlBinary, Format::StlAscii,
                                 Format::Msh41, Format::Msh22, Format::Vtk,       Format::Vtu,      Format::Medit};

/// A name whose extension tells the format.
std::string file_name(Format format) {
  const std::string_view name = format_name(format);
  return "mesh." + std::string(name.substr(0, name.find('-')));
}

}  // namespace

TEST_CASE("Every format is told by its content, whatever the name says") {
  for (const Format format : all_formats) {
    CAPTURE(format_name(format));
    const std::string bytes = write_mesh(float_tetrahedron(), format);
    CHECK(detect_format("", bytes) == format);
    CHECK(format_from_name(format_name(format)) == format);
    if (format != Format::Obj) CHECK(detect_format("mesh.obj", bytes) == format);
  }
}

TEST_CASE("The extension decides, in any case, where the content does not") {
  CHECK(detect_format("a.b/mesh.OBJ", "hello") == Format::Obj);
  CHECK(detect_format("C:\\x\\mesh.Stl", "too short") == Format::StlBinary);
  CHECK(detect_format("mesh.off", "3 1 0\n") == Format::Off);
  CHECK(format_from_path("out.PLY") == Format::PlyBinary);
}

TEST_CASE("Without a hint in name or content the format is unknown") {
  for (const char* name : {"", "mesh", "mesh.txt", "stl", "a.stl/mesh", ".obj/"}) {
    CAPTURE(name);
    CHECK(error_of([&] { return detect_format(name, "hello"); }).code == ErrorCode::UnknownFormat);
    CHECK(error_of([&] { return format_from_path(name); }).code == ErrorCode::UnknownFormat);
  }
  CHECK(error_of([] { return format_from_name("dxf"); }).code == ErrorCode::UnknownFormat);
}

TEST_CASE("Formats that are written only have names, and reading them says so") {
  CHECK(format_from_path("out.inp") == Format::Abaqus);
  CHECK(format_from_path("out.bdf") == Format::Nastran);
  CHECK(format_from_path("out.NAS") == Format::Nastran);
  CHECK(format_from_path("out.glb") == Format::Glb);
  for (const Format format : {Format::Glb, Format::Abaqus, Format::Nastran}) {
    CHECK_FALSE(is_readable_format(format));
    CHECK(format_from_name(format_name(format)) == format);
    const Error error = error_of([&] { return read_mesh(write_mesh(float_tetrahedron(), format), file_name(format)); });
    CHECK(error.code == ErrorCode::UnknownFormat);
    CHECK(error.message == "files of the format " + std::string(format_name(format)) + " are written, not read");
  }
}

TEST_CASE("Labels keep their names in every format that has room for names") {
  for (const Format format : {Format::Obj, Format::StlAscii, Format::PlyAscii, Format::PlyBinary, Format::Msh41, Format::Msh22, Format::Vtk,
                              Format::Vtu, Format::Medit}) {
    CAPTURE(format_name(format));
    const SurfaceMesh mesh = awkward_tetrahedron();
    CHECK(face_names(read_mesh(write_mesh(mesh, format), "")) == face_names(mesh));
  }
}

TEST_CASE("A mesh written in any format is read back bit for bit through one door") {
  for (const Format format : all_formats) {
    CAPTURE(format_name(format));
    const SurfaceMesh mesh = is_float32_format(format) ? float_tetrahedron() : awkward_tetrahedron();
    CHECK(corner_bits(read_mesh(write_mesh(mesh, format), "")) == corner_bits(mesh));
  }
}

TEST_CASE("Only binary STL and GLB keep coordinates as float32") {
  CHECK(is_float32_format(Format::Glb));
  for (const Format format : all_formats) CHECK(is_float32_format(format) == (format == Format::StlBinary));
}

TEST_CASE("A file cut off anywhere gives a mesh or an error that names a line or byte") {
  for (const Format format : all_formats) {
    const std::string bytes = write_mesh(float_tetrahedron(), format);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      try {
        const SurfaceMesh mesh = read_mesh(std::string_view(bytes).substr(0, size), file_name(format));
        REQUIRE(mesh.triangles.size() <= 4);
      } catch (const Error& error) {
        CAPTURE(format_name(format), size, error.message);
        REQUIRE(error.ids.size() == 1);
        REQUIRE((error.id_kind == IdKind::Line || error.id_kind == IdKind::Byte));
      }
    }
  }
}

TEST_CASE("A file with random damage gives a mesh with sound indices or a typed error") {
  constexpr std::uint64_t seed = 3;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::size_t meshes = 0;
  std::size_t errors = 0;
  for (const Format format : all_formats) {
    const std::string name = file_name(format);
    const std::string sound = write_mesh(float_tetrahedron(), format);
    for (std::size_t i = 0; i < scaled_count(3000, 100000); ++i) {
      std::string bytes = sound;
      for (std::uint64_t flips = random() % 4 + 1; flips > 0; --flips) {
        const std::size_t at = static_cast<std::size_t>(random() % bytes.size());
        const std::uint64_t kind = random() % 4;
        if (kind == 0) bytes[at] = static_cast<char>(random() % 256);
        if (kind == 1) bytes[at] = "0123456789 \n-+.e/\\#<>$"[random() % 22];
        if (kind == 2) bytes.erase(at, 1);
        if (kind == 3) bytes.insert(at, 1, bytes[static_cast<std::size_t>(random() % bytes.size())]);
        if (bytes.empty()) bytes = "x";
      }
      try {
        const SurfaceMesh mesh = read_mesh(bytes, name);
        for (const Triangle& triangle : mesh.triangles) {
          for (const VertexId vertex : triangle) REQUIRE(vertex.index() < mesh.points.size());
        }
        REQUIRE((mesh.face_labels.empty() || mesh.face_labels.size() == mesh.triangles.size()));
        for (const std::uint32_t label : mesh.face_labels) REQUIRE(label < mesh.label_names.size());
        ++meshes;
      } catch (const Error& error) {
        REQUIRE(error.code != ErrorCode::InternalError);
        ++errors;
      }
    }
  }
  CHECK(meshes > 100);
  CHECK(errors > 100);
}
