// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Describes a mesh: what a report says about it.
#include "mortise/mesh/inspect.h"

#include <algorithm>
#include <vector>

#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

VertexId apex_of(const SurfaceMesh& mesh, HalfEdge h) { return origin_of(mesh, next_in_face(next_in_face(h))); }

// Faces that repeat a vertex, sorted by corners.
std::uint64_t count_duplicates_repeating(const SurfaceMesh& mesh) {
  std::vector<Triangle> faces;
  for (const Triangle& t : mesh.triangles) {
    if (repeats_vertex(t)) faces.push_back(t);
  }
  for (Triangle& t : faces) std::sort(t.begin(), t.end());
  std::sort(faces.begin(), faces.end());
  return static_cast<std::uint64_t>(faces.end() - std::unique(faces.begin(), faces.end()));
}

// Faces on the same vertices meet at the edge between the lowest two of these.
std::uint64_t count_duplicate_faces(const SurfaceMesh& mesh, const MeshTopology& topology) {
  std::uint64_t count = count_duplicates_repeating(mesh);
  std::vector<VertexId> apexes;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() < 2) continue;
    apexes.clear();
    for (const HalfEdge h : uses) {
      if (const VertexId apex = apex_of(mesh, h); topology.edges[e][1] < apex) apexes.push_back(apex);
    }
    std::sort(apexes.begin(), apexes.end());
    count += static_cast<std::uint64_t>(apexes.end() - std::unique(apexes.begin(), apexes.end()));
  }
  return count;
}

std::size_t count_non_manifold_vertices(const SurfaceMesh& mesh, const MeshTopology& topology, const SplitPinches& split,
                                        std::size_t crowded_edges) {
  if (crowded_edges != 0) return find_non_manifold_vertices(mesh, topology).size();
  // Nothing was split but vertices with several fans.
  std::size_t count = 0;
  for (std::size_t v = 1; v < split.source.size(); ++v) {
    const bool is_first_copy = v == 1 || split.source[v - 2] != split.source[v];
    count += split.source[v - 1] == split.source[v] && is_first_copy ? 1 : 0;
  }
  return count;
}

std::optional<std::int64_t> total_genus(const SurfaceMesh& mesh, const MeshTopology& topology, const SplitPinches& split, bool is_closed) {
  if (!is_closed) return std::nullopt;
  const bool any_repeats = std::any_of(mesh.triangles.begin(), mesh.triangles.end(), repeats_vertex);
  return any_repeats ? genus_of(mesh, topology) : genus_of(split);
}

void describe_topology(const SurfaceMesh& mesh, const MeshTopology& topology, MeshReport& report) {
  report.closed = find_unbalanced_edges(mesh, topology).empty();
  report.oriented = find_inconsistent_edges(mesh, topology).empty();
  report.boundary_edges = find_boundary_edges(topology).size();
  report.non_manifold_edges = find_non_manifold_edges(topology).size();
  const SplitPinches split = split_pinches(mesh, topology);
  report.non_manifold_vertices = count_non_manifold_vertices(mesh, topology, split, report.non_manifold_edges);
  report.manifold = report.non_manifold_edges == 0 && report.non_manifold_vertices == 0;
  report.components = connect_by_vertices(mesh).count;
  report.shells = split.shells.count;
  report.genus = total_genus(mesh, topology, split, report.closed);
  report.duplicate_faces = count_duplicate_faces(mesh, topology);
}

void describe_measures(const SurfaceMesh& mesh, MeshReport& report) {
  if (report.closed) report.volume = enclosed_volume(mesh);
  const FaceMeasures faces = measure_faces(mesh);
  report.area = faces.area;
  report.min_angle_deg = faces.angles.min_deg;
  report.max_angle_deg = faces.angles.max_deg;
  report.bbox = bounding_box(mesh);
}

void describe_pairs(const SurfaceMesh& mesh, const MeshTopology& topology, MeshReport& report) {
  const SelfCrossingCounts counts = count_self_crossings(mesh, topology);
  report.crossing_pairs = counts.crossing;
  report.overlapping_pairs = counts.coplanar_overlap;
  report.touching_pairs = counts.touching;
  report.self_intersections = counts.crossing + counts.coplanar_overlap + counts.touching;
  report.degenerate_faces = counts.degenerate_faces;
}

MeshReport describe(const SurfaceMesh& mesh, const MeshTopology& topology) {
  MeshReport report;
  report.vertices = mesh.points.size();
  report.triangles = mesh.triangles.size();
  describe_topology(mesh, topology, report);
  describe_measures(mesh, report);
  return report;
}

}  // namespace

MeshReport inspect_without_pairs(const SurfaceMesh& mesh) {
  validate(mesh);
  return describe(mesh, build_topology(mesh));
}

MeshReport inspect(const SurfaceMesh& mesh) {
  validate(mesh);
  const MeshTopology topology = build_topology(mesh);
  MeshReport report = describe(mesh, topology);
  describe_pairs(mesh, topology, report);
  return report;
}

}  // namespace mortise
