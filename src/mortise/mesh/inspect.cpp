// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Describes a mesh: what a report says about it.
#include "mortise/mesh/inspect.h"

#include <algorithm>
#include <vector>

#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

std::uint64_t count_duplicate_faces(const SurfaceMesh& mesh) {
  std::vector<Triangle> faces = mesh.triangles;
  for (Triangle& t : faces) std::sort(t.begin(), t.end());
  std::sort(faces.begin(), faces.end());
  return static_cast<std::uint64_t>(faces.end() - std::unique(faces.begin(), faces.end()));
}

void describe_topology(const SurfaceMesh& mesh, MeshReport& report) {
  const MeshTopology topology = build_topology(mesh);
  report.closed = find_unbalanced_edges(mesh, topology).empty();
  report.oriented = find_inconsistent_edges(mesh, topology).empty();
  report.boundary_edges = find_boundary_edges(topology).size();
  report.non_manifold_edges = find_non_manifold_edges(topology).size();
  report.non_manifold_vertices = find_non_manifold_vertices(mesh, topology).size();
  report.manifold = report.non_manifold_edges == 0 && report.non_manifold_vertices == 0;
  report.components = connect_by_vertices(mesh).count;
  report.shells = split_pinches(mesh, topology).shells.count;
  report.genus = genus_of(mesh, topology);
}

void describe_pairs(const SurfaceMesh& mesh, MeshReport& report) {
  const SelfCrossingCounts counts = count_self_crossings(mesh);
  report.crossing_pairs = counts.crossing;
  report.overlapping_pairs = counts.coplanar_overlap;
  report.touching_pairs = counts.touching;
  report.self_intersections = counts.crossing + counts.coplanar_overlap + counts.touching;
  report.degenerate_faces = counts.degenerate_faces;
}

}  // namespace

MeshReport inspect_without_pairs(const SurfaceMesh& mesh) {
  validate(mesh);
  MeshReport report;
  report.vertices = mesh.points.size();
  report.triangles = mesh.triangles.size();
  describe_topology(mesh, report);
  if (report.closed) report.volume = enclosed_volume(mesh);
  report.area = surface_area(mesh);
  report.bbox = bounding_box(mesh);
  const AngleRange angles = angle_range(mesh);
  report.min_angle_deg = angles.min_deg;
  report.max_angle_deg = angles.max_deg;
  report.duplicate_faces = count_duplicate_faces(mesh);
  return report;
}

MeshReport inspect(const SurfaceMesh& mesh) {
  MeshReport report = inspect_without_pairs(mesh);
  describe_pairs(mesh, report);
  return report;
}

}  // namespace mortise
