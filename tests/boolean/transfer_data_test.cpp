// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex and corner data through every operation on several meshes.
#include "mortise/boolean/transfer_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "mortise/arrange/prepared_operand.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/mesh/corners_to_vertices.h"
#include "mortise/mesh/group_by_label.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/data_checks.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"
#include "support/scene_list.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation all_operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference,
                                        Operation::Partition};

/// A box with one value per face of it, as data of every vertex or corner.
SurfaceMesh with_channel(SurfaceMesh mesh, const std::string& name, double value) {
  mesh.vertex_data.push_back({name, 1, DataKind::Value, std::vector<double>(mesh.points.size(), value)});
  return mesh;
}

const DataChannel& channel(const SurfaceMesh& mesh, const std::string& name) {
  return *std::find_if(mesh.corner_data.begin(), mesh.corner_data.end(), [&](const DataChannel& c) { return c.name == name; });
}

/// The unit normal of every triangle, at its corners.
SurfaceMesh with_normals(SurfaceMesh mesh) {
  DataChannel normals{"normal", 3, DataKind::Normal, {}};
  for (const Triangle& t : mesh.triangles) {
    const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
    const Vec3d n = cross(b - a, c - a);
    for (int i = 0; i < 3; ++i) {
      for (const double x : {n.x, n.y, n.z}) normals.values.push_back(x / std::sqrt(dot(n, n)));
    }
  }
  mesh.corner_data.push_back(std::move(normals));
  return mesh;
}

/// Do the normals of the channel look out of every triangle, at right angles?
bool has_outward_normals(const SurfaceMesh& mesh) {
  const DataChannel& normals = channel(mesh, "normal");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [p, q, r] = mesh.triangles[t];
    const Vec3d area = cross(mesh.points[q.index()] - mesh.points[p.index()], mesh.points[r.index()] - mesh.points[p.index()]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double* n = normals.values.data() + 3 * (3 * t + i);
      if (!(dot({n[0], n[1], n[2]}, area) > 0.999 * std::sqrt(dot(area, area)))) return false;
    }
  }
  return true;
}

std::vector<SurfaceMesh> with_random_data(std::vector<SurfaceMesh> solids, RandomSource& random) {
  for (std::size_t k = 0; k < solids.size(); ++k) {
    solids[k] = test::with_random_data(std::move(solids[k]), random, k);
    const auto label = [&](std::size_t f) { return static_cast<std::uint32_t>(f % 3); };
    for (std::size_t f = 0; k % 3 != 2 && f < solids[k].triangles.size(); ++f) solids[k].face_labels.push_back(label(f));
    solids[k].label_names = {"steel", k % 2 == 0 ? "copper" : "glass", "air"};
  }
  return solids;
}

void check_exactly(const std::vector<SurfaceMesh>& solids) {
  const auto operands = pointers_to(solids);
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, solids);
    if (result.report.certificate.repair_displacement > 0) continue;
    CHECK(faults_of_data(operands, result) == "");
    CHECK(faults_of_groups(operands, result) == "");
  }
  const ImprintResult imprinted = imprint(operands);
  if (imprinted.whole.report.certificate.repair_displacement == 0) CHECK(faults_of_data(operands, imprinted) == "");
}

double worst_deviation(const std::vector<SurfaceMesh>& solids) {
  double worst = 0, size = 0;
  for (const SurfaceMesh& mesh : solids) size = std::max(size, largest_coordinate(mesh));
  for (const Operation operation : all_operations) worst = std::max(worst, deviation_from_chart(evaluate(operation, solids).mesh, size));
  const auto operands = pointers_to(solids);
  const ImprintResult imprinted = imprint(operands);
  worst = std::max(worst, deviation_from_chart(imprinted.whole.mesh, size));
  for (const ImprintedOperand& operand : imprinted.operands) worst = std::max(worst, deviation_from_chart(operand.mesh, size));
  return worst;
}

SurfaceMesh turned(const SurfaceMesh& mesh, RandomSource& random) {
  SurfaceMesh result = mesh;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) result = transform(result, rotation(axis, random.between(0, 360)));
  return result;
}

}  // namespace

TEST_CASE("data of small scenes are copied at corners and correctly rounded elsewhere", "[data]") {
  RandomSource random(7);
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    check_exactly(with_random_data(scene.operands, random));
  }
}

