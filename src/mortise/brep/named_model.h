// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The model in a file of an analysis program, its groups as attributes: the way back from entity_mesh_of.
#pragma once

#include <vector>

#include "mortise/brep/attributes.h"
#include "mortise/brep/build_brep.h"
#include "mortise/io/entity_mesh.h"

namespace mortise {

struct NamedModel {
  SurfaceMesh mesh;  ///< as read_mesh() gives it: points welded, labels from names
  BrepRules rules;   ///< those given, with a group for every face of the file, and its lines as user edges
  ClassifiedBrep model;
  std::vector<Attribute> attributes;  ///< one for each name, ascending
};

/// Builds the model of a file: faces of the file stay apart, its lines are edges where triangles have them as sides, and creases part faces
/// as the rules say. Groups become attributes of kind User and value null, one for each name.
///
/// A region of the file is every region of the model whose faces are among its own, looking the same way; when there is none, the region
/// with just its faces. An edge or vertex of the file that is none of the model gives its name to nothing, a part of an edge to all of it.
/// @param rules  groups and user edges are added
/// @throws what build_brep() throws
/// O(n log n).
[[nodiscard]] NamedModel named_model_of(const EntityMesh& file, BrepRules rules = {});

}  // namespace mortise
