// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models of generated shapes and of results, counted by hand.
#include "mortise/brep/build_brep.h"

#include <algorithm>
#include <numeric>

#include "mortise/base/trig.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/imprint.h"
#include "mortise/brep/model_queries.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Counts {
  std::size_t vertices, edges, faces, regions;  // bounded ones

  bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces, " << c.regions << " regions";
}

Counts counts_of(const Brep& brep) { return {brep.vertex_count, brep.edges.size(), brep.faces.size(), brep.region_count - 1}; }

BrepRules rules_with(Seams seams) {
  BrepRules rules;
  rules.seams = seams;
  return rules;
}

ClassifiedBrep sound_model(const SurfaceMesh& mesh, const BrepRules& rules = {}) {
  ClassifiedBrep model = build_brep(mesh, rules);
  CHECK(find_faults(mesh, model) == std::vector<std::string>());
  return model;
}

Counts counts(const SurfaceMesh& mesh, const BrepRules& rules = {}) { return counts_of(sound_model(mesh, rules).brep); }

std::size_t mesh_edges_on_edges(const ClassifiedBrep& model) {
  return model.classification.path.items.size() - model.classification.path.size();
}

/// Triangles between a ring of 17 vertices and one of 6 inside it, and inside that; counterclockwise.
void add_cap(std::size_t outer, std::size_t inner, bool is_turned, SurfaceMesh& mesh) {
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    mesh.triangles.push_back({VertexId(a), VertexId(is_turned ? c : b), VertexId(is_turned ? b : c)});
  };
  for (std::size_t a = 0, b = 0; a < 17 || b < 6;) {
    const std::size_t from_outer = outer + a % 17, from_inner = inner + b % 6;
    if (6 * (a + 1) <= 17 * (b + 1)) {
      add(from_outer, outer + ++a % 17, from_inner);
    } else {
      add(from_outer, inner + ++b % 6, from_inner);
    }
  }
  for (std::size_t b = 1; b + 1 < 6; ++b) add(inner, inner + b, inner + b + 1);
}

/// The cylinder of Fig. 6, 17 segments round, 12 along, with 6 vertices inside each cap: 462 triangles.
SurfaceMesh cylinder_with_caps() {
  SurfaceMesh mesh;
  const auto add_ring = [&](double radius, std::size_t count, double z) {
    for (std::size_t i = 0; i < count; ++i) {
      const double degrees = 360.0 * static_cast<double>(i) / static_cast<double>(count);
      mesh.points.push_back({radius * trig::cos_deg(degrees), radius * trig::sin_deg(degrees), z});
    }
  };
  for (int i = 0; i <= 12; ++i) add_ring(1, 17, 0.25 * i);
  add_ring(0.5, 6, 0);
  add_ring(0.5, 6, 3);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < 17; ++j) {
      const std::size_t a = 17 * i + j, b = 17 * i + (j + 1) % 17;
      mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(b + 17)});
      mesh.triangles.push_back({VertexId(a), VertexId(b + 17), VertexId(a + 17)});
    }
  }
  add_cap(0, 13 * 17, true, mesh);
  add_cap(12 * 17, 13 * 17 + 6, false, mesh);
  return mesh;
}

/// Every triangle in four.
SurfaceMesh halved(const SurfaceMesh& mesh) {
  const MeshTopology topology = build_topology(mesh);
  SurfaceMesh result;
  result.points = mesh.points;
  for (const auto& [a, b] : topology.edges) result.points.push_back(0.5 * (mesh.points[a.index()] + mesh.points[b.index()]));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    const auto middle = [&](std::size_t k) { return VertexId(mesh.points.size() + topology.edge_of[3 * t + k].index()); };
    for (const Triangle& part : {Triangle{c[0], middle(0), middle(2)}, Triangle{c[1], middle(1), middle(0)},
                                 Triangle{c[2], middle(2), middle(1)}, Triangle{middle(0), middle(1), middle(2)}}) {
      result.triangles.push_back(part);
    }
  }
  return result;
}

