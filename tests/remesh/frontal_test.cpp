// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Figs. 26d and 27h: model faces in planes meshed by a front, beside the local mesher and against what a Delaunay mesh of a polygon is.
#include <algorithm>
#include <cmath>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/triangulate_polygon.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/planar_delaunay.h"
#include "mortise/remesh/quality_report.h"
#include "mortise/remesh/remesh.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/equal_bits.h"
#include "support/random_solids.h"
#include "support/remesh_scenes.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

RemeshResult meshed(const ModelScene& scene, const SizingProxy& sizes, Mesher mesher = Mesher::Frontal) {
  RemeshRules rules;
  rules.mesher = mesher;
  return remesh(scene.mesh, scene.model, scene.normals, sizes, rules);
}

// The model, the surface and what is free of the model's own small angles.
QualityReport check_meshed(const ModelScene& scene, const RemeshResult& result, const SizingProxy& sizes) {
  const ClassifiedBrep model{scene.model.brep, result.classification};
  CHECK(find_faults(result.mesh, model).empty());
  CHECK_NOTHROW(EditMesh(result.mesh, model).check());
  CHECK(find_self_crossings(result.mesh).empty());
  CHECK(result.kept.empty());
  const QualityReport report = measure_quality(result.mesh, model, sizes);
  CHECK(report.folds == 0);
  CHECK(report.free.least_angle_deg >= 33);
  return report;
}

// Of a polygon, z = 0 or put on a plane of no axis.
SurfaceMesh polygon_sheet(const std::vector<std::array<double, 2>>& corners, bool is_tilted = false) {
  SurfaceMesh sheet;
  for (const auto& [x, y] : corners)
    sheet.points.push_back(is_tilted ? Vec3d{0.8 * x - 0.48 * y + 3, 0.6 * x + 0.64 * y - 7, 0.6 * y + 5} : Vec3d{x, y, 0});
  for (const auto& [a, b, c] : triangulate_polygon(sheet.points).triangles)
    sheet.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return sheet;
}

const std::vector<std::array<double, 2>> u_shape{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

std::vector<std::array<double, 2>> star_shape() {
  std::vector<std::array<double, 2>> corners;
  for (int k = 0; k < 10; ++k) {
    const double radius = k % 2 == 0 ? 2 : 1;
    corners.push_back({radius * trig::cos_deg(36 * k), radius * trig::sin_deg(36 * k)});
  }
  return corners;
}

// What the front leaves before triangles are smoothed.
WorkingMesh with_front(const ModelScene& scene, const SizingProxy& sizes) {
  WorkingMesh w(scene.mesh, scene.model, scene.normals, sizes, {});
  await_front(w);
  resample_model_edges(w);
  mesh_planar_faces(w);
  w.mesh.check();
  return w;
}

// Is d clearly inside the circle through a, b, c, all of one plane?
bool is_in_circle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const Vec3d n = cross(b - a, c - a), across = cross(n, b - a);
  const double t = dot(c - a, c - b) / dot(across, c - a) / 2;
  const Vec3d centre = 0.5 * (a + b) + t * across;
  return length(d - centre) < (1 - 1e-9) * length(a - centre);
}

std::size_t count_live(const WorkingMesh& w) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < w.mesh.vertex_count(); ++v) count += w.mesh.has(VertexId(v)) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("Fig. 27h: faces with three holes are meshed by the front, sizes grow from the holes", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Subtract, plate_and_drills(), without_seams(1));
  constexpr double growth = 1.2;
  const SizingProxy sizes(sources_at_rims(growth), {.global = 0.5});
  const RemeshResult result = meshed(scene, sizes);
  const QualityReport report = check_meshed(scene, result, sizes);
  const std::vector<double> growths = growths_of(result.mesh);
  CHECK(growths[growths.size() * 95 / 100] < growth * 1.05);
  CHECK(report.edges.greatest_growth < growth * 1.05);
  std::size_t with_four_loops = 0;
  for (std::size_t f = 0; f < scene.model.brep.faces.size(); ++f) {
    if (scene.model.brep.loops_of_face.of(ModelFaceId(f)).size() != 4) continue;
    ++with_four_loops;
    const SurfaceMesh face = part_of(result, ModelFaceId(f));
    double area = 12;
    for (const Drilling& d : drillings) area -= sides_of_drill / 2.0 * d.radius * d.radius * trig::sin_deg(360.0 / sides_of_drill);
    CHECK(surface_area(face) == Approx(area).epsilon(1e-12));
    std::vector<VertexId> corners;
    for (const Triangle& t : face.triangles) corners.insert(corners.end(), t.begin(), t.end());
    std::sort(corners.begin(), corners.end());
    const auto vertices = std::unique(corners.begin(), corners.end()) - corners.begin();
    const auto off_plane = [&](VertexId v) { return face.points[v.index()].z != face.points[corners[0].index()].z; };
    CHECK(std::none_of(corners.begin(), corners.end(), off_plane));
    CHECK(vertices + static_cast<std::ptrdiff_t>(face.triangles.size()) ==
          static_cast<std::ptrdiff_t>(build_topology(face).edges.size()) - 2);
  }
  CHECK(with_four_loops == 2);
}

