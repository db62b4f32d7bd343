// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Object File Format, text.
#include "mortise/io/off.h"

#include "mortise/base/numbers.h"
#include "mortise/io/polygon_soup.h"
#include "mortise/io/text.h"
#include "mortise/mesh/polygons.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_off";

struct Counts {
  std::uint32_t vertices;
  std::uint32_t faces;
};

bool starts_as_number(std::string_view word) { return word.find_first_of("+-0123456789") == 0; }

/// Reads over "[ST][C][N]OFF" in `rest` when it is there: the keyword may be left out.
void take_keyword(std::string_view& rest, const TextPlace& place) {
  std::string_view after = rest;
  const std::string_view word = take_word(after);
  if (starts_as_number(word) && word.find("OFF") == std::string_view::npos) return;
  for (const std::string_view known : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"}) {
    if (word != known) continue;
    rest = after;
    return;
  }
  fail_at_line(ErrorCode::ParseFailed, place, "the keyword OFF is missing, or names a kind that is not a text of 3D points");
}

void require_line(LineReader& lines, std::string_view what) {
  if (!lines.next_content())
    fail_at_line(ErrorCode::ParseFailed, lines.place(), "the file ends where " + std::string(what) + " is expected");
}

Counts read_counts(LineReader& lines) {
  require_line(lines, "the keyword OFF");
  std::string_view rest = lines.line();
  take_keyword(rest, lines.place());
  if (trim(rest).empty()) {
    require_line(lines, "the line of counts");
    rest = lines.line();
  }
  const std::uint32_t vertices = read_count(take_word(rest), lines.place(), "the number of vertices");
  const std::uint32_t faces = read_count(take_word(rest), lines.place(), "the number of faces");
  return {vertices, faces};
}

Vec3d read_vertex(LineReader& lines) {
  require_line(lines, "a vertex");
  std::string_view rest = lines.line();
  Vec3d point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = read_coordinate(take_word(rest), lines.place());
  return point;
}

void read_face(LineReader& lines, std::uint32_t vertex_count, PolygonSoup& soup) {
  require_line(lines, "a face");
  std::string_view rest = lines.line();
  const std::uint32_t corner_count = read_count(take_word(rest), lines.place(), "the number of corners");
  if (corner_count < 3) fail_at_line(ErrorCode::ParseFailed, lines.place(), "a face needs at least three corners");
  for (std::uint32_t i = 0; i < corner_count; ++i) {
    const std::int64_t index = read_integer(take_word(rest), lines.place(), "a vertex index");
    if (index < 0 || index >= vertex_count) {
      fail_at_line(ErrorCode::BadIndex, lines.place(),
                   "the face names vertex " + std::to_string(index) + " of " + std::to_string(vertex_count) + " (the first is 0)");
    }
    soup.corners.push_back(static_cast<std::uint32_t>(index));
  }
  soup.end_face();
}

}  // namespace

SurfaceMesh read_off(std::string_view text) {
  LineReader lines(text, stage_name);
  const Counts counts = read_counts(lines);
  PolygonSoup soup;
  soup.points.reserve(believable_count(counts.vertices, text.size() - lines.offset(), 6));
  for (std::uint32_t i = 0; i < counts.vertices; ++i) soup.points.push_back(read_vertex(lines));
  soup.face_ends.reserve(believable_count(counts.faces, text.size() - lines.offset(), 8));
  for (std::uint32_t i = 0; i < counts.faces; ++i) read_face(lines, counts.vertices, soup);
  return build_mesh(std::move(soup));
}

std::string write_off(const SurfaceMesh& mesh) {
  const Polygons polygons = find_polygons(mesh);
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " + std::to_string(polygons.size()) + " 0\n";
  for (const Vec3d& point : mesh.points) {
    append_point(text, point);
    text += '\n';
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto corners = polygons.corners_of(i);
    text += std::to_string(corners.size());
    for (const VertexId vertex : corners) text.append(" ").append(std::to_string(vertex.value));
    text += '\n';
  }
  return text;
}

}  // namespace mortise
