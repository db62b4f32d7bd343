// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Abaqus and Nastran files as text, and numbers in their fields.
#include <cmath>

#include "io/io_support.h"
#include "mortise/base/numbers.h"
#include "mortise/io/abaqus.h"
#include "mortise/io/fitted_number.h"
#include "mortise/io/nastran.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// One triangle per label.
EntityMesh named_faces(const std::vector<std::string>& names) {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  mesh.label_names = names;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    mesh.triangles.push_back(triangle(0, 1, 2));
    mesh.face_labels.push_back(i);
  }
  return entity_mesh_of(mesh);
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("An Abaqus file has nodes, elements by face, and sets and surfaces by group") {
  CHECK(write_abaqus(named_faces({"inlet"})) ==
        "*HEADING\nMortise\n*NODE, NSET=ALL_NODES\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 0.5, 0.\n*ELEMENT, TYPE=S3, ELSET=FACE_1\n1, 1, 2, "
        "3\n"
        "*ELSET, ELSET=inlet\n1\n*SURFACE, NAME=inlet, TYPE=ELEMENT\ninlet, SPOS\n");
}

TEST_CASE("Groups of edges and vertices are node sets in an Abaqus file") {
  const std::string text = write_abaqus(two_regions());
  CHECK(contains(text, "*NSET, NSET=the_rim\n1, 2, 3\n"));
  CHECK(contains(text, "*NSET, NSET=fix\n2\n"));
  CHECK(contains(text, "*ELSET, ELSET=wall\n4, 6, 7\n"));
  CHECK_FALSE(contains(text, "steel"));
}

TEST_CASE("Names for Abaqus are legal, different in any case, and explained") {
  const std::string text =
      write_abaqus(named_faces({"a b", "A_B", "7", "\xC3\xA4!", "face_1", std::string(90, 'x'), std::string(100, 'X')}));
  CHECK(contains(text, "** a_b is the group 'a b'\n*ELSET, ELSET=a_b\n1\n"));
  CHECK(contains(text, "** A_B_2 is the group 'A_B'\n*ELSET, ELSET=A_B_2\n2\n"));
  CHECK(contains(text, "*ELSET, ELSET=G_7\n"));
  CHECK(contains(text, "*ELSET, ELSET=G___\n"));
  CHECK(contains(text, "*ELSET, ELSET=face_1_2\n"));
  CHECK(contains(text, "*ELSET, ELSET=" + std::string(80, 'x') + "\n"));
  CHECK(contains(text, "*ELSET, ELSET=" + std::string(78, 'X') + "_2\n"));
}

TEST_CASE("Abaqus sets have sixteen numbers on a line") {
  const std::string text = write_abaqus(entity_mesh_of([] {
    SurfaceMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles.assign(17, triangle(0, 1, 2));
    mesh.face_labels.assign(17, 0);
    mesh.label_names = {"all"};
    return mesh;
  }()));
  CHECK(contains(text, "ELSET=all\n1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16\n17\n*SURFACE"));
}

TEST_CASE("A Nastran file has large fields for nodes, properties for faces and comments with names") {
  CHECK(write_nastran(named_faces({"inlet"})) ==
        "$ Mortise\nBEGIN BULK\n"
        "$HMNAME COMP                   1\"inlet\"\n"
        "$ group \"inlet\": properties 1\n"
        "GRID*                  1                              0.              0.\n"
        "*                     0.\n"
        "GRID*                  2                              1.              0.\n"
        "*                     0.\n"
        "GRID*                  3                              0.             0.5\n"
        "*                     0.\n"
        "CTRIA3         1       1       1       2       3\n"
        "ENDDATA\n");
}

TEST_CASE("Groups of edges and vertices are sets of nodes in a Nastran file") {
  const std::string text = write_nastran(two_regions());
  CHECK(contains(text, "$ SET1 1 is the group \"the rim\"\nSET1           1       1       2       3\n"));
  CHECK(contains(text, "$ SET1 2 is the group \"fix\"\nSET1           2       2\n"));
  CHECK(contains(text, "$ group \"wall\": properties 2\n"));
}

TEST_CASE("Tags that no field of a Nastran file holds are refused") {
  EntityMesh mesh = named_faces({"inlet"});
  mesh.entities[2][0].tag = 100000000;
  const Error error = error_of([&] { return write_nastran(mesh); });
  CHECK(error.code == ErrorCode::OutOfRange);
  CHECK(error.stage == "write_nastran");
}

TEST_CASE("Numbers that fit a field keep every bit, others are rounded to what fits") {
  CHECK(fitted_number(0, 16, ExponentStyle::SignOnly) == "0.");
  CHECK(fitted_number(-0.0, 16, ExponentStyle::SignOnly) == "-0.");
  CHECK(fitted_number(-1234.5, 16, ExponentStyle::SignOnly) == "-1234.5");
  CHECK(fitted_number(1e22, 16, ExponentStyle::SignOnly) == "1.+22");
  CHECK(fitted_number(1e-7, 16, ExponentStyle::WithLetter) == "1.e-7");
  CHECK(fitted_number(1.0 / 3, 16, ExponentStyle::SignOnly) == "0.33333333333333");
  CHECK(fitted_number(-1.0 / 3, 20, ExponentStyle::WithLetter) == "-0.3333333333333333");
  CHECK(fitted_number(-2.0 / 3, 16, ExponentStyle::SignOnly) == "-0.6666666666667");
  CHECK(fitted_number(-4.9e-324, 16, ExponentStyle::SignOnly) == "-5.-324");
  CHECK(fitted_number(0.99999999999999989, 16, ExponentStyle::SignOnly) == "1.");
  CHECK(fitted_number(-1.2345678901234567e-100, 16, ExponentStyle::SignOnly) == "-1.23456789-100");
}

TEST_CASE("Fitted numbers stay within their field and near their value, over the whole range") {
  double value = 4.9e-320;
  for (int i = 0; i < 600; ++i, value *= -13.7) {
    if (!(std::fabs(value) < 1e300)) break;
    const std::string with_letter = fitted_number(value, 20, ExponentStyle::WithLetter);
    CAPTURE(value, with_letter);
    REQUIRE(with_letter.size() <= 20);
    REQUIRE(fitted_number(value, 16, ExponentStyle::SignOnly).size() <= 16);
    REQUIRE(std::fabs(parse_double(with_letter).value - value) <= std::fabs(value) * 1e-11);
  }
}