// The part of all edges that are in other bins of length.
double histogram_distance(const LengthMarks& a, const LengthMarks& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.bins.size(); ++k)
    sum += std::fabs(static_cast<double>(a.bins[k]) / static_cast<double>(a.count) -
                     static_cast<double>(b.bins[k]) / static_cast<double>(b.count));
  return sum / 2;
}

TEST_CASE("Fig. 26d: by the same sizes the front makes edges as long as the local mesher does", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Subtract, plate_and_drills());
  for (const SizingProxy& sizes : {SizingProxy(sources_at_rims(1.2), {.global = 0.5}), SizingProxy({}, {.global = 0.05})}) {
    const RemeshResult by_changes = meshed(scene, sizes, Mesher::Local);
    const QualityReport local = measure_quality(by_changes.mesh, {scene.model.brep, by_changes.classification}, sizes);
    const QualityReport frontal = check_meshed(scene, meshed(scene, sizes), sizes);
    CHECK(std::fabs(frontal.edges.mean / local.edges.mean - 1) < 0.03);
    CHECK(frontal.edges.in_band > local.edges.in_band - 0.002);
    CHECK(histogram_distance(local.edges, frontal.edges) < 0.15);
    CHECK(frontal.all.mean_radius_ratio > local.all.mean_radius_ratio);
  }
}

TEST_CASE("walls between regions are meshed by the front once", "[remesh]") {
  const ModelScene scene = scene_of(Operation::Partition, {box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.25, 0.25}, {2, 0.75, 1.5})});
  const SizingProxy sizes({}, {.global = 0.05});
  const RemeshResult result = meshed(scene, sizes);
  const QualityReport report = check_meshed(scene, result, sizes);
  CHECK(std::fabs(report.edges.mean - 1) < 0.02);
  CHECK(report.edges.in_band > 0.995);
  CHECK(report.all.mean_radius_ratio > 0.975);
  CHECK(surface_area(result.mesh) == Approx(surface_area(scene.mesh)).epsilon(1e-12));
  CHECK(find_boundary_edges(build_topology(result.mesh)).empty());
}

TEST_CASE("faces of any shape are meshed by the front", "[remesh]") {
  for (const bool is_tilted : {false, true}) {
    for (const auto& corners : {u_shape, star_shape()}) {
      const ModelScene scene = scene_of(polygon_sheet(corners, is_tilted));
      REQUIRE(scene.model.brep.faces.size() == 1);
      for (const double size : {0.4, 0.1, 0.03}) {
        const SizingProxy sizes({}, {.global = size});
        const RemeshResult result = meshed(scene, sizes);
        check_meshed(scene, result, sizes);
        CHECK(surface_area(result.mesh) == Approx(surface_area(scene.mesh)).epsilon(1e-12));
        double off = 0;
        const Vec3d normal = is_tilted ? Vec3d{0.36, -0.48, 0.8} : Vec3d{0, 0, 1};
        for (const Vec3d& p : result.mesh.points) off = std::max(off, std::fabs(dot(p - scene.mesh.points[0], normal)));
        CHECK(off <= (is_tilted ? 1e-13 : 0));
      }
    }
  }
}

