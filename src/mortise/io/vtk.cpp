// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// VTK's legacy format, text.
#include "mortise/io/vtk.h"

#include <limits>

#include "mortise/base/numbers.h"
#include "mortise/io/cell_grid.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_vtk";
constexpr std::string_view magic = "# vtk DataFile Version";

// ---- Reading --------------------------------------------------------------------------------------------------------

/// Cells of one statement, not yet joined with the others.
struct CellList {
  std::vector<std::uint32_t> corners, ends, lines;
};

/// What the statements say, in the order VTK numbers cells in.
struct Statements {
  CellGrid grid;
  CellList cells[4];  ///< VERTICES or CELLS, LINES, POLYGONS, TRIANGLE_STRIPS
  bool is_poly_data = false;
};

std::uint32_t next_count(WordReader& words, std::string_view what) { return read_count(words.next(), words.place(), what); }

void read_points(WordReader& words, Statements& statements) {
  const std::uint32_t count = next_count(words, "the number of points");
  static_cast<void>(words.next());  // the type of the numbers
  if (!statements.grid.points.empty()) words.fail("the points are given twice");
  statements.grid.points.reserve(believable_count(count, words.bytes_left(), 6));
  for (std::uint32_t i = 0; i < count; ++i) {
    Vec3d point;
    for (std::size_t k = 0; k < 3; ++k) point[k] = read_coordinate(words.next(), words.place());
    statements.grid.points.push_back(point);
  }
}

std::uint32_t next_corner(WordReader& words, const Statements& statements) {
  return read_vertex_index(words.next(), words.place(), 0, statements.grid.points.size());
}

/// Behind "OFFSETS": ends of cells, then corners.
void read_offset_cells(WordReader& words, std::uint32_t offsets, std::uint32_t corners, const Statements& statements, CellList& cells) {
  static_cast<void>(words.next());  // the type of the numbers
  std::uint32_t previous = 0;
  for (std::uint32_t i = 0; i < offsets; ++i) {
    const std::uint32_t offset = next_count(words, "an offset");
    if (offset < previous || offset > corners || (i == 0 && offset != 0)) words.fail("the offsets of the cells do not ascend from 0");
    if (i + 1 == offsets && offset != corners) words.fail("the last offset is not the number of corners");
    if (i > 0) cells.ends.push_back(offset);
    previous = offset;
  }
  words.expect("connectivity");
  static_cast<void>(words.next());
  std::size_t cell = 0;
  for (std::uint32_t i = 0; i < corners; ++i) {
    cells.corners.push_back(next_corner(words, statements));
    for (; cell < cells.ends.size() && cells.ends[cell] <= i + 1; ++cell) cells.lines.push_back(words.place().line);
  }
  cells.lines.resize(cells.ends.size(), words.place().line);
}

/// "n size", then offsets and corners (5.1) or lists that begin with their length.
void read_cells(WordReader& words, const Statements& statements, CellList& cells) {
  if (!cells.ends.empty()) words.fail("cells of one kind are given twice");
  const std::uint32_t count = next_count(words, "the number of cells");
  const std::uint32_t size = next_count(words, "the size of the list of cells");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string_view word = words.next();
    if (i == 0 && word == "OFFSETS") return read_offset_cells(words, count, size, statements, cells);
    const std::uint32_t length = read_count(word, words.place(), "the number of corners");
    cells.lines.push_back(words.place().line);
    for (std::uint32_t k = 0; k < length; ++k) cells.corners.push_back(next_corner(words, statements));
    cells.ends.push_back(static_cast<std::uint32_t>(cells.corners.size()));
  }
}

void read_types(WordReader& words, CellGrid& grid) {
  const std::uint32_t count = next_count(words, "the number of cell types");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t type = next_count(words, "the type of a cell");
    grid.types.push_back(static_cast<std::uint8_t>(std::min<std::uint32_t>(type, std::numeric_limits<std::uint8_t>::max())));
  }
}

void skip_words(WordReader& words, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    if (words.next().empty()) words.fail("the file ends inside an array");
  }
}

bool is_integer_type(std::string_view type) { return type.find("float") == std::string_view::npos && type != "double" && type != "string"; }

