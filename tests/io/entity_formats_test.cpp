// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Formats of analysis programs through one door: round trips with points, lines and regions; damage.
#include <array>
#include <random>

#include "io/io_support.h"
#include "mortise/io/formats.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr std::array readable_formats{Format::Msh41, Format::Msh22, Format::Vtk, Format::Vtu, Format::Medit};

/// What a format gives back of two_regions().
EntityMesh kept_by(Format format) {
  if (format == Format::Msh41) return two_regions();
  EntityMesh mesh = two_regions_flattened();
  if (format != Format::Medit) return mesh;
  mesh.names = {mesh.names[4], mesh.names[2], mesh.names[1], mesh.names[0], mesh.names[3]};  // as entities have them, none of regions
  mesh.entities[0][0].names = {0};
  mesh.entities[1][0].names = {1};
  mesh.entities[2][0].names = {2, 3};
  mesh.entities[2][2].names = {4};
  return mesh;
}

void check_sound(const EntityMesh& mesh) {
  const std::array<const std::vector<std::uint32_t>*, 3> element_entities{&mesh.point_entities, &mesh.line_entities,
                                                                          &mesh.triangle_entities};
  for (const VertexId vertex : mesh.point_elements) REQUIRE(vertex.index() < mesh.points.size());
  for (const auto& line : mesh.lines) REQUIRE((line[0].index() < mesh.points.size() && line[1].index() < mesh.points.size()));
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId vertex : t) REQUIRE(vertex.index() < mesh.points.size());
  }
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    const std::vector<MeshEntity>& entities = mesh.entities[dimension];
    for (std::size_t i = 0; i < entities.size(); ++i) {
      REQUIRE(entities[i].tag > (i == 0 ? 0 : entities[i - 1].tag));
      for (const std::uint32_t name : entities[i].names) REQUIRE(mesh.names.at(name).dimension == dimension);
    }
    if (dimension == 3) continue;
    for (const std::uint32_t entity : *element_entities[dimension]) REQUIRE(entity < entities.size());
  }
  REQUIRE(mesh.triangle_entities.size() == mesh.triangles.size());
  REQUIRE(mesh.line_entities.size() == mesh.lines.size());
  REQUIRE(mesh.point_entities.size() == mesh.point_elements.size());
}

}  // namespace

TEST_CASE("A mesh of entities comes back from every format, but for what its header says is lost") {
  for (const Format format : readable_formats) {
    CAPTURE(format_name(format));
    check_same(read_entity_mesh(write_entity_mesh(two_regions(), format), ""), kept_by(format));
  }
}

TEST_CASE("A labelled mesh comes back from every format as the same faces") {
  for (const Format format : readable_formats) {
    CAPTURE(format_name(format));
    check_same(read_entity_mesh(write_mesh(awkward_tetrahedron(), format), ""), entity_mesh_of(awkward_tetrahedron()));
  }
}

TEST_CASE("Meshes with points only and with nothing at all can be written and read") {
  SurfaceMesh points;
  points.points = {{1, 2, 3}, {4, 5, 6}};
  for (const Format format : readable_formats) {
    CAPTURE(format_name(format));
    CHECK(point_bits(read_mesh(write_mesh(points, format), "")) == point_bits(points));
    CHECK(read_mesh(write_mesh({}, format), "").points.empty());
    CHECK(read_entity_mesh(write_entity_mesh({}, format), "").triangles.empty());
    EntityMesh loose;
    loose.points = points.points;
    CHECK(read_entity_mesh(write_entity_mesh(loose, format), "").points == points.points);
  }
}

TEST_CASE("Equal points stay apart in a mesh of entities and are welded in a surface mesh") {
  SurfaceMesh mesh = float_tetrahedron();
  mesh.points.push_back(mesh.points[0]);
  mesh.triangles[3] = triangle(2, 4, 3);
  for (const Format format : readable_formats) {
    CAPTURE(format_name(format));
    const std::string bytes = write_mesh(mesh, format);
    CHECK(read_entity_mesh(bytes, "").points.size() == 5);
    CHECK(read_mesh(bytes, "").points.size() == 4);
  }
}

TEST_CASE("Other formats give and take meshes of entities as surfaces with labels") {
  const EntityMesh mesh = entity_mesh_of(awkward_tetrahedron());
  const EntityMesh back = read_entity_mesh(write_entity_mesh(mesh, Format::Obj), "mesh.obj");
  check_same(back, mesh);
}

TEST_CASE("An analysis file cut off anywhere gives a sound mesh or an error that names a line") {
  for (const Format format : readable_formats) {
    const std::string bytes = write_entity_mesh(two_regions(), format);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      try {
        check_sound(read_entity_mesh(std::string_view(bytes).substr(0, size), "mesh." + std::string(format_name(format))));
      } catch (const Error& error) {
        CAPTURE(format_name(format), size, error.message);
        REQUIRE(error.id_kind == IdKind::Line);
        REQUIRE(error.ids.size() == 1);
      }
    }
  }
}

TEST_CASE("An analysis file with words exchanged gives a sound mesh or a typed error") {
  constexpr std::uint64_t seed = 17;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  constexpr std::array<std::string_view, 16> words{"0",  "-1", "1",    "3",      "4000000000", "99999999999999999999", "x",     "\n",
                                                   "\"", "<",  "</a>", "$Nodes", "METADATA",   "FIELD f 4000000000",   "CELLS", "nan"};
  std::size_t meshes = 0, errors = 0;
  for (const Format format : readable_formats) {
    const std::string sound = write_entity_mesh(two_regions(), format);
    for (std::size_t i = 0; i < scaled_count(2000, 50000); ++i) {
      std::string bytes = sound;
      for (std::uint64_t changes = random() % 3 + 1; changes > 0; --changes) {
        const std::size_t begin = bytes.find_first_not_of(" \n", static_cast<std::size_t>(random() % bytes.size()));
        if (begin == std::string::npos) continue;
        const std::size_t end = std::min(bytes.find_first_of(" \n", begin), bytes.size());
        bytes.replace(begin, end - begin, words[static_cast<std::size_t>(random() % words.size())]);
      }
      try {
        const EntityMesh mesh = read_entity_mesh(bytes, "mesh." + std::string(format_name(format)));
        check_sound(mesh);
        for (const Format target : readable_formats) REQUIRE(!write_entity_mesh(mesh, target).empty());
        ++meshes;
      } catch (const Error& error) {
        REQUIRE(error.code != ErrorCode::InternalError);
        ++errors;
      }
    }
  }
  CHECK(meshes > 100);
  CHECK(errors > 100);
}