TEST_CASE("edges and vertices of the model inside a face stay in it", "[remesh]") {
  // A wall stands on a part of a square; a tetrahedron on another square touches its middle.
  const ModelScene slit =
      scene_of(make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.3, 0.5, 0}, {0.7, 0.5, 0}, {0.3, 0.5, 1}, {0.7, 0.5, 1}},
                         {{0, 1, 5}, {0, 5, 4}, {0, 4, 3}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 5, 7}, {4, 7, 6}}));
  const ModelScene touched =
      scene_of(make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.45, 0.55, 0}, {0.4, 0.4, 1}, {0.6, 0.4, 1}, {0.5, 0.7, 1}},
                         {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {4, 6, 5}, {4, 7, 6}, {4, 5, 7}, {5, 6, 7}}));
  CHECK(slit.model.brep.faces.size() == 2);
  CHECK(touched.model.brep.faces.size() > 1);
  const SizingProxy sizes({}, {.global = 0.08});
  for (const ModelScene* scene : {&slit, &touched}) {
    const RemeshResult result = meshed(*scene, sizes);
    check_meshed(*scene, result, sizes);
    CHECK(surface_area(result.mesh) == Approx(surface_area(scene->mesh)).epsilon(1e-12));
    const Vec3d inner = scene->mesh.points[4];
    CHECK(std::find(result.mesh.points.begin(), result.mesh.points.end(), inner) != result.mesh.points.end());
  }
  const WorkingMesh w = with_front(touched, sizes);
  CHECK(std::count(w.is_done.begin(), w.is_done.end(), std::uint8_t{1}) == static_cast<std::ptrdiff_t>(touched.model.brep.faces.size()));
}

TEST_CASE("sizes above that of a face leave the vertices on its border only", "[remesh]") {
  const SizingProxy sizes({}, {.global = 100});
  for (const auto& corners : {u_shape, star_shape()}) {
    SurfaceMesh finer = meshed(scene_of(polygon_sheet(corners)), SizingProxy({}, {.global = 0.1})).mesh;
    CHECK(finer.triangles.size() > 500);
    CHECK(meshed(scene_of(finer), sizes).mesh.triangles.size() == corners.size() - 2);
  }
  const ModelScene drilled = scene_of(Operation::Subtract, plate_and_drills(), without_seams(1));
  std::size_t on_plate = 0;
  const RemeshResult result = meshed(drilled, sizes);
  for (const Triangle& t : result.mesh.triangles) {
    on_plate += std::all_of(t.begin(), t.end(), [&](VertexId v) { return result.mesh.points[v.index()].z == 0; }) ? 1 : 0;
  }
  CHECK(on_plate == 4 + 3 * sides_of_drill + 2 * 3 - 2);
}

TEST_CASE("the front leaves Delaunay triangles of random polygons", "[remesh]") {
  for (std::size_t seed = 1; seed <= scaled_count(40, 1000); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    const std::size_t n = 3 + random.below(30);
    const bool is_round = random.once_in(2), is_tilted = random.once_in(2);
    std::vector<std::array<double, 2>> corners;
    for (std::size_t k = 0; k < n; ++k) {
      const double radius = is_round ? 1 : random.between(0.4, 1.5),
                   angle = 360 * (static_cast<double>(k) + random.between(0, 0.5)) / static_cast<double>(n);
      corners.push_back({radius * trig::cos_deg(angle), radius * trig::sin_deg(angle)});
    }
    const ModelScene scene = scene_of(polygon_sheet(corners, is_tilted), without_seams(0.01));
    const SizingProxy sizes(std::vector{point_source({0.2, 0.1, 0}, random.octaves(-7, -2), random.between(1.05, 1.5))},
                            {.global = random.octaves(-5, 1)});
    if (predict_triangle_count(scene.mesh, sizes) > 5000) continue;
    const WorkingMesh w = with_front(scene, sizes);
    const EditMesh& m = w.mesh;
    CHECK(w.is_done[ModelFaceId(0)] == 1);
    const auto at = [&](VertexId v) { return m.points[v.index()]; };
    double area = 0;
    std::size_t turned = 0, not_delaunay = 0, held = 0;
    const bool is_hole_free = is_round && count_live(w) < 400;
    for (std::size_t i = 0; i < m.triangle_count(); ++i) {
      const FaceId t(i);
      if (!m.has(t)) continue;
      const auto [a, b, c] = m.triangle(t);
      area += triangle_area(at(a), at(b), at(c));
      turned += orient2d(at(a), at(b), at(c), Axis::Z) == Sign::Positive ? 0 : 1;
      for (auto h = static_cast<HalfEdge>(3 * i), end = h + 3; h < end; ++h) {
        if (!m.is_on_model_edge(h)) not_delaunay += is_in_circle(at(a), at(b), at(c), at(m.apex(m.opposite(h)))) ? 1 : 0;
      }
      for (std::size_t v = 0; is_hole_free && v < m.vertex_count(); ++v) {
        if (m.has(VertexId(v))) held += is_in_circle(at(a), at(b), at(c), m.points[v]) ? 1 : 0;
      }
    }
    CHECK(turned == 0);
    CHECK(not_delaunay == 0);
    CHECK(held == 0);
    CHECK(area == Approx(surface_area(scene.mesh)).epsilon(1e-12));
  }
}

