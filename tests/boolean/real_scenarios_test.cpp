// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Real meshes against printed figures of another library: volumes, areas, genus and parts of the paper's scenes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Part {
  std::string file;
  std::string moves;
};

/// A result and what was printed of it: text, since its last digit says how exact it is; empty or -1 where nothing was.
struct Figures {
  Operation operation;
  std::vector<std::size_t> order;  ///< of the parts
  std::string volume;
  std::string area;
  long genus = -1;
  long shells = -1;
};

struct Scenario {
  std::string name;
  std::vector<Part> parts;
  std::vector<Figures> figures;
};

constexpr Operation unite_all = Operation::Union, common = Operation::Intersect, less_rest = Operation::Subtract;

std::vector<std::size_t> all_of(std::size_t n) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  return order;
}

/// Two parts: union, intersection, first less second, second less first.
std::vector<Figures> pair_figures(const std::string& all, const std::string& both, const std::string& a_less_b,
                                  const std::string& b_less_a) {
  return {{unite_all, {0, 1}, all, ""}, {common, {0, 1}, both, ""}, {less_rest, {0, 1}, a_less_b, ""}, {less_rest, {1, 0}, b_less_a, ""}};
}

Scenario cylinders() {
  std::vector<Figures> figures = pair_figures("25.2075953542", "2.77763788766", "16.018133792", "6.41182367447");
  figures[0].area = "62.6536205";
  figures[2].genus = 1;
  figures[3].shells = 2;
  return {"Fig. 5 cylinders", {{"primitives/fig05_cylinder_a.off", ""}, {"primitives/fig05_cylinder_b.off", ""}}, figures};
}

Scenario eight_tori() {
  std::vector<Part> parts;
  for (int i = 0; i < 8; ++i) parts.push_back({"primitives/fig25_torus.off", "t=3,0,0 rz=" + std::to_string(45 * i)});
  return {"Fig. 25 eight tori",
          parts,
          {{unite_all, all_of(8), "13.2696560214", "84.6338942", 9, 1}, {less_rest, all_of(8), "1.58171022393", ""}}};
}

Scenario box_and_cylinders(const std::string& box) {
  return {"Fig. 27 " + box,
          {{"primitives/" + box + ".off", ""},
           {"primitives/fig27_cylinder_1.off", ""},
           {"primitives/fig27_cylinder_2.off", ""},
           {"primitives/fig27_cylinder_3.off", ""}},
          {{unite_all, all_of(4), "8.13417179298", "26.2554926"}, {less_rest, all_of(4), "7.73165641404", "", 3, 1}}};
}

Scenario sphere_pair() {
  std::vector<Figures> figures = pair_figures("0.150512325409", "0.0502476038832", "0.0501323604465", "0.0501323610791");
  figures[2].area = "1.04497487";
  return {"sphere pair", {{"primitives/gch_sphere1.obj", ""}, {"primitives/gch_sphere2.obj", ""}}, figures};
}

Scenario flush_on_deck() {
  std::vector<Figures> figures = pair_figures("2.43715374729", "0", "2.43630567736", "0.000848069934538");
  figures[0].shells = 1;
  return {"Fig. 28 flush on deck", {{"ship/dtc_hull.ply", ""}, {"ship/stack_funnel.obj", "s=0.015 t=1.2,0,0.5723220109939575"}}, figures};
}

Scenario coplanar_duct() {
  std::vector<Figures> figures = pair_figures("0.000875", "0.00025", "0.000625", "0");
  figures[2].shells = 2;
  return {"coplanar duct", {{"cad/duct.off", ""}, {"cad/porous_block.off", ""}}, figures};
}

Scenario spot_and_blub() {
  std::vector<Figures> figures = pair_figures("0.776455212817", "0.185770272378", "0.532488515722", "0.0581964247174");
  figures[2].genus = 4;
  return {"spot and blub", {{"scans/spot.obj", ""}, {"scans/blub.obj", "s=0.6"}}, figures};
}

Scenario fandisk_pair() {
  std::vector<Figures> figures = pair_figures("1.62343934342", "0.621996149087", "0.500721597167", "0.500721597167");
  figures[2].genus = 2;
  return {"fandisk", {{"cad/fandisk.off", ""}, {"cad/fandisk.off", "rz=30 t=0.2,0.1,0.05"}}, figures};
}

std::vector<Scenario> scenarios() {
  return {
      cylinders(),
      eight_tori(),
      {"Fig. 26 sphere and torus",
       {{"primitives/fig26_sphere.off", ""}, {"primitives/fig26_torus.off", ""}},
       pair_figures("6.16992102889", "0.605824201819", "3.55837939443", "2.00571743264")},
      box_and_cylinders("fig27_box_fine"),
      box_and_cylinders("fig27_box_coarse"),
      box_and_cylinders("fig27_box_quads"),
      sphere_pair(),
      {"Fig. 28 implant on deck",
       {{"ship/dtc_hull.ply", ""}, {"ship/stack_funnel.obj", "s=0.015 t=1.2,0,0.50"}},
       pair_figures("2.43694930021", "0.000204447077", "2.43610123028", "0.00064362285744")},
      flush_on_deck(),
      {"mixer zone",
       {{"cad/mixer_zone.obj", ""}, {"cad/mixer_stirrer.obj", ""}},
       pair_figures("0.0829113563022", "0.00246055847757", "0.0804507978247", "0")},
      coplanar_duct(),
      spot_and_blub(),
      fandisk_pair(),
  };
}

