// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Describes a mesh: what a report says about it.
#pragma once

#include <cstdint>
#include <optional>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// What there is to say about a mesh by itself (architecture.md 7). Vertices count as shared by index only: weld first.
struct MeshReport {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  bool closed = true;                    ///< every directed edge occurs as often as its reverse
  bool oriented = true;                  ///< along no edge of two faces do both run the same way
  bool manifold = true;                  ///< no edge has more than two faces and no vertex more than one fan
  std::uint64_t boundary_edges = 0;      ///< edges of exactly one face
  std::uint64_t non_manifold_edges = 0;  ///< edges of more than two faces
  std::uint64_t non_manifold_vertices = 0;
  std::uint64_t components = 0;       ///< connected through shared vertices
  std::uint64_t shells = 0;           ///< connected through edges after splitting pinches
  std::optional<std::int64_t> genus;  ///< sum over shells; nothing when open
  std::optional<double> volume;       ///< signed; nothing when open
  double area = 0;
  Box3 bbox;                 ///< of the vertices the faces use; empty without faces
  double min_angle_deg = 0;  ///< 0 without faces
  double max_angle_deg = 0;
  std::uint64_t self_intersections = 0;  ///< pairs of faces that meet in more than what they share: the sum of the next three
  std::uint64_t crossing_pairs = 0;      ///< inner points of both meet, in different planes
  std::uint64_t overlapping_pairs = 0;   ///< in one plane, they share area
  std::uint64_t touching_pairs = 0;      ///< they meet on the boundary of at least one
  std::uint64_t degenerate_faces = 0;    ///< without area; not counted in pairs
  std::uint64_t duplicate_faces = 0;     ///< faces whose three vertices an earlier face has, in any order
};

/// Describes a mesh.
/// @throws what validate throws
/// O(n log n) in faces plus time in proportion to the pairs of faces whose boxes meet.
[[nodiscard]] MeshReport inspect(const SurfaceMesh& mesh);

/// What inspect says without comparing pairs of faces: from self_intersections to degenerate_faces all counts stay 0.
/// @throws what validate throws
/// O(n log n) in faces.
[[nodiscard]] MeshReport inspect_without_pairs(const SurfaceMesh& mesh);

}  // namespace mortise
