// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangles in runs of one label, as renderers draw them: a run for each material.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/select_faces.h"

namespace mortise {

/// Triangles of one label, one after the other.
struct FaceGroup {
  std::uint32_t first = 0;  ///< triangle
  std::uint32_t count = 0;  ///< more than 0
  std::uint32_t label = 0;  ///< index into SurfaceMesh::label_names
};

struct GroupedMesh {
  MeshPart part;                  ///< all triangles, those of a lower label first, else in their order; vertices they use
  std::vector<FaceGroup> groups;  ///< labels ascending, those without triangles left out; one of label 0 where there are no labels
};

/// @throws what validate() throws
/// O(n log n)
[[nodiscard]] GroupedMesh group_by_label(const SurfaceMesh& mesh);

}  // namespace mortise
