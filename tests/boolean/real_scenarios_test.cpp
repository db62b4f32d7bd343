// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Real meshes against printed figures of another library: volumes, areas, genus and parts of the paper's scenes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/scene_list.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// The scenes with printed figures.
std::vector<ListedScene> scenarios() {
  std::vector<ListedScene> found;
  for (const ListedScene& scene : listed_scenes()) {
    if (scene.has_figures) found.push_back(scene);
  }
  return found;
}

bool is_made_to_break(const ListedScene& scene) { return scene.operands[0].starts_with("nasty/synthetic/"); }

ListedScene scenario_named(const std::string& name) {
  for (const ListedScene& scene : scenarios()) {
    if (scene.name == name) return scene;
  }
  throw std::invalid_argument("no scene is called " + name);
}

/// One unit of the last digit printed.
double last_digit(const std::string& figure) {
  const std::size_t point = figure.find('.'), end = std::min(figure.find('e'), figure.size());
  if (point == std::string::npos) return 0;
  const double exponent = end == figure.size() ? 0 : std::strtod(figure.c_str() + end + 1, nullptr);
  return std::pow(10.0, exponent - static_cast<double>(end - point - 1));
}

bool agrees(double value, const std::string& figure, double volume_of_first) {
  const double printed = std::strtod(figure.c_str(), nullptr);
  return std::abs(value - printed) <= std::max({1e-9 * std::abs(printed), last_digit(figure), 1e-12 * volume_of_first});
}

struct Loaded {
  std::vector<SurfaceMesh> operands;
  std::vector<double> volumes;
  double coordinate = 0;
  std::size_t triangles = 0;
};

bool is_too_large(const Loaded& loaded) { return is_reduced_run() && loaded.triangles > 20000; }

/// With the volumes of the operands, unless they are too large for this run.
Loaded load(const ListedScene& scene) {
  Loaded loaded;
  for (const std::string& text : scene.operands) {
    loaded.operands.push_back(load_operand(text));
    loaded.triangles += loaded.operands.back().triangles.size();
  }
  if (is_too_large(loaded)) return loaded;
  for (const SurfaceMesh& mesh : loaded.operands) {
    loaded.volumes.push_back(exact_volume(mesh));
    loaded.coordinate = std::max(loaded.coordinate, largest_coordinate(mesh));
  }
  return loaded;
}

BooleanResult check_evaluation(const Loaded& loaded, const ListedEvaluation& evaluation) {
  std::vector<const SurfaceMesh*> operands;
  for (const std::size_t i : evaluation.order) operands.push_back(&loaded.operands[i]);
  BooleanResult result = evaluate_word(evaluation.word, operands);
  CHECK(faults_of_mesh(result) == "");
  // Rationals take their time: where instructions are slow only the small scenes are checked by them.
  if (!is_reduced_run() || loaded.triangles < 6000) CHECK(faults_of_provenance(operands, result, Repairs::Allowed) == "");
  const Shape shape = shape_of(result.mesh);
  const double first = loaded.volumes[evaluation.order[0]];
  INFO("volume " << shape.volume << " against " << evaluation.volume << ", area " << shape.area << " against " << evaluation.area);
  CHECK(agrees(shape.volume, evaluation.volume, first));
  if (!evaluation.area.empty()) CHECK(agrees(shape.area, evaluation.area, first));
  if (!evaluation.genus.empty()) CHECK(std::to_string(shape.genus) == evaluation.genus);
  if (!evaluation.parts.empty()) CHECK(std::to_string(shape.shells) == evaluation.parts);
  return result;
}

/// V(A) + V(B) = V(A or B) + V(A and B), V(A less B) = V(A) - V(A and B) and the other way round.
void check_identities(const Loaded& loaded, const std::vector<BooleanResult>& results) {
  std::vector<double> volume;
  double tolerance = 0;
  for (const BooleanResult& result : results) {
    const Shape shape = shape_of(result.mesh);
    volume.push_back(shape.volume);
    tolerance =
        std::max(tolerance, identity_tolerance(loaded.volumes[0] + loaded.volumes[1], shape.area, result.report, loaded.coordinate));
  }
  CHECK(std::abs(loaded.volumes[0] + loaded.volumes[1] - volume[0] - volume[1]) <= 2 * tolerance);
  CHECK(std::abs(loaded.volumes[0] - volume[1] - volume[2]) <= 2 * tolerance);
  CHECK(std::abs(loaded.volumes[1] - volume[1] - volume[3]) <= 2 * tolerance);
}

}  // namespace

