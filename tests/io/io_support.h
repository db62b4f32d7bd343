// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the tests of readers and writers share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/base/bits.h"
#include "mortise/base/error.h"
#include "mortise/io/entity_mesh.h"
#include "mortise/mesh/surface_mesh.h"
#include "support/catch.h"

namespace mortise::test {

/// The error a call throws; one that no reader throws when there is none.
template <class Call>
Error error_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::InternalError, "error_of", "no error was thrown");
}

/// Fails unless the call throws this code, from this stage, with this one place.
template <class Call>
void check_error(ErrorCode code, std::string_view stage, IdKind kind, std::uint32_t place, const Call& call) {
  const Error error = error_of(call);
  CAPTURE(error.message);
  CHECK(error_code_name(error.code) == error_code_name(code));
  CHECK(error.stage == stage);
  CHECK(id_kind_name(error.id_kind) == id_kind_name(kind));
  CHECK(error.ids == std::vector<std::uint32_t>{place});
}

/// The bits of every coordinate of every corner of every triangle, in order: what has to survive a format without shared vertices.
inline std::vector<std::uint64_t> corner_bits(const SurfaceMesh& mesh) {
  std::vector<std::uint64_t> bits;
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId vertex : triangle) {
      for (std::size_t i = 0; i < 3; ++i) bits.push_back(cast_bits<std::uint64_t>(mesh.points[vertex.index()][i]));
    }
  }
  return bits;
}

/// The bits of every coordinate of every vertex, in order.
inline std::vector<std::uint64_t> point_bits(const SurfaceMesh& mesh) {
  std::vector<std::uint64_t> bits;
  for (const Vec3d& point : mesh.points) {
    for (std::size_t i = 0; i < 3; ++i) bits.push_back(cast_bits<std::uint64_t>(point[i]));
  }
  return bits;
}

/// The name of the label of every triangle; empty when there are no labels.
inline std::vector<std::string> face_names(const SurfaceMesh& mesh) {
  std::vector<std::string> names;
  for (const std::uint32_t label : mesh.face_labels) names.push_back(mesh.label_names.at(label));
  return names;
}

inline Triangle triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return {VertexId(a), VertexId(b), VertexId(c)}; }

/// A tetrahedron whose coordinates are awkward to print: thirds, tiny, huge, subnormal, a negative zero. Labels "front" (two runs)
/// and "back side".
inline SurfaceMesh awkward_tetrahedron() {
  SurfaceMesh mesh;
  mesh.points = {
      {1.0 / 3, -0.0, 1e-300}, {6.02214076e23, 0.1, 4.9e-324}, {123456789.01234567, 1e300, -2.0 / 3}, {0.3, 9007199254740993.0, -1.5}};
  mesh.triangles = {triangle(0, 2, 1), triangle(0, 1, 3), triangle(1, 2, 3), triangle(2, 0, 3)};
  mesh.face_labels = {0, 1, 1, 0};
  mesh.label_names = {"front", "back side"};
  return mesh;
}

/// The same shape in numbers a float holds.
inline SurfaceMesh float_tetrahedron() {
  SurfaceMesh mesh = awkward_tetrahedron();
  mesh.points = {{0.25, -0.0, 1}, {2, static_cast<double>(0.1F), 0}, {1, 3, static_cast<double>(1e-40F)}, {0.5, 1, -16777215}};
  return mesh;
}

/// Two tetrahedra on one triangle, as a partition has them: regions 1 (below the triangle) and 2, faces 2 and 4 round them, 7 between them,
/// its rim as the closed edge 3 from vertex 9 to itself. Face 2 is in two groups, face 4 in none, group 5 has no name, point 5 is loose.
inline EntityMesh two_regions() {
  EntityMesh mesh;
  mesh.points = awkward_tetrahedron().points;
  mesh.points.push_back({1, 2, 1.0 / 7});
  mesh.points.push_back({1e-9, 5, 5});
  mesh.point_elements = {VertexId(1)};
  mesh.point_entities = {0};
  mesh.lines = {{VertexId(1), VertexId(2)}, {VertexId(2), VertexId(0)}, {VertexId(0), VertexId(1)}};
  mesh.line_entities = {0, 0, 0};
  mesh.triangles = {triangle(0, 1, 3), triangle(0, 1, 2), triangle(1, 2, 3), triangle(1, 0, 4),
                    triangle(2, 0, 3), triangle(2, 1, 4), triangle(0, 2, 4)};
  mesh.triangle_entities = {1, 2, 1, 0, 1, 0, 0};
  mesh.names = {{2, 11, "wall"}, {2, 4, "left, outer \xC3\xA4"}, {1, 11, "the rim"}, {2, 5, ""}, {0, 1, "fix"}, {3, 11, "steel"},
                {3, 12, "air"}};
  mesh.entities[0] = {{9, {4}, {}}};
  mesh.entities[1] = {{3, {2}, {9, 9}}};
  mesh.entities[2] = {{2, {1, 0}, {-3}}, {4, {}, {3}}, {7, {3}, {3}}};
  mesh.entities[3] = {{1, {5}, {2, 7}}, {2, {6}, {4, -7}}};
  return mesh;
}

/// What is left of it where regions and boundaries have no place.
inline EntityMesh two_regions_flattened() {
  EntityMesh mesh = two_regions();
  mesh.entities[3].clear();
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    for (MeshEntity& entity : mesh.entities[dimension]) entity.boundary.clear();
  }
  return mesh;
}

inline std::vector<std::uint64_t> point_bits(const EntityMesh& mesh) { return point_bits(SurfaceMesh{mesh.points, {}, {}, {}, {}, {}}); }

/// Fails unless the meshes are the same, coordinates bit for bit.
inline void check_same(const EntityMesh& mesh, const EntityMesh& expected) {
  CHECK(point_bits(mesh) == point_bits(expected));
  CHECK(mesh.point_elements == expected.point_elements);
  CHECK(mesh.lines == expected.lines);
  CHECK(mesh.triangles == expected.triangles);
  CHECK(mesh.point_entities == expected.point_entities);
  CHECK(mesh.line_entities == expected.line_entities);
  CHECK(mesh.triangle_entities == expected.triangle_entities);
  CHECK((mesh.names == expected.names));
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    CAPTURE(dimension);
    CHECK((mesh.entities[dimension] == expected.entities[dimension]));
  }
}

}  // namespace mortise::test
