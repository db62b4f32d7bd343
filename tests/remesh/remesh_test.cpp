// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Remeshed models against the sizes asked for, the surface they came from, and the model they are meshes of.
#include "mortise/remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/base/error.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/result_features.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/validate.h"
#include "mortise/remesh/edit_mesh.h"
#include "mortise/remesh/reference_surface.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Quality {
  double least_angle = 180, greatest_angle = 0, mean_ratio = 0, mean_edge = 0, in_band = 0;
};

// Radius ratio 2 r / R, edges and the part of them between h / sqrt 2 and h sqrt 2, with the mean of the sizes at both ends.
Quality measure(const SurfaceMesh& mesh, const SizingProxy& sizes) {
  Quality q;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
    for (const double angle : triangle_angles_deg(a, b, c)) {
      q.least_angle = std::min(q.least_angle, angle);
      q.greatest_angle = std::max(q.greatest_angle, angle);
    }
    const double ab = length(b - a), bc = length(c - b), ca = length(a - c), area = triangle_area(a, b, c);
    q.mean_ratio += 16 * area * area / (ab * bc * ca * (ab + bc + ca));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d &from = mesh.points[t[k].index()], &to = mesh.points[t[(k + 1) % 3].index()];
      const double edge = length(to - from) / ((sizes.size_at(from) + sizes.size_at(to)) / 2);
      q.mean_edge += edge / 3;
      q.in_band += edge > std::sqrt(0.5) && edge < std::sqrt(2.0) ? 1.0 / 3 : 0;
    }
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  return {q.least_angle, q.greatest_angle, q.mean_ratio / count, q.mean_edge / count, q.in_band / count};
}

// Every vertex on the entity it had or was made on, model vertices where they were, the model the same.
void check_model(const ModelScene& scene, const RemeshResult& result) {
  const ClassifiedBrep model{scene.model.brep, result.classification};
  CHECK(find_faults(result.mesh, model).empty());
  CHECK_NOTHROW(EditMesh(result.mesh, model).check());
  const ReferenceSurface reference(scene.mesh, scene.model, scene.normals);
  const double within = 1e-9 * length(bounding_box(scene.mesh).hi - bounding_box(scene.mesh).lo);
  std::size_t off = 0;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    for (const VertexId v : result.mesh.triangles[t]) {
      const Vec3d& p = result.mesh.points[v.index()];
      const Vec3d on = reference.locate(result.classification.face_of_triangle[t], p, result.sources[t].value).point;
      off += length(on - p) > within ? 1 : 0;
    }
  }
  CHECK(off == 0);
  for (std::size_t v = 0; v < scene.model.brep.vertex_count; ++v) {
    const Vec3d &before = scene.mesh.points[scene.model.classification.mesh_vertex[ModelVertexId(v)].index()],
                &after = result.mesh.points[result.classification.mesh_vertex[ModelVertexId(v)].index()];
    CHECK(before == after);
  }
}

RemeshResult remeshed(const ModelScene& scene, const SizingProxy& sizes) {
  RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
  check_model(scene, result);
  return result;
}

}  // namespace

TEST_CASE("the union of two cylinders gets triangles of one size and no angle below 30 degrees", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(48));
  CHECK(measure_faces(scene.mesh).angles.min_deg < 0.1);
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult result = remeshed(scene, sizes);
  const Quality q = measure(result.mesh, sizes);
  CHECK(q.least_angle > 30);
  CHECK(q.greatest_angle < 115);
  CHECK(q.mean_ratio > 0.96);
  CHECK(std::fabs(q.mean_edge - 1) < 0.03);
  CHECK(q.in_band > 0.995);
  CHECK(enclosed_volume(result.mesh) == Approx(enclosed_volume(scene.mesh)).epsilon(2e-3));
  CHECK(find_self_crossings(result.mesh).empty());
  CHECK(static_cast<double>(result.mesh.triangles.size()) == Approx(predict_triangle_count(scene.mesh, sizes)).epsilon(0.05));
}

TEST_CASE("seams are edges", "[remesh]") {
  BrepRules disc;
  disc.seams = Seams::Disc;
  const ModelScene tube = scene_of(make_cylinder(1, 4, 48), BrepRules{}), torus = scene_of(make_torus(2, 0.7, 80, 40), disc);
  CHECK(tube.model.brep.edges.size() == 3);
  CHECK(torus.model.brep.edges.size() == 3);
  for (const ModelScene* scene : {&tube, &torus}) {
    const SizingProxy sizes({}, {.global = 0.16});
    const RemeshResult result = remeshed(*scene, sizes);
    const Quality q = measure(result.mesh, sizes);
    CHECK(q.least_angle > 30);
    CHECK(q.greatest_angle < 115);
    CHECK(q.mean_ratio > 0.95);
  }
}

