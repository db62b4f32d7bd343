// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizes people give on parts of a model, as size sources (paper 7.3).
#pragma once

#include <span>
#include <vector>

#include "mortise/brep/attributes.h"
#include "mortise/brep/model_queries.h"
#include "mortise/size/size_source.h"

namespace mortise {

// Sizes and growths that no source can have are left to check_sources; all sources come by ascending part of the mesh.

/// The mesh on an entity as sources of one size: a vertex is a point, an edge its segments, a face its triangles, a region those of its
/// faces.
/// @throws Error{InvalidArgument} when there is no such entity
[[nodiscard]] std::vector<SizeSource> sources_on(const ModelView& view, const ModelEntity& entity, double size, double growth);

/// Sources of size max(smallest, L / least_edges) along every model edge of length L, but seams.
/// @throws Error{InvalidArgument} when least_edges is 0, or smallest negative or not finite
[[nodiscard]] std::vector<SizeSource> sources_for_edge_counts(const ModelView& view, std::uint32_t least_edges, double smallest,
                                                              double growth);

/// The triangles of a mesh with sizes that are linear between its vertices. A triangle that is too thin for that is the two segments
/// from the ends of its longest edge to its third corner.
/// @param sizes  per vertex; those of vertices without triangles do not matter
/// @throws Error{InvalidArgument} when there is not one size per vertex, or naming vertices of triangles whose size is no positive number
[[nodiscard]] std::vector<SizeSource> sources_of_vertex_sizes(const SurfaceMesh& mesh, std::span<const double> sizes, double growth);

/// sources_on every target of the attributes of kind Size, whose value is the size.
/// @throws Error{InvalidArgument} naming an attribute whose value is no positive number, or that is on what is not there
[[nodiscard]] std::vector<SizeSource> sources_of_attributes(const ModelView& view, std::span<const Attribute> attributes, double growth);

}  // namespace mortise
