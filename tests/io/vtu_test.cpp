// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// VTK's XML format: pieces, arrays, strings, errors with their line.
#include "mortise/io/vtu.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// One triangle; the points begin in line 4, the cells in line 7.
std::string piece(const std::string& points, const std::string& corners, const std::string& offsets, const std::string& types,
                  const std::string& cell_data = "") {
  return "<Piece NumberOfPoints='3' NumberOfCells='1'>\n<Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>\n" +
         points + "\n</DataArray></Points>\n<Cells>\n<DataArray type='Int32' Name='connectivity' format='ascii'>" + corners +
         "</DataArray>\n<DataArray type='Int32' Name='offsets' format='ascii'>" + offsets +
         "</DataArray>\n<DataArray type='UInt8' Name='types' format='ascii'>" + types + "</DataArray>\n</Cells>\n<CellData>\n" + cell_data +
         "</CellData></Piece>\n";
}

std::string file(const std::string& inside) {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n" + inside + "</UnstructuredGrid></VTKFile>\n";
}

const std::string three_points = "0 0 0 1 0 0 0 1 0";

std::string array_of(const std::string& name, const std::string& numbers) {
  return "<DataArray type='Int32' Name='" + name + "' format='ascii'>" + numbers + "</DataArray>\n";
}

void check_fails(ErrorCode code, std::uint32_t line, std::string_view text) {
  CAPTURE(text);
  check_error(code, "read_vtu", IdKind::Line, line, [&] { return read_vtu(text); });
}

}  // namespace

TEST_CASE("VTU pieces are read one after the other") {
  const EntityMesh mesh =
      read_vtu(file(piece(three_points, "0 1 2", "3", "5", array_of("entity", "4")) + piece(three_points, "2 1 0", "3", "5")));
  CHECK(mesh.points.size() == 6);
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(0, 1, 2), triangle(5, 4, 3)});
  CHECK(mesh.entities[2].size() == 2);
}

TEST_CASE("VTU declarations, comments, other arrays and raw data at the end are read over") {
  const std::string arrays =
      "<DataArray Name='t' type='Float64' format='appended' offset='0'/>\n<DataArray Name='group' type='Float32' format='ascii'>1.5"
      "</DataArray><Array Name='s' type='String' format='binary'>AAAA</Array>\n";
  const std::string text = file("<!-- <Piece> -->\n" + piece(three_points, "0 1 2", "3", "5", arrays));
  CHECK(read_vtu("<?xml version='1.0'?>\n<!DOCTYPE any>\n" + text).triangles.size() == 1);
  std::string appended = text.substr(0, text.find("</VTKFile>"));
  appended += "<AppendedData encoding='raw'>\n_<<<\0>" + std::string("\n</AppendedData></VTKFile>");
  CHECK(read_vtu(appended).triangles.size() == 1);
}

TEST_CASE("VTU strings are numbers of bytes with a 0 behind each") {
  const std::string field = "<FieldData>" + array_of("group_dimensions", "2 2") + array_of("group_tags", "4 3") +
                            "<DataArray type='String' Name='group_names' format='ascii'>97 32 -61 -92 0\n0</DataArray></FieldData>\n";
  const EntityMesh mesh = read_vtu(file(field + piece(three_points, "0 1 2", "3", "5", array_of("group", "4"))));
  CHECK((mesh.names == std::vector<PhysicalName>{{2, 4, "a \xC3\xA4"}, {2, 3, ""}}));
  CHECK((mesh.entities[2] == std::vector<MeshEntity>{{4, {0}, {}}}));
}

TEST_CASE("Texts that are no VTU file are refused") {
  check_fails(ErrorCode::ParseFailed, 1, "");
  check_fails(ErrorCode::ParseFailed, 2, "\n<svg/>\n");
  check_fails(ErrorCode::ParseFailed, 1, "<VTKFile type='PolyData'>\n</VTKFile>");
  check_fails(ErrorCode::ParseFailed, 2, "<VTKFile type='UnstructuredGrid'>\n</VTKFiles>");
  check_fails(ErrorCode::ParseFailed, 3, "<VTKFile type='UnstructuredGrid'>\n<Piece>\n");
  check_fails(ErrorCode::ParseFailed, 2, "<VTKFile type='UnstructuredGrid'>\n<Piece a=5>\n");
  check_fails(ErrorCode::ParseFailed, 2, "<VTKFile type='UnstructuredGrid'>\n<Piece a>\n");
  check_fails(ErrorCode::ParseFailed, 2, "<VTKFile type='UnstructuredGrid'>\n<!-- never ends");
  check_fails(ErrorCode::ParseFailed, 2, file("<Piece NumberOfPoints='-3' NumberOfCells='1'></Piece>"));
}

TEST_CASE("Bad VTU points and cells name their line") {
  check_fails(ErrorCode::ParseFailed, 4, file(piece("0 0 0 1 0 x 0 1 0", "0 1 2", "3", "5")));
  check_fails(ErrorCode::NotFinite, 5, file(piece("0 0 0\n1 0 nan 0 1 0", "0 1 2", "3", "5")));
  check_fails(ErrorCode::ParseFailed, 3, file(piece("0 0 0 1 0 0 0 1", "0 1 2", "3", "5")));
  check_fails(ErrorCode::BadIndex, 7, file(piece(three_points, "0 1 3", "3", "5")));
  check_fails(ErrorCode::ParseFailed, 8, file(piece(three_points, "0 1 2", "4", "5")));
  check_fails(ErrorCode::ParseFailed, 8, file(piece(three_points, "0 1 2", "2", "5")));
  check_fails(ErrorCode::ParseFailed, 2, file(piece(three_points, "0 1 2", "3", "5 5")));
  check_fails(ErrorCode::ParseFailed, 7, file(piece(three_points, "0 1 2", "3", "9")));
  check_fails(ErrorCode::ParseFailed, 7, file(piece(three_points, "0 1 2", "3", "22")));
  check_fails(ErrorCode::ParseFailed, 12, file(piece(three_points, "0 1 2", "3", "5", array_of("entity", "4 5"))));
  check_fails(ErrorCode::ParseFailed, 12, file(piece(three_points, "0 1 2", "3", "5", array_of("entity", "4.5"))));
}

TEST_CASE("VTU arrays that are not text say so") {
  std::string text = file(piece(three_points, "0 1 2", "3", "5"));
  text.replace(text.find("'ascii'"), 7, "'binary'");
  check_fails(ErrorCode::ParseFailed, 3, text);
}
