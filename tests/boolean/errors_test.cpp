// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every error code with every kind of place: what docs/errors.md says there is, and no other.
#include <functional>
#include <limits>
#include <set>

#include "mortise/arrange/planar_triangulation.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mesh/round_to_float32.h"
#include "mortise/mortise.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/document.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
const SurfaceMesh moved_unit = box({0.5, 0.5, 0.5}, {2, 2, 2});

/// A call that fails, and how.
struct Provocation {
  ErrorCode code;
  IdKind kind;
  std::vector<std::uint32_t> ids;  ///< all the places it names
  int operand;                     ///< the one it names, or -1
  std::function<void()> call;
};

SurfaceMesh without_face(SurfaceMesh mesh, std::size_t face) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(face));
  return mesh;
}

SurfaceMesh with_number(SurfaceMesh mesh, std::size_t vertex, double number) {
  mesh.points[vertex].y = number;
  return mesh;
}

SurfaceMesh with_index(SurfaceMesh mesh, std::size_t face, std::size_t vertex) {
  mesh.triangles[face][1] = VertexId(vertex);
  return mesh;
}

SurfaceMesh with_face_turned(SurfaceMesh mesh, std::size_t face) {
  std::swap(mesh.triangles[face][0], mesh.triangles[face][1]);
  return mesh;
}

SurfaceMesh with_nameless_label(SurfaceMesh mesh, std::size_t face) {
  mesh.label_names = {"a"};
  mesh.face_labels.assign(mesh.triangles.size(), 0);
  mesh.face_labels[face] = 1;
  return mesh;
}

/// Two triangles with an edge in common, one of them marked as a wall: the other should be one as well.
SurfaceMesh half_marked_sheet() {
  SurfaceMesh sheet = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  sheet.walls = {1, 0};
  return sheet;
}

/// A file with these bytes in place of others.
std::string with_bytes(std::string file, std::size_t at, std::string_view bytes) { return file.replace(at, bytes.size(), bytes); }

void unite_with(const SurfaceMesh& second, const BooleanOptions& options = {}) { (void)unite(moved_unit, second, options); }

void unite_solids(const SurfaceMesh& second) {
  BooleanOptions options;
  options.require_solids = true;
  unite_with(second, options);
}

void unite_within(std::uint64_t contact_memory) {
  BooleanOptions options;
  options.contact_memory = contact_memory;
  unite_with(unit, options);
}

void unite_until_refused() {
  BooleanOptions options;
  options.progress = [](std::string_view, double) { return false; };
  unite_with(unit, options);
}

/// What a planar triangulation believes: its points are not all on one line.
void triangulate_line() {
  PointSet points;
  std::vector<PointId> vertices;
  for (const double x : {0.0, 1.0, 2.0}) vertices.push_back(points.add_input({x, x, 0}));
  const std::vector<std::uint64_t> lines(vertices.size(), 0);
  (void)PlanarTriangulation(points, Axis::Z, vertices, lines);
}

std::vector<Provocation> about_operands() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  using enum ErrorCode;
  std::vector<std::uint32_t> all_faces;
  for (std::uint32_t f = 0; f < unit.triangles.size(); ++f) all_faces.push_back(f);
  return {
      {InvalidArgument, IdKind::None, {}, -1, [] { (void)evaluate(Operation::Union, {}); }},
      {InvalidArgument, IdKind::Faces, {3}, 1, [] { unite_with(with_nameless_label(unit, 3)); }},
      {NotFinite, IdKind::Vertices, {6}, 1, [] { unite_with(with_number(unit, 6, nan)); }},
      {BadIndex, IdKind::Faces, {3}, 1, [] { unite_with(with_index(unit, 3, 8)); }},
      {NotClosed, IdKind::VertexPairs, {2, 0, 0, 3, 3, 2}, 1, [] { unite_solids(without_face(unit, 0)); }},
      {NotClosed, IdKind::None, {}, -1, [] { (void)split_parts(half_marked_sheet(), SplitBy::Regions); }},
      {NotOriented, IdKind::VertexPairs, {2, 0, 0, 3, 3, 2}, 1, [] { unite_with(with_face_turned(unit, 0)); }},
      {InsideOut, IdKind::Faces, all_faces, 1, [] { unite_with(inside_out(unit)); }},
      {ResultTooLarge, IdKind::None, {}, -1, [] { unite_within(100); }},
      {Cancelled, IdKind::None, {}, -1, unite_until_refused},
      {InternalError, IdKind::None, {}, -1, triangulate_line},
  };
}

std::vector<Provocation> about_meshes() {
  using enum ErrorCode;
  return {
      {InvalidArgument,
       IdKind::Vertices,
       {0, 1},
       -1,
       [] {
         (void)extrude_to(make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 2}, {0, 1, 2}}, {{0, 1, 2}, {0, 2, 3}}), 0);
       }},
      {OutOfRange, IdKind::Vertices, {4}, -1, [] { (void)round_to_float32(with_number(unit, 4, 1e39)); }},
      {OutOfRange,
       IdKind::None,
       {},
       -1,
       [] {
         (void)make_half_space({{1, 0, 0}, 1e308}, bounding_box(box({-1e308, 0, 0}, {1e308, 1, 1})));
       }},
  };
}

