// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The model of a result from those of its operands: only what the operation touched is built again (paper 7.1, closing remarks).
#pragma once

#include <cstddef>
#include <span>

#include "mortise/brep/build_brep.h"
#include "mortise/mesh/provenance.h"

namespace mortise {

/// An operand with its model, and the normals this was built with.
struct OperandModel {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  const FaceNormals& normals;
};

struct RebuiltBrep {
  ClassifiedBrep model;
  std::size_t touched = 0;  ///< triangles on faces that were built again
  std::size_t visited = 0;  ///< triangles that took: those, and their neighbours over vertices
};

/// The model that build_brep(mesh, rules, source_normals(...)) makes, but for the order of loops, and where they start.
///
/// A face of an operand is untouched when all its triangles are in the result as they were, and at all its vertices, those on its
/// boundary included, all triangles of the operand and no others: then it is in the result with its boundary and its seam. All other
/// triangles are divided anew; where that is most of the mesh, all of it. With a weak angle or a least dangling crease faces that features
/// lead to from there are touched too, for what features are depends on how they go on.
///
/// Regions are found from all faces. Triangles are compared with those of the operands one by one; that is not counted.
/// @param operands  by number; models built by the same rules, but for groups and user edges, and those without any
/// @throws what build_brep does; Error{InvalidArgument} when a facet comes from a triangle that no operand has
[[nodiscard]] RebuiltBrep rebuild_brep(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands,
                                       const BrepRules& rules = {});

}  // namespace mortise
