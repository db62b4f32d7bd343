// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Takes a mesh apart.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/select_faces.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

enum class SplitBy : std::uint8_t {
  Components,  ///< faces connected through edges, with any number of faces on an edge; what meets in a vertex only comes apart
  Regions,     ///< solids connected through their inside, each with its cavities (find_regions)
};

/// The parts of a mesh in the order of their lowest faces. Equal positions count as one vertex; sources are faces and (lowest)
/// vertices of `mesh`. Every face is in one part; by regions those that repeat a vertex are in none. Of a mesh with walls (a
/// partition) a face between two regions is in both, turned with the region behind it; sheets are in none. Data become corner data.
/// @throws what validate() throws; by regions also Error{NotClosed} and Error{NotOriented} naming vertex pairs, and
/// Error{InsideOut} naming the faces of a part that runs inwards and is the cavity of nothing
/// O(n log n), by regions plus a ray for each cavity.
[[nodiscard]] std::vector<MeshPart> split_parts(const SurfaceMesh& mesh, SplitBy by);

}  // namespace mortise
