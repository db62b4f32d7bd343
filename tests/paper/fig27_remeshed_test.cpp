// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 27: three cylinders of 64 sides through a plate of twelve triangles, and through the same plate of many: one model, and remeshed
// by sizes that grow from the holes good triangles on both.
#include "mortise/base/trig.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double growth = 1.2;

/// The plate [0, 4] x [0, 3] x [0, 1] in squares of a quarter; sides have vertices of their own.
SurfaceMesh plate_of_squares() {
  const SurfaceMesh lid = make_grid_sheet(4, 3, 16, 12), end = with_axes_turned(make_grid_sheet(3, 1, 12, 4)),
                    side = with_axes_turned(with_axes_turned(make_grid_sheet(1, 4, 4, 16)));
  return joined({moved(lid, {0, 0, 1}), inside_out(lid), moved(end, {4, 0, 0}), inside_out(end), moved(side, {0, 3, 0}), inside_out(side)});
}

ModelScene drilled(const SurfaceMesh& plate) {
  std::vector<SurfaceMesh> solids = plate_and_drills();
  solids[0] = plate;
  return scene_of(Operation::Subtract, solids);
}

double polygon_area(double radius) { return sides_of_drill / 2.0 * radius * radius * trig::sin_deg(360.0 / sides_of_drill); }

double area_of_holes() {
  double area = 0;
  for (const Drilling& d : drillings) area += polygon_area(d.radius);
  return area;
}

std::vector<std::size_t> counts_of(const Brep& brep) {
  return {brep.vertex_count, brep.edges.size(), brep.faces.size(), brep.loops.size(), brep.region_count, brep.region_of_shell.size()};
}

/// Faces with four loops: top and bottom.
std::vector<ModelFaceId> faces_with_holes(const Brep& brep) {
  std::vector<ModelFaceId> faces;
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    if (brep.loops_of_face.of(ModelFaceId(f)).size() == 4) faces.emplace_back(f);
  }
  return faces;
}

}  // namespace

TEST_CASE("Fig. 27: a plate of twelve triangles and one of many have the same model with three holes", "[paper][brep]") {
  const ModelScene coarse = drilled(plate_and_drills()[0]), fine = drilled(plate_of_squares());
  CHECK(fine.mesh.triangles.size() > coarse.mesh.triangles.size() + 1000);
  // Eight corners and a vertex on each rim; no seams on the holes.
  CHECK(counts_of(coarse.model.brep) == std::vector<std::size_t>{14, 18, 9, 6 + 3 * 2 + 3 * 2, 2, 2});
  CHECK(counts_of(fine.model.brep) == counts_of(coarse.model.brep));
  for (const ModelScene* scene : {&coarse, &fine}) {
    CHECK(find_faults(scene->mesh, scene->model).empty());
    CHECK(enclosed_volume(scene->mesh) == Approx(12 - area_of_holes()).epsilon(1e-12));
  }
}

TEST_CASE("Fig. 27: remeshed, both plates have good triangles that grow from the holes, and the topology they had", "[paper][remesh]") {
  const SizingProxy sizes(sources_at_rims(growth), {.global = 0.5});
  for (const SurfaceMesh& plate : {plate_and_drills()[0], plate_of_squares()}) {
    const ModelScene scene = drilled(plate);
    CHECK(measure_faces(scene.mesh).angles.min_deg < 2);
    const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
    const ClassifiedBrep after = model_after(scene, result);
    CHECK(find_faults(result.mesh, after).empty());
    CHECK(euler_characteristic(result.mesh) == 2 - 2 * 3);
    const QualityReport q = measure_quality(result.mesh, after, sizes);
    CHECK(q.folds == 0);
    CHECK(q.free.count == q.all.count);
    CHECK(q.free.least_angle_deg > 30);
    CHECK(q.edges.greatest_growth < growth * 1.05);
    const std::vector<double> growths = growths_of(result.mesh);
    CHECK(growths[growths.size() * 97 / 100] < growth * 1.05);
    CHECK(growths.back() < 1.65);
    CHECK(deviation_after(scene, result, sizes).curves_to_reference.in_sizes < 1e-3);
    const std::vector<ModelFaceId> faces = faces_with_holes(scene.model.brep);
    REQUIRE(faces.size() == 2);
    for (const ModelFaceId f : faces) {
      CHECK(euler_characteristic(part_of(result, f)) == -2);
      CHECK(surface_area(part_of(result, f)) == Approx(12 - area_of_holes()).epsilon(1e-12));
    }
  }
}