TEST_CASE("data of random solids are copied at corners and correctly rounded elsewhere", "[data]") {
  for (std::size_t seed = 1; seed <= scaled_count(60, 2000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(seed % 4 == 0 ? 4 : 2);
    check_exactly(with_random_data(solids, random));
  }
}

TEST_CASE("expressions, implants, kept faces and resolved meshes have the data of their faces", "[data]") {
  RandomSource random(8);
  const std::vector<SurfaceMesh> solids = with_random_data(
      {box({0, 0, 0}, {3, 3, 3}), tetrahedron({1, 1, 1}, {5, 1.5, 1}, {1, 5, 2}, {1.5, 1, 5}), octahedron({0.5, 2, 1.75}, 1.625)}, random);
  const auto operands = pointers_to(solids);
  CHECK(faults_of_data(operands, evaluate_expression("(a | b) & !c", operands)) == "");
  CHECK(faults_of_data(operands, evaluate_expression("a ^ b ^ c", operands)) == "");
  CHECK(faults_of_data(operands, implant(operands)) == "");
  CHECK(faults_of_data(operands, implant(operands, ImplantContact::Drop)) == "");
  for (const KeepMask mask : std::array<KeepMask, 4>{1, 2, 4, 8}) {
    const BooleanResult all = keep_faces(63, operands), kept = keep_faces(mask, operands);
    CHECK(kept.mesh.triangles.size() < all.mesh.triangles.size());
    CHECK(kept.mesh.corner_data.size() == 4);
    CHECK(faults_of_groups(operands, kept) == "");
  }
  CHECK(faults_of_data(operands, keep_faces(63, operands)) == "");
  const std::vector<SurfaceMesh> crossed = with_random_data({joined({box({0, 0, 0}, {3, 3, 3}), octahedron({3, 3, 2.75}, 1.625)})}, random);
  CHECK(faults_of_data(pointers_to(crossed), resolve(crossed[0])) == "");
}

TEST_CASE("faces that were kept bring the data they had among all", "[data]") {
  const std::vector<SurfaceMesh> solids{with_chart(make_icosphere(1, 2)), with_chart(moved(make_icosphere(1, 2), {0.5, 0.25, 0.125}))};
  const BooleanResult kept = keep_faces(keep_mask(std::array<std::string, 2>{"10", "21"}), pointers_to(solids));
  CHECK(kept.mesh.triangles.size() > 100);
  CHECK(deviation_from_chart(kept.mesh, 1) < 1e-15);
}

TEST_CASE("meshes without data give results without data", "[data]") {
  const BooleanResult result = unite(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
  CHECK(result.mesh.corner_data.empty());
  const auto& stages = result.report.stages;
  CHECK(std::none_of(stages.begin(), stages.end(), [](const StageTime& s) { return s.stage == "transfer_data"; }));
}

TEST_CASE("a call can be stopped while it transfers data, and leaves its operands alone", "[data]") {
  const std::vector<SurfaceMesh> solids{with_chart(make_icosphere(1, 4)), with_chart(moved(make_icosphere(1, 4), {0.5, 0.25, 0.125}))};
  const std::vector<SurfaceMesh> before = solids;
  int reports = 0;
  BooleanOptions options;
  double last = 0;
  options.progress = [&](std::string_view stage, double fraction) {
    CHECK(fraction >= last);
    last = fraction;
    return stage != "transfer_data" || ++reports < 2;
  };
  const auto error = error_of([&] { (void)evaluate_boolean(Operation::Union, pointers_to(solids), options); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::Cancelled);
  CHECK(error->stage == "transfer_data");
  for (std::size_t k = 0; k < 2; ++k) CHECK(solids[k].vertex_data[0].values == before[k].vertex_data[0].values);
}

TEST_CASE("an operand without a channel has no values in the result", "[data]") {
  const SurfaceMesh painted = with_channel(box({0, 0, 0}, {2, 2, 2}), "heat", 20), plain = box({1, 1, 1}, {3, 3, 3});
  const BooleanResult result = subtract(painted, plain);
  const DataChannel& heat = channel(result.mesh, "heat");
  REQUIRE(heat.values.size() == 3 * result.mesh.triangles.size());
  std::size_t without = 0;
  for (std::size_t c = 0; c < heat.values.size(); ++c) {
    const bool is_of_plain = result.provenance.source_operand[c / 3] == 1;
    without += is_of_plain ? 1U : 0U;
    CHECK((is_of_plain ? std::isnan(heat.values[c]) : heat.values[c] == 20));
  }
  CHECK(without > 0);
}

TEST_CASE("an empty result has the channels, and no values", "[data]") {
  const BooleanResult result = intersect(with_channel(box({0, 0, 0}, {1, 1, 1}), "heat", 20), box({2, 2, 2}, {3, 3, 3}));
  REQUIRE(result.mesh.corner_data.size() == 1);
  CHECK(result.mesh.corner_data[0].name == "heat");
  CHECK(result.mesh.corner_data[0].values.empty());
}

TEST_CASE("channels of one name are one; other components and kinds are errors that name them", "[data]") {
  const SurfaceMesh a = with_channel(box({0, 0, 0}, {2, 2, 2}), "heat", 20), b = with_channel(box({1, 1, 1}, {3, 3, 3}), "heat", 30);
  const BooleanResult result = unite(a, b);
  REQUIRE(result.mesh.corner_data.size() == 1);
  for (std::size_t c = 0; c < result.mesh.corner_data[0].values.size(); ++c) {
    CHECK(result.mesh.corner_data[0].values[c] == (result.provenance.source_operand[c / 3] == 0 ? 20 : 30));
  }
  SurfaceMesh wide = box({1, 1, 1}, {3, 3, 3});
  wide.vertex_data.push_back({"heat", 2, DataKind::Value, std::vector<double>(16, 1)});
  const auto error = error_of([&] { (void)unite(a, wide); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
  CHECK(error->operand == 1);
  CHECK(error->message.find("'heat' has 2 components here and 1") != std::string::npos);
  SurfaceMesh normals = box({0, 0, 0}, {2, 2, 2}), vectors = box({1, 1, 1}, {3, 3, 3});
  normals.vertex_data.push_back({"n", 3, DataKind::Normal, std::vector<double>(24, 1)});
  vectors.vertex_data.push_back({"n", 3, DataKind::Vector, std::vector<double>(24, 1)});
  const auto other = error_of([&] { (void)unite(normals, vectors); });
  REQUIRE(other);
  CHECK(other->message.find("'n' is of another kind") != std::string::npos);
}

TEST_CASE("normals of a tool look out of the hole it leaves; other data do not turn", "[data]") {
  const SurfaceMesh block = with_normals(box({0, 0, 0}, {4, 4, 4}));
  const SurfaceMesh tool = with_normals(transform(box({1, 1, 1}, {3, 3, 6}), rotation(Axis::Z, 30)));
  for (const Operation operation : all_operations) {
    if (operation == Operation::Partition) continue;  // faces between regions have two outsides
    INFO(operation_name(operation));
    CHECK(has_outward_normals(evaluate(operation, {block, tool}).mesh));
  }
  const ImprintResult imprinted = imprint(block, tool);
  for (const ImprintedOperand& operand : imprinted.operands) CHECK(has_outward_normals(operand.mesh));
  const BooleanResult heated = subtract(with_channel(box({0, 0, 0}, {4, 4, 4}), "heat", 20), with_channel(tool, "heat", -30));
  const DataChannel& heat = channel(heated.mesh, "heat");
  CHECK(*std::min_element(heat.values.begin(), heat.values.end()) == -30);
}

TEST_CASE("where faces coincide the data are those of the first operand", "[data]") {
  const SurfaceMesh a = with_channel(box({0, 0, 0}, {2, 2, 2}), "heat", 20), b = with_channel(box({1, 0, 0}, {3, 2, 2}), "heat", 30);
  const auto check_first = [&](const SurfaceMesh& first, const SurfaceMesh& second) {
    const BooleanResult result = unite(first, second);
    std::size_t shared = 0;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
      if (result.provenance.category[t] != FacetCategory::OnSame) continue;
      ++shared;
      CHECK(channel(result.mesh, "heat").values[3 * t] == channel(unite(first, first).mesh, "heat").values[0]);
    }
    CHECK(shared > 0);
  };
  check_first(a, b);
  check_first(b, a);
}

TEST_CASE("data of vertices stay continuous on their operand, bit for bit", "[data]") {
  RandomSource random(6);
  std::vector<SurfaceMesh> solids{make_icosphere(1, 2), turned(make_torus(1, 0.375, 24, 12), random)};
  for (SurfaceMesh& mesh : solids) {
    mesh.vertex_data.push_back({"heat", 1, DataKind::Value, {}});
    for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.vertex_data[0].values.push_back(random.between(0, 1));
  }
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, solids);
    REQUIRE(result.report.certificate.repair_displacement == 0);
    std::vector<std::array<double, 2>> first(result.mesh.points.size(), {-1, -1});  // per vertex and operand
    for (std::size_t c = 0; c < 3 * result.mesh.triangles.size(); ++c) {
      double& known = first[result.mesh.triangles[c / 3][c % 3].index()][result.provenance.source_operand[c / 3]];
      if (known == -1) known = result.mesh.corner_data[0].values[c];
      CHECK(known == result.mesh.corner_data[0].values[c]);
    }
  }
}

TEST_CASE("simplified results have their data; faces with data are not joined across", "[data]") {
  // The second box cuts the first; what the expression takes of it lies inside: the cut is left over.
  const SurfaceMesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 0.5, -1}, {3, 1.5, 1}), c = box({1.25, 0.75, 0.25}, {1.75, 1.25, 0.75});
  BooleanOptions cut, coplanar;
  cut.simplify = Simplify::Cut;
  coplanar.simplify = Simplify::Coplanar;
  const std::vector<SurfaceMesh> charted{with_chart(a), with_chart(b), with_chart(c)};
  const auto operands = pointers_to(charted);
  const BooleanResult whole = evaluate_expression("a | (b & c)", operands), result = evaluate_expression("a | (b & c)", operands, cut);
  CHECK(result.mesh.triangles.size() == 12);
  CHECK(whole.mesh.triangles.size() > 12);
  CHECK(deviation_from_chart(result.mesh, 2) == 0);
  const SurfaceMesh next = box({2, 0, 0}, {4, 2, 2});
  const BooleanResult flat = unite(charted[0], with_chart(next), coplanar);
  CHECK(deviation_from_chart(flat.mesh, 4) == 0);
  CHECK(unite(a, next, coplanar).mesh.triangles.size() == 12);
  CHECK(flat.mesh.triangles.size() == 20);
}

