// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What our remeshing costs and how good its triangles are, beside CGAL and Gmsh on the same meshes in one run:
// remesh_speed FOLDER [RUNS [SCENE]]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "../peers/cgal_remesh.h"
#include "../peers/measure_cost.h"
#include "gmsh_remesh.h"
#include "mortise/mortise.h"
#include "remesh_scenes.h"

namespace {

using namespace mortise;
using namespace mortise::peers;

constexpr double percent = 100;

RemesherAnswer our_remesh(const RemeshScene& scene) {
  RemeshResult result;
  RemeshRules rules;
  rules.zone = scene.zone;
  const Cost cost = measure_cost([&] { result = remesh(scene.mesh, scene.model, scene.normals, scene.sizes, rules); });
  return {"", std::move(result.mesh), {scene.model.brep, std::move(result.classification)}, cost.milliseconds / 1000, cost.megabytes};
}

/// The answer of the last run with the median of all times and the most memory.
template <class Remesh>
RemesherAnswer median_of(std::size_t runs, Remesh remesh_once) {
  std::vector<double> seconds;
  RemesherAnswer answer;
  double megabytes = 0;
  for (std::size_t i = 0; i < runs; ++i) {
    answer = remesh_once();
    if (!answer.refusal.empty()) return answer;
    seconds.push_back(answer.seconds);
    megabytes = std::max(megabytes, answer.megabytes);
  }
  std::sort(seconds.begin(), seconds.end());
  answer.seconds = seconds[seconds.size() / 2];
  answer.megabytes = megabytes;
  return answer;
}

void print_head() {
  std::printf("%-14s %9s %8s %8s  %11s  %11s  %13s  %6s %6s %6s  %15s  %17s  %6s %5s %5s %6s\n", "", "triangles", "seconds", "ktri/s",
              "least angle", "largest", "below 30", "2r/R", "edge/h", "band %", "surfaces, in h", "model edges, in h", "bound%", "folds",
              "cross", "MB");
  std::printf("%-14s %9s %8s %8s  %5s %5s  %5s %5s  %6s %6s  %6s %6s %6s  %7s %7s  %8s %8s\n", "", "", "", "", "all", "free", "all", "free",
              "all", "free", "free", "free", "free", "to", "from", "to", "from");
}

void print_row(const RemeshScene& scene, const char* who, const RemesherAnswer& answer) {
  if (!answer.refusal.empty()) {
    std::printf("%-14s %s\n", who, answer.refusal.c_str());
    return;
  }
  const QualityReport q = measure_quality(answer.mesh, answer.model, scene.sizes);
  const Deviation d = measure_deviation(answer.mesh, answer.model, scene.mesh, scene.model, scene.sizes, Matching::None);
  const auto count = static_cast<double>(q.all.count);
  std::printf(
      "%-14s %9zu %8.2f %8.1f  %5.1f %5.1f  %5.1f %5.1f  %6zu %6zu  %6.4f %6.4f %6.2f  %7.4f %7.4f  %8.5f %8.5f  %6.2f %5zu %5zu %6.0f\n",
      who, q.all.count, answer.seconds, answer.seconds > 0 ? count / answer.seconds / 1000 : 0, q.all.least_angle_deg,
      q.free.least_angle_deg, q.all.greatest_angle_deg, q.free.greatest_angle_deg, q.all.below_30, q.free.below_30,
      q.free.mean_radius_ratio, q.free_edges.mean, percent * q.free_edges.in_band, d.to_reference.in_sizes, d.from_reference.in_sizes,
      d.curves_to_reference.in_sizes, d.curves_from_reference.in_sizes, percent * (1 - static_cast<double>(q.free.count) / count), q.folds,
      find_self_crossings(answer.mesh).size(), answer.megabytes);
  std::fflush(stdout);
}

// All else stays: its triangles cost next to nothing.
void print_zone(const RemeshScene& scene, const RemesherAnswer& answer) {
  const auto given = static_cast<double>(std::count(scene.zone.begin(), scene.zone.end(), std::uint8_t{1}));
  const double made = given + static_cast<double>(answer.mesh.triangles.size()) - static_cast<double>(scene.mesh.triangles.size());
  std::printf("ours           zone of %.0f triangles, then %.0f: %.3f s, %.2f us each, %.0f MB\n", given, made, answer.seconds,
              1e6 * answer.seconds / made, answer.megabytes);
}

void compare(const NamedScene& named, const std::string& folder, std::size_t runs) {
  const RemeshScene scene = named.make();
  std::printf("\n%s: %s; %zu triangles, %zu model faces, %zu model edges, %.0f triangles asked for\n", named.name.c_str(),
              named.what.c_str(), scene.mesh.triangles.size(), scene.model.brep.faces.size(), scene.model.brep.edges.size(),
              predict_triangle_count(scene.mesh, scene.sizes));
  if (!scene.zone.empty()) {
    print_zone(scene, median_of(runs, [&] { return our_remesh(scene); }));
    return;
  }
  print_row(scene, "given", {"", scene.mesh, scene.model, 0, 0});
  print_row(scene, "ours", median_of(runs, [&] { return our_remesh(scene); }));
  if (!scene.is_uniform) {
    std::puts("CGAL, Gmsh     know one size only here");
    return;
  }
  const double size = scene.sizes.limits().global;
  print_row(scene, "CGAL", median_of(runs, [&] { return cgal_remesh(scene.mesh, scene.model, size, ModelEdges::Constrained); }));
  print_row(scene, "CGAL protected", median_of(runs, [&] { return cgal_remesh(scene.mesh, scene.model, size, ModelEdges::Protected); }));
  std::string file = named.name;
  std::replace(file.begin(), file.end(), ' ', '_');
  print_row(scene, "Gmsh", gmsh_remesh(scene.mesh, size, folder + "/" + file));
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fputs("usage: remesh_speed FOLDER [RUNS [SCENE]]\n", stderr);
    return 2;
  }
  const std::string folder = words[1], only = count > 3 ? words[3] : "";
  const std::size_t runs = count > 2 ? std::max(1UL, std::strtoul(words[2], nullptr, 10)) : 3;
  std::filesystem::create_directories(folder);
  std::printf(
      "medians of %zu runs (Gmsh: one, the whole program); h: the size wanted; band: edges in h / sqrt 2 .. h sqrt 2; bound: triangles\n"
      "that are not free, since a small feature is near; cross: pairs of triangles that cross; MB: peak on top of the mesh\n\n",
      runs);
  print_head();
  for (const NamedScene& scene : remesh_scenes()) {
    if (only.empty() || only == scene.name) compare(scene, folder, runs);
  }
  return 0;
}
