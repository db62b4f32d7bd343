// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which faces of operands' models are in a result just as they were.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/brep/build_brep.h"
#include "mortise/mesh/provenance.h"

namespace mortise {

/// An operand with its model, and the normals this was built with.
struct OperandModel {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  const FaceNormals& normals;
};

using OldFaceId = Id<struct OldFaceTag>;  ///< of all operands' models, in turn

/// What of the operands is in the result as it was.
struct KeptFaces {
  std::vector<std::uint32_t> first_face;         ///< per operand, and their end: the number of its first face
  std::vector<OldFaceId> face_of_triangle;       ///< per triangle of the result: the face it comes from
  IdVector<OldFaceId, std::uint8_t> is_touched;  ///< or nothing is left of it
  IdVector<OldFaceId, std::uint8_t> is_flipped;  ///< of untouched ones
  std::vector<std::vector<VertexId>> image;      ///< per operand and vertex: the vertex of the result with all its triangles, or none

  [[nodiscard]] OldFaceId old_face(std::size_t operand, ModelFaceId face) const { return OldFaceId(first_face[operand] + face.index()); }
};

/// A face is untouched when all its triangles are whole in the result, and all its vertices have just the triangles they had, those on its
/// boundary included. With a weak angle or a least dangling crease also faces that features lead to from a touched one are touched.
/// @throws Error{InvalidArgument} when a facet comes from a triangle that no operand has
/// O(n).
[[nodiscard]] KeptFaces find_kept_faces(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands,
                                        const FeatureRules& rules);

}  // namespace mortise
