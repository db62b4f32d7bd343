// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// MEDIT: keywords, references, comments with names, errors with their line.
#include "mortise/io/medit.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// Lines 1 to 8.
const std::string head = "MeshVersionFormatted 2\nDimension\n3\nVertices 4\n0 0 0 0\n1 0 0 5\n1 1 0 0\n0 1 0 0\n";

void check_fails(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_medit", IdKind::Line, line, [&] { return read_medit(text); });
}

}  // namespace

TEST_CASE("MEDIT references are the tags of entities, 0 one that is free") {
  const EntityMesh mesh =
      read_medit(head + "Edges\n1\n1 2 8\nTriangles\n2\n1 2 3 0\n1 3 4 1\nQuadrilaterals\n1\n1 2 3 4 7\nCorners 1\n2\nEnd\n");
  CHECK((mesh.entities[0] == std::vector<MeshEntity>{{5, {}, {}}}));
  CHECK((mesh.entities[1] == std::vector<MeshEntity>{{8, {}, {}}}));
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{1, {}, {}}, {2, {}, {}}, {7, {}, {}}}));
  CHECK(mesh.triangle_entities == std::vector<std::uint32_t>{1, 0, 2, 2});
  CHECK(mesh.point_elements == std::vector<VertexId>{VertexId(1)});
}

TEST_CASE("MEDIT keywords may be written in any case, comments and other lists are read over") {
  const EntityMesh mesh = read_medit(
      "\xEF\xBB\xBF# any\nmeshversionformatted 1\nDIMENSION 2 # flat\nvertices\n3\n0 0 0\n1 0 0\n0 1 0\nRidges\n1\n1\n"
      "Normals\n1\n0 0 1\nRequiredVertices\n0\ntriangles 1\n1 2 3 1\n");
  CHECK(mesh.points == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh.triangles.size() == 1);
}

TEST_CASE("MEDIT comments name groups by dimension, reference and tag") {
  const EntityMesh mesh = read_medit("# group 2 7 3 in let\n# group 9 7 3 no\n# group 2 7\n" + head + "Triangles 1\n1 2 3 7\n");
  CHECK((mesh.names == std::vector<PhysicalName>{{2, 3, "in let"}}));
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{7, {0}, {}}}));
}

TEST_CASE("Bad MEDIT files name their line") {
  check_fails(ErrorCode::ParseFailed, 0, "");
  check_fails(ErrorCode::ParseFailed, 1, "Vertices 4\n");
  check_fails(ErrorCode::ParseFailed, 2, "MeshVersionFormatted 2\nDimension 4\n");
  check_fails(ErrorCode::ParseFailed, 2, "MeshVersionFormatted 2\nVertices -1\n");
  check_fails(ErrorCode::ParseFailed, 3, "MeshVersionFormatted 2\nVertices 4000000000\n0 0 0 0\n");
  check_fails(ErrorCode::ParseFailed, 3, "MeshVersionFormatted 2\nVertices 1\n0 0 x 0\n");
  check_fails(ErrorCode::NotFinite, 3, "MeshVersionFormatted 2\nVertices 1\n0 0 nan 0\n");
  check_fails(ErrorCode::ParseFailed, 9, head + "Vertices 0\n");
  check_fails(ErrorCode::BadIndex, 10, head + "Triangles 1\n1 2 5 0\n");
  check_fails(ErrorCode::BadIndex, 10, head + "Triangles 1\n0 1 2 0\n");
  check_fails(ErrorCode::BadIndex, 10, head + "Corners 1\n5\n");
  check_fails(ErrorCode::ParseFailed, 10, head + "Triangles 1\n1 2 3 9999999999\n");
  check_fails(ErrorCode::ParseFailed, 11, head + "Triangles 1\n1 2 3 0\n1 2 4 0\n");
  check_fails(ErrorCode::ParseFailed, 10, head + "Triangles 4000000000\n1 2 3 0\n");
}

TEST_CASE("Volume and curved elements of MEDIT files are refused") {
  for (const char* keyword : {"Tetrahedra", "Hexahedra", "PRISMS", "TrianglesP2"}) {
    check_fails(ErrorCode::ParseFailed, 9, head + keyword + " 1\n1 2 3 4 0\n");
  }
}
