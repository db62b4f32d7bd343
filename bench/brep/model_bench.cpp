// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Writes large meshes as STL and prints what their models cost us; scripts/bench-models runs Gmsh on the same files.
// usage: model_bench FOLDER RUNS   (a line for each: name, triangles, faces, edges, regions, median milliseconds)
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

void run(const std::string& folder, const BenchMesh& bench, int runs) {
  const SurfaceMesh mesh = stored(folder + "/" + bench.name + ".stl", bench.make());
  std::vector<double> times;
  ClassifiedBrep model;
  for (int i = 0; i < runs; ++i) {
    const Stopwatch watch;
    model = build_brep(mesh);
    times.push_back(watch.milliseconds());
  }
  std::sort(times.begin(), times.end());
  std::printf("%s %zu %zu %zu %zu %.1f\n", bench.name.c_str(), mesh.triangles.size(), model.brep.faces.size(), model.brep.edges.size(),
              model.brep.region_count - 1, times[times.size() / 2]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: model_bench FOLDER RUNS\n", stderr);
    return 2;
  }
  for (const BenchMesh& bench : meshes) run(argv[1], bench, std::max(1, std::atoi(argv[2])));
}
