// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// VTK's XML format for unstructured grids, text.
#include "mortise/io/vtu.h"

#include <algorithm>
#include <limits>

#include "mortise/io/cell_grid.h"
#include "mortise/io/text.h"
#include "mortise/io/xml.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_vtu";

// ---- Reading --------------------------------------------------------------------------------------------------------

/// A DataArray whose numbers are not read yet.
struct Array {
  std::string name, type, format, components;
  std::string_view text;
  TextPlace place;
};

/// The arrays of one part of a piece, or of the field data.
using Arrays = std::vector<Array>;

struct Piece {
  TextPlace place;
  std::string point_count, cell_count;
  Arrays points, cells, cell_data;
};

struct Document {
  Arrays field_data;
  std::vector<Piece> pieces;
};

Array array_of(const XmlTag& tag, const XmlReader& xml) {
  return {std::string(tag.value_of("Name")),
          std::string(tag.value_of("type")),
          std::string(tag.value_of("format")),
          std::string(tag.value_of("NumberOfComponents")),
          tag.is_empty ? std::string_view() : xml.text_behind(),
          xml.place()};
}

/// Where the arrays inside a tag belong; none when they mean nothing.
Arrays* arrays_of(std::string_view tag, Document& document) {
  if (tag == "FieldData") return &document.field_data;
  if (document.pieces.empty()) return nullptr;
  Piece& piece = document.pieces.back();
  return tag == "Points" ? &piece.points : tag == "Cells" ? &piece.cells : tag == "CellData" ? &piece.cell_data : nullptr;
}

void check_file_tag(const XmlTag& tag) {
  if (tag.name != "VTKFile") fail_at_line(ErrorCode::ParseFailed, tag.place, "'VTKFile' is expected");
  if (tag.value_of("type") == "UnstructuredGrid") return;
  fail_at_line(ErrorCode::ParseFailed, tag.place, "the file does not hold an UnstructuredGrid");
}

/// All tags of the text; raw data behind the last piece are not looked at.
Document read_document(std::string_view text) {
  XmlReader xml(text, stage_name);
  XmlTag tag;
  if (!xml.next(tag)) xml.fail("'VTKFile' is expected but the file ends");
  check_file_tag(tag);
  Document document;
  Arrays* arrays = nullptr;
  while (xml.next(tag) && tag.name != "AppendedData") {
    if (tag.name == "Piece" && !tag.is_end) {
      document.pieces.push_back(
          {tag.place, std::string(tag.value_of("NumberOfPoints")), std::string(tag.value_of("NumberOfCells")), {}, {}, {}});
    } else if (tag.name == "DataArray" || tag.name == "Array") {
      if (!tag.is_end && arrays != nullptr) arrays->push_back(array_of(tag, xml));
    } else {
      arrays = tag.is_end || tag.is_empty ? nullptr : arrays_of(tag.name, document);
    }
  }
  return document;
}

/// The words of an array.
WordReader words_of(const Array& array) {
  if (array.format != "ascii" && !array.format.empty()) {
    fail_at_line(ErrorCode::ParseFailed, array.place,
                 "the array '" + one_line_name(array.name) + "' is not text, and only text is read: save the file as ASCII");
  }
  return WordReader(LineReader(array.text, stage_name, array.place.line - 1));
}

/// Reads every number of an array by a function of word and place.
template <class Read>
void read_all(const Array& array, const Read& read) {
  WordReader words = words_of(array);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) read(word, words.place());
}

void read_integers(const Array& array, std::vector<std::int64_t>& numbers) {
  read_all(array,
           [&](std::string_view word, const TextPlace& place) { numbers.push_back(read_integer(word, place, "a number of an array")); });
}

const Array& find_array(const Arrays& arrays, std::string_view name, const TextPlace& place) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const Array& array) { return array.name == name; });
  if (found == arrays.end()) fail_at_line(ErrorCode::ParseFailed, place, "the piece has no array '" + std::string(name) + "'");
  return *found;
}

void read_points(const Piece& piece, CellGrid& grid) {
  const std::uint32_t count = read_count(piece.point_count, piece.place, "the number of points");
  if (count == 0) return;
  if (piece.points.size() != 1 || piece.points[0].components != "3") {
    fail_at_line(ErrorCode::ParseFailed, piece.place, "the piece has not one array of points with three components");
  }
  std::vector<double> numbers;
  read_all(piece.points[0], [&](std::string_view word, const TextPlace& place) { numbers.push_back(read_coordinate(word, place)); });
  if (numbers.size() != std::size_t{count} * 3) {
    fail_at_line(ErrorCode::ParseFailed, piece.points[0].place, "the array has not three numbers for each point");
  }
  for (std::size_t i = 0; i < numbers.size(); i += 3) grid.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
}

