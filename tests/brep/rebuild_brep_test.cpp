// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A model rebuilt round the cut is the model built anew.
#include "mortise/brep/rebuild_brep.h"

#include <algorithm>
#include <tuple>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// What an operand of the next operation needs.
struct Modelled {
  SurfaceMesh mesh;
  ClassifiedBrep model;
  FaceNormals normals;
};

Modelled modelled(SurfaceMesh mesh, const BrepRules& rules) {
  Modelled result{std::move(mesh), {}, {}};
  result.normals = measure_normals(result.mesh, build_topology(result.mesh));
  result.model = build_brep(result.mesh, rules, result.normals);
  return result;
}

using Loop = std::pair<std::uint32_t, std::vector<std::pair<std::uint32_t, bool>>>;

// The loops of every face: their edges from the lowest on, or their vertex.
std::vector<Loop> sorted_loops(const Brep& brep) {
  std::vector<Loop> loops;
  for (std::size_t l = 0; l < brep.loops.size(); ++l) {
    Loop loop{brep.loops[LoopId(l)].face.value, {}};
    for (const EdgeUse& use : brep.uses_of_loop.of(LoopId(l))) loop.second.emplace_back(use.edge.value, use.is_reversed);
    if (loop.second.empty()) loop.second.emplace_back(brep.loops[LoopId(l)].start.value, false);
    std::rotate(loop.second.begin(), std::min_element(loop.second.begin(), loop.second.end()), loop.second.end());
    loops.push_back(std::move(loop));
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

std::vector<std::tuple<std::uint32_t, std::uint32_t, bool>> sorted_uses(const Brep& brep) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, bool>> uses;
  for (std::size_t e = 0; e < brep.edges.size(); ++e) {
    for (const FaceUse& use : brep.faces_of_edge.of(ModelEdgeId(e))) {
      uses.emplace_back(static_cast<std::uint32_t>(e), use.face.value, use.is_reversed);
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

// As they follow one another.
std::vector<FaceUse> crowded_uses(const Brep& brep) {
  std::vector<FaceUse> crowded;
  for (std::size_t e = 0; e < brep.edges.size(); ++e) {
    const auto uses = brep.faces_of_edge.of(ModelEdgeId(e));
    if (uses.size() > 2) crowded.insert(crowded.end(), uses.begin(), uses.end());
  }
  return crowded;
}

void check_same(const ClassifiedBrep& a, const ClassifiedBrep& b) {
  REQUIRE(a.brep.faces.size() == b.brep.faces.size());
  for (std::size_t f = 0; f < a.brep.faces.size(); ++f) {
    const ModelFace &face = a.brep.faces[ModelFaceId(f)], &other = b.brep.faces[ModelFaceId(f)];
    CHECK(std::tie(face.genus, face.region_behind, face.region_in_front) ==
          std::tie(other.genus, other.region_behind, other.region_in_front));
  }
  REQUIRE(a.brep.edges.size() == b.brep.edges.size());
  for (std::size_t e = 0; e < a.brep.edges.size(); ++e) {
    const ModelEdge &edge = a.brep.edges[ModelEdgeId(e)], &other = b.brep.edges[ModelEdgeId(e)];
    CHECK(std::tie(edge.start, edge.end, edge.is_seam) == std::tie(other.start, other.end, other.is_seam));
  }
  CHECK(a.brep.region_count == b.brep.region_count);
  CHECK(a.brep.region_of_shell.values() == b.brep.region_of_shell.values());
  CHECK(a.brep.shells_of_region.items == b.brep.shells_of_region.items);
  CHECK(sorted_loops(a.brep) == sorted_loops(b.brep));
  CHECK(sorted_uses(a.brep) == sorted_uses(b.brep));
  CHECK(crowded_uses(a.brep) == crowded_uses(b.brep));
  CHECK(a.classification.mesh_vertex.values() == b.classification.mesh_vertex.values());
  CHECK(a.classification.path.items == b.classification.path.items);
  CHECK(a.classification.face_of_triangle == b.classification.face_of_triangle);
  CHECK(a.classification.entity_of_vertex == b.classification.entity_of_vertex);
}

struct Counts {
  std::size_t touched = 0, visited = 0, triangles = 0;
};

/// The result, its model rebuilt and compared with one built anew.
Modelled operate(Operation operation, const std::vector<Modelled>& operands, const BrepRules& rules, Counts& counts) {
  std::vector<const SurfaceMesh*> meshes;
  std::vector<OperandModel> models;
  std::vector<FaceNormals> normals;
  for (const Modelled& operand : operands) {
    meshes.push_back(&operand.mesh);
    models.push_back({operand.mesh, operand.model, operand.normals});
    normals.push_back(operand.normals);
  }
  BooleanResult result = evaluate_boolean(operation, meshes);
  Modelled next{std::move(result.mesh), {}, source_normals(result.provenance, normals)};
  RebuiltBrep rebuilt = rebuild_brep(next.mesh, result.provenance, models, rules);
  check_same(rebuilt.model, build_brep(next.mesh, rules, next.normals));
  counts.touched += rebuilt.touched;
  counts.visited += rebuilt.visited;
  counts.triangles += next.mesh.triangles.size();
  CHECK(rebuilt.visited <= 8 * rebuilt.touched);
  next.model = std::move(rebuilt.model);
  return next;
}

/// Rows of turned and tilted parts that stand alone, on a plate.
SurfaceMesh plate_with_parts(RandomSource& random) {
  std::vector<SurfaceMesh> parts{make_box({-1, -1, -1}, {11, 8, 0})};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double turn = random.between(0, 90);
      const SurfaceMesh part = (i + j) % 3 == 0   ? make_cylinder(0.8, 2, 24)
                               : (i + j) % 3 == 1 ? make_torus(0.8, 0.3, 20, 10)
                                                  : make_box({-0.7, -0.7, -0.5}, {0.7, 0.7, 1.5});
      parts.push_back(transform(part, compose(rotation(Axis::Z, turn), translation({3.0 * i, 3.0 * j, (i + j) % 2 == 0 ? 0.5 : -0.4}))));
    }
  }
  return evaluate_boolean(Operation::Union, pointers_to(parts)).mesh;
}

SurfaceMesh small_tool(RandomSource& random) {
  const double size = random.between(0.2, 0.9), turn = random.between(0, 90), tilt = random.between(0, 90);
  const double x = random.between(-1, 11), y = random.between(-1, 8), z = random.between(-0.8, 2);
  const bool is_round = random.below(2) == 0;
  const SurfaceMesh tool = is_round ? make_cylinder(size, 2 * size, 16) : make_box({-size, -size, -size}, {size, size, size});
  return transform(transform(tool, compose(rotation(Axis::X, tilt), rotation(Axis::Z, turn))), translation({x, y, z}));
}

}  // namespace

TEST_CASE("a model rebuilt round the cut is the one built anew, in chains of operations", "[brep][rebuild]") {
  Counts counts;
  for (std::size_t seed = 1; seed <= scaled_count(18, 400); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    BrepRules rules;
    rules.seams = std::array{Seams::None, Seams::Annulus, Seams::Disc}[seed % 3];
    Modelled model = modelled(plate_with_parts(random), rules);
    for (int step = 0; step < 8; ++step) {
      INFO("step " << step);
      const Operation operation = std::array{Operation::Subtract, Operation::Union, Operation::SymmetricDifference}[random.below(3)];
      model = operate(operation, {std::move(model), modelled(small_tool(random), rules)}, rules, counts);
    }
  }
  CHECK(counts.touched < counts.triangles / 2);  // else this compares a model with itself
}

TEST_CASE("a model rebuilt round the cut is the one built anew, for small solids in all contacts", "[brep][rebuild]") {
  Counts counts;
  for (std::size_t seed = 1; seed <= scaled_count(60, 2000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(3);
    BrepRules rules;
    rules.seams = std::array{Seams::None, Seams::Annulus, Seams::Disc}[seed % 3];
    std::vector<Modelled> operands;
    for (const SurfaceMesh& solid : solids) operands.push_back(modelled(solid, rules));
    const std::vector<Modelled> two(operands.begin(), operands.begin() + 2);
    const Modelled cells = operate(Operation::Partition, two, rules, counts);
    (void)operate(Operation::Subtract, two, rules, counts);
    (void)operate(Operation::Intersect, operands, rules, counts);
    (void)operate(Operation::Union, operands, rules, counts);
  }
}

TEST_CASE("rules that look along features touch what features lead to; groups and user edges part faces in a rebuilt model too",
          "[brep][rebuild]") {
  Counts counts;
  RandomSource random(5);
  BrepRules rules;
  rules.features.face_angle_deg = 50;
  rules.features.weak_angle_deg = 20;
  rules.features.least_dangling = 3;
  Modelled model = modelled(plate_with_parts(random), rules);
  for (int step = 0; step < 8; ++step)
    model = operate(Operation::Subtract, {std::move(model), modelled(small_tool(random), rules)}, rules, counts);

  const std::vector<Modelled> boxes{modelled(box({0, 0, 0}, {4, 4, 4}), {}), modelled(box({3, 3, 3}, {5, 5, 5}), {})};
  const BooleanResult cut = evaluate_boolean(Operation::Subtract, std::array{&boxes[0].mesh, &boxes[1].mesh});
  const std::vector<OperandModel> models{{boxes[0].mesh, boxes[0].model, boxes[0].normals},
                                         {boxes[1].mesh, boxes[1].model, boxes[1].normals}};
  const FaceNormals normals = source_normals(cut.provenance, {boxes[0].normals, boxes[1].normals});
  BrepRules parted;
  for (std::uint32_t t = 0; t < cut.mesh.triangles.size(); ++t) parted.features.groups.push_back(t % 2);
  const RebuiltBrep in_groups = rebuild_brep(cut.mesh, cut.provenance, models, parted);
  check_same(in_groups.model, build_brep(cut.mesh, parted, normals));
  CHECK(in_groups.model.brep.faces.size() > build_brep(cut.mesh, {}, normals).brep.faces.size());

  BrepRules crossed;
  const auto is_diagonal = [&](const Triangle& t) {
    const Vec3d along = cut.mesh.points[t[0].index()] - cut.mesh.points[t[1].index()];
    return along.x != 0 && along.y != 0;
  };
  const auto found = std::find_if(cut.mesh.triangles.begin(), cut.mesh.triangles.end(), is_diagonal);
  REQUIRE(found != cut.mesh.triangles.end());
  crossed.features.user_edges = {{(*found)[0], (*found)[1]}};
  const RebuiltBrep with_edge = rebuild_brep(cut.mesh, cut.provenance, models, crossed);
  check_same(with_edge.model, build_brep(cut.mesh, crossed, normals));
}

TEST_CASE("an operation that changes nothing leaves a model as it was; what cannot be rebuilt is refused", "[brep][rebuild]") {
  const Modelled cube = modelled(box({0, 0, 0}, {1, 1, 1}), {}), far = modelled(box({5, 0, 0}, {6, 1, 1}), {});
  const BooleanResult result = evaluate_boolean(Operation::Subtract, std::array{&cube.mesh, &far.mesh});
  const std::vector<OperandModel> models{{cube.mesh, cube.model, cube.normals}, {far.mesh, far.model, far.normals}};
  const RebuiltBrep same = rebuild_brep(result.mesh, result.provenance, models);
  CHECK(same.touched == 0);
  CHECK(same.visited == 0);
  CHECK(same.model.brep.faces.size() == 6);
  CHECK(same.model.brep.edges.size() == 12);
  CHECK(same.model.brep.vertex_count == 8);

  const auto code_of = [&](const Provenance& provenance, const std::vector<OperandModel>& operands, const BrepRules& rules) {
    try {
      (void)rebuild_brep(result.mesh, provenance, operands, rules);
    } catch (const Error& error) {
      return error.code;
    }
    return ErrorCode::InternalError;
  };
  BrepRules bad_edge, bad_angle, bad_groups;
  bad_edge.features.user_edges = {{VertexId(0), VertexId(1000)}};
  bad_angle.edge_angle_deg = 200;
  bad_groups.features.groups = {1, 2};
  CHECK(code_of({}, models, {}) == ErrorCode::InvalidArgument);
  CHECK(code_of(result.provenance, {}, {}) == ErrorCode::InvalidArgument);
  CHECK(code_of(result.provenance, models, bad_edge) == ErrorCode::InvalidArgument);
  CHECK(code_of(result.provenance, models, bad_angle) == ErrorCode::InvalidArgument);
  CHECK(code_of(result.provenance, models, bad_groups) == ErrorCode::InvalidArgument);
}
