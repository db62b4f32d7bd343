// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Times our unions beside CGAL's, on the same operands in one run, and writes these for other peers: speed FOLDER [RUNS].
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "cgal_answers.h"
#include "measure_cost.h"
#include "mortise/mortise.h"
#include "speed_scenes.h"

namespace {

using namespace mortise;
using namespace mortise::peers;

/// What the runs of one side cost; the result of the last one.
struct Side {
  std::vector<double> milliseconds;
  double megabytes = 0;
  double volume = 0;

  void add(const Cost& cost) {
    milliseconds.push_back(cost.milliseconds);
    megabytes = std::max(megabytes, cost.megabytes);
  }
  [[nodiscard]] double median() const {
    std::vector<double> sorted = milliseconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

void run_ours(const SpeedScene& scene, Side& side) {
  std::vector<const SurfaceMesh*> operands;
  for (const SurfaceMesh& mesh : scene.operands) operands.push_back(&mesh);
  BooleanResult result;
  side.add(measure_cost([&] { result = evaluate_boolean(Operation::Union, operands); }));
  side.volume = enclosed_volume(result.mesh);
}

void run_theirs(const SpeedScene& scene, Side& side) {
  const CostOfUnion answer = cgal_union(scene.operands, scene.runs);
  side.add(answer.cost);
  side.volume = answer.volume;
}

void compare(const SpeedScene& scene, std::size_t runs) {
  Side ours, theirs;
  for (std::size_t i = 0; i < runs; ++i) {
    run_ours(scene, ours);
    run_theirs(scene, theirs);
  }
  std::size_t triangles = 0;
  for (const SurfaceMesh& mesh : scene.operands) triangles += mesh.triangles.size();
  std::printf("%-10s %5zu %9zu  %9.1f %9.1f %7.2f  %8.0f %8.0f   %.12g %.12g\n", scene.name.c_str(), scene.operands.size(), triangles,
              ours.median(), theirs.median(), theirs.median() / ours.median(), ours.megabytes, theirs.megabytes, ours.volume,
              theirs.volume);
  std::fflush(stdout);
}

/// As FOLDER/scene/number.off.
void write_operands(const SpeedScene& scene, const std::string& folder) {
  std::filesystem::create_directories(folder + "/" + scene.name);
  for (std::size_t k = 0; k < scene.operands.size(); ++k) {
    write_mesh_file(folder + "/" + scene.name + "/" + std::to_string(k) + ".off", scene.operands[k]);
  }
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "usage: speed FOLDER [RUNS]\n");
    return 2;
  }
  const std::size_t runs = count > 2 ? std::max(1UL, std::strtoul(words[2], nullptr, 10)) : 7;
  std::printf("native, medians of %zu runs in ms; a ratio above 1: CGAL takes longer; memory: peak in MB on top of the operands\n", runs);
  std::printf("%-10s %5s %9s  %9s %9s %7s  %8s %8s   %s\n", "union of", "parts", "triangles", "ours", "CGAL", "ratio", "ours", "CGAL",
              "volumes");
  for (const SpeedScene& scene : make_speed_scenes()) {
    write_operands(scene, words[1]);
    compare(scene, runs);
  }
}
