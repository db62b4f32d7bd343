// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// MEDIT's mesh format, text.
#include "mortise/io/medit.h"

#include "mortise/io/entity_mesh_builder.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "read_medit";
constexpr std::string_view group_mark = "# group ";

// ---- Reading --------------------------------------------------------------------------------------------------------

bool is_keyword(std::string_view word) { return (word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z'); }

class MeditReader {
 public:
  explicit MeditReader(std::string_view text) : words_(LineReader(text, stage_name), Comments::CutFromHash) {}

  /// Everything behind the version, into the builder.
  void read(EntityMeshBuilder& builder) {
    words_.expect("meshversionformatted");
    static_cast<void>(read_integer(words_.next(), words_.place(), "the version"));
    std::string_view keyword = words_.next();
    while (!keyword.empty() && !equals_ignoring_case(keyword, "end")) keyword = read_list(keyword, builder);
    for (const std::uint32_t corner : corners_) builder.add_element(std::array{corner}, references_[corner]);
  }

 private:
  /// Reads what follows a keyword and returns the next one.
  std::string_view read_list(std::string_view keyword, EntityMeshBuilder& builder) {
    if (equals_ignoring_case(keyword, "dimension")) {
      read_dimension();
    } else if (equals_ignoring_case(keyword, "vertices")) {
      read_vertices(builder);
    } else if (equals_ignoring_case(keyword, "edges")) {
      read_elements(2, builder);
    } else if (equals_ignoring_case(keyword, "triangles")) {
      read_elements(3, builder);
    } else if (equals_ignoring_case(keyword, "quadrilaterals")) {
      read_elements(4, builder);
    } else if (equals_ignoring_case(keyword, "corners")) {
      read_corners(builder);
    } else {
      return skip_list(keyword);
    }
    const std::string_view next = words_.next();
    if (!next.empty() && !is_keyword(next)) words_.fail("a keyword is expected: the list before holds more than it promises");
    return next;
  }

  void read_dimension() {
    const std::int64_t dimension = read_integer(words_.next(), words_.place(), "the dimension");
    if (dimension != 2 && dimension != 3) words_.fail("the dimension is neither 2 nor 3");
    dimension_ = static_cast<std::size_t>(dimension);
  }

  std::uint32_t read_count_of(std::string_view what) { return read_count(words_.next(), words_.place(), what); }

  std::int64_t read_reference() { return read_tag(words_.next(), words_.place(), "a reference", -0x7fffffff); }

  void read_vertices(EntityMeshBuilder& builder) {
    if (!builder.points.empty()) words_.fail("the vertices are listed twice");
    const std::uint32_t count = read_count_of("the number of vertices");
    builder.points.reserve(believable_count(count, words_.bytes_left(), 6));
    for (std::uint32_t i = 0; i < count; ++i) {
      Vec3d point;
      for (std::size_t k = 0; k < dimension_; ++k) point[k] = read_coordinate(words_.next(), words_.place());
      builder.points.push_back(point);
      references_.push_back(read_reference());
    }
  }

  void read_elements(std::size_t corner_count, EntityMeshBuilder& builder) {
    const std::uint32_t count = read_count_of("the number of elements");
    std::vector<std::uint32_t> corners(corner_count);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t& corner : corners) corner = read_vertex_index(words_.next(), words_.place(), 1, builder.points.size());
      builder.add_element(corners, read_reference());
    }
  }

  void read_corners(const EntityMeshBuilder& builder) {
    const std::uint32_t count = read_count_of("the number of corners");
    for (std::uint32_t i = 0; i < count; ++i)
      corners_.push_back(read_vertex_index(words_.next(), words_.place(), 1, builder.points.size()));
  }

  /// Reads over numbers up to the next keyword.
  std::string_view skip_list(std::string_view keyword) {
    check_meaning(keyword);
    std::string_view word = words_.next();
    while (!word.empty() && !is_keyword(word)) word = words_.next();
    return word;
  }

  /// Fails for words that are none of the format's, and for elements that cannot be left out.
  void check_meaning(std::string_view keyword) {
    for (const std::string_view volume : {"tetrahedra", "hexahedra", "hexaedra", "prisms", "pyramids", "pentahedra"}) {
      if (equals_ignoring_case(keyword, volume)) words_.fail("volume elements are not read yet: save the surface mesh only");
    }
    for (const std::string_view curved : {"edgesp2", "trianglesp2", "quadrilateralsq2", "tetrahedrap2"}) {
      if (equals_ignoring_case(keyword, curved)) words_.fail("curved elements are not read: save elements with straight edges");
    }
    if (!is_keyword(keyword)) words_.fail("a keyword is expected");
  }

  WordReader words_;
  std::size_t dimension_ = 3;
  std::vector<std::int64_t> references_;  ///< per vertex
  std::vector<std::uint32_t> corners_;
};

