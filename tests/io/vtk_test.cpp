// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// VTK's legacy format: kinds of data sets and cells, arrays, errors with their line.
#include "mortise/io/vtk.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const std::string head = "# vtk DataFile Version 3.0\ntitle\nASCII\n";
/// Lines 4 to 9.
const std::string grid_points = head + "DATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string poly_points = head + "DATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0\n1 1 0\n0 1 0\n\n";

void check_fails(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_vtk", IdKind::Line, line, [&] { return read_vtk(text); });
}

}  // namespace

TEST_CASE("VTK grids of points, lines and polygons of every kind are read") {
  const EntityMesh mesh =
      read_vtk(grid_points + "CELLS 7 25\n1 0\n2 0 1\n3 1 2 3\n3 0 1 2\n4 0 1 3 2\n4 0 1 2 3\n2 2 3\n" + "CELL_TYPES 7\n1 3 4\n5 8 9 2\n");
  CHECK(mesh.point_elements == std::vector<VertexId>{VertexId(0), VertexId(2), VertexId(3)});
  CHECK(mesh.lines.size() == 3);
  CHECK(mesh.triangles.size() == 5);
}

TEST_CASE("VTK cells in version 5.1 have offsets") {
  const EntityMesh mesh =
      read_vtk(grid_points + "CELLS 3 5\nOFFSETS vtktypeint64\n0 3 5\nCONNECTIVITY vtktypeint64\n0 1\n2 2 3\n" + "CELL_TYPES 2\n5\n3\n");
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2)});
  CHECK(mesh.lines.size() == 1);
}

TEST_CASE("VTK PolyData numbers its cells by kind: points, lines, polygons") {
  const EntityMesh mesh = read_vtk(poly_points + "POLYGONS 1 5\n4 0 1 2 3\nVERTICES 1 3\n2 0 1\nLINES 1 4\n3 0 1 2\n" +
                                   "CELL_DATA 3\nSCALARS entity int\nLOOKUP_TABLE default\n4 5 6\n");
  CHECK(mesh.entities[0].at(0).tag == 4);
  CHECK(mesh.entities[1].at(0).tag == 5);
  CHECK(mesh.entities[2].at(0).tag == 6);
  CHECK(mesh.point_elements.size() == 2);
  CHECK(mesh.lines.size() == 2);
  CHECK(mesh.triangles.size() == 2);
}

TEST_CASE("VTK arrays without meaning are read over, of points and of cells") {
  const EntityMesh mesh =
      read_vtk(grid_points + "METADATA\nINFORMATION 1\nNAME L2 LOCATION x\nDATA 2 0 1\n\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n" +
               "POINT_DATA 4\nSCALARS t double 2\nLOOKUP_TABLE own\n1 2 3 4 5 6 7 nan\nLOOKUP_TABLE own 1\n0 0 0 1\nVECTORS v float\n" +
               "0 0 0 0 0 0 0 0 0 0 0 0\nNORMALS n float\n0 0 0 0 0 0 0 0 0 0 0 0\nTEXTURE_COORDINATES uv 1 float\n0 0 0 0\n" +
               "CELL_DATA 1\nTENSORS t float\n1 2 3 4 5 6 7 8 9\nCOLOR_SCALARS c 3\n0 0 1\nGLOBAL_IDS i vtkIdType\n4\n" +
               "FIELD f 4\ntext 1 1 string\na%20b c\nMETADATA\nCOMPONENT_NAMES\nx\n\ngroup 2 1 int\n1 2\nentity 1 1 "
               "float\n8.5\nCellEntityIds 1 1 int\n3\n");
  CHECK(mesh.entities[2].at(0).tag == 3);
  CHECK(mesh.names.empty());
}

TEST_CASE("VTK groups without entities are the entities") {
  const EntityMesh mesh =
      read_vtk(grid_points + "CELLS 2 8\n3 0 1 2\n3 0 2 3\nCELL_TYPES 2\n5 5\nCELL_DATA 2\nFIELD f 1\ngmsh:physical 1 2 int\n0 4\n");
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{1, {}, {}}, {4, {0}, {}}}));
  CHECK((mesh.names == std::vector<PhysicalName>{{2, 4, ""}}));
}