TEST_CASE("a prepared operand that is moved has the data of the moved mesh", "[data]") {
  const SurfaceMesh block = with_normals(with_chart(box({0, 0, 0}, {2, 2, 2}))), ball = with_chart(make_icosphere(1, 2));
  const AffineMap place = compose(rotation(Axis::X, 33), translation({0.5, 0.25, 0.125}));
  const PreparedOperand prepared(block);
  const BooleanResult result = subtract(ball, Operand(prepared, place)), fresh = subtract(ball, transform(block, place));
  REQUIRE(result.mesh.corner_data.size() == 2);
  for (std::size_t c = 0; c < 2; ++c) {
    const auto is_same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    const std::vector<double>&found = result.mesh.corner_data[c].values, &wanted = fresh.mesh.corner_data[c].values;
    CHECK(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), is_same));
  }
}

TEST_CASE("seams of a soup stay seams", "[data]") {
  SurfaceMesh soup = soup_of(box({0, 0, 0}, {2, 2, 2}));
  DataChannel side{"side", 1, DataKind::Value, {}};
  for (std::size_t v = 0; v < soup.points.size(); ++v) side.values.push_back(static_cast<double>(v / 6));
  soup.vertex_data.push_back(side);
  const BooleanResult result = subtract(soup, box({1, 1, 1}, {3, 3, 3}));
  for (std::size_t c = 0; c < 3 * result.mesh.triangles.size(); ++c) {
    if (result.provenance.source_operand[c / 3] != 0) continue;
    CHECK(channel(result.mesh, "side").values[c] == result.provenance.source_face[c / 3] / 2);
  }
}