TEST_CASE("booleans of real meshes agree with the printed figures, closed, oriented and certified", "[scenario]") {
  std::size_t real = 0, made = 0;
  if (is_data_missing()) return;
  for (const ListedScene& scene : scenarios()) {
    INFO(scene.name);
    const Loaded loaded = load(scene);
    if (is_too_large(loaded)) continue;
    std::vector<BooleanResult> results;
    for (const ListedEvaluation& evaluation : scene.evaluations) {
      INFO(evaluation.name);
      results.push_back(check_evaluation(loaded, evaluation));
    }
    if (loaded.operands.size() == 2) check_identities(loaded, results);
    ++(is_made_to_break(scene) ? made : real);
  }
  std::printf("real meshes: %zu scenarios, and %zu of meshes made to break booleans\n", real, made);
}

TEST_CASE("the sphere pair has as many triangles as the answer published with it", "[scenario]") {
  if (is_data_missing()) return;
  const SurfaceMesh published = read_data("primitives/gch_sphere1_minus_sphere2.obj");
  const BooleanResult result =
      evaluate(Operation::Subtract, {read_data("primitives/gch_sphere1.obj"), read_data("primitives/gch_sphere2.obj")});
  CHECK(published.triangles.size() == 3140);
  CHECK(result.mesh.triangles.size() == published.triangles.size());
  CHECK(result.mesh.points.size() == published.points.size());
}

TEST_CASE("a spike standing on a face meets it in a point, a tetrahedron on its edge in that edge", "[scenario]") {
  if (is_data_missing()) return;
  const BooleanResult spike = evaluate(Operation::Union, load(scenario_named("spike standing on a face")).operands);
  CHECK(spike.graph.points.size() == 1);
  CHECK(spike.graph.edges.empty());
  CHECK(spike.report.contact.points == 1);
  const BooleanResult wedge = evaluate(Operation::Union, load(scenario_named("tetrahedron standing on an edge")).operands);
  CHECK(wedge.graph.open_chains == 1);
  CHECK(wedge.graph.closed_loops == 0);
  CHECK(wedge.report.contact.length == Approx(0.6));
}

TEST_CASE("the three boxes of Fig. 27 give the same volume and the same intersection with the cylinders", "[scenario]") {
  if (is_data_missing()) return;
  std::vector<double> volumes;
  for (const char* box : {"Fig. 27 fine box", "Fig. 27 coarse box", "Fig. 27 box of quads"}) {
    const Loaded loaded = load(scenario_named(box));
    volumes.push_back(exact_volume(evaluate(Operation::Union, loaded.operands).mesh));
  }
  CHECK(volumes[1] == Approx(volumes[0]).epsilon(1e-12));
  CHECK(volumes[2] == Approx(volumes[0]).epsilon(1e-12));
}

TEST_CASE("real meshes: A with B equals B with A", "[scenario]") {
  if (is_data_missing()) return;
  for (const ListedScene& scene : scenarios()) {
    if (scene.operands.size() != 2) continue;
    const Loaded loaded = load(scene);
    if (is_too_large(loaded)) continue;
    for (const Operation operation : {Operation::Union, Operation::Intersect}) {
      INFO(scene.name << ", " << operation_name(operation));
      const BooleanResult forward = evaluate(operation, loaded.operands);
      const BooleanResult backward = evaluate(operation, {loaded.operands[1], loaded.operands[0]});
      CHECK(forward.mesh.triangles.size() == backward.mesh.triangles.size());
      CHECK(sorted_points(forward.mesh) == sorted_points(backward.mesh));
      CHECK(forward.graph.edges.size() == backward.graph.edges.size());
      CHECK(forward.graph.closed_loops == backward.graph.closed_loops);
    }
  }
}

TEST_CASE("real meshes scaled by 2^300 and 2^-300 give the scaled result, bit for bit", "[scenario]") {
  if (is_data_missing()) return;
  const std::vector<SurfaceMesh> parts = load(scenario_named("sphere pair")).operands;
  const SurfaceMesh plain = evaluate(Operation::Subtract, parts).mesh;
  for (const int exponent : {300, -300}) {
    const double factor = std::ldexp(1.0, exponent);
    const BooleanResult result = evaluate(Operation::Subtract, {scaled(parts[0], factor), scaled(parts[1], factor)});
    CHECK((result.mesh.points == scaled(plain, factor).points));
    CHECK(result.mesh.triangles.size() == plain.triangles.size());
    CHECK(result.report.certificate.status == CertificateStatus::Certified);
  }
}

TEST_CASE("the eight tori unite to the same solid in any order", "[scenario]") {
  if (is_data_missing()) return;
  std::vector<SurfaceMesh> tori = load(scenario_named("Fig. 25 eight tori")).operands;
  const BooleanResult forward = evaluate(Operation::Union, tori);
  std::swap(tori[0], tori[5]);
  std::swap(tori[2], tori[7]);
  const BooleanResult shuffled = evaluate(Operation::Union, tori);
  CHECK(forward.mesh.triangles.size() == shuffled.mesh.triangles.size());
  CHECK(sorted_points(forward.mesh) == sorted_points(shuffled.mesh));
}
