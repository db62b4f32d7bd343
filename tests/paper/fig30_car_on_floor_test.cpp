// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 30: four tyres press into the floor of a tunnel: footprints imprinted in a sheet and cut out of a box, then sizes that grow from
// them. Areas of footprints are summed along the loops of the graph.
#include <algorithm>
#include <cmath>

#include "mortise/boolean/imprint.h"
#include "mortise/brep/result_features.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "mortise/size/graph_sources.h"
#include "support/catch.h"
#include "support/imprint_checks.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double growth = 1.2, plane = 6 * 3;

/// With round shoulders, 2 cm deep in the floor z = 0.
SurfaceMesh tyre(double x, double y) {
  const std::vector<Vec2d> profile{{0, -0.1},    {0.28, -0.1},  {0.31, -0.085}, {0.325, -0.06}, {0.33, -0.03},
                                   {0.33, 0.03}, {0.325, 0.06}, {0.31, 0.085},  {0.28, 0.1},    {0, 0.1}};
  return moved(transform(revolve(profile, 64), rotation(Axis::X, 90)), {x, y, 0.31});
}

/// Four of them in one mesh.
SurfaceMesh tyres() { return joined({tyre(1.6, 0.8), tyre(4.3, 0.8), tyre(1.6, 2.2), tyre(4.3, 2.2)}); }

SurfaceMesh floor_sheet() { return make_grid_sheet(6, 3, 12, 6); }

/// Twice the area of a closed polygon in z = 0 is the sum of the cross products along it.
double area_of_loops(const IntersectionGraph& graph) {
  double sum = 0;
  for (const std::vector<std::uint32_t>& chain : graph.chains) {
    double twice = 0;
    for (std::size_t k = 1; k < chain.size(); ++k) twice += cross(graph.points[chain[k - 1]], graph.points[chain[k]]).z;
    sum += std::fabs(twice) / 2;
  }
  return sum;
}

void check_four_loops(const IntersectionGraph& graph) {
  CHECK(graph.closed_loops == 4);
  CHECK(graph.open_chains == 0);
  REQUIRE(graph.chains.size() == 4);
  for (const std::vector<std::uint32_t>& chain : graph.chains) {
    CHECK(chain.front() == chain.back());
    CHECK(chain.size() > 10);
    for (const std::uint32_t p : chain) CHECK(graph.points[p].z == 0);
  }
}

double area_at_level(const SurfaceMesh& mesh, double z) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
    if (a.z == z && b.z == z && c.z == z) area += triangle_area(a, b, c);
  }
  return area;
}

using MeshEdges = std::vector<std::array<VertexId, 2>>;

struct Floor {
  ModelScene scene;
  MeshEdges loops;
};

/// With four footprints as faces of their own.
Floor imprinted_floor() {
  const ImprintResult imprinted = imprint(floor_sheet(), tyres());
  const ImprintedOperand& floor = imprinted.operands[0];
  MeshEdges loops;
  for (const auto& [a, b] : shared_edges(imprinted)) {
    const auto vertex_of = [&](std::uint32_t id) {
      return VertexId(
          static_cast<std::size_t>(std::lower_bound(floor.vertex_ids.begin(), floor.vertex_ids.end(), id) - floor.vertex_ids.begin()));
    };
    loops.push_back({vertex_of(a), vertex_of(b)});
  }
  BrepRules rules = without_seams();
  rules.features.user_edges = loops;
  return {scene_of(floor.mesh, rules), loops};
}

/// The largest |z| of any corner.
double height_off_plane(const SurfaceMesh& mesh) {
  double off = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) off = std::max(off, std::fabs(mesh.points[v.index()].z));
  }
  return off;
}

/// Round closed model edges, in units of the size at the middle: edges on them, the mean on every loop; edges that leave them, the mean.
struct Rings {
  std::size_t loops = 0;
  double least_on = 10, greatest_on = 0, mean_off = 0;
};

Rings rings_of(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizes) {
  const auto sizes_long = [&](VertexId a, VertexId b) {
    const Vec3d &p = mesh.points[a.index()], &q = mesh.points[b.index()];
    return length(q - p) / sizes.size_at(0.5 * (p + q));
  };
  Rings rings;
  std::vector<std::uint8_t> is_on(mesh.points.size(), 0);
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    if (path.front() != path.back()) continue;
    double sum = 0;
    for (std::size_t k = 1; k < path.size(); ++k) sum += sizes_long(path[k - 1], path[k]);
    for (const VertexId v : path) is_on[v.index()] = 1;
    const double mean = sum / static_cast<double>(path.size() - 1);
    rings.least_on = std::min(rings.least_on, mean);
    rings.greatest_on = std::max(rings.greatest_on, mean);
    ++rings.loops;
  }
  double count = 0;
  for (const auto& [a, b] : build_topology(mesh).edges) {
    if (is_on[a.index()] == is_on[b.index()]) continue;
    rings.mean_off += sizes_long(a, b);
    ++count;
  }
  rings.mean_off /= count;
  return rings;
}

}  // namespace