SurfaceMesh result_of(Operation operation, const std::vector<SurfaceMesh>& operands) {
  return evaluate_boolean(operation, pointers_to(operands)).mesh;
}

SurfaceMesh imprinted(const std::vector<SurfaceMesh>& operands, std::size_t k) { return imprint(pointers_to(operands)).operands[k].mesh; }

const std::vector<SurfaceMesh>& fig_2() {
  static const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  return boxes;
}

}  // namespace

TEST_CASE("a cube has 8 vertices, 12 edges, 6 faces at any tessellation", "[brep]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  CHECK(counts(cube) == Counts{8, 12, 6, 1});
  // Cut by others, whose traces are no creases.
  for (const SurfaceMesh& other : {make_icosphere(0.7, 3), transform(cube, rotation(Axis::Z, 30)), make_torus(0.9, 0.2, 40, 20)}) {
    const SurfaceMesh cut = imprinted({cube, moved(other, {0.6, 0.55, 0.5})}, 0);
    CHECK(cut.triangles.size() > 12);
    CHECK(counts(cut) == Counts{8, 12, 6, 1});
  }
  CHECK(counts(transform(cube, rotation(Axis::X, 33))) == Counts{8, 12, 6, 1});
}

TEST_CASE("the six operations on two boxes have the models of Fig. 2", "[brep][paper]") {
  CHECK(counts(result_of(Operation::Union, fig_2())) == Counts{20, 30, 12, 1});
  CHECK(counts(result_of(Operation::Subtract, fig_2())) == Counts{14, 21, 9, 1});
  CHECK(counts(result_of(Operation::Intersect, fig_2())) == Counts{8, 12, 6, 1});
  BrepRules by_source;
  const BooleanResult partition = evaluate_boolean(Operation::Partition, pointers_to(fig_2()));
  const ClassifiedBrep model = sound_model(partition.mesh, by_source);
  CHECK(counts_of(model.brep) == Counts{22, 36, 18, 3});
  std::size_t of_four = 0;
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) of_four += model.brep.faces_of_edge.of(ModelEdgeId(e)).size() == 4 ? 1 : 0;
  CHECK(of_four == 6);
}

TEST_CASE("a cylinder has two circles and a seam that its side uses twice", "[brep]") {
  const SurfaceMesh cylinder = make_cylinder(1, 3, 17);
  const ClassifiedBrep model = sound_model(cylinder);
  CHECK(counts_of(model.brep) == Counts{2, 3, 3, 1});
  std::size_t seams = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    const ModelEdgeId edge(e);
    const auto faces = model.brep.faces_of_edge.of(edge);
    REQUIRE(faces.size() == 2);
    if (!model.brep.edges[edge].is_seam) {
      CHECK(model.brep.edges[edge].start == model.brep.edges[edge].end);
      continue;
    }
    ++seams;
    CHECK(faces[0].face == faces[1].face);
    CHECK(faces[0].is_reversed != faces[1].is_reversed);
    CHECK(model.brep.loops_of_face.of(faces[0].face).size() == 1);
  }
  CHECK(seams == 1);
  CHECK(counts(cylinder, rules_with(Seams::None)) == Counts{2, 2, 3, 1});
  CHECK(counts(cylinder, rules_with(Seams::Disc)) == Counts{2, 3, 3, 1});
  for (double angle = 21.2; angle < 90; angle += 0.4) {
    BrepRules rules;
    rules.features.face_angle_deg = angle;
    CHECK(counts(cylinder, rules) == Counts{2, 3, 3, 1});
  }
  BrepRules narrow;
  narrow.features.face_angle_deg = 21;  // 360 / 17 = 21.18
  CHECK(counts(cylinder, narrow) == Counts{34, 51, 19, 1});
}

