// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A model as files of analysis programs carry it: elements on entities, boundaries, named groups.
#pragma once

#include <span>

#include "mortise/brep/attributes.h"
#include "mortise/io/entity_mesh.h"

namespace mortise {

/// The mesh of a model with an entity for every vertex, edge, face and region, but for seams, voids and the outside. Tags are numbers of
/// the model plus 1, of regions as they are. What one gives Gmsh as MSH 4.1, to mesh the regions.
///
/// Labels of triangles name their faces, attributes their targets. When anything has a name, faces and regions without one are
/// called "face 3" and "region 2", or "face 3_2" where that is taken: programs leave out what is in no group.
[[nodiscard]] EntityMesh entity_mesh_of(const ModelView& view, std::span<const Attribute> attributes = {});

}  // namespace mortise
