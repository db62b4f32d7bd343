// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Writes large meshes as STL and prints what their models cost us; scripts/bench-models runs Gmsh on the same files.
// usage: model_bench FOLDER RUNS   (a line for each: name, triangles, faces, edges, regions, median milliseconds; then, of the pins with a
// hole drilled into one: "drilled", triangles, triangles visited, milliseconds of the model built anew, and of it rebuilt)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "mortise/base/stopwatch.h"
#include "mortise/mortise.h"

using namespace mortise;

namespace {

struct BenchMesh {
  std::string name;
  std::function<SurfaceMesh()> make;
};

SurfaceMesh two_spheres() {
  const SurfaceMesh ball = make_icosphere(1, 7);
  const SurfaceMesh other = transform(ball, compose(rotation(Axis::X, 20), translation({0.5, 0.3, 0.2})));
  return unite(ball, other).mesh;
}

/// Many faces and edges: a plate with 24 x 24 finely turned pins.
SurfaceMesh pins() {
  std::vector<SurfaceMesh> parts{make_box({-1, -1, -1}, {48, 48, 0})};
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < 24; ++j) parts.push_back(transform(make_cylinder(0.7, 3, 400), translation({2.0 * i, 2.0 * j, -0.5})));
  }
  std::vector<const SurfaceMesh*> pointers;
  for (const SurfaceMesh& part : parts) pointers.push_back(&part);
  return evaluate_boolean(Operation::Union, pointers).mesh;
}

const std::vector<BenchMesh> meshes{
    {"torus", [] { return make_torus(3, 1, 1000, 500); }},
    {"spheres", two_spheres},
    {"pins", pins},
};

/// As it is read back from the file, which is what Gmsh gets.
SurfaceMesh stored(const std::string& file, const SurfaceMesh& mesh) {
  write_mesh_file(file, mesh);
  return weld(read_mesh_file(file)).mesh;
}

template <class Work>
double median_milliseconds(int runs, Work work) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const Stopwatch watch;
    work();
    times.push_back(watch.milliseconds());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void run(const std::string& folder, const BenchMesh& bench, int runs) {
  const SurfaceMesh mesh = stored(folder + "/" + bench.name + ".stl", bench.make());
  ClassifiedBrep model;
  const double time = median_milliseconds(runs, [&] { model = build_brep(mesh); });
  std::printf("%s %zu %zu %zu %zu %.1f\n", bench.name.c_str(), mesh.triangles.size(), model.brep.faces.size(), model.brep.edges.size(),
              model.brep.region_count - 1, time);
}

void run_drilled(int runs) {
  const SurfaceMesh plate = pins(), drill = transform(make_cylinder(0.2, 5, 32), translation({2, 2, 1}));
  const BooleanResult result = subtract(plate, drill);
  const FaceNormals plate_normals = measure_normals(plate, build_topology(plate)),
                    drill_normals = measure_normals(drill, build_topology(drill));
  const ClassifiedBrep plate_model = build_brep(plate), drill_model = build_brep(drill);
  const std::vector<OperandModel> models{{plate, plate_model, plate_normals}, {drill, drill_model, drill_normals}};
  RebuiltBrep rebuilt;
  const double anew = median_milliseconds(runs, [&] {
    (void)build_brep(result.mesh, {}, source_normals(result.provenance, {plate_normals, drill_normals}));
  });
  const double local = median_milliseconds(runs, [&] { rebuilt = rebuild_brep(result.mesh, result.provenance, models); });
  std::printf("drilled %zu %zu %.1f %.1f\n", result.mesh.triangles.size(), rebuilt.visited, anew, local);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: model_bench FOLDER RUNS\n", stderr);
    return 2;
  }
  for (const BenchMesh& bench : meshes) run(argv[1], bench, std::max(1, std::atoi(argv[2])));
  run_drilled(std::max(1, std::atoi(argv[2])));
}