TEST_CASE("every face can be opened to a disc", "[brep]") {
  const SurfaceMesh ring = make_torus(3, 1, 30, 16), ball = make_icosphere(1, 3);
  CHECK(counts(ring) == Counts{0, 0, 1, 1});
  CHECK(sound_model(ring).brep.faces[ModelFaceId(0)].genus == 1);
  const ClassifiedBrep square = sound_model(ring, rules_with(Seams::Disc));
  CHECK(square.brep.faces[ModelFaceId(0)].genus == 0);
  CHECK(square.brep.loops.size() == 1);
  CHECK(square.brep.edges.size() == square.brep.vertex_count + 1);
  CHECK(counts(ball) == Counts{0, 0, 1, 1});
  CHECK(counts(ball, rules_with(Seams::Disc)) == Counts{2, 1, 1, 1});
  const SurfaceMesh chain = result_of(Operation::Union, {ring, transform(ring, compose(rotation(Axis::X, 80), translation({3, 0, 0})))});
  for (const SurfaceMesh& mesh : {chain, cylinder_with_caps()}) {
    const Brep brep = sound_model(mesh, rules_with(Seams::Disc)).brep;
    CHECK(brep.loops.size() == brep.faces.size());
    for (const ModelFace& face : brep.faces) CHECK(face.genus == 0);
  }
}

TEST_CASE("two cylinders of 924 triangles have the model of Fig. 6", "[brep][paper]") {
  const SurfaceMesh one = cylinder_with_caps();
  REQUIRE(one.triangles.size() == 462);
  const SurfaceMesh two = joined({one, moved(one, {5, 0, 0})});
  const ClassifiedBrep model = sound_model(two);
  CHECK(counts_of(model.brep) == Counts{4, 6, 6, 2});
  CHECK(mesh_edges_on_edges(model) == 92);
  for (double angle = 21.2; angle < 90; angle += 2.1) {
    BrepRules rules;
    rules.features.face_angle_deg = angle;
    CHECK(counts(two, rules) == Counts{4, 6, 6, 2});
  }
}

TEST_CASE("crossing cylinders have the model of Fig. 17", "[brep][paper]") {
  const SurfaceMesh wide = moved(make_cylinder(1, 4, 48), {0, 0, -2});
  const SurfaceMesh narrow = transform(moved(make_cylinder(0.6, 4, 48), {0, 0, -2}), rotation(Axis::X, 90));
  const SurfaceMesh both = result_of(Operation::Union, {wide, narrow});
  const auto edges_and_loops = [&](Seams seams) {
    const Brep brep = sound_model(both, rules_with(seams)).brep;
    CHECK(brep.faces.size() == 7);
    return std::pair(brep.edges.size() - brep.vertex_count, brep.loops.size());
  };
  CHECK(edges_and_loops(Seams::None) == std::pair<std::size_t, std::size_t>(0, 12));
  CHECK(edges_and_loops(Seams::Annulus) == std::pair<std::size_t, std::size_t>(2, 10));
  CHECK(edges_and_loops(Seams::Disc) == std::pair<std::size_t, std::size_t>(5, 7));
}

TEST_CASE("holes through a coarse box and a fine one have one model (Fig. 27)", "[brep][paper]") {
  SurfaceMesh coarse = box({0, 0, 0}, {8, 4, 1}), fine = coarse;
  for (int level = 0; level < 4; ++level) fine = halved(fine);
  const SurfaceMesh hole = moved(make_cylinder(0.75, 2, 64), {0, 0, -0.5});
  const std::vector<SurfaceMesh> holes{moved(hole, {1.5, 2, 0}), moved(hole, {4, 2.25, 0}), moved(hole, {6.5, 1.75, 0})};
  for (const SurfaceMesh& plate : {coarse, fine}) {
    std::vector<SurfaceMesh> operands{plate};
    operands.insert(operands.end(), holes.begin(), holes.end());
    const SurfaceMesh drilled = result_of(Operation::Subtract, operands);
    BrepRules rules = rules_with(Seams::None);
    const ClassifiedBrep model = sound_model(drilled, rules);
    CHECK(counts_of(model.brep) == Counts{14, 18, 9, 1});
    std::size_t with_four_loops = 0;
    double area = 0;
    const ModelView view = view_of(drilled, model);
    for (std::uint32_t f = 0; f < 9; ++f) {
      if (model.brep.loops_of_face.of(ModelFaceId(f)).size() != 4) continue;
      ++with_four_loops;
      area += measure(view, {EntityDimension::Face, f});
    }
    CHECK(with_four_loops == 2);
    const double polygon = 32 * 0.75 * 0.75 * trig::sin_deg(360.0 / 64);
    CHECK(area == Approx(2 * (32 - 3 * polygon)).epsilon(1e-12));
    CHECK(counts(drilled) == Counts{14, 21, 9, 1});
  }
}

