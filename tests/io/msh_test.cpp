// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// MSH 2.2 and 4.1: what sections mean, groups and entities, errors with their line.
#include "mortise/io/msh.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const std::string head22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string head41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
/// Lines 4 to 10.
const std::string nodes22 = "$Nodes\n4\n10 0 0 0\n7 1 0 0\n8 1 1 0\n9 0 1 0\n$EndNodes\n";
/// Lines 4 to 15.
const std::string nodes41 = "$Nodes\n1 4 1 9\n2 1 0 4\n1\n2\n4\n9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n";

std::string elements(const std::string& inside) { return "$Elements\n" + inside + "$EndElements\n"; }

void check_fails(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_msh", IdKind::Line, line, [&] { return read_msh(text); });
}

}  // namespace

TEST_CASE("MSH nodes come ascending by their numbers, whatever these are") {
  const EntityMesh mesh = read_msh(head22 + nodes22 + elements("1\n1 2 2 0 1 7 8 10\n"));
  CHECK(mesh.points == std::vector<Vec3d>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 3)});
}

TEST_CASE("MSH quadrangles become triangles of their entity") {
  const EntityMesh mesh = read_msh(head22 + nodes22 + elements("1\n1 3 2 0 6 10 7 8 9\n"));
  CHECK(mesh.triangles.size() == 2);
  CHECK(mesh.entities[2].at(0).tag == 6);
}

TEST_CASE("MSH comments and sections of other meaning are read over") {
  const std::string other = "$Periodic\n0\n$EndPeriodic\n$NodeData\n1\n\"a $ b\"\n$EndNodeData\n";
  const EntityMesh mesh = read_msh("$Comments\nany $text\n$EndComments\n" + head22 + other + nodes22 + elements("0\n") + other);
  CHECK(mesh.points.size() == 4);
}

TEST_CASE("Copies of elements in several groups are one entity in all of them") {
  const EntityMesh mesh = read_msh(head22 + "$PhysicalNames\n2\n2 5 \"five \"\"\"\n2 6 \"six\"\n$EndPhysicalNames\n" + nodes22 +
                                   elements("4\n1 2 2 6 1 7 8 9\n2 2 2 -5 1 7 8 9\n3 2 2 6 1 7 9 10\n4 2 2 -5 1 7 9 10\n"));
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2), triangle(0, 2, 3)});
  CHECK((mesh.names == std::vector<PhysicalName>{{2, 5, "five \"\""}, {2, 6, "six"}}));
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{1, {1, 0}, {}}}));
}

TEST_CASE("Other elements of one entity in several groups are an entity for each group") {
  const EntityMesh mesh = read_msh(head22 + nodes22 + elements("3\n1 2 2 6 1 7 8 9\n2 2 2 5 1 7 9 10\n3 2 2 0 3 7 9 10\n"));
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{1, {0}, {}}, {2, {1}, {}}, {3, {}, {}}}));
  CHECK(mesh.triangle_entities == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("MSH 4.1 entities have groups and boundaries, elements come by their numbers") {
  const std::string entities =
      "$Entities\n1 1 2 1\n3 0 0 0 1 8\n4 0 0 0 1 1 0 0 2 3 -3\n1 0 0 0 1 1 0 2 7 -9 1 -4\n2 0 0 0 1 1 0 0 0\n5 0 0 0 1 1 0 0 2 1 -2\n"
      "$EndEntities\n";
  const EntityMesh mesh = read_msh(head41 + entities + nodes41 + elements("2 2 1 2\n2 2 2 1\n11 1 2 4\n2 1 2 1\n10 1 4 9\n"));
  CHECK((mesh.entities[0] == std::vector<MeshEntity>{{3, {0}, {}}}));
  CHECK((mesh.entities[1] == std::vector<MeshEntity>{{4, {}, {3, 3}}}));
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{1, {1, 2}, {-4}}, {2, {}, {}}}));
  CHECK((mesh.entities[3] == std::vector<MeshEntity>{{5, {}, {1, -2}}}));
  CHECK((mesh.names == std::vector<PhysicalName>{{0, 8, ""}, {2, 7, ""}, {2, 9, ""}}));
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 2, 3), triangle(0, 1, 2)});
}

TEST_CASE("MSH 4.1 nodes may have parameters on their entity") {
  const EntityMesh mesh = read_msh(head41 + "$Nodes\n2 2 1 2\n1 1 1 1\n1\n0 1 2 0.5\n2 1 1 1\n2\n3 4 5 0.25 0.75\n$EndNodes\n");
  CHECK(mesh.points == std::vector<Vec3d>{{0, 1, 2}, {3, 4, 5}});
}

TEST_CASE("MSH files of other versions, binary ones and other texts are refused") {
  check_fails(ErrorCode::ParseFailed, 0, "");
  check_fails(ErrorCode::ParseFailed, 1, "mesh\n");
  check_fails(ErrorCode::ParseFailed, 2, "$MeshFormat\n4 0 8\n");
  check_fails(ErrorCode::ParseFailed, 2, "$MeshFormat\n1 0 8\n");
  check_fails(ErrorCode::ParseFailed, 2, "$MeshFormat\n4.1 1 8\n");
  check_fails(ErrorCode::ParseFailed, 2, "$MeshFormat\n4.1 0\n");
  check_fails(ErrorCode::ParseFailed, 3, "$MeshFormat\n2.2 0 8\n$Nodes\n");
  check_fails(ErrorCode::ParseFailed, 4, head22 + "nodes\n");
  check_fails(ErrorCode::ParseFailed, 5, head22 + "$Periodic\n0\n");
}

