// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The model of a result from those of its operands: only what the operation touched is built again (paper 7.1, closing remarks).
#pragma once

#include <cstddef>
#include <span>

#include "mortise/brep/kept_faces.h"

namespace mortise {

struct RebuiltBrep {
  ClassifiedBrep model;
  std::size_t touched = 0;  ///< triangles on faces that were built again
  std::size_t visited = 0;  ///< triangles that took: those, and their neighbours over vertices
};

/// The model that build_brep(mesh, rules, source_normals(...)) makes, but for the order of loops, and where they start.
///
/// Untouched faces (find_kept_faces) are in the result with their boundaries and seams. All other triangles are divided anew; where that is
/// most of the mesh, all of it.
///
/// Regions are found from all faces. Triangles are compared with those of the operands one by one; that is not counted.
/// @param operands  by number; models built by the same rules, but for groups and user edges, and those without any
/// @throws what build_brep does; Error{InvalidArgument} when a facet comes from a triangle that no operand has
[[nodiscard]] RebuiltBrep rebuild_brep(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands,
                                       const BrepRules& rules = {});

}  // namespace mortise