TEST_CASE("open sheets, cavities and several solids have their regions", "[brep]") {
  CHECK(counts(make_grid_sheet(2, 1, 4, 3)) == Counts{4, 4, 1, 0});
  const SurfaceMesh cube = box({0, 0, 0}, {4, 4, 4}), hole = inside_out(box({1, 1, 1}, {2, 2, 2}));
  const SurfaceMesh hollow = joined({cube, hole, box({1.25, 1.25, 1.25}, {1.75, 1.75, 1.75})});
  const ClassifiedBrep model = sound_model(hollow);
  CHECK(counts_of(model.brep) == Counts{24, 36, 18, 3});  // the solid, the hole, the cube in the hole
  CHECK(model.brep.region_of_shell.size() == 6);
  std::vector<std::size_t> shells;
  for (std::size_t r = 0; r < 4; ++r) shells.push_back(model.brep.shells_of_region.of(ModelRegionId(r)).size());
  CHECK(shells == std::vector<std::size_t>{1, 2, 2, 1});
}

TEST_CASE("solids that touch share vertices and edges of the model", "[brep]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  CHECK(counts(result_of(Operation::Union, {cube, box({1, 1, 0}, {2, 2, 1})})) == Counts{14, 23, 12, 2});
  CHECK(counts(result_of(Operation::Union, {cube, box({1, 1, 1}, {2, 2, 2})})) == Counts{15, 24, 12, 2});
  // Two octahedra that meet in a point inside their faces, where creases do not matter.
  BrepRules smooth;
  smooth.features.face_angle_deg = 180;
  const SurfaceMesh ball = make_icosphere(1, 0);
  SurfaceMesh pair = joined({ball, ball});
  const std::size_t count = ball.points.size();
  for (std::size_t v = count; v < 2 * count; ++v) pair.points[v] = 2.0 * ball.points[0] - pair.points[v];
  for (std::size_t t = ball.triangles.size(); t < pair.triangles.size(); ++t) {
    std::swap(pair.triangles[t][1], pair.triangles[t][2]);
    for (VertexId& v : pair.triangles[t]) v = v == VertexId(count) ? VertexId(0) : v;
  }
  pair.points[count] = {9, 9, 9};  // no triangle uses it
  const ClassifiedBrep touching = sound_model(pair, smooth);
  CHECK(counts_of(touching.brep) == Counts{1, 0, 2, 2});
  CHECK(touching.brep.loops.size() == 2);
  CHECK(touching.brep.uses_of_loop.items.empty());
}

TEST_CASE("labels, user edges and weak creases part faces", "[brep]") {
  SurfaceMesh sheet = make_grid_sheet(4, 1, 4, 1);
  sheet.label_names = {"left", "right"};
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) sheet.face_labels.push_back(t < 4 ? 0 : 1);
  CHECK(counts(sheet) == Counts{6, 7, 2, 0});
  BrepRules rules;
  rules.features.splits_at_labels = false;
  CHECK(counts(sheet, rules) == Counts{4, 4, 1, 0});
  rules.features.user_edges = {{sheet.triangles[0][0], sheet.triangles[0][1]}, {sheet.triangles[0][1], sheet.triangles[0][2]}};
  CHECK(sound_model(sheet, rules).brep.faces.size() >= 1);
  rules.features.user_edges = {{VertexId(0), VertexId(9)}};
  CHECK(error_of([&] { (void)build_brep(sheet, rules); })->code == ErrorCode::InvalidArgument);
}