TEST_CASE("a linear chart stays linear across the cut of turned shapes", "[data]") {
  RandomSource random(3);
  for (std::size_t i = 0; i < scaled_count(6, 200); ++i) {
    INFO("case " << i);
    const SurfaceMesh ring = turned(make_torus(1, 0.375, 24, 12), random), ball = turned(make_icosphere(0.75, 2), random);
    const SurfaceMesh block = turned(box({-0.5, -0.75, -1}, {0.5, 0.75, 1}), random);
    CHECK(worst_deviation({with_chart(ring), with_chart(moved(ball, random.point(-0.5, 0.5)))}) < 4e-16);
    CHECK(worst_deviation({with_chart(ring), with_chart(ball), with_chart(block)}) < 4e-16);
  }
}

TEST_CASE("a linear chart stays linear on needles", "[data]") {
  RandomSource random(4);
  for (std::size_t i = 0; i < scaled_count(40, 1000); ++i) {
    INFO("case " << i);
    const double width = random.octaves(-48, -10);
    const SurfaceMesh needle = turned(box({-1, -width, -width / 3}, {1, width, width / 3}), random);
    const SurfaceMesh blade = turned(tetrahedron({-1, -1, 0}, {1, -1, width}, {0, 1, 0}, {0.1, 0.2, width * 2}), random);
    const SurfaceMesh block = turned(box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}), random);
    CHECK(worst_deviation({with_chart(needle), with_chart(block)}) < 1e-12);
    CHECK(worst_deviation({with_chart(blade), with_chart(block)}) < 1e-12);
    CHECK(worst_deviation({with_chart(needle), with_chart(blade)}) < 1e-12);
  }
}

