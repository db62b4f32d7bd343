// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Builds the scenes.
#include "remesh_scenes.h"

#include <cmath>

#include "support/data.h"

namespace mortise::peers {
namespace {

using Operands = std::vector<SurfaceMesh>;

struct Sizes {
  SizingProxy proxy;
  bool is_uniform = true;
};

Sizes uniform(double size) { return {SizingProxy({}, {.global = size}), true}; }

/// The size that asks for about so many triangles.
Sizes asking_for(double triangles, const SurfaceMesh& mesh) { return uniform(std::sqrt(surface_area(mesh) * 2.31 / triangles)); }

RemeshScene scene_of(SurfaceMesh mesh, FaceNormals normals, Sizes sizes) {
  mesh.vertex_data.clear();
  mesh.corner_data.clear();
  mesh.face_labels.clear();
  mesh.label_names.clear();
  BrepRules rules;
  rules.seams = Seams::None;
  ClassifiedBrep model = build_brep(mesh, rules, normals);
  return {std::move(mesh), std::move(normals), std::move(model), std::move(sizes.proxy), sizes.is_uniform, {}};
}

BooleanResult evaluated(Operation operation, const Operands& operands) {
  std::vector<const SurfaceMesh*> pointers;
  for (const SurfaceMesh& mesh : operands) pointers.push_back(&mesh);
  return evaluate_boolean(operation, pointers);
}

FaceNormals normals_of(const BooleanResult& result, const Operands& operands) {
  std::vector<FaceNormals> normals;
  for (const SurfaceMesh& mesh : operands) normals.push_back(measure_normals(mesh, build_topology(mesh)));
  return source_normals(result.provenance, normals);
}

RemeshScene scene_of(Operation operation, const Operands& operands, double size) {
  const BooleanResult result = evaluated(operation, operands);
  return scene_of(result.mesh, normals_of(result, operands), uniform(size));
}

RemeshScene united(const Operands& operands, double triangles) {
  const BooleanResult result = evaluated(Operation::Union, operands);
  return scene_of(result.mesh, normals_of(result, operands), asking_for(triangles, result.mesh));
}

/// Two cylinders of length 4 that cross, the axes a little apart.
Operands crossing_cylinders(std::uint32_t around) {
  Operands both{make_cylinder(1, 4, around), make_cylinder(0.6, 4, around)};
  for (Vec3d& p : both[1].points) p = {p.z - 2, p.x + 0.02, p.y + 2.013};
  return both;
}

RemeshScene torus() {
  const SurfaceMesh mesh = make_torus(2, 0.7, 160, 80);
  return scene_of(mesh, measure_normals(mesh, build_topology(mesh)), uniform(0.08));
}

/// Small triangles where the cylinders meet, growing away from there (Fig. 23c).
RemeshScene graded() {
  const Operands operands = crossing_cylinders(48);
  const BooleanResult result = evaluated(Operation::Union, operands);
  std::vector<SizeSource> sources;
  for (const auto& [a, b] : find_graph_edges(result.mesh, result.provenance))
    sources.push_back(segment_source(result.mesh.points[a.index()], result.mesh.points[b.index()], 0.03, 1.2));
  return scene_of(result.mesh, normals_of(result, operands), {SizingProxy(sources, {.global = 0.15}), false});
}

/// In a ring, each overlapping its neighbours (Fig. 25).
RemeshScene eight_tori() {
  Operands operands;
  const SurfaceMesh one = make_torus(1, 0.3, 48, 24);
  for (int i = 0; i < 8; ++i) operands.push_back(transform(one, compose(translation({3, 0, 0}), rotation(Axis::Z, 45.0 * i))));
  return scene_of(Operation::Union, operands, 0.08);
}

/// A ball, a ring and a bent sheet as one model of regions and sheets (Fig. 26).
RemeshScene ball_ring_and_sheet() {
  SurfaceMesh sheet;
  sheet.points = {{-1.6, 0.05, -1.6}, {1.6, 0.05, -1.6}, {1.6, 0.05, 1.6}, {-1.6, 0.05, 1.6}, {-1.6, 2.05, 1.6}, {1.6, 2.05, 1.6}};
  for (const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{0, 2, 1}, {0, 3, 2}, {3, 5, 2}, {3, 4, 5}})
    sheet.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return scene_of(Operation::Partition, {make_sphere(1, 64, 32), make_torus(1.1, 0.35, 64, 24), sheet}, 0.08);
}

/// A box of twelve triangles less three slender cylinders (Fig. 27).
RemeshScene drilled_box() {
  Operands operands{make_box({-1, -1, -1}, {1, 1, 1})};
  for (const Vec3d& at : {Vec3d{-0.55, -0.3, -1.5}, Vec3d{0.1, 0.45, -1.5}, Vec3d{0.6, -0.45, -1.5}})
    operands.push_back(transform(make_cylinder(0.12, 3, 64), translation(at)));
  return scene_of(Operation::Subtract, operands, 0.06);
}

/// A torus of a million triangles and a cylinder through its side: four layers round where they meet (Fig. 28).
RemeshScene zone_of_a_million() {
  Operands operands{make_torus(2, 0.7, 1000, 500), transform(make_cylinder(0.3, 2, 48), translation({2, 0, 0}))};
  const BooleanResult result = evaluated(Operation::Union, operands);
  RemeshScene scene = scene_of(result.mesh, normals_of(result, operands), uniform(0.015));
  scene.zone = layers_round(result.mesh, find_graph_edges(result.mesh, result.provenance), 4);
  return scene;
}

using test::read_data;

std::vector<NamedScene> real_scenes() {
  if (!test::data_folder()) return {};
  return {
      {"funnel", "a funnel sunk in a hull",
       [] {
         return united({read_data("ship/dtc_hull.ply"), read_data("ship/stack_funnel.obj", "s=0.015 t=1.2,0,0.50")}, 60000);
       }},
      {"fins", "four fins on a body",
       [] {
         Operands operands{read_data("aircraft/cape_bullet.obj")};
         for (const char* fin : {"1", "2", "3", "4"}) operands.push_back(read_data(std::string("aircraft/cape_fin") + fin + ".obj"));
         return united(operands, 40000);
       }},
      {"wing", "a wing on a fuselage",
       [] {
         return united({read_data("aircraft/ceasiom_fuselage_closed.off"), read_data("aircraft/ceasiom_wing_swept.stl", "t=11,0,-0.4")},
                       40000);
       }},
      {"flange", "a flange on a hull",
       [] {
         return united({read_data("ship/dtc_hull.ply"), read_data("cad/flange.stl", "s=4 t=3.5,0,0.61")}, 60000);
       }},
      {"scans", "a scan united with itself, turned",
       [] {
         return united({read_data("scans/armadillo100k.ply"), read_data("scans/armadillo100k.ply", "ry=90")}, 60000);
       }},
  };
}

}  // namespace

std::vector<NamedScene> remesh_scenes() {
  std::vector<NamedScene> scenes{
      {"U48", "two cylinders of 48 segments united", [] { return scene_of(Operation::Union, crossing_cylinders(48), 0.1); }},
      {"U180", "two cylinders of 180 segments united", [] { return scene_of(Operation::Union, crossing_cylinders(180), 0.025); }},
      {"T", "a torus of stretched triangles", torus},
      {"Fig. 23c", "as U48, small triangles along the cut", graded},
      {"Fig. 25", "eight tori united", eight_tori},
      {"Fig. 26", "a ball, a ring and a sheet: regions, sheets, edges with many triangles", ball_ring_and_sheet},
      {"Fig. 27", "a box of twelve triangles with three holes", drilled_box},
      {"zone", "four layers round the cut in a torus of a million triangles", zone_of_a_million},
  };
  for (NamedScene& scene : real_scenes()) scenes.push_back(std::move(scene));
  return scenes;
}

}  // namespace mortise::peers
