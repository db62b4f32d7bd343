// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a mesh knows of each face beside its corners: label, wall or not, diagonals, data. Keeps these arrays in step with the triangles.
#pragma once

#include <array>
#include <utility>

#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// `to` gets the marks of `from`, a face of the same mesh.
inline void copy_face_marks(FaceId from, FaceId to, SurfaceMesh& mesh) {
  if (!mesh.face_labels.empty()) mesh.face_labels[to.index()] = mesh.face_labels[from.index()];
  if (!mesh.walls.empty()) mesh.walls[to.index()] = mesh.walls[from.index()];
  if (!mesh.diagonals.empty()) mesh.diagonals[to.index()] = mesh.diagonals[from.index()];
  copy_corner_data(from, to, mesh);
}

/// Appends the marks of a face to those of a mesh that has the same kinds of marks; data of those channels the mesh has.
inline void append_face_marks(const SurfaceMesh& source, FaceId f, SurfaceMesh& mesh) {
  if (!source.face_labels.empty()) mesh.face_labels.push_back(std::uint32_t{source.face_labels[f.index()]});
  if (!source.walls.empty()) mesh.walls.push_back(std::uint8_t{source.walls[f.index()]});
  if (!source.diagonals.empty()) mesh.diagonals.push_back(std::uint8_t{source.diagonals[f.index()]});
  append_corner_data(source, f, mesh);
}

/// As many marks as triangles: no label, no wall, no diagonal, no values where there were none.
inline void resize_face_marks(SurfaceMesh& mesh) {
  if (!mesh.face_labels.empty()) mesh.face_labels.resize(mesh.triangles.size());
  if (!mesh.walls.empty()) mesh.walls.resize(mesh.triangles.size());
  if (!mesh.diagonals.empty()) mesh.diagonals.resize(mesh.triangles.size());
  resize_corner_data(mesh);
}

/// A face with other corners is part of no polygon any more.
inline void forget_diagonals(FaceId f, SurfaceMesh& mesh) {
  if (!mesh.diagonals.empty()) mesh.diagonals[f.index()] = 0;
}

inline void set_corners(FaceId f, const Triangle& corners, SurfaceMesh& mesh) {
  mesh.triangles[f.index()] = corners;
  forget_diagonals(f, mesh);
}

/// The face runs the other way, from the same first corner.
inline void reverse_corners(FaceId f, SurfaceMesh& mesh) {
  Triangle& t = mesh.triangles[f.index()];
  std::swap(t[1], t[2]);
  reverse_corner_data(f, mesh);
  if (mesh.diagonals.empty()) return;
  std::uint8_t& bits = mesh.diagonals[f.index()];
  bits = static_cast<std::uint8_t>((bits & 2U) | (bits & 1U) << 2U | bits >> 2U);
}

/// The face looks the other way: so do the normals at its corners.
inline void turn_over(FaceId f, SurfaceMesh& mesh) {
  reverse_corners(f, mesh);
  turn_normals(f, mesh);
}

/// The diagonals of a face with these corners, any of them first and either way round, given those of the same face as `source`; none
/// when the corners are not the same three.
template <class Corner>
[[nodiscard]] std::uint8_t diagonals_from(const std::array<Corner, 3>& source, std::uint8_t bits, const std::array<Corner, 3>& corners) {
  std::uint8_t result = 0;
  for (unsigned k = 0; k < 3; ++k) {  // an edge by the corner opposite to it
    unsigned at = 0;
    while (at < 3 && !(source[at] == corners[k])) ++at;
    if (at == 3) return 0;
    if ((bits >> (at + 1) % 3 & 1U) != 0) result = static_cast<std::uint8_t>(result | 1U << (k + 1) % 3);
  }
  return result;
}

}  // namespace mortise
