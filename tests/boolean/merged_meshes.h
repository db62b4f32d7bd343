// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Results written by hand, for the repairs.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "mortise/boolean/certify.h"
#include "support/mesh_checks.h"

namespace mortise::test {

/// Operands that are nothing but points: the first `inputs` vertices of a result stand for input points, all others for
/// points a cut made.
[[nodiscard]] inline OperandFaces points_only(std::size_t inputs, std::size_t made) {
  OperandFaces faces;
  std::vector<LinePoints> lines;
  for (std::size_t i = 0; i < made; ++i) {
    const double x = static_cast<double>(i);
    const PointId low = faces.points.add_input({x, -1, 0});
    lines.push_back({low, faces.points.add_input({x, 1, 0})});
  }
  const PointId left = faces.points.add_input({-9, 0.25, 0}), right = faces.points.add_input({1e6, 0.25, 0});
  for (std::size_t i = 0; faces.points.size() < inputs; ++i) faces.points.add_input({static_cast<double>(i), 50, 0});
  for (const LinePoints& line : lines) faces.points.add_line_line(line, {left, right}, Axis::Z);
  return faces;
}

/// The mesh as a result of one operand, triangle t from face t; vertices below `inputs` are input vertices.
[[nodiscard]] inline MergedMesh merged_of(const SurfaceMesh& mesh, std::size_t inputs, const OperandFaces& faces) {
  MergedMesh merged;
  merged.mesh = mesh;
  const std::size_t first_made = faces.points.input_count();
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const bool is_input = v < inputs;
    merged.point_of_vertex.push_back(PointId(is_input ? v : first_made + (v - inputs)));
    merged.provenance.vertex_operand.push_back(is_input ? 0 : Provenance::none);
    merged.provenance.vertex_source.push_back(is_input ? static_cast<std::uint32_t>(v) : Provenance::none);
  }
  merged.provenance.other_source_begin.push_back(0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    merged.facet_of_triangle.push_back({FacetId(t), false, FacetCategory::Outside, RegionId()});
    merged.is_repaired.push_back(0);
    merged.provenance.source_operand.push_back(0);
    merged.provenance.source_face.push_back(t);
    merged.provenance.flipped.push_back(0);
    merged.provenance.category.push_back(FacetCategory::Outside);
    merged.provenance.covering.push_back(0);
    merged.provenance.other_source_begin.push_back(0);
  }
  merged.provenance.covering_sets = {{0}};
  return merged;
}

/// The facets of such a result: its triangles.
[[nodiscard]] inline Facets facets_of(const MergedMesh& merged) {
  Facets facets;
  for (const Triangle& t : merged.mesh.triangles) {
    const auto point_of = [&](std::size_t i) { return merged.point_of_vertex[t[i].index()]; };
    facets.corners.push_back({point_of(0), point_of(1), point_of(2)});
  }
  return facets;
}

/// Which rule of a result does not hold after a repair; empty when all do.
[[nodiscard]] inline std::string fault_of(const MergedMesh& merged) {
  const std::size_t n = merged.mesh.triangles.size(), vertices = merged.mesh.points.size();
  const Provenance& p = merged.provenance;
  for (const std::size_t size : {merged.facet_of_triangle.size(), merged.is_repaired.size(), p.source_operand.size(), p.source_face.size(),
                                 p.flipped.size(), p.category.size(), p.covering.size(), p.other_source_begin.size() - 1}) {
    if (size != n) return "facet arrays of different sizes";
  }
  if (!merged.mesh.face_labels.empty() && merged.mesh.face_labels.size() != n) return "labels of another size";
  if (!merged.mesh.walls.empty() && merged.mesh.walls.size() != n) return "walls of another size";
  if (merged.point_of_vertex.size() != vertices || p.vertex_operand.size() != vertices || p.vertex_source.size() != vertices) {
    return "vertex arrays of different sizes";
  }
  if (!std::is_sorted(p.other_source_begin.begin(), p.other_source_begin.end()) || p.other_source_begin.front() != 0 ||
      p.other_source_begin.back() != p.other_source_face.size() || p.other_source_face.size() != p.other_source_operand.size()) {
    return "other sources out of order";
  }
  std::vector<std::uint8_t> is_used(vertices, 0);
  for (const Triangle& t : merged.mesh.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return "triangle with a corner twice";
    for (const VertexId v : t) is_used.at(v.index()) = 1;
  }
  if (std::count(is_used.begin(), is_used.end(), 0) != 0) return "vertex without a triangle";
  return is_balanced(merged.mesh) ? "" : "edge out of balance";
}

}  // namespace mortise::test
