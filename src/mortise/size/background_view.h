// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The wanted sizes for Gmsh, as a view it takes for a background mesh.
#pragma once

#include <string>

#include "mortise/geom/vec.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

struct ViewLimits {
  double error = 0.03;             ///< cells are halved where sizes in them are off by a larger part
  std::size_t most_cells = 50000;  ///< the view is coarser rather than have more
};

/// Tetrahedra that fill a box, with the size at every corner as a float32: a list-based post-processing view, for a file NAME.pos.
///
/// Cubes halved where linear interpolation is off, the worst first, each cut into six. `Merge "NAME.pos"; Background
/// Mesh View[0];` meshes by it; Mesh.MeshSizeExtendFromBoundary, Mesh.MeshSizeFromPoints and Mesh.MeshSizeFromCurvature want to be 0 then
/// (Gmsh before 4.9: Mesh.CharacteristicLength...).
///
/// @param box  what is to be meshed is in it; may be flat
/// @throws Error{InvalidArgument} for a box that is empty, a point or not finite, and limits that are not positive
/// O(cells log sources), a cell being about 1.5 KB of text.
[[nodiscard]] std::string background_view(const SizingProxy& proxy, const Box3& box, const ViewLimits& limits = {});

}  // namespace mortise