TEST_CASE("Fig. 30: four tyres leave four closed loops in the floor, whose area is what the plane had", "[paper][imprint]") {
  const ImprintResult imprinted = imprint(floor_sheet(), tyres());
  check_four_loops(imprinted.whole.graph);
  CHECK(surface_area(imprinted.operands[0].mesh) == Approx(plane).epsilon(1e-12));
  const BooleanResult footprints = evaluate(Operation::Intersect, {floor_sheet(), tyres()});
  const double patches = area_of_loops(imprinted.whole.graph);
  CHECK(patches > 4 * 0.02);
  CHECK(surface_area(footprints.mesh) == Approx(patches).epsilon(1e-12));
}

TEST_CASE("Fig. 30: a floor of a box united with tyres is the plane less the four footprints", "[paper]") {
  for (const SurfaceMesh& floor : {box({0, 0, -0.5}, {6, 3, 0}), floor_sheet()}) {
    const BooleanResult united = evaluate(Operation::Union, {floor, tyres()});
    check_four_loops(united.graph);
    CHECK(area_at_level(united.mesh, 0) == Approx(plane - area_of_loops(united.graph)).epsilon(1e-12));
  }
}

TEST_CASE("Fig. 30: sizes grow from the loops, and the floor stays a plane", "[paper][remesh]") {
  const Floor floor = imprinted_floor();
  const ModelScene& scene = floor.scene;
  CHECK(scene.model.brep.faces.size() == 5);
  const SizingProxy sizes(sources_of_graph(scene.mesh.points, floor.loops, growth), {.global = 0.5});
  for (const Mesher mesher : {Mesher::Local, Mesher::Frontal}) {
    INFO((mesher == Mesher::Local ? "local" : "frontal"));
    RemeshRules rules;
    rules.mesher = mesher;
    const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, rules);
    const ClassifiedBrep after = model_after(scene, result);
    CHECK(find_faults(result.mesh, after).empty());
    CHECK(surface_area(result.mesh) == Approx(plane).epsilon(1e-12));
    CHECK(height_off_plane(result.mesh) <= 1e-12);
    const Rings rings = rings_of(result.mesh, after, sizes);
    CHECK(rings.loops == 4);
    CHECK(std::fabs(rings.least_on - 1) < 0.1);
    CHECK(std::fabs(rings.greatest_on - 1) < 0.1);
    CHECK(std::fabs(rings.mean_off - 1) < 0.1);
    const QualityReport q = measure_quality(result.mesh, after, sizes);
    CHECK(q.folds == 0);
    CHECK(q.free.count == q.all.count);
    CHECK(q.free.least_angle_deg > 34);
    CHECK(q.edges.in_band > 0.985);
    CHECK(q.edges.greatest_growth < growth * 1.05);
    const std::vector<double> growths = growths_of(result.mesh);
    CHECK(growths[growths.size() * 97 / 100] < growth * 1.05);
    CHECK(growths.back() < 1.8);
  }
}

TEST_CASE("Fig. 30: the floor of a box with tyres in it stays a plane with four holes", "[paper][remesh]") {
  const std::vector<SurfaceMesh> operands{box({0, 0, -0.5}, {6, 3, 0}), tyres()};
  const BooleanResult united = evaluate(Operation::Union, operands);
  const ModelScene scene = scene_of(united, operands);
  const auto graph = find_graph_edges(united.mesh, united.provenance);
  const SizingProxy sizes(sources_of_graph(united.mesh.points, graph, growth), {.global = 0.3});
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
  CHECK(find_faults(result.mesh, model_after(scene, result)).empty());
  CHECK(count_crossings(result.mesh) == 0);
  std::size_t floors = 0;
  for (std::size_t f = 0; f < scene.model.brep.faces.size(); ++f) {
    if (scene.model.brep.loops_of_face.of(ModelFaceId(f)).size() != 5) continue;
    const SurfaceMesh part = part_of(result, ModelFaceId(f));
    CHECK(height_off_plane(part) <= 1e-12);
    CHECK(surface_area(part) == Approx(plane - area_of_loops(united.graph)).epsilon(1e-4));  // loops are cut along their chords
    CHECK(measure_faces(part).angles.min_deg > 33);
    ++floors;
  }
  CHECK(floors == 1);
}