std::vector<Provocation> about_files() {
  using enum ErrorCode;
  const std::string stl = write_mesh(unit, Format::StlBinary), ply = write_mesh(unit, Format::PlyBinary);
  const std::uint32_t first_corner = 80 + 4 + 12;  // behind the header, the count and a normal
  const std::uint32_t last_index = static_cast<std::uint32_t>(ply.size()) - 4;
  const std::string no_number = with_bytes(stl, first_corner, std::string_view("\0\0\xc0\x7f", 4));
  const std::string no_vertex = with_bytes(ply, last_index, std::string_view("\x08\0\0\0", 4));
  return {
      {NotFinite, IdKind::Line, {2}, -1, [] { (void)read_mesh("v 0 0 0\nv 1 nan 0\n", "a.obj"); }},
      {NotFinite, IdKind::Byte, {first_corner}, -1, [no_number] { (void)read_mesh(no_number, "a.stl"); }},
      {BadIndex, IdKind::Line, {2}, -1, [] { (void)read_mesh("v 0 0 0\nf 1 2 1\n", "a.obj"); }},
      {BadIndex, IdKind::Byte, {last_index}, -1, [no_vertex] { (void)read_mesh(no_vertex, "a.ply"); }},
      {OutOfRange, IdKind::Line, {1}, -1, [] { (void)read_mesh("v 1e400 0 0\n", "a.obj"); }},
      {ParseFailed, IdKind::Line, {2}, -1, [] { (void)read_mesh("v 0 0 0\nv 1 zero 0\n", "a.obj"); }},
      {ParseFailed, IdKind::Byte, {80}, -1, [stl] { (void)read_mesh(stl.substr(0, stl.size() - 1), "a.stl"); }},
      {UnknownFormat, IdKind::None, {}, -1, [] { (void)read_mesh("what is this?", ""); }},
      {FileFailed, IdKind::None, {}, -1, [] { (void)read_mesh_file("/nowhere/at/all.stl"); }},
  };
}

std::vector<Provocation> provocations() {
  std::vector<Provocation> all = about_operands();
  for (const auto& more : {about_meshes(), about_files()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Code and kind of places, "NOT_FINITE byte"; "none" for no places.
std::string words_of(ErrorCode code, IdKind kind) {
  return std::string(error_code_name(code)) + " " + (kind == IdKind::None ? "none" : std::string(id_kind_name(kind)));
}

std::vector<std::string> documented_codes() {
  std::vector<std::string> codes;
  for (const auto& row : read_table("docs/errors.md")) codes.push_back(row.at(0));
  codes.erase(codes.begin());
  return codes;
}

/// A word for each kind of place in each line of the table.
std::set<std::string> documented_words() {
  std::set<std::string> words;
  const auto rows = read_table("docs/errors.md");
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const std::string& kinds = rows[r].at(2);
    for (std::size_t at = 0, end; at < kinds.size(); at = end + 2) {
      end = std::min(kinds.find(", ", at), kinds.size());
      words.insert(rows[r][0] + " " + kinds.substr(at, end - at));
    }
  }
  return words;
}

}  // namespace

TEST_CASE("the documentation has every error code once, in the order of the enumeration, with something to do", "[errors]") {
  std::vector<std::string> codes;
  for (int code = 0; code <= static_cast<int>(ErrorCode::InternalError); ++code) {
    codes.emplace_back(error_code_name(static_cast<ErrorCode>(code)));
  }
  CHECK(documented_codes() == codes);
  for (const auto& row : read_table("docs/errors.md")) {
    REQUIRE(row.size() == 4);
    for (const std::string& cell : row) CHECK(!cell.empty());
  }
}

TEST_CASE("every error code can be provoked, with its places and the operand", "[errors]") {
  const std::vector<SurfaceMesh> before{unit, moved_unit};  // operands, as they are to stay
  for (const Provocation& provocation : provocations()) {
    INFO(words_of(provocation.code, provocation.kind));
    const auto error = error_of(provocation.call);
    REQUIRE(error);
    CHECK(words_of(error->code, error->id_kind) == words_of(provocation.code, provocation.kind));
    CHECK(error->ids == provocation.ids);
    CHECK(error->operand == provocation.operand);
    CHECK(!error->stage.empty());
    CHECK(!error->message.empty());
  }
  CHECK((has_same_bits(unit, before[0]) && has_same_bits(moved_unit, before[1])));
}

TEST_CASE("the codes and kinds of places provoked are those of the documentation", "[errors]") {
  std::set<std::string> words{"OUT_OF_MEMORY none"};  // std::bad_alloc in C++: see tests/tools/failed_calls.cpp
  for (const Provocation& provocation : provocations()) words.insert(words_of(provocation.code, provocation.kind));
  CHECK(words == documented_words());
}