TEST_CASE("a torus of long triangles gets good ones", "[remesh]") {
  const ModelScene scene = scene_of(make_torus(2, 0.7, 80, 40));
  const SizingProxy sizes({}, {.global = 0.16});
  const RemeshResult result = remeshed(scene, sizes);
  const Quality q = measure(result.mesh, sizes);
  CHECK(q.least_angle > 30);
  CHECK(q.greatest_angle < 115);
  CHECK(q.mean_ratio > 0.955);
  CHECK(std::fabs(q.mean_edge - 1) < 0.03);
  CHECK(q.in_band > 0.99);
}

TEST_CASE("by the rules of the paper edges are between one and two sizes long", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(48));
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, paper_rules());
  check_model(scene, result);
  const Quality q = measure(result.mesh, sizes);
  CHECK(q.least_angle > 30);
  CHECK(q.mean_edge > 1.3);
  CHECK(q.mean_edge < 1.45);
}

TEST_CASE("where faces would come to cross, they are not made coarse, or the triangles given stay", "[remesh]") {
  // A tetrahedron thinner than the size; the ridge between two of its sides is no model edge.
  SurfaceMesh mesh;
  mesh.points = {{0, 2, 2}, {3, 4, 2}, {3, 4, 4}, {0, 3, 4}};
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) { mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)}); };
  add(0, 1, 2), add(0, 3, 1), add(1, 3, 2), add(2, 3, 0);
  const ModelScene scene = scene_of(mesh);
  struct Case {
    double size;
    std::size_t kept;
  };
  for (const Case& c : {Case{0.214, 0}, Case{0.411, 4}}) {
    const SizingProxy sizes({}, {.global = c.size});
    RemeshRules blind;
    blind.audits = 0;
    CHECK_FALSE(find_self_crossings(remesh(scene.mesh, scene.model, scene.normals, sizes, blind).mesh).empty());
    const RemeshResult result = remeshed(scene, sizes);
    CHECK(find_self_crossings(result.mesh).empty());
    CHECK(result.new_crossings.empty());
    CHECK(result.kept.size() == c.kept);
  }
}

TEST_CASE("corners of a rim that are a rounding apart become one", "[remesh]") {
  // Vertices of the ball are half way up, but for a last bit: needles round each of them.
  const ModelScene scene = scene_of(Operation::Subtract, {make_icosphere(1, 3), box({-3, -3, -3}, {3, 3, 0.5})});
  CHECK(measure_faces(scene.mesh).angles.min_deg < 1e-14);
  const SizingProxy sizes({}, {.global = 0.15});
  const RemeshResult result = remeshed(scene, sizes);
  CHECK(result.kept.empty());
  CHECK(measure(result.mesh, sizes).least_angle > 30);
  CHECK(find_self_crossings(result.mesh).empty());
}

TEST_CASE("the tip of a cone inside a face stays", "[remesh]") {
  const ModelScene scene = scene_of(make_cone(1, 2, 24));
  REQUIRE(scene.model.brep.faces.size() == 2);
  const RemeshResult result = remeshed(scene, SizingProxy({}, {.global = 0.2}));
  CHECK(std::find(result.mesh.points.begin(), result.mesh.points.end(), Vec3d{0, 0, 2}) != result.mesh.points.end());
}

TEST_CASE("sizes grow away from a source on the surface", "[remesh]") {
  const ModelScene scene = scene_of(box({0, 0, 0}, {1, 1, 1}));
  const SizingProxy sizes(std::vector{segment_source({0.2, 0.3, 1}, {0.7, 0.6, 1}, 0.01, 1.2)}, {.global = 0.2});
  const RemeshResult result = remeshed(scene, sizes);
  const Quality q = measure(result.mesh, sizes);
  CHECK(q.least_angle > 30);
  CHECK(q.greatest_angle < 115);
  CHECK(std::fabs(q.mean_edge - 1) < 0.05);
  CHECK(q.in_band > 0.97);
  CHECK(enclosed_volume(result.mesh) == Approx(1).epsilon(1e-12));
}

TEST_CASE("walls between regions are meshed once, with the edges where three faces meet", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Partition, {box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.25, 0.25}, {2, 0.75, 1.5})});
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult result = remeshed(scene, sizes);
  const Quality q = measure(result.mesh, sizes);
  CHECK(q.least_angle > 30);
  CHECK(q.in_band > 0.97);
  CHECK(surface_area(result.mesh) == Approx(surface_area(scene.mesh)).epsilon(1e-12));
  CHECK_FALSE(find_non_manifold_edges(build_topology(result.mesh)).empty());
  CHECK(find_boundary_edges(build_topology(result.mesh)).empty());
}