/// "DIMENSION REFERENCE TAG NAME"; false when the comment is another one.
bool read_group(std::string_view rest, EntityMeshBuilder& builder) {
  const auto take_number = [&] {
    const double number = value_of_word(take_word(rest));
    const bool is_number = number >= 0 && number <= 0x7fffffff && number == static_cast<double>(static_cast<std::int32_t>(number));
    return is_number ? static_cast<std::int32_t>(number) : -1;
  };
  const std::int32_t dimension = take_number(), reference = take_number(), tag = take_number();
  if (dimension < 0 || dimension > 2 || reference < 1 || tag < 1) return false;
  const auto d = static_cast<std::size_t>(dimension);
  const std::uint32_t group = builder.group_of(d, tag);
  builder.set_name(group, trim(rest));
  builder.add_to_group(d, builder.entity_of(d, reference), group);
  return true;
}

void read_groups(std::string_view text, EntityMeshBuilder& builder) {
  LineReader lines(text, stage_name);
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.substr(0, group_mark.size()) == group_mark) static_cast<void>(read_group(line.substr(group_mark.size()), builder));
  }
}

// ---- Writing --------------------------------------------------------------------------------------------------------

/// Per vertex the entity of its first point element, 0 where there is none; and those elements' vertices.
struct Corners {
  std::vector<std::int32_t> references;
  std::vector<VertexId> vertices;
};

Corners find_corners(const EntityMesh& mesh) {
  Corners corners{std::vector<std::int32_t>(mesh.points.size(), 0), {}};
  for (std::size_t i = 0; i < mesh.point_elements.size(); ++i) {
    const VertexId vertex = mesh.point_elements[i];
    if (corners.references[vertex.index()] != 0) continue;
    corners.references[vertex.index()] = mesh.entities[0][mesh.point_entities[i]].tag;
    corners.vertices.push_back(vertex);
  }
  return corners;
}

/// The groups of every entity, in their order: the first one is what a surface is labelled by.
void append_groups(const EntityMesh& mesh, std::string& text) {
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    for (const MeshEntity& entity : mesh.entities[dimension]) {
      for (const std::uint32_t name : entity.names) {
        const PhysicalName& group = mesh.names[name];
        text.append(group_mark).append(std::to_string(dimension)).append(" ").append(std::to_string(entity.tag)).append(" ");
        text.append(std::to_string(group.tag)).append(" ").append(one_line_name(group.name)).append("\n");
      }
    }
  }
}

void begin_list(std::string_view keyword, std::size_t count, std::string& text) {
  text.append(keyword).append("\n").append(std::to_string(count)).append("\n");
}

template <class Element>
void append_elements(std::string_view keyword, const std::vector<Element>& elements, const std::vector<std::uint32_t>& element_entities,
                     const std::vector<MeshEntity>& entities, std::string& text) {
  if (elements.empty()) return;
  begin_list(keyword, elements.size(), text);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (const VertexId vertex : elements[i]) text.append(std::to_string(vertex.index() + 1)).append(" ");
    text.append(std::to_string(entities[element_entities[i]].tag)).append("\n");
  }
}

}  // namespace

bool is_medit(std::string_view bytes) {
  constexpr std::size_t probe_size = 1024;
  WordReader words(LineReader(bytes.substr(0, probe_size), stage_name), Comments::CutFromHash);
  return equals_ignoring_case(words.next(), "meshversionformatted");
}

EntityMesh read_medit(std::string_view text) {
  EntityMeshBuilder builder;
  read_groups(text, builder);
  MeditReader(text).read(builder);
  return std::move(builder).finish();
}

std::string write_medit(const EntityMesh& mesh) {
  const Corners corners = find_corners(mesh);
  std::string text = "MeshVersionFormatted 2\nDimension 3\n# Mortise\n";
  append_groups(mesh, text);
  begin_list("Vertices", mesh.points.size(), text);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    append_point(text, mesh.points[i]);
    text.append(" ").append(std::to_string(corners.references[i])).append("\n");
  }
  if (!corners.vertices.empty()) begin_list("Corners", corners.vertices.size(), text);
  for (const VertexId vertex : corners.vertices) text.append(std::to_string(vertex.index() + 1)).append("\n");
  append_elements("Edges", mesh.lines, mesh.line_entities, mesh.entities[1], text);
  if (!mesh.lines.empty()) begin_list("Ridges", mesh.lines.size(), text);
  for (std::size_t i = 0; i < mesh.lines.size(); ++i) text.append(std::to_string(i + 1)).append("\n");
  append_elements("Triangles", mesh.triangles, mesh.triangle_entities, mesh.entities[2], text);
  return text += "End\n";
}

}  // namespace mortise
