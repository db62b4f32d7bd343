// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex and corner data of the operands on the triangles of a result (docs/decisions/008).
#pragma once

#include <span>
#include <vector>

#include "mortise/arrange/operand_faces.h"
#include "mortise/base/progress.h"
#include "mortise/boolean/result.h"

namespace mortise {

/// The channels of all operands without values, in the order of their first operand, there those of the vertices first; equal
/// names are one channel.
/// @throws Error{InvalidArgument} naming the operand when its channel has other components or another kind than one before
[[nodiscard]] std::vector<DataChannel> join_channels(std::span<const SurfaceMesh* const> operands);

/// Where the corners of triangles are exactly.
struct ExactOperands {
  std::span<const SurfaceMesh* const> operands;
  const OperandFaces& faces;
  std::span<const PointId> point_of_vertex;
};

/// A triangle and the face of an operand that it lies in.
struct TriangleInFace {
  Triangle corners;  ///< indices into point_of_vertex
  SourceId face;
  bool is_flipped = false;  ///< runs against it
};

/// Gives channels the values of the faces at the corners of triangles: bit for bit where a corner is one of the face, elsewhere the
/// value of the linear function on the face, from exact barycentric coordinates, rounded once. A corner that a repair moved off its
/// face has the value where it is seen along an axis, or the nearest one the face has. Normals of flipped triangles turn
/// round. Where the operand has no such channel, or the face no value, there is none.
///
/// @param channels  some of join_channels()
/// @throws Error{Cancelled}
/// O(n) in the triangles, n log n in corners that are none of their face.
void transfer_data(const ExactOperands& source, std::span<const TriangleInFace> triangles, std::vector<DataChannel>& channels,
                   const ProgressCallback& progress);

/// The face behind every triangle of a result: its first source.
[[nodiscard]] std::vector<TriangleInFace> triangles_in_faces(const OperandFaces& faces, const BooleanResult& result);

}  // namespace mortise
