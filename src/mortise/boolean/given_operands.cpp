// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sources of sources.
#include "mortise/boolean/given_operands.h"

#include <algorithm>

namespace mortise {

std::vector<OperandVertex> name_given_sources(std::span<const SurfaceMesh* const> operands, std::span<const ImprintedOperand> made,
                                              Coordinates coordinates, EvaluatedSelection& evaluated) {
  Provenance& p = evaluated.result.provenance;
  const auto name_face = [&](std::uint32_t operand, std::uint32_t& face) { face = made[operand].source_face[face]; };
  for (std::size_t t = 0; t < p.source_face.size(); ++t) name_face(p.source_operand[t], p.source_face[t]);
  for (std::size_t i = 0; i < p.other_source_face.size(); ++i) name_face(p.other_source_operand[i], p.other_source_face[i]);
  const std::size_t vertex_count = evaluated.point_of_vertex.size();
  std::vector<std::uint32_t> vertex_at(evaluated.faces.points.size(), Provenance::none);
  for (std::uint32_t v = 0; v < vertex_count; ++v) vertex_at[evaluated.point_of_vertex[v].index()] = v;
  p.vertex_operand.assign(vertex_count, Provenance::none);
  p.vertex_source.assign(vertex_count, Provenance::none);
  std::vector<OperandVertex> moved;
  for (std::uint32_t k = 0; k < made.size(); ++k) {
    const std::vector<PointId>& points = evaluated.faces.point_of_vertex[OperandId(k)];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t v = vertex_at[points[i].index()], source = made[k].source_vertex[i];
      if (v == Provenance::none || source == Provenance::none) continue;
      const Vec3d& given = operands[k]->points[source];
      const Vec3d rounded = coordinates == Coordinates::Float32 ? nearest_float32(given) : given;
      Vec3d& point = evaluated.result.mesh.points[v];
      if (!(point == rounded)) {
        moved.push_back({k, source});
      } else if (p.vertex_operand[v] == Provenance::none) {
        p.vertex_operand[v] = k;
        p.vertex_source[v] = source;
        point = rounded;  // with the sign of its zeros
      }
    }
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  return moved;
}

EvaluatedSelection at_its_doubles(const OperandList& operands, BooleanResult result) {
  EvaluatedSelection evaluated;
  evaluated.faces = gather_operands(operands);
  for (const Vec3d& p : result.mesh.points) evaluated.point_of_vertex.push_back(evaluated.faces.points.add_input(p));
  evaluated.result = std::move(result);
  return evaluated;
}

}  // namespace mortise
