// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 26: sphere, torus and corner sheet kept together, remeshed: junctions of two to four faces stay where they were, and so does the
// border of the sheet.
#include <map>

#include "mortise/brep/validate_brep.h"
#include "mortise/geom/length.h"
#include "support/catch.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// Per number of triangles at it, the length of the edges of a mesh; two at an edge inside a face or on a crease are left out.
std::map<std::size_t, double> lengths_by_fan(const SurfaceMesh& mesh) {
  const MeshTopology topology = build_topology(mesh);
  std::map<std::size_t, double> lengths;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto& [a, b] = topology.edges[e];
    const std::size_t fan = topology.uses_of(MeshEdgeId(e)).size();
    if (fan != 2) lengths[fan] += length(mesh.points[b.index()] - mesh.points[a.index()]);
  }
  return lengths;
}

/// Mesh edges on model edges without a triangle for every face that uses the model edge.
std::size_t count_lost_fans(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  const MeshTopology topology = build_topology(mesh);
  std::size_t lost = 0;
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    const std::size_t fan = model.brep.faces_of_edge.of(ModelEdgeId(e)).size();
    for (std::size_t k = 1; k < path.size(); ++k) {
      const MeshEdgeId edge = find_edge(topology, path[k - 1], path[k]);
      lost += edge.is_valid() && topology.uses_of(edge).size() == fan ? 0 : 1;
    }
  }
  return lost;
}

}  // namespace

TEST_CASE("Fig. 26: remeshed, junctions stay where they were with all their faces, and the border of the sheet has its length",
          "[paper][remesh]") {
  const ModelScene scene = scene_of(Operation::Partition, ball_ring_and_corner_sheet());
  CHECK(count_lost_fans(scene.mesh, scene.model) == 0);
  std::map<std::size_t, double> before = lengths_by_fan(scene.mesh);
  for (const double size : {0.08, 0.15}) {
    INFO("size " << size);
    const SizingProxy sizes({}, {.global = size});
    const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
    const ClassifiedBrep after = model_after(scene, result);
    CHECK(find_faults(result.mesh, after).empty());
    CHECK(count_crossings(result.mesh) == 0);
    CHECK(count_lost_fans(result.mesh, after) == 0);
    std::map<std::size_t, double> now = lengths_by_fan(result.mesh);
    CHECK((now.size() == 2 && before.size() == 2));  // fans of 1 and 4
    CHECK(now[1] == Approx(2 * (3.2 + 2.0 + 1.65)).epsilon(1e-12));
    CHECK((now[4] < before[4] && now[4] > 0.99 * before[4]));
    const Deviation d = deviation_after(scene, result, sizes);
    CHECK(d.curves_to_reference.in_sizes < 1e-3);
    // An edge of up to 1.22 sizes cuts off a corner of up to 45 degrees: half of it times tan 22.5 degrees.
    CHECK(d.curves_from_reference.in_sizes < 0.26);
    const QualityReport q = measure_quality(result.mesh, after, sizes);
    CHECK(q.folds == 0);
    CHECK(q.free.least_angle_deg > 34);
    CHECK(static_cast<double>(q.free.count) > 0.85 * static_cast<double>(q.all.count));
  }
}
