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

}  // namespace mortise::test
