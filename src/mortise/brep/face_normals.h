// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Directions of triangles for telling creases, also of those too thin to have one.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/provenance.h"
#include "mortise/mesh/topology.h"

namespace mortise {

struct FaceNormals {
  std::vector<Vec3d> normals;         ///< per triangle, of length 1; zero where there is none
  std::vector<std::uint32_t> planes;  ///< empty, or per triangle: the angle between triangles of one plane is 0
};

/// The normals of a mesh from elsewhere. A triangle lower than 1e-6 of its longest edge takes the normal across that edge.
/// O(n).
[[nodiscard]] FaceNormals measure_normals(const SurfaceMesh& mesh, const MeshTopology& topology);

/// The normals of the facets of a result: those of the triangles they come from, one plane for each of these.
/// @param operand_normals  per operand; turned over where a facet runs against its source
/// @throws Error{InvalidArgument} when a source is not there
[[nodiscard]] FaceNormals source_normals(const Provenance& provenance, const std::vector<FaceNormals>& operand_normals);

}  // namespace mortise
