// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One arrangement with all its facets, then the mesh of each operand out of it.
#include "mortise/boolean/imprint.h"

#include <array>
#include <utility>

#include "mortise/boolean/evaluate_selection.h"
#include "mortise/boolean/transfer_data.h"

namespace mortise {
namespace {

// Data of an operand on its triangles, each of which runs as its face.
std::vector<DataChannel> data_of(OperandId k, const EvaluatedSelection& evaluated, std::span<const SurfaceMesh* const> operands,
                                 const ImprintedOperand& imprinted) {
  const SurfaceMesh* const given = operands[k.index()];
  std::vector<DataChannel> channels = join_channels({&given, 1});
  if (channels.empty()) return channels;
  std::vector<TriangleInFace> in_faces;
  for (std::size_t t = 0; t < imprinted.mesh.triangles.size(); ++t) {
    Triangle corners = imprinted.mesh.triangles[t];
    for (VertexId& v : corners) v = VertexId(imprinted.vertex_ids[v.index()]);
    in_faces.push_back({corners, SourceId(std::size_t{evaluated.faces.first[k]} + imprinted.source_face[t]), false});
  }
  transfer_data({operands, evaluated.faces, evaluated.point_of_vertex}, in_faces, channels, {});
  return channels;
}

}  // namespace

ImprintResult imprint(const OperandList& operands, const BooleanOptions& options) {
  EvaluatedSelection evaluated = evaluate_selection_exactly("imprint", select_all, operands, options);
  ImprintResult result;
  result.operands = read_operands(operands.meshes(), evaluated.result.mesh, evaluated.result.provenance);
  for (std::size_t k = 0; k < operands.size(); ++k) {
    result.operands[k].mesh.corner_data = data_of(OperandId(k), evaluated, operands.meshes(), result.operands[k]);
  }
  result.whole = std::move(evaluated.result);
  return result;
}

ImprintResult imprint(const Operand& a, const Operand& b, const BooleanOptions& options) { return imprint(std::array{a, b}, options); }

}  // namespace mortise