TEST_CASE("a linear chart stays linear where rounding had to be repaired", "[data]") {
  std::size_t repaired = 0;
  const std::size_t enough = scaled_count(10, 250);
  for (std::size_t seed = 1; repaired < enough && seed <= 10000; ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    std::vector<SurfaceMesh> solids = slightly_off(random.next(3));
    for (SurfaceMesh& mesh : solids) mesh = with_chart(std::move(mesh));
    CHECK(worst_deviation(solids) < 1e-12);
    repaired += evaluate(Operation::Union, solids).report.certificate.repair_displacement > 0 ? 1U : 0U;
  }
  CHECK(repaired == enough);
}

TEST_CASE("a linear chart stays linear through a chain of operations", "[data]") {
  RandomSource random(5);
  SurfaceMesh part = with_chart(box({-2, -2, -2}, {2, 2, 2}));
  for (int i = 0; i < 8; ++i) {
    const SurfaceMesh tool = moved(turned(make_cylinder(0.4, 3, 12), random), random.point(-1, 1));
    part = i % 3 == 2 ? unite(part, with_chart(tool)).mesh : subtract(part, with_chart(tool)).mesh;
  }
  CHECK(part.triangles.size() > 100);
  CHECK(deviation_from_chart(part, 2) < 4e-15);
}

TEST_CASE("a linear chart stays linear across the cut of real meshes", "[data][scenario]") {
  if (is_data_missing()) return;
  const std::array<std::string, 7> names{"Fig. 5 cylinders", "sphere pair",    "Fig. 28 flush on deck",     "Fig. 28 almost flush",
                                         "Fig. 28 impeller", "Fig. 28 flange", "Fig. 29 body and four fins"};
  double worst = 0;
  std::size_t made = 0, scenes = 0;
  for (const ListedScene& scene : listed_scenes()) {
    if (std::find(names.begin(), names.end(), scene.name) == names.end()) continue;
    INFO(scene.name);
    ++scenes;
    RandomSource random(scenes);
    std::vector<SurfaceMesh> operands;
    double size = 0;
    const AffineMap turn = compose(rotation(Axis::X, random.between(0, 360)), rotation(Axis::Z, random.between(0, 360)));
    for (const std::string& operand : scene.operands) operands.push_back(with_chart(transform(load_operand(operand), turn)));
    for (const SurfaceMesh& mesh : operands) size = std::max(size, largest_coordinate(mesh));
    for (const Operation operation : all_operations) {
      const BooleanResult result = evaluate(operation, operands);
      const double deviation = deviation_from_chart(result.mesh, size);
      const Certificate& certificate = result.report.certificate;
      if (certificate.snap_rounds == 0) {
        worst = std::max(worst, deviation);
      } else {  // a vertex that was moved off its face keeps the value of the face
        CHECK(deviation <= 1e-12 + 4 * certificate.repair_displacement / size);
      }
      const auto& sources = result.provenance.vertex_source;
      made += static_cast<std::size_t>(std::count(sources.begin(), sources.end(), Provenance::none));
      CHECK(faults_of_groups(pointers_to(operands), result) == "");
    }
  }
  CHECK(scenes == names.size());
  std::printf("linear chart on real meshes: %zu made vertices, largest deviation %.2g of the size\n", made, worst);
  CHECK(worst < 1e-12);
}

