// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Wavefront OBJ: our own reader takes the positions and checks every statement, tinyobjloader takes faces and names.
#include "mortise/io/obj.h"

#include <limits>

#include "mortise/base/numbers.h"
#include "mortise/io/obj_data.h"
#include "mortise/io/obj_faces.h"
#include "mortise/io/polygon_soup.h"
#include "mortise/io/text.h"
#include "mortise/mesh/polygons.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_obj";

/// Where a face stands, to resolve its relative indices and to name it in errors.
struct FacePlace {
  std::uint32_t line;
  std::uint32_t points_before;
  std::size_t textures_before, normals_before;
};

/// What the first pass leaves for the second.
struct Statements {
  std::vector<Vec3d> points;
  ObjValues textures{2, {}}, normals{3, {}};
  std::vector<FacePlace> face_places;
  std::string face_text;  ///< only f, g, o and usemtl, each on one line, every f sound
};

bool is_continued(std::string_view line) { return !line.empty() && line.back() == '\\'; }

/// The rest of a statement with the lines joined that it is continued on.
class StatementText {
 public:
  StatementText(LineReader& lines, std::string_view rest) : text_(trim(cut_comment(rest))) {
    while (is_continued(text_)) {
      text_.remove_suffix(1);
      joined_ = std::string(text_) + ' ';
      if (!lines.next()) fail_at_line(ErrorCode::ParseFailed, lines.place(), "the file ends inside a continued line");
      joined_ += trim(cut_comment(lines.line()));
      text_ = joined_;
    }
  }
  StatementText(const StatementText&) = delete;
  StatementText& operator=(const StatementText&) = delete;

  std::string_view next_word() { return take_word(text_); }

 private:
  std::string joined_;
  std::string_view text_;
};

void read_vertex(LineReader& lines, std::string_view rest, Statements& statements) {
  const TextPlace place = lines.place();
  StatementText text(lines, rest);
  Vec3d point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = read_coordinate(text.next_word(), place);
  statements.points.push_back(point);
}

/// A `vt` or `vn`. Missing texture coordinates are 0.
void read_values(LineReader& lines, std::string_view rest, ObjValues& values) {
  StatementText text(lines, rest);
  for (std::size_t k = 0; k < values.components; ++k) {
    const std::string_view word = text.next_word();
    const bool is_zero = word.empty() && k > 0 && values.components == 2;
    values.numbers.push_back(is_zero ? 0 : value_of_word(word));
  }
}

/// Checks one of the up to three indices of a corner: only the first must be there.
void check_index(std::string_view digits, bool is_vertex, const TextPlace& place) {
  if (digits.empty() && !is_vertex) return;
  const std::int64_t index = read_integer(digits, place, "an index");
  if (index < std::numeric_limits<int>::min() || index > std::numeric_limits<int>::max()) {
    fail_at_line(ErrorCode::BadIndex, place, "an index is out of range");
  }
}

/// Checks "i", "i/j", "i//k" or "i/j/k".
void check_corner(std::string_view word, const TextPlace& place) {
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = word.find('/');
    check_index(word.substr(0, slash), part == 0, place);
    if (slash == std::string_view::npos) return;
    word.remove_prefix(slash + 1);
  }
  fail_at_line(ErrorCode::ParseFailed, place, "a corner has more than three indices");
}

void read_face(LineReader& lines, std::string_view rest, Statements& statements) {
  const TextPlace place = lines.place();
  StatementText text(lines, rest);
  statements.face_text += 'f';
  int corner_count = 0;
  for (std::string_view word = text.next_word(); !word.empty(); word = text.next_word()) {
    check_corner(word, place);
    statements.face_text.append(" ").append(word);
    ++corner_count;
  }
  if (corner_count < 3) fail_at_line(ErrorCode::ParseFailed, place, "a face needs at least three corners");
  statements.face_text += '\n';
  statements.face_places.push_back(
      {place.line, static_cast<std::uint32_t>(statements.points.size()), statements.textures.size(), statements.normals.size()});
}