/// The corners and ends of the cells of a piece, behind those of the pieces before it.
void read_connectivity(const Piece& piece, std::size_t points_before, CellGrid& grid) {
  const auto corners_before = static_cast<std::uint32_t>(grid.corners.size());
  const std::size_t point_count = grid.points.size() - points_before;
  std::vector<std::uint32_t> line_of_corner;
  read_all(find_array(piece.cells, "connectivity", piece.place), [&](std::string_view word, const TextPlace& place) {
    grid.corners.push_back(static_cast<std::uint32_t>(points_before) + read_vertex_index(word, place, 0, point_count));
    line_of_corner.push_back(place.line);
  });
  const Array& offsets = find_array(piece.cells, "offsets", piece.place);
  std::uint32_t previous = 0;
  read_all(offsets, [&](std::string_view word, const TextPlace& place) {
    const std::uint32_t offset = read_count(word, place, "an offset");
    if (offset < previous || offset > line_of_corner.size()) {
      fail_at_line(ErrorCode::ParseFailed, place, "the offsets of the cells do not ascend to the number of corners");
    }
    grid.cell_ends.push_back(corners_before + offset);
    grid.lines.push_back(offset > previous ? line_of_corner[offset - 1] : place.line);
    previous = offset;
  });
  if (previous != line_of_corner.size()) {
    fail_at_line(ErrorCode::ParseFailed, offsets.place, "the last offset is not the number of corners");
  }
}

void read_types(const Array& array, CellGrid& grid) {
  read_all(array, [&](std::string_view word, const TextPlace& place) {
    const std::uint32_t type = read_count(word, place, "the type of a cell");
    grid.types.push_back(static_cast<std::uint8_t>(std::min<std::uint32_t>(type, std::numeric_limits<std::uint8_t>::max())));
  });
}

bool is_of_integers(const Array& array) {
  const bool is_one = array.components.empty() || array.components == "1";
  return is_one && (array.type.find("Int") != std::string::npos);
}

/// Arrays of tags; a piece that lacks one that others have gives 0.
void read_cell_data(const Piece& piece, CellGrid& grid) {
  const std::size_t cells_before = std::min(grid.entities.size(), grid.tags.size());
  for (const Array& array : piece.cell_data) {
    if (!is_of_integers(array)) continue;
    std::vector<std::int64_t>* const kept = is_entity_array(array.name)  ? &grid.entities
                                            : is_group_array(array.name) ? &grid.tags
                                                                         : nullptr;
    if (kept == nullptr || kept->size() != cells_before) continue;
    read_integers(array, *kept);
    if (kept->size() != grid.cell_count()) fail_at_line(ErrorCode::ParseFailed, array.place, "the array has not one number for each cell");
  }
  grid.entities.resize(grid.cell_count(), 0);
  grid.tags.resize(grid.cell_count(), 0);
}

void read_piece(const Piece& piece, CellGrid& grid) {
  const std::uint32_t cells = read_count(piece.cell_count, piece.place, "the number of cells");
  const std::size_t points_before = grid.points.size(), cells_before = grid.cell_count();
  read_points(piece, grid);
  if (cells > 0) {
    read_connectivity(piece, points_before, grid);
    read_types(find_array(piece.cells, "types", piece.place), grid);
  }
  if (grid.cell_count() - cells_before != cells || grid.types.size() != grid.cell_count()) {
    fail_at_line(ErrorCode::ParseFailed, piece.place, "the arrays of the cells are not as long as the piece says");
  }
  read_cell_data(piece, grid);
}

void read_names(const Array& array, std::vector<std::string>& names) {
  std::string name;
  read_all(array, [&](std::string_view word, const TextPlace& place) {
    const std::int64_t code = read_integer(word, place, "a byte of a string");
    if (code < -128 || code > 255) fail_at_line(ErrorCode::ParseFailed, place, "a byte of a string is out of range");
    if (code != 0) {
      name += static_cast<char>(code);
    } else {
      names.push_back(std::move(name));
      name.clear();
    }
  });
  if (!name.empty()) names.push_back(name);
}

void read_groups(const Arrays& arrays, CellGroups& groups) {
  for (const Array& array : arrays) {
    if (array.type == "String" && array.name == CellGroups::names_name && groups.names.empty()) read_names(array, groups.names);
    if (array.name == CellGroups::dimensions_name && groups.dimensions.empty()) read_integers(array, groups.dimensions);
    if (array.name == CellGroups::tags_name && groups.tags.empty()) read_integers(array, groups.tags);
    if (array.name == CellGroups::members_name && groups.members.empty()) read_integers(array, groups.members);
  }
}