TEST_CASE("results of random operations are meshed by the front to sound models", "[remesh]") {
  for (std::size_t seed = 1; seed <= scaled_count(40, 1000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids{random.next_of_all_kinds(), random.next_of_all_kinds()};
    const Operation operation = random.once_in(2) ? Operation::Union : Operation::Partition;
    const ModelScene scene = scene_of(operation, solids);
    if (scene.mesh.triangles.empty() || !find_self_crossings(scene.mesh).empty()) continue;
    const RemeshResult result = meshed(scene, SizingProxy({}, {.global = random.octaves(-2, 1)}));
    CHECK(find_faults(result.mesh, {scene.model.brep, result.classification}).empty());
    CHECK(find_self_crossings(result.mesh).empty());
    CHECK(surface_area(result.mesh) == Approx(surface_area(scene.mesh)).epsilon(0.06));
  }
}

TEST_CASE("faces with triangles outside the zone are not for the front, all others are", "[remesh]") {
  const ModelScene scene = scene_of(box({0, 0, 0}, {1, 1, 1}));
  RemeshRules rules;
  rules.mesher = Mesher::Frontal;
  rules.zone.assign(scene.mesh.triangles.size(), 1);
  rules.zone[0] = 0;
  const SizingProxy sizes({}, {.global = 0.1});
  WorkingMesh w(scene.mesh, scene.model, scene.normals, sizes, rules.zone);
  await_front(w);
  CHECK(std::count(w.awaits_front.begin(), w.awaits_front.end(), std::uint8_t{1}) == 5);
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, rules);
  CHECK(find_faults(result.mesh, {scene.model.brep, result.classification}).empty());
  const auto corners_of = [](const SurfaceMesh& mesh, const Triangle& t) {
    return std::array{mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()]};
  };
  const auto given = corners_of(scene.mesh, scene.mesh.triangles[0]);
  CHECK(std::count_if(result.mesh.triangles.begin(), result.mesh.triangles.end(),
                      [&](const Triangle& t) { return corners_of(result.mesh, t) == given; }) == 1);
}

