// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// OFF: header forms, colours, errors with their line, round trip.
#include "mortise/io/off.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

void check_off_error(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_off", IdKind::Line, line, [&] { return read_off(text); });
}

const std::string three_vertices = "0 0 0\n1 0 0\n0 1 0\n";

}  // namespace

TEST_CASE("OFF headers in all their forms are read") {
  for (const char* header :
       {"OFF\n3 1 0\n", "OFF 3 1 3\n", "OFF # text\r\n# counts\r\n\r\n3 1\r\n", "3 1 0\n", "NOFF\n3 1 0\n", "STCNOFF 3 1 0\n"}) {
    CAPTURE(header);
    const SurfaceMesh mesh = read_off(header + three_vertices + "3 0 1 2\n");
    CHECK(mesh.points == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2)});
  }
}

TEST_CASE("OFF colours behind vertices and faces are read over") {
  const SurfaceMesh mesh = read_off("COFF\n3 2 0\n0 0 0 255 0 0 255\n1 0 0 0.5 nan x\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 1  # green\n");
  CHECK(mesh.points.size() == 3);
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2), triangle(0, 2, 1)});
}

TEST_CASE("An OFF text without faces or without anything is a valid mesh") {
  CHECK(read_off("OFF\n0 0 0\n").points.empty());
  CHECK(read_off("OFF 3 0 0\n" + three_vertices).points.size() == 3);
}

TEST_CASE("Bad OFF headers name their line") {
  check_off_error(ErrorCode::ParseFailed, 0, "");
  check_off_error(ErrorCode::ParseFailed, 1, "OBJ\n3 1 0\n");
  check_off_error(ErrorCode::ParseFailed, 1, "4OFF\n3 1 0\n");
  check_off_error(ErrorCode::ParseFailed, 1, "OFF BINARY\n");
  check_off_error(ErrorCode::ParseFailed, 1, "OFF");
  check_off_error(ErrorCode::ParseFailed, 2, "OFF\n3\n");
  check_off_error(ErrorCode::ParseFailed, 2, "OFF\n-3 1 0\n");
  check_off_error(ErrorCode::ParseFailed, 2, "OFF\n99999999999 1 0\n");
}

TEST_CASE("OFF counts that the text does not hold are an error, not an allocation") {
  check_off_error(ErrorCode::ParseFailed, 5, "OFF\n4000000000 1 0\n" + three_vertices);
  check_off_error(ErrorCode::ParseFailed, 6, "OFF\n3 4000000000 0\n" + three_vertices + "3 0 1 2\n");
  check_off_error(ErrorCode::ParseFailed, 6, "OFF\n3 1 0\n" + three_vertices + "4000000000 0 1 2\n");
}

TEST_CASE("Bad OFF vertices name their line") {
  check_off_error(ErrorCode::ParseFailed, 4, "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n");
  check_off_error(ErrorCode::ParseFailed, 3, "OFF\n3 1 0\n0 0 0x\n");
  check_off_error(ErrorCode::NotFinite, 3, "OFF\n3 1 0\n0 nan 0\n");
  check_off_error(ErrorCode::NotFinite, 3, "OFF\n3 1 0\n0 inf 0\n");
  check_off_error(ErrorCode::OutOfRange, 3, "OFF\n3 1 0\n0 1e999 0\n");
}

TEST_CASE("Bad OFF faces name their line") {
  const std::string head = "OFF\n3 2 0\n" + three_vertices + "3 0 1 2\n";
  check_off_error(ErrorCode::BadIndex, 7, head + "3 0 1 3\n");
  check_off_error(ErrorCode::BadIndex, 7, head + "3 -1 1 2\n");
  check_off_error(ErrorCode::ParseFailed, 7, head + "3 0 1\n");
  check_off_error(ErrorCode::ParseFailed, 7, head + "2 0 1\n");
  check_off_error(ErrorCode::ParseFailed, 7, head + "3 0 1 2.0\n");
  check_off_error(ErrorCode::ParseFailed, 7, head + "x\n");
}

TEST_CASE("An OFF round trip keeps every bit and every triangle") {
  const SurfaceMesh mesh = awkward_tetrahedron();
  const SurfaceMesh back = read_off(write_off(mesh));
  CHECK(point_bits(back) == point_bits(mesh));
  CHECK(back.triangles == mesh.triangles);
  CHECK(read_off(write_off({})).triangles.empty());
}