TEST_CASE("Bad MSH nodes name their line") {
  check_fails(ErrorCode::ParseFailed, 5, head22 + "$Nodes\n-1\n");
  check_fails(ErrorCode::ParseFailed, 6, head22 + "$Nodes\n4000000000\n1 0 0 0\n");
  check_fails(ErrorCode::ParseFailed, 6, head22 + "$Nodes\n1\n1 0 0 x\n");
  check_fails(ErrorCode::NotFinite, 6, head22 + "$Nodes\n1\n1 0 nan 0\n");
  check_fails(ErrorCode::OutOfRange, 6, head22 + "$Nodes\n1\n1 0 1e999 0\n");
  check_fails(ErrorCode::ParseFailed, 7, head22 + "$Nodes\n2\n1 0 0 0\n1 0 0 1\n$EndNodes\n");
  check_fails(ErrorCode::ParseFailed, 7, head22 + "$Nodes\n1\n1 0 0 0\n2 0 0 1\n$EndNodes\n");
  check_fails(ErrorCode::ParseFailed, 7, head41 + "$Nodes\n1 2 1 2\n2 1 0 2\n1\n");
  check_fails(ErrorCode::ParseFailed, 6, head41 + "$Nodes\n1 2 1 2\n4 1 0 2\n1\n");
}

TEST_CASE("Bad MSH elements name their line") {
  const auto fails22 = [](ErrorCode code, const std::string& line) {
    check_fails(code, 13, head22 + nodes22 + elements("1\n" + line + "\n"));
  };
  fails22(ErrorCode::BadIndex, "1 2 2 0 1 7 8 11");
  fails22(ErrorCode::ParseFailed, "1 2 2 0 1 7 8 x");
  fails22(ErrorCode::ParseFailed, "1 2 2 0 -1 7 8 9");
  fails22(ErrorCode::ParseFailed, "1 2 2 9999999999 1 7 8 9");
  fails22(ErrorCode::ParseFailed, "1 4 2 0 1 7 8 9 10");
  fails22(ErrorCode::ParseFailed, "1 9 2 0 1 7 8 9 10 7 7");
  fails22(ErrorCode::ParseFailed, "1 2 -2 0 1 7 8 9");
  const auto fails41 = [](ErrorCode code, std::uint32_t line, const std::string& block) {
    check_fails(code, line, head41 + nodes41 + elements("1 1 1 1\n" + block + "\n"));
  };
  fails41(ErrorCode::BadIndex, 19, "2 1 2 1\n1 1 2 3");
  fails41(ErrorCode::ParseFailed, 18, "1 1 2 1\n1 1 2 4");
  fails41(ErrorCode::ParseFailed, 18, "3 1 4 1\n1 1 2 4 9");
  fails41(ErrorCode::ParseFailed, 18, "2 0 2 1\n1 1 2 4");
  fails41(ErrorCode::ParseFailed, 20, "2 1 2 4000000000\n1 1 2 4");
}

TEST_CASE("Volume elements are refused with a sentence that says what to do") {
  const Error error = error_of([] { return read_msh(head22 + nodes22 + elements("1\n1 4 2 0 1 7 8 9 10\n")); });
  CHECK(error.message == "line 13: volume elements are not read yet (elements of type 4): save the surface mesh only");
}

TEST_CASE("Bad MSH entities and names name their line") {
  check_fails(ErrorCode::ParseFailed, 6, head41 + "$Entities\n1 0 0\n$EndEntities\n");
  check_fails(ErrorCode::ParseFailed, 6, head41 + "$Entities\n1 0 0 0\n0 0 0 0 0\n$EndEntities\n");
  check_fails(ErrorCode::ParseFailed, 6, head41 + "$Entities\n1 0 0 0\n1 0 0 0 1 0\n$EndEntities\n");
  check_fails(ErrorCode::ParseFailed, 7, head41 + "$Entities\n0 1 0 0\n1 0 0 0 0 0 0 0 4000000000 1\n$EndEntities\n");
  check_fails(ErrorCode::ParseFailed, 6, head22 + "$PhysicalNames\n1\n2 1 name\n$EndPhysicalNames\n");
  check_fails(ErrorCode::ParseFailed, 6, head22 + "$PhysicalNames\n1\n4 1 \"name\"\n$EndPhysicalNames\n");
  check_fails(ErrorCode::ParseFailed, 6, head22 + "$PhysicalNames\n1\n2 0 \"name\"\n$EndPhysicalNames\n");
}

TEST_CASE("Gmsh finds what MSH 4.1 has to have: boxes of entities, ends of edges, numbers of blocks") {
  const std::string text = write_msh41(two_regions());
  CHECK(text.find("$Entities\n1 1 3 2\n9 6.02214076e+23 0.1 5e-324 1 1\n") != std::string::npos);
  CHECK(text.find(" 1 11 2 9 -9\n") != std::string::npos);
  CHECK(text.find("$Elements\n5 11 1 11\n0 9 15 1\n1 2\n1 3 1 3\n") != std::string::npos);
}

TEST_CASE("Double quotes in names become single ones in MSH files") {
  EntityMesh mesh = entity_mesh_of(awkward_tetrahedron());
  mesh.names[0].name = "a \"b\"\nc";
  CHECK(read_msh(write_msh22(mesh)).names[0].name == "a 'b' c");
  CHECK(read_msh(write_msh41(mesh)).names[0].name == "a 'b' c");
}