TEST_CASE("vertices go into Delaunay triangles where there is room, and out again", "[remesh]") {
  const ModelScene scene = scene_of(make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  const SizingProxy sizes({}, {.global = 1});
  WorkingMesh w(scene.mesh, scene.model, scene.normals, sizes, {});
  PlanarDelaunay delaunay(w);
  delaunay.enter_plane({0, 0, 1});
  CHECK(delaunay.is_counterclockwise(FaceId(0)));
  const VertexId on_edge = delaunay.try_insert(FaceId(0), {0.5, 0.5, 0}, 0.2);
  REQUIRE(on_edge.is_valid());
  CHECK(w.mesh.live_triangle_count() == 4);
  const VertexId in_triangle = delaunay.try_insert(FaceId(0), {0.5, 0.8, 0}, 0.2);
  REQUIRE(in_triangle.is_valid());
  CHECK(w.mesh.live_triangle_count() == 6);
  // Beyond the border, near a vertex of another triangle, near the border.
  for (const Vec3d& p : {Vec3d{1.5, 0.5, 0}, Vec3d{0.5, 0.45, 0}, Vec3d{0.25, 0.09, 0}})
    CHECK_FALSE(delaunay.try_insert(FaceId(0), p, 0.2).is_valid());
  for (const VertexId v : {on_edge, in_triangle}) {
    CHECK(delaunay.try_remove(v));
    w.mesh.check();
  }
  CHECK(w.mesh.live_triangle_count() == 2);
}

TEST_CASE("a face with a triangle that turns the wrong way round is not for the front", "[remesh]") {
  const ModelScene scene =
      scene_of(make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
  const SizingProxy sizes({}, {.global = 0.1});
  WorkingMesh w(scene.mesh, scene.model, scene.normals, sizes, {});
  await_front(w);
  CHECK(w.coarseness_of(ModelFaceId(0)) > 1);
  w.mesh.points[4] = {1.25, 0.5, 0};
  mesh_planar_faces(w);
  CHECK(w.mesh.live_triangle_count() == 4);
  CHECK(w.is_done[ModelFaceId(0)] == 0);
  CHECK(w.coarseness_of(ModelFaceId(0)) == 1);
}

TEST_CASE("the front leaves the same bits each time, and the same shape at every scale", "[remesh]") {
  const ModelScene scene = scene_of(polygon_sheet(star_shape(), true));
  const RemeshResult first = meshed(scene, SizingProxy({}, {.global = 0.1})), again = meshed(scene, SizingProxy({}, {.global = 0.1}));
  REQUIRE(first.mesh.points.size() == again.mesh.points.size());
  CHECK(first.mesh.triangles == again.mesh.triangles);
  CHECK(first.sources == again.sources);
  CHECK(std::equal(first.mesh.points.begin(), first.mesh.points.end(), again.mesh.points.begin(), have_equal_bits));
  for (const double scale : {0x1p-20, 0x1p20}) {
    SurfaceMesh other = scene.mesh;
    for (Vec3d& p : other.points) p = scale * p;
    const RemeshResult result = meshed(scene_of(other), SizingProxy({}, {.global = 0.1 * scale}));
    CHECK(result.mesh.triangles == first.mesh.triangles);
    CHECK(std::equal(result.mesh.points.begin(), result.mesh.points.end(), first.mesh.points.begin(),
                     [&](const Vec3d& p, const Vec3d& q) { return p == scale * q; }));
  }
}

TEST_CASE("the front can be stopped", "[remesh]") {
  const ModelScene scene = scene_of(polygon_sheet(u_shape));
  RemeshRules rules;
  rules.mesher = Mesher::Frontal;
  rules.rounds = {1};
  std::size_t calls = 0, stop_at = 0;
  rules.progress = [&](std::string_view, double) { return ++calls != stop_at; };
  const SizingProxy sizes({}, {.global = 0.015});
  CHECK(remesh(scene.mesh, scene.model, scene.normals, sizes, rules).mesh.triangles.size() > 60000);
  CHECK(calls > 8);
  for (stop_at = 1; stop_at < 8; ++stop_at) {
    calls = 0;
    try {
      static_cast<void>(remesh(scene.mesh, scene.model, scene.normals, sizes, rules));
      FAIL("it went on");
    } catch (const Error& error) {
      CHECK(error.code == ErrorCode::Cancelled);
    }
    CHECK(calls == stop_at);
  }
}

TEST_CASE("labels, walls and sources are those of the triangles a face had", "[remesh]") {
  SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.label_names = {"side", "lid"};
  for (const Triangle& t : mesh.triangles)
    mesh.face_labels.push_back(std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh.points[v.index()].z == 1; }) ? 1 : 0);
  const ModelScene scene = scene_of(mesh);
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult result = meshed(scene, sizes);
  check_meshed(scene, result, sizes);
  std::size_t outside = 0;
  double lid = 0;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const auto [a, b, c] = result.mesh.triangles[t];
    const Vec3d &p = result.mesh.points[a.index()], &q = result.mesh.points[b.index()], &r = result.mesh.points[c.index()];
    if (result.mesh.face_labels[t] == 1) lid += triangle_area(p, q, r);
    const Triangle& source = mesh.triangles[result.sources[t].index()];
    const Vec3d middle = 1.0 / 3 * (p + q + r);
    const Vec3d& origin = mesh.points[source[0].index()];
    const Vec3d normal = cross(mesh.points[source[1].index()] - origin, mesh.points[source[2].index()] - origin);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d &from = mesh.points[source[k].index()], &to = mesh.points[source[(k + 1) % 3].index()];
      outside += dot(cross(to - from, middle - from), normal) < -1e-12 ? 1 : 0;
    }
  }
  CHECK(outside == 0);
  CHECK(lid == Approx(1).epsilon(1e-12));
}
