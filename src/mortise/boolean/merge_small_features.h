// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What is smaller than a length goes: short edges, narrow strips, thin walls and gaps.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A mesh without its small features; another model than before.
struct MergedFeatures {
  SurfaceMesh mesh;                ///< labels and walls are those of the sources; without data
  std::vector<FaceId> sources;     ///< per triangle: of the given mesh
  std::vector<FaceId> gone;        ///< ascending: triangles of the given mesh that are no source
  std::vector<FaceId> unresolved;  ///< ascending: of the given mesh; they cross others now, or lie on them, or not all that is near fitted
  std::uint64_t moved_vertices = 0;  ///< to the place of another one
  double largest_move = 0;           ///< of a vertex; at most the length
};

/// Vertices, edges and faces nearer to each other than this length become one, as in share_within_tolerance. Where triangles come to lie on
/// each other, what was between them is gone: one of them stays where that leaves a wall between two regions or a sheet, else none. So a
/// thin part vanishes and a thin gap closes. Also what is no feature: triangles smaller than the length go wherever they are.
///
/// @param model  of the mesh; says which regions are on both sides of a triangle
/// @param least  length, > 0
/// @throws Error{InvalidArgument} for a length that is not positive and finite; Error{Cancelled}
/// O(n log n), plus time in proportion to the pairs that are near.
[[nodiscard]] MergedFeatures merge_small_features(const SurfaceMesh& mesh, const ClassifiedBrep& model, double least,
                                                  const ProgressCallback& progress = {});

}  // namespace mortise