TEST_CASE("Names keep every byte in VTK files") {
  EntityMesh mesh = entity_mesh_of(awkward_tetrahedron());
  mesh.names[0].name = "50% \"\xC3\xA4\" %20";
  CHECK(read_vtk(write_vtk(mesh)).names[0].name == mesh.names[0].name);
}

TEST_CASE("VTK files of other kinds are refused") {
  check_fails(ErrorCode::ParseFailed, 0, "");
  check_fails(ErrorCode::ParseFailed, 1, "vtk\n");
  check_fails(ErrorCode::ParseFailed, 2, "# vtk DataFile Version 3.0\ntitle");
  check_fails(ErrorCode::ParseFailed, 3, "# vtk DataFile Version 3.0\ntitle\nBINARY\n");
  check_fails(ErrorCode::ParseFailed, 3, "# vtk DataFile Version 3.0\ntitle\nUTF\n");
  check_fails(ErrorCode::ParseFailed, 4, head + "DATASET STRUCTURED_POINTS\n");
  check_fails(ErrorCode::ParseFailed, 5, head + "DATASET POLYDATA\nCELL_TYPES 1\n5\n");
}

TEST_CASE("Bad VTK points and cells name their line") {
  check_fails(ErrorCode::ParseFailed, 6, head + "DATASET POLYDATA\nPOINTS 4000000000 float\n0 0 0\n");
  check_fails(ErrorCode::ParseFailed, 6, head + "DATASET POLYDATA\nPOINTS 1 float\n0 x 0\n");
  check_fails(ErrorCode::NotFinite, 6, head + "DATASET POLYDATA\nPOINTS 1 float\n0 inf 0\n");
  check_fails(ErrorCode::BadIndex, 11, grid_points + "CELLS 1 4\n3 0 1 4\nCELL_TYPES 1\n5\n");
  check_fails(ErrorCode::BadIndex, 11, grid_points + "CELLS 1 4\n3 0 -1 1\nCELL_TYPES 1\n5\n");
  check_fails(ErrorCode::ParseFailed, 12, grid_points + "CELLS 1 4\n4000000000 0 1 2\nCELL_TYPES 1\n5\n");
  check_fails(ErrorCode::ParseFailed, 11, grid_points + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n5\n");
  check_fails(ErrorCode::ParseFailed, 13, grid_points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n");
  check_fails(ErrorCode::ParseFailed, 12, grid_points + "CELLS 2 3\nOFFSETS int\n0 4\nCONNECTIVITY int\n0 1 2\n");
  check_fails(ErrorCode::ParseFailed, 12, grid_points + "CELLS 2 3\nOFFSETS int\n0 2\nCONNECTIVITY int\n0 1 2\n");
  check_fails(ErrorCode::ParseFailed, 12, grid_points + "CELLS 2 3\nOFFSETS int\n1 3\nCONNECTIVITY int\n0 1 2\n");
}

TEST_CASE("Volume, curved and strip cells name the line of the cell") {
  for (const char* type : {"0", "6", "10", "12", "21", "22", "300"}) {
    check_fails(ErrorCode::ParseFailed, 12, grid_points + "CELLS 2 9\n3 0 1 2\n4 0 1 2 3\nCELL_TYPES 2\n5 " + type + "\n");
  }
}

TEST_CASE("Bad VTK arrays name a line") {
  const std::string cells = grid_points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
  check_fails(ErrorCode::ParseFailed, 17, cells + "CELL_DATA 1\nSCALARS entity int 1\nLOOKUP_TABLE default\n1.5\n");
  check_fails(ErrorCode::ParseFailed, 17, cells + "CELL_DATA 1\nSCALARS entity int 1\nLOOKUP_TABLE default\n9999999999\n");
  check_fails(ErrorCode::ParseFailed, 16, cells + "CELL_DATA 1\nSCALARS entity int 1\n4\n");
  check_fails(ErrorCode::ParseFailed, 15, cells + "CELL_DATA 4000000000\nVECTORS v float\n");
  check_fails(ErrorCode::ParseFailed, 14, cells + "SCALARS entity int 1\n");
  check_fails(ErrorCode::ParseFailed, 17, cells + "FIELD f 1\ngroup_tags 1 1 int\n3\n\n");
  check_fails(ErrorCode::ParseFailed, 16, cells + "FIELD f 1\ngroup_names 1 4000000000 string\nx\n");
}