/// The first pass over the text.
Statements read_statements(std::string_view text) {
  Statements statements;
  LineReader lines(text, stage_name);
  std::uint32_t unknown_line = 0;
  bool is_obj = false;
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view keyword = take_word(rest);
    if (keyword.empty() || keyword[0] == '#') continue;
    if (keyword == "v") {
      read_vertex(lines, rest, statements);
    } else if (keyword == "f") {
      read_face(lines, rest, statements);
    } else if (keyword == "g" || keyword == "o" || keyword == "usemtl") {
      statements.face_text.append(keyword).append(" ").append(one_line_name(rest)).append("\n");
    } else if (keyword == "vt" || keyword == "vn") {
      read_values(lines, rest, keyword == "vt" ? statements.textures : statements.normals);
    } else if (keyword != "s" && keyword != "mtllib") {
      if (unknown_line == 0) unknown_line = lines.place().line;
      continue;
    }
    is_obj = true;
  }
  if (!is_obj && unknown_line != 0)
    fail_at_line(ErrorCode::ParseFailed, {stage_name, unknown_line}, "this is not a statement of the OBJ format");
  return statements;
}

std::uint32_t resolve_index(int index, const FacePlace& face, std::size_t point_count) {
  const TextPlace place{stage_name, face.line};
  if (index == 0) fail_at_line(ErrorCode::BadIndex, place, "the face names vertex 0 (the first is 1)");
  const std::int64_t resolved = index > 0 ? std::int64_t{index} - 1 : std::int64_t{face.points_before} + index;
  if (resolved < 0 || resolved >= static_cast<std::int64_t>(point_count)) {
    fail_at_line(ErrorCode::BadIndex, place,
                 "the face names vertex " + std::to_string(index) + " of " + std::to_string(index > 0 ? point_count : face.points_before));
  }
  return static_cast<std::uint32_t>(resolved);
}

}  // namespace

SurfaceMesh read_obj(std::string_view text) {
  Statements statements = read_statements(text);
  ObjFaces faces = load_obj_faces(statements.face_text);
  MORTISE_CHECK(faces.face_ends.size() == statements.face_places.size(), "faces of the OBJ text");
  PolygonSoup soup;
  soup.points = std::move(statements.points);
  soup.corners.reserve(faces.corners.size());
  DataChannel uv{"uv", 2, DataKind::Value, {}}, normal{"normal", 3, DataKind::Normal, {}};
  std::size_t corner = 0;
  for (std::size_t face = 0; face < faces.face_ends.size(); ++face) {
    const FacePlace& place = statements.face_places[face];
    for (; corner < faces.face_ends[face]; ++corner) {
      soup.corners.push_back(resolve_index(faces.corners[corner], place, soup.points.size()));
      append_indexed(faces.textures[corner], place.textures_before, statements.textures, uv.values);
      append_indexed(faces.normals[corner], place.normals_before, statements.normals, normal.values);
    }
  }
  for (DataChannel* channel : {&uv, &normal}) {
    if (has_values(*channel)) soup.corner_data.push_back(std::move(*channel));
  }
  soup.face_ends = std::move(faces.face_ends);
  soup.face_labels = std::move(faces.face_labels);
  soup.label_names = std::move(faces.label_names);
  return build_mesh(std::move(soup));
}

std::string write_obj(const SurfaceMesh& mesh) {
  std::string text = "# Mortise\n";
  for (const Vec3d& point : mesh.points) {
    text += "v ";
    append_point(text, point);
    text += '\n';
  }
  const std::vector<std::uint32_t> textures = write_values("vt", uv_of(mesh), text);
  const std::vector<std::uint32_t> normals = write_values("vn", normals_of(mesh), text);
  const Polygons polygons = find_polygons(mesh);
  const auto label_of = [&](std::size_t i) { return mesh.face_labels[polygons.first_triangle[i].index()]; };
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (!mesh.face_labels.empty() && (i == 0 || label_of(i) != label_of(i - 1))) {
      text.append("g ").append(one_line_name(mesh.label_names[label_of(i)])).append("\n");
    }
    text += 'f';
    for (const HalfEdge side : polygons.sides_of(i)) {
      text.append(" ").append(std::to_string(std::uint64_t{origin_of(mesh, side).value} + 1));
      append_indices(textures.empty() ? 0 : textures[side], normals.empty() ? 0 : normals[side], text);
    }
    text += '\n';
  }
  return text;
}

}  // namespace mortise