TEST_CASE("only layers round the intersection graph change, all else stays byte for byte", "[remesh]") {
  std::vector<SurfaceMesh> operands{make_torus(2, 0.7, 80, 40), make_cylinder(0.3, 4, 24)};
  for (Vec3d& p : operands[1].points) p = p + Vec3d{2, 0.1, -2};
  const BooleanResult united = evaluate_boolean(Operation::Union, pointers_to(operands));
  const ModelScene scene = scene_of(Operation::Union, operands);
  const auto graph = find_graph_edges(united.mesh, united.provenance);
  const SizingProxy sizes({}, {.global = 0.08});
  RemeshRules rules;
  rules.zone = layers_round(scene.mesh, graph, 4);
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, rules);
  CHECK(find_faults(result.mesh, {scene.model.brep, result.classification}).empty());

  const auto outside = std::count(rules.zone.begin(), rules.zone.end(), std::uint8_t{0});
  CHECK(outside > 4000);
  CHECK(count_lost(scene.mesh, rules.zone, result.mesh) == 0);

  // Inside, away from triangles that stay, sizes and angles are those asked for.
  SurfaceMesh zone = result.mesh;
  zone.triangles.clear();
  for (const Triangle& t : result.mesh.triangles) {
    const bool is_near = std::all_of(t.begin(), t.end(), [&](VertexId v) {
      const Vec3d& p = result.mesh.points[v.index()];
      return std::any_of(graph.begin(), graph.end(),
                         [&](const auto& ends) { return length(p - scene.mesh.points[ends[0].index()]) < 0.1; });
    });
    if (is_near) zone.triangles.push_back(t);
  }
  CHECK(zone.triangles.size() > 150);
  CHECK(measure(zone, sizes).least_angle > 30);
  CHECK(measure(scene.mesh, sizes).least_angle < 1);
}

TEST_CASE("a sheet keeps its border", "[remesh]") {
  SurfaceMesh sheet;
  sheet.points = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}, {0, 1, 2}, {3, 1, 2}};
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) { sheet.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)}); };
  add(0, 1, 2), add(0, 2, 3), add(3, 2, 5), add(3, 5, 4);
  const ModelScene scene = scene_of(sheet);
  const SizingProxy sizes({}, {.global = 0.2});
  const RemeshResult result = remeshed(scene, sizes);
  const Quality q = measure(result.mesh, sizes);
  CHECK(q.least_angle > 30);
  CHECK(surface_area(result.mesh) == Approx(9).epsilon(1e-12));
  CHECK(result.classification.path.of(ModelEdgeId(0)).size() > 3);
}

TEST_CASE("labels stay with the surface they are on", "[remesh]") {
  SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.label_names = {"side", "lid"};
  for (const Triangle& t : mesh.triangles) {
    const bool is_lid = std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh.points[v.index()].z == 1; });
    mesh.face_labels.push_back(is_lid ? 1 : 0);
  }
  const ModelScene scene = scene_of(mesh);
  const RemeshResult result = remeshed(scene, SizingProxy({}, {.global = 0.2}));
  double lid = 0;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const auto [a, b, c] = result.mesh.triangles[t];
    if (result.mesh.face_labels[t] == 1)
      lid += triangle_area(result.mesh.points[a.index()], result.mesh.points[b.index()], result.mesh.points[c.index()]);
  }
  CHECK(lid == Approx(1).epsilon(1e-12));
  CHECK(result.mesh.label_names == mesh.label_names);
}

TEST_CASE("rules and sizes without a meaning are refused, and a count out of bounds is foretold", "[remesh]") {
  const ModelScene scene = scene_of(box({0, 0, 0}, {1, 1, 1}));
  const auto code_of = [&](const ModelScene& of, const SizingProxy& sizes, const RemeshRules& rules) {
    try {
      static_cast<void>(remesh(of.mesh, of.model, of.normals, sizes, rules));
    } catch (const Error& error) {
      return error.code;
    }
    return ErrorCode::InternalError;
  };
  const SizingProxy sizes({}, {.global = 0.2}), tiny({}, {.global = 1e-5});
  RemeshRules cancelling, narrow, unknown, elsewhere, finer;
  elsewhere.zone = {1, 0};
  narrow.shortest = 2;
  unknown.longest = std::numeric_limits<double>::quiet_NaN();
  finer.rounds = {0.5};
  CHECK(code_of(scene, tiny, {}) == ErrorCode::ResultTooLarge);
  CHECK(code_of(scene, sizes, narrow) == ErrorCode::InvalidArgument);
  CHECK(code_of(scene, sizes, unknown) == ErrorCode::InvalidArgument);
  CHECK(code_of(scene, sizes, finer) == ErrorCode::InvalidArgument);
  CHECK(code_of(scene, sizes, elsewhere) == ErrorCode::InvalidArgument);
  CHECK_THROWS_AS(layers_round(scene.mesh, {{VertexId(0), VertexId(99)}}, 1), Error);
  cancelling.progress = [](std::string_view, double fraction) { return fraction < 0.2; };
  CHECK(code_of(scene, sizes, cancelling) == ErrorCode::Cancelled);
}