/// One unit of the last digit printed.
double last_digit(const std::string& figure) {
  const std::size_t point = figure.find('.');
  return point == std::string::npos ? 0 : std::pow(10.0, -static_cast<double>(figure.size() - point - 1));
}

bool agrees(double value, const std::string& figure, double volume_of_first) {
  const double printed = std::strtod(figure.c_str(), nullptr);
  return std::abs(value - printed) <= std::max({1e-9 * std::abs(printed), last_digit(figure), 1e-12 * volume_of_first});
}

struct Loaded {
  std::vector<SurfaceMesh> parts;
  std::vector<double> volumes;
  double coordinate = 0;
  std::size_t triangles = 0;
};

Loaded load(const Scenario& scenario) {
  Loaded loaded;
  for (const Part& part : scenario.parts) {
    loaded.parts.push_back(read_data(part.file, part.moves));
    loaded.volumes.push_back(exact_volume(loaded.parts.back()));
    loaded.coordinate = std::max(loaded.coordinate, largest_coordinate(loaded.parts.back()));
    loaded.triangles += loaded.parts.back().triangles.size();
  }
  return loaded;
}

BooleanResult check_figures(const Loaded& loaded, const Figures& figures) {
  std::vector<const SurfaceMesh*> operands;
  for (const std::size_t i : figures.order) operands.push_back(&loaded.parts[i]);
  BooleanResult result = evaluate_boolean(figures.operation, operands);
  CHECK(faults_of_mesh(result) == "");
  // Rationals take their time: where instructions are slow only the small scenes are checked by them.
  if (!is_reduced_run() || loaded.triangles < 6000) CHECK(faults_of_provenance(operands, result, Repairs::Allowed) == "");
  const Shape shape = shape_of(result.mesh);
  const double first = loaded.volumes[figures.order[0]];
  INFO("volume " << shape.volume << " against " << figures.volume << ", area " << shape.area << " against " << figures.area);
  CHECK(agrees(shape.volume, figures.volume, first));
  if (!figures.area.empty()) CHECK(agrees(shape.area, figures.area, first));
  if (figures.genus >= 0) CHECK(shape.genus == figures.genus);
  if (figures.shells >= 0) CHECK(shape.shells == static_cast<std::size_t>(figures.shells));
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
  std::size_t count = 0;
  if (is_data_missing()) return;
  for (const Scenario& scenario : scenarios()) {
    INFO(scenario.name);
    const Loaded loaded = load(scenario);
    if (is_reduced_run() && loaded.triangles > 20000) continue;
    std::vector<BooleanResult> results;
    for (const Figures& figures : scenario.figures) {
      INFO(operation_name(figures.operation) << ", first operand " << figures.order[0]);
      results.push_back(check_figures(loaded, figures));
    }
    if (results.size() == 4) check_identities(loaded, results);
    ++count;
  }
  std::printf("real meshes: %zu scenarios\n", count);
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

TEST_CASE("the three boxes of Fig. 27 give the same volume and the same intersection with the cylinders", "[scenario]") {
  if (is_data_missing()) return;
  std::vector<double> volumes;
  for (const std::string box : {"fig27_box_fine", "fig27_box_coarse", "fig27_box_quads"}) {
    const Loaded loaded = load(box_and_cylinders(box));
    volumes.push_back(exact_volume(evaluate(Operation::Union, loaded.parts).mesh));
  }
  CHECK(volumes[1] == Approx(volumes[0]).epsilon(1e-12));
  CHECK(volumes[2] == Approx(volumes[0]).epsilon(1e-12));
}

TEST_CASE("real meshes: A with B equals B with A", "[scenario]") {
  if (is_data_missing()) return;
  for (const Scenario& scenario : scenarios()) {
    if (scenario.parts.size() != 2) continue;
    const Loaded loaded = load(scenario);
    if (is_reduced_run() && loaded.triangles > 20000) continue;
    for (const Operation operation : {Operation::Union, Operation::Intersect}) {
      INFO(scenario.name << ", " << operation_name(operation));
      const BooleanResult forward = evaluate(operation, loaded.parts);
      const BooleanResult backward = evaluate(operation, {loaded.parts[1], loaded.parts[0]});
      CHECK(forward.mesh.triangles.size() == backward.mesh.triangles.size());
      CHECK(sorted_points(forward.mesh) == sorted_points(backward.mesh));
      CHECK(forward.graph.edges.size() == backward.graph.edges.size());
      CHECK(forward.graph.closed_loops == backward.graph.closed_loops);
    }
  }
}

TEST_CASE("real meshes scaled by 2^300 and 2^-300 give the scaled result, bit for bit", "[scenario]") {
  if (is_data_missing()) return;
  const std::vector<SurfaceMesh> parts = load(sphere_pair()).parts;
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
  std::vector<SurfaceMesh> tori = load(eight_tori()).parts;
  const BooleanResult forward = evaluate(Operation::Union, tori);
  std::swap(tori[0], tori[5]);
  std::swap(tori[2], tori[7]);
  const BooleanResult shuffled = evaluate(Operation::Union, tori);
  CHECK(forward.mesh.triangles.size() == shuffled.mesh.triangles.size());
  CHECK(sorted_points(forward.mesh) == sorted_points(shuffled.mesh));
}
