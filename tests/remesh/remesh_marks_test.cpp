// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Real results, remeshed: the marks of the triangles no small feature spoils, as far as they were reached.
#include <cmath>
#include <string>

#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct MarkedScene {
  std::vector<SurfaceMesh> operands;
  double triangles = 0;   ///< asked for
  double least_deg = 33;  ///< of all free triangles
  double greatest_deg = 110;
  double most_bound = 0.02;  ///< of triangles that are not free
  double most_away = 0.4;    ///< of either surface from the other, in sizes
};

void check_marks(const MarkedScene& wanted) {
  SurfaceMesh mesh = wanted.operands.front();
  FaceNormals normals = measure_normals(mesh, build_topology(mesh));
  if (wanted.operands.size() > 1) {
    const BooleanResult united = evaluate(Operation::Union, wanted.operands);
    std::vector<FaceNormals> of_operands;
    for (const SurfaceMesh& operand : wanted.operands) of_operands.push_back(measure_normals(operand, build_topology(operand)));
    mesh = united.mesh;
    normals = source_normals(united.provenance, of_operands);
  }
  mesh.face_labels.clear();
  mesh.label_names.clear();
  const ModelScene scene = scene_of(std::move(mesh), std::move(normals));
  const SizingProxy sizes({}, {.global = std::sqrt(surface_area(scene.mesh) * 2.31 / wanted.triangles)});
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
  const ClassifiedBrep after = model_after(scene, result);
  CHECK(find_faults(result.mesh, after).empty());
  CHECK(result.new_crossings.empty());
  CHECK(result.kept.empty());
  const QualityReport q = measure_quality(result.mesh, after, sizes);
  CHECK(q.free.least_angle_deg > wanted.least_deg);
  CHECK(q.free.greatest_angle_deg < wanted.greatest_deg);
  CHECK(q.free.mean_radius_ratio > 0.955);
  CHECK(q.free_edges.in_band > 0.99);
  CHECK(std::fabs(q.free_edges.mean - 1) < 0.03);
  CHECK(static_cast<double>(q.all.count - q.free.count) < wanted.most_bound * static_cast<double>(q.all.count));
  const Deviation d = deviation_after(scene, result, sizes);
  CHECK(d.to_reference.in_sizes < wanted.most_away);
  CHECK(d.from_reference.in_sizes < wanted.most_away);
  CHECK(d.curves_to_reference.in_sizes < 1e-3);
}

}  // namespace

TEST_CASE("a wing on a fuselage and fins on a body have the marks of remeshing", "[remesh]") {
  if (is_data_missing()) return;
  MarkedScene wing{{read_data("aircraft/ceasiom_fuselage_closed.off"), read_data("aircraft/ceasiom_wing_swept.stl", "t=11,0,-0.4")}, 40000};
  check_marks(wing);
  MarkedScene fins{{read_data("aircraft/cape_bullet.obj")}, 40000};
  for (const char* fin : {"1", "2", "3", "4"}) fins.operands.push_back(read_data(std::string("aircraft/cape_fin") + fin + ".obj"));
  check_marks(fins);
}

TEST_CASE("scans of animals have the marks of remeshing", "[remesh]") {
  if (is_data_missing()) return;
  for (const char* file : {"scans/bob_small.ply", "scans/cactus10k.obj", "scans/spot.obj", "scans/blub.obj", "scans/bunny_adaptive.off"}) {
    INFO(file);
    MarkedScene scan{{read_data(file)}, 20000};
    scan.most_bound = 0.06;
    scan.most_away = 0.5;
    check_marks(scan);
  }
}

TEST_CASE("funnel and flange on a hull, and a scan united with itself, have the marks of remeshing", "[remesh][large]") {
  if (is_data_missing()) return;
  check_marks({{read_data("ship/dtc_hull.ply"), read_data("ship/stack_funnel.obj", "s=0.015 t=1.2,0,0.50")}, 60000});
  check_marks({{read_data("ship/dtc_hull.ply"), read_data("cad/flange.stl", "s=4 t=3.5,0,0.61")}, 60000});
  MarkedScene scans{{read_data("scans/armadillo100k.ply"), read_data("scans/armadillo100k.ply", "ry=90")}, 60000};
  scans.least_deg = 30;
  scans.greatest_deg = 115;
  scans.most_bound = 0.07;
  scans.most_away = 0.8;
  check_marks(scans);
}
