// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A mesh in pieces, their boundaries in paths: what the faces, edges and vertices of its model are made of.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/brep/build_brep.h"
#include "mortise/brep/trace_edges.h"

namespace mortise {

struct DividedMesh {
  FaceComponents pieces;
  FeatureEdges features;
  FaceBoundaries boundaries;
  std::vector<std::uint8_t> is_corner;  ///< per mesh vertex
  TracedEdges edges;
};

/// Faces that are known from another model, on a part of a mesh: round their other boundaries anything may be missing.
struct KnownFaces {
  static constexpr std::uint32_t none = 0xffffffffU;

  std::vector<std::uint32_t> face_of_triangle;  ///< any number of its own for every known face; none: to be found
  std::vector<MeshEdgeId> seams;                ///< of known faces
};

/// @throws what find_feature_edges does; Error{InvalidArgument} for an edge angle outside 0 .. 180
/// @param known  nothing, or one face per triangle; what is said of known faces and their boundaries means nothing, but where they bound
/// others
[[nodiscard]] DividedMesh divide_mesh(const SurfaceMesh& mesh, const MeshTopology& topology, const BrepRules& rules,
                                      const FaceNormals& normals, const KnownFaces& known = {});

}  // namespace mortise