void read_integers(WordReader& words, std::uint64_t count, std::vector<std::int64_t>& numbers) {
  numbers.clear();
  for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(read_integer(words.next(), words.place(), "a number of an array"));
}

/// An array of one number per cell: kept when it says entities or groups.
void read_cell_array(WordReader& words, std::string_view name, std::string_view type, std::uint64_t count, bool has_meaning,
                     CellGrid& grid) {
  if (has_meaning && is_integer_type(type) && is_entity_array(name)) return read_integers(words, count, grid.entities);
  if (has_meaning && is_integer_type(type) && is_group_array(name)) return read_integers(words, count, grid.tags);
  skip_words(words, count);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/// Strings are one per line, with "%20" for what is no letter.
std::string decode(std::string_view word) {
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool is_code = word[i] == '%' && i + 2 < word.size() && hex_digit(word[i + 1]) >= 0 && hex_digit(word[i + 2]) >= 0;
    text += is_code ? static_cast<char>(hex_digit(word[i + 1]) * 16 + hex_digit(word[i + 2])) : word[i];
    if (is_code) i += 2;
  }
  return text;
}

void read_strings(WordReader& words, std::uint64_t count, std::vector<std::string>* kept) {
  static_cast<void>(words.rest_of_line());
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!words.next_line()) words.fail("the file ends inside an array");
    const std::string_view line = words.rest_of_line();
    if (kept != nullptr) kept->push_back(decode(line));
  }
}

/// One array of a FIELD: "name components tuples type", then its values.
struct FieldHead {
  std::string name;
  std::uint64_t value_count;
  std::string_view type;
};

FieldHead read_field_head(WordReader& words) {
  std::string_view name = words.next();
  while (name == "METADATA") {
    words.skip_paragraph();
    name = words.next();
  }
  const std::uint32_t components = next_count(words, "the number of components");
  const std::uint32_t tuples = next_count(words, "the number of rows");
  return {decode(name), std::uint64_t{components} * tuples, words.next()};
}

void read_file_field(WordReader& words, CellGroups& groups) {
  static_cast<void>(words.next());
  const std::uint32_t arrays = next_count(words, "the number of arrays");
  for (std::uint32_t i = 0; i < arrays; ++i) {
    const auto [name, count, type] = read_field_head(words);
    if (type == "string") {
      read_strings(words, count, name == CellGroups::names_name && groups.names.empty() ? &groups.names : nullptr);
    } else if (name == CellGroups::dimensions_name) {
      read_integers(words, count, groups.dimensions);
    } else if (name == CellGroups::tags_name) {
      read_integers(words, count, groups.tags);
    } else if (name == CellGroups::members_name) {
      read_integers(words, count, groups.members);
    } else {
      skip_words(words, count);
    }
  }
}

/// What POINT_DATA or CELL_DATA begins.
struct DataSection {
  std::uint32_t count = 0;
  bool is_of_cells = false;
};

void read_data_field(WordReader& words, const DataSection& section, CellGrid& grid) {
  static_cast<void>(words.next());
  const std::uint32_t arrays = next_count(words, "the number of arrays");
  for (std::uint32_t i = 0; i < arrays; ++i) {
    const auto [name, count, type] = read_field_head(words);
    if (type == "string") {
      read_strings(words, count, nullptr);
    } else {
      read_cell_array(words, name, type, count, section.is_of_cells && count == section.count, grid);
    }
  }
}

/// "SCALARS name type [components]", then perhaps the name of a table on a line of its own, then values.
void read_scalars(WordReader& words, const DataSection& section, CellGrid& grid) {
  const std::string name = decode(words.next());
  const std::string_view type = words.next();
  const std::string_view rest = words.rest_of_line();
  const std::uint32_t components = rest.empty() ? 1 : read_count(rest, words.place(), "the number of components");
  words.expect("lookup_table");
  static_cast<void>(words.next());
  read_cell_array(words, name, type, std::uint64_t{components} * section.count, section.is_of_cells && components == 1, grid);
}

/// How many values per point or cell an attribute has that means nothing here; 0: it is none.
std::uint64_t skipped_components(std::string_view keyword) {
  if (keyword == "VECTORS" || keyword == "NORMALS") return 3;
  if (keyword == "TENSORS") return 9;
  if (keyword == "TENSORS6") return 6;
  return keyword == "GLOBAL_IDS" || keyword == "PEDIGREE_IDS" || keyword == "EDGE_FLAGS" ? 1 : 0;
}