TEST_CASE("creases that fade out go on as weak ones, or end; short dangling ones are dropped", "[brep]") {
  // A strip folded along its middle line, from 60 degrees at one end to none at the other.
  SurfaceMesh strip = make_grid_sheet(10, 2, 10, 2);
  for (Vec3d& p : strip.points) {
    if (p.y == 1) p.z = 0.6 * (1 - p.x / 10);
  }
  BrepRules rules;
  rules.features.face_angle_deg = 40;
  const ClassifiedBrep plain = sound_model(strip, rules);
  CHECK(plain.brep.faces.size() == 1);
  const std::size_t on_edges = mesh_edges_on_edges(plain);
  rules.features.weak_angle_deg = 10;
  CHECK(mesh_edges_on_edges(sound_model(strip, rules)) > on_edges);
  rules.features.weak_angle_deg.reset();
  rules.features.least_dangling = 20;
  const ClassifiedBrep dropped = sound_model(strip, rules);
  CHECK(mesh_edges_on_edges(dropped) == 24);
  CHECK(counts_of(dropped.brep) == Counts{5, 5, 1, 0});  // the border turns by 62 degrees at one end
}

TEST_CASE("a sliver takes the normal across its longest edge", "[brep]") {
  // A square with a sliver along a side, that stands upright by its corners.
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 1e-9}};
  const auto triangle = [](std::size_t a, std::size_t b, std::size_t c) { return Triangle{VertexId(a), VertexId(b), VertexId(c)}; };
  mesh.triangles = {triangle(0, 1, 2), triangle(0, 2, 3), triangle(1, 0, 4)};
  CHECK(counts(mesh).faces == 1);
  mesh.points[4].z = 1e-3;
  CHECK(counts(mesh).faces == 2);
}

TEST_CASE("models of random results are sound, in every mode of seams", "[brep]") {
  for (std::size_t seed = 1; seed <= scaled_count(40, 1000); ++seed) {
    INFO("seed " << seed);
    const std::vector<SurfaceMesh> solids = RandomSolids(seed).next(2 + seed % 3);
    for (const Operation operation : {Operation::Union, Operation::Subtract, Operation::SymmetricDifference, Operation::Partition}) {
      const BooleanResult result = evaluate_boolean(operation, pointers_to(solids));
      if (result.report.certificate.status != CertificateStatus::Certified) continue;
      for (const Seams seams : {Seams::None, Seams::Annulus, Seams::Disc}) (void)sound_model(result.mesh, rules_with(seams));
    }
  }
}

TEST_CASE("bad rules and triangles that repeat a vertex are refused", "[brep]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  const auto code_with = [&](auto change) {
    BrepRules rules;
    change(rules);
    return error_of([&] { (void)build_brep(cube, rules); })->code;
  };
  CHECK(code_with([](BrepRules& r) { r.features.face_angle_deg = 181; }) == ErrorCode::InvalidArgument);
  CHECK(code_with([](BrepRules& r) { r.features.weak_angle_deg = 50; }) == ErrorCode::InvalidArgument);
  CHECK(code_with([](BrepRules& r) { r.edge_angle_deg = -1; }) == ErrorCode::InvalidArgument);
  SurfaceMesh bad = cube;
  bad.triangles[3][1] = bad.triangles[3][0];
  const auto error = error_of([&] { (void)build_brep(bad); });
  CHECK(error->code == ErrorCode::InvalidArgument);
  CHECK(error->ids == std::vector<std::uint32_t>{3});
}