TEST_CASE("texture coordinates of a real mesh stay where nothing is cut and within those of the face elsewhere", "[data][scenario]") {
  if (is_data_missing()) return;
  const std::vector<SurfaceMesh> operands{read_data("scans/spot.obj"), read_data("scans/blub.obj", "s=0.7 rx=30 t=0.2,0.1,0.3")};
  for (const Operation operation : all_operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, operands);
    const DataChannel& uv = channel(result.mesh, "uv");
    std::size_t copied = 0, inside = 0;
    for (std::size_t c = 0; c < 3 * result.mesh.triangles.size(); ++c) {
      const SurfaceMesh& operand = operands[result.provenance.source_operand[c / 3]];
      const std::size_t face = result.provenance.source_face[c / 3];
      const Vec3d& p = result.mesh.points[result.mesh.triangles[c / 3][c % 3].index()];
      std::array<std::array<double, 3>, 2> at_corners;
      std::size_t corner = 3;
      for (std::size_t i = 0; i < 3; ++i) {
        if (operand.points[operand.triangles[face][i].index()] == p) corner = i;
        for (std::size_t k = 0; k < 2; ++k) at_corners[k][i] = channel(operand, "uv").values[2 * (3 * face + i) + k];
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const double found = uv.values[2 * c + k];
        const auto [least, most] = std::minmax_element(at_corners[k].begin(), at_corners[k].end());
        CHECK((corner < 3 ? found == at_corners[k][corner] : *least <= found && found <= *most));
      }
      (corner < 3 ? copied : inside) += 1;
    }
    CHECK(copied > 100);
    CHECK(inside > 100);
  }
}

TEST_CASE("groups of a result are runs of its labels", "[data]") {
  SurfaceMesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
  a.label_names = {"steel", "copper"};
  b.label_names = {"copper", "glass"};
  for (std::uint32_t f = 0; f < 12; ++f) {
    a.face_labels.push_back(f % 2);
    b.face_labels.push_back(f / 2 % 2);
  }
  const BooleanResult result = unite(a, b);
  const GroupedMesh grouped = group_by_label(result.mesh);
  CHECK(result.mesh.label_names == std::vector<std::string>{"steel", "copper", "glass"});
  std::uint32_t next = 0;
  for (const FaceGroup& g : grouped.groups) {
    CHECK(g.first == next);
    next += g.count;
    for (std::uint32_t t = g.first; t < next; ++t) {
      CHECK(grouped.part.mesh.face_labels[t] == g.label);
      const FaceId source = grouped.part.source_face[t];
      const SurfaceMesh& operand = result.provenance.source_operand[source.index()] == 0 ? a : b;
      const std::uint32_t label = operand.face_labels[result.provenance.source_face[source.index()]];
      CHECK(operand.label_names[label] == result.mesh.label_names[g.label]);
    }
  }
  CHECK(next == result.mesh.triangles.size());
  CHECK(grouped.groups.size() == 3);
}

TEST_CASE("a result with vertices for its corners is the same surface, ready for a graphics card", "[data]") {
  const SurfaceMesh a = with_normals(with_chart(box({0, 0, 0}, {2, 2, 2}))), b = box({1, 1, 1}, {3, 3, 3});
  const BooleanResult result = subtract(a, b);
  const MeshOfVertices drawn = corners_to_vertices(result.mesh, 0);
  CHECK(drawn.mesh.corner_data.empty());
  REQUIRE(drawn.mesh.vertex_data.size() == 2);
  const DataChannel& normals = drawn.mesh.vertex_data[1];
  CHECK(normals.kind == DataKind::Normal);
  CHECK(std::none_of(normals.values.begin(), normals.values.end(), [](double x) { return std::isnan(x); }));
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = drawn.mesh.triangles[t][i];
      CHECK(drawn.source_vertex[v.index()] == result.mesh.triangles[t][i]);
      const double u = result.mesh.corner_data[0].values[2 * (3 * t + i)];
      CHECK(drawn.mesh.vertex_data[0].values[2 * v.index()] == (std::isnan(u) ? 0 : u));
    }
  }
  // Six sides and three of the notch, each with its own corners; a side has 4 corners, 6 where the notch cuts it.
  CHECK(drawn.mesh.points.size() == 3 * 4 + 3 * 6 + 3 * 4);
}