/// Reads an attribute of points or cells; false when the keyword is none.
bool read_attribute(std::string_view keyword, WordReader& words, const DataSection& section, CellGrid& grid) {
  if (keyword == "SCALARS") {
    read_scalars(words, section, grid);
  } else if (keyword == "FIELD") {
    read_data_field(words, section, grid);
  } else if (keyword == "LOOKUP_TABLE") {
    static_cast<void>(words.next());
    skip_words(words, std::uint64_t{next_count(words, "the size of a table")} * 4);
  } else if (keyword == "COLOR_SCALARS" || keyword == "TEXTURE_COORDINATES") {
    static_cast<void>(words.next());
    const std::uint64_t components = next_count(words, "the number of components");
    if (keyword == "TEXTURE_COORDINATES") static_cast<void>(words.next());
    skip_words(words, components * section.count);
  } else if (const std::uint64_t components = skipped_components(keyword); components > 0) {
    skip_words(words, 2 + components * section.count);
  } else {
    return false;
  }
  return true;
}

/// Where the cells of a keyword belong; 4: it is none.
std::size_t cell_list_of(std::string_view keyword, bool is_poly_data) {
  if (!is_poly_data) return keyword == "CELLS" ? 0 : 4;
  return keyword == "VERTICES" ? 0 : keyword == "LINES" ? 1 : keyword == "POLYGONS" ? 2 : keyword == "TRIANGLE_STRIPS" ? 3 : 4;
}

Statements read_statements(WordReader& words, bool is_poly_data) {
  Statements statements;
  statements.is_poly_data = is_poly_data;
  DataSection section;
  bool has_section = false;
  for (std::string_view keyword = words.next(); !keyword.empty(); keyword = words.next()) {
    const std::size_t list = cell_list_of(keyword, is_poly_data);
    if (list < 4) {
      read_cells(words, statements, statements.cells[list]);
    } else if (keyword == "POINTS") {
      read_points(words, statements);
    } else if (keyword == "CELL_TYPES" && !is_poly_data) {
      read_types(words, statements.grid);
    } else if (keyword == "METADATA") {
      words.skip_paragraph();
    } else if (keyword == "FIELD" && !has_section) {
      read_file_field(words, statements.grid.groups);
    } else if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
      section = {next_count(words, "the number of values"), keyword == "CELL_DATA"};
      has_section = true;
    } else if (!has_section || !read_attribute(keyword, words, section, statements.grid)) {
      words.fail("this is not a statement of a surface in VTK's format");
    }
  }
  return statements;
}

/// Puts the cells of all statements into one list.
void join_cells(Statements& statements) {
  constexpr std::uint8_t poly_types[] = {2, 4, 7, 6};  // strings of points, of lines, polygons, strips
  CellGrid& grid = statements.grid;
  for (std::size_t list = 0; list < 4; ++list) {
    const CellList& cells = statements.cells[list];
    const auto before = static_cast<std::uint32_t>(grid.corners.size());
    grid.corners.insert(grid.corners.end(), cells.corners.begin(), cells.corners.end());
    grid.lines.insert(grid.lines.end(), cells.lines.begin(), cells.lines.end());
    for (const std::uint32_t end : cells.ends) grid.cell_ends.push_back(before + end);
    if (statements.is_poly_data) grid.types.resize(grid.cell_ends.size(), poly_types[list]);
  }
}