/// Arrays of nothing but 0 say nothing.
void drop_zeros(std::vector<std::int64_t>& numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [](std::int64_t number) { return number == 0; })) numbers.clear();
}

// ---- Writing --------------------------------------------------------------------------------------------------------

/// Appends a DataArray, so many numbers to a line.
template <class Numbers>
void append_array(std::string_view attributes, const Numbers& numbers, std::size_t per_line, std::string& text) {
  text.append("<DataArray ").append(attributes).append(" format=\"ascii\">\n");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool ends_line = (i + 1) % per_line == 0 || i + 1 == numbers.size();
    text.append(std::to_string(numbers[i])).append(ends_line ? "\n" : " ");
  }
  text += "</DataArray>\n";
}

std::string field_attributes(std::string_view name, std::size_t components, std::size_t rows) {
  return "type=\"Int32\" Name=\"" + std::string(name) + "\" NumberOfComponents=\"" + std::to_string(components) + "\" NumberOfTuples=\"" +
         std::to_string(rows) + "\"";
}

void append_names(const std::vector<std::string>& names, std::string& text) {
  text.append("<DataArray type=\"String\" Name=\"").append(CellGroups::names_name);
  text.append("\" NumberOfTuples=\"").append(std::to_string(names.size())).append("\" format=\"ascii\">\n");
  for (const std::string& name : names) {
    for (const char c : name) text.append(std::to_string(int{static_cast<unsigned char>(c)})).append(" ");
    text += "0\n";
  }
  text += "</DataArray>\n";
}

void append_groups(const CellGroups& groups, std::string& text) {
  if (groups.tags.empty()) return;
  text += "<FieldData>\n";
  append_array(field_attributes(CellGroups::dimensions_name, 1, groups.dimensions.size()), groups.dimensions, 20, text);
  append_array(field_attributes(CellGroups::tags_name, 1, groups.tags.size()), groups.tags, 20, text);
  append_names(groups.names, text);
  append_array(field_attributes(CellGroups::members_name, 3, groups.members.size() / 3), groups.members, 3, text);
  text += "</FieldData>\n";
}

void append_points(const std::vector<Vec3d>& points, std::string& text) {
  text += "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Vec3d& point : points) {
    append_point(text, point);
    text += '\n';
  }
  text += "</DataArray>\n</Points>\n";
}

void append_corners(const CellGrid& grid, std::string& text) {
  text += "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::size_t corner = 0;
  for (const std::uint32_t end : grid.cell_ends) {
    for (; corner < end; ++corner) text.append(std::to_string(grid.corners[corner])).append(corner + 1 < end ? " " : "\n");
  }
  text += "</DataArray>\n";
}

}  // namespace

bool is_vtu(std::string_view bytes) {
  constexpr std::size_t probe_size = 4096;
  const std::string_view head = bytes.substr(0, probe_size);
  return trim(head.substr(0, head.find('<'))).empty() && head.find("<VTKFile") != std::string_view::npos;
}

EntityMesh read_vtu(std::string_view text) {
  const Document document = read_document(text);
  CellGrid grid;
  for (const Piece& piece : document.pieces) read_piece(piece, grid);
  read_groups(document.field_data, grid.groups);
  drop_zeros(grid.entities);
  drop_zeros(grid.tags);
  const std::uint32_t line = document.pieces.empty() ? 1 : document.pieces.front().place.line;
  return entity_mesh_of_grid(std::move(grid), {stage_name, line});
}

std::string write_vtu(const EntityMesh& mesh) {
  const CellGrid grid = cell_grid_of(mesh);
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n";
  text += "<!-- Mortise -->\n<UnstructuredGrid>\n";
  append_groups(grid.groups, text);
  text.append("<Piece NumberOfPoints=\"").append(std::to_string(grid.points.size()));
  text.append("\" NumberOfCells=\"").append(std::to_string(grid.cell_count())).append("\">\n");
  append_points(grid.points, text);
  text += "<Cells>\n";
  append_corners(grid, text);
  append_array("type=\"Int64\" Name=\"offsets\"", grid.cell_ends, 20, text);
  append_array("type=\"UInt8\" Name=\"types\"", grid.types, 40, text);
  text += "</Cells>\n<CellData>\n";
  append_array("type=\"Int32\" Name=\"entity\"", grid.entities, 20, text);
  append_array("type=\"Int32\" Name=\"group\"", grid.tags, 20, text);
  return text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace mortise
