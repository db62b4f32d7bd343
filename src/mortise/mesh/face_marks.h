// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a mesh knows of each face beside its corners: label, wall or not. Keeps these arrays in step with the triangles.
#pragma once

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// `to` gets the marks of `from`, a face of the same mesh.
inline void copy_face_marks(FaceId from, FaceId to, SurfaceMesh& mesh) {
  if (!mesh.face_labels.empty()) mesh.face_labels[to.index()] = mesh.face_labels[from.index()];
  if (!mesh.walls.empty()) mesh.walls[to.index()] = mesh.walls[from.index()];
}

/// Appends the marks of a face to those of a mesh that has the same kinds of marks.
inline void append_face_marks(const SurfaceMesh& source, FaceId f, SurfaceMesh& mesh) {
  if (!source.face_labels.empty()) mesh.face_labels.push_back(std::uint32_t{source.face_labels[f.index()]});
  if (!source.walls.empty()) mesh.walls.push_back(std::uint8_t{source.walls[f.index()]});
}

/// As many marks as triangles: no label, no wall where there were none.
inline void resize_face_marks(SurfaceMesh& mesh) {
  if (!mesh.face_labels.empty()) mesh.face_labels.resize(mesh.triangles.size());
  if (!mesh.walls.empty()) mesh.walls.resize(mesh.triangles.size());
}

}  // namespace mortise