/// Reads the three lines and the statement every file begins with. Does it hold PolyData?
bool read_head(LineReader& lines) {
  if (!lines.next() || !is_vtk(lines.line()))
    fail_at_line(ErrorCode::ParseFailed, lines.place(), "'" + std::string(magic) + "' is expected");
  if (!lines.next() || !lines.next()) fail_at_line(ErrorCode::ParseFailed, lines.place(), "the file ends inside its header");
  const std::string_view encoding = trim(lines.line());
  if (equals_ignoring_case(encoding, "binary")) {
    fail_at_line(ErrorCode::ParseFailed, lines.place(), "the file is binary, and only text files are read: save it as ASCII");
  }
  if (!equals_ignoring_case(encoding, "ascii")) fail_at_line(ErrorCode::ParseFailed, lines.place(), "'ASCII' is expected");
  while (lines.next() && trim(lines.line()).empty()) continue;
  std::string_view rest = lines.line();
  const bool is_data_set = equals_ignoring_case(take_word(rest), "dataset");
  const bool is_poly_data = equals_ignoring_case(trim(rest), "polydata");
  if (!is_data_set || (!is_poly_data && !equals_ignoring_case(trim(rest), "unstructured_grid"))) {
    fail_at_line(ErrorCode::ParseFailed, lines.place(), "'DATASET POLYDATA' or 'DATASET UNSTRUCTURED_GRID' is expected");
  }
  return is_poly_data;
}

// ---- Writing --------------------------------------------------------------------------------------------------------

std::string encode(std::string_view name) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  for (const char c : name) {
    const bool is_plain = c > ' ' && c <= '~' && c != '%' && c != '"';
    const auto code = static_cast<unsigned char>(c);
    if (is_plain) {
      text += c;
    } else {
      text.append("%").append(1, digits[code / 16]).append(1, digits[code % 16]);
    }
  }
  return text;
}

void append_field_array(std::string_view name, std::size_t components, const std::vector<std::int64_t>& numbers, std::string& text) {
  text.append(name).append(" ").append(std::to_string(components)).append(" ");
  text.append(std::to_string(numbers.size() / components)).append(" int\n");
  for (std::size_t i = 0; i < numbers.size(); ++i) text.append(std::to_string(numbers[i])).append((i + 1) % components == 0 ? "\n" : " ");
}

void append_groups(const CellGroups& groups, std::string& text) {
  if (groups.tags.empty()) return;
  text.append("FIELD FieldData ").append(groups.members.empty() ? "3\n" : "4\n");
  append_field_array(CellGroups::dimensions_name, 1, groups.dimensions, text);
  append_field_array(CellGroups::tags_name, 1, groups.tags, text);
  text.append(CellGroups::names_name).append(" 1 ").append(std::to_string(groups.names.size())).append(" string\n");
  for (const std::string& name : groups.names) text.append(encode(name)).append("\n");
  if (!groups.members.empty()) append_field_array(CellGroups::members_name, 3, groups.members, text);
}

void append_cells(const CellGrid& grid, std::string& text) {
  text.append("CELLS ").append(std::to_string(grid.cell_count())).append(" ");
  text.append(std::to_string(grid.cell_count() + grid.corners.size())).append("\n");
  std::size_t corner = 0;
  for (const std::uint32_t end : grid.cell_ends) {
    text += std::to_string(end - corner);
    for (; corner < end; ++corner) text.append(" ").append(std::to_string(grid.corners[corner]));
    text += '\n';
  }
  text.append("CELL_TYPES ").append(std::to_string(grid.cell_count())).append("\n");
  for (const std::uint8_t type : grid.types) text.append(std::to_string(int{type})).append("\n");
}

}  // namespace

bool is_vtk(std::string_view bytes) { return bytes.substr(0, magic.size()) == magic; }

EntityMesh read_vtk(std::string_view text) {
  LineReader lines(text, stage_name);
  const bool is_poly_data = read_head(lines);
  WordReader words(lines);
  Statements statements = read_statements(words, is_poly_data);
  join_cells(statements);
  return entity_mesh_of_grid(std::move(statements.grid), words.place());
}

std::string write_vtk(const EntityMesh& mesh) {
  const CellGrid grid = cell_grid_of(mesh);
  std::string text(magic);
  text += " 3.0\nMortise\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  text.append("POINTS ").append(std::to_string(grid.points.size())).append(" double\n");
  for (const Vec3d& point : grid.points) {
    append_point(text, point);
    text += '\n';
  }
  append_cells(grid, text);
  append_groups(grid.groups, text);
  text.append("CELL_DATA ").append(std::to_string(grid.cell_count())).append("\n");
  text += "FIELD FieldData 2\n";
  append_field_array("entity", 1, grid.entities, text);
  append_field_array("group", 1, grid.tags, text);
  return text;
}

}  // namespace mortise
