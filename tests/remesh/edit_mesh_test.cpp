// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Single changes of a classified mesh, each followed by the check of the whole structure.
#include "mortise/remesh/edit_mesh.h"

#include <algorithm>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

ClassifiedBrep seamless_model(const SurfaceMesh& mesh) {
  BrepRules rules;
  rules.seams = Seams::None;
  return build_brep(mesh, rules);
}

struct Counts {
  std::size_t vertices = 0, triangles = 0, edge_uses = 0;
  bool operator==(const Counts&) const = default;
};

Counts count(const EditMesh& mesh) {
  Counts counts;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) counts.vertices += mesh.has(VertexId(v)) ? 1 : 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) counts.triangles += mesh.has(FaceId(t)) ? 1 : 0;
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) counts.edge_uses += mesh.has(h) && mesh.is_on_model_edge(h) ? 1 : 0;
  return counts;
}

// Neither diagonal of the same two triangles is elsewhere in the mesh.
bool can_swap(const EditMesh& mesh, HalfEdge h) {
  if (mesh.is_on_model_edge(h)) return false;
  const VertexId c = mesh.apex(h), d = mesh.apex(mesh.opposite(h));
  return c != d && !mesh.are_neighbours(c, d);
}

// Two boxes side by side in one mesh with the wall between them: three triangles at its edges.
SurfaceMesh boxes_with_wall() {
  const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
  return evaluate_boolean(Operation::Partition, pointers_to(boxes)).mesh;
}

// A change of each kind at random, with a check after each.
void change_at_random(EditMesh& mesh, RandomSource& random, std::size_t changes) {
  for (std::size_t k = 0; k < changes; ++k) {
    const auto h = static_cast<HalfEdge>(random.below(mesh.half_edge_count()));
    const std::size_t kind = random.below(4);
    if (!mesh.has(h)) continue;
    const VertexId gone = random.once_in(2) ? mesh.origin(h) : mesh.target(h);
    const Vec3d middle = 0.5 * (mesh.points[mesh.origin(h).index()] + mesh.points[mesh.target(h).index()]);
    if (kind == 0) static_cast<void>(mesh.split_edge(h, middle));
    if (kind == 1 && can_swap(mesh, h)) mesh.swap_edge(h);
    if (kind == 2 && mesh.can_collapse(h, gone)) mesh.collapse_edge(h, gone);
    if (kind == 3) static_cast<void>(mesh.split_in_three(face_of(h), middle));
    mesh.check();
  }
}

}  // namespace

TEST_CASE("a split edge has a vertex on its entity, and every triangle of it is two", "[remesh]") {
  const SurfaceMesh mesh = boxes_with_wall();
  const ClassifiedBrep model = seamless_model(mesh);
  EditMesh edit(mesh, model);
  const Counts before = count(edit);
  std::size_t uses_seen = 0;
  for (HalfEdge h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (!edit.has(h)) continue;
    std::size_t uses = 0;
    edit.for_each_use(h, [&](HalfEdge) { ++uses; });
    uses_seen = std::max(uses_seen, uses);
    const bool on_edge = edit.is_on_model_edge(h);
    EditMesh copy = edit;
    const VertexId m = copy.split_edge(h, {9, 9, 9});
    copy.check();
    CHECK(copy.points[m.index()] == Vec3d{9, 9, 9});
    CHECK(copy.entity(m).dimension == (on_edge ? EntityDimension::Edge : EntityDimension::Face));
    CHECK(copy.is_inside_edge(m) == on_edge);
    CHECK(copy.is_inside_face(m) == !on_edge);
    CHECK(count(copy) == Counts{before.vertices + 1, before.triangles + uses, before.edge_uses + (on_edge ? uses : 0)});
  }
  CHECK(uses_seen == 3);
}

TEST_CASE("a triangle split in three has a vertex inside its face", "[remesh]") {
  const SurfaceMesh mesh = boxes_with_wall();
  EditMesh edit(mesh, seamless_model(mesh));
  const Counts before = count(edit);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const VertexId m = edit.split_in_three(FaceId(t), {9, 9, 9});
    edit.check();
    CHECK(edit.is_inside_face(m));
    CHECK(edit.entity(m) == ModelEntity{EntityDimension::Face, edit.face(FaceId(t)).value});
    for (const VertexId v : mesh.triangles[t]) CHECK(edit.are_neighbours(m, v));
  }
  const std::size_t n = mesh.triangles.size();
  CHECK(count(edit) == Counts{before.vertices + n, before.triangles + 2 * n, before.edge_uses});
}

TEST_CASE("collapsing a new vertex undoes the split that made it", "[remesh]") {
  const SurfaceMesh mesh = boxes_with_wall();
  const EditMesh edit(mesh, seamless_model(mesh));
  for (HalfEdge h = 0; h < 3 * mesh.triangles.size(); ++h) {
    EditMesh copy = edit;
    const VertexId to = copy.origin(h);
    const VertexId m = copy.split_edge(h, {9, 9, 9});
    HalfEdge back = 0;
    copy.for_each_leaving(to, [&](HalfEdge g) {
      if (copy.target(g) == m) back = g;
      if (copy.origin(previous_in_face(g)) == m) back = previous_in_face(g);
    });
    REQUIRE(copy.can_collapse(back, m));
    CHECK_FALSE(copy.can_collapse(back, to));
    copy.collapse_edge(back, m);
    copy.check();
    CHECK(count(copy) == count(edit));
    CHECK(copy.are_neighbours(to, edit.target(h)));
  }
}

TEST_CASE("an edge swapped twice is where it was", "[remesh]") {
  const SurfaceMesh mesh = make_icosphere(1, 1);
  EditMesh edit(mesh, seamless_model(mesh));
  for (HalfEdge h = 0; h < edit.half_edge_count(); ++h) {
    const VertexId a = edit.origin(h), b = edit.target(h), c = edit.apex(h), d = edit.apex(edit.opposite(h));
    edit.swap_edge(h);
    edit.check();
    CHECK((edit.origin(h) == d && edit.target(h) == c));
    CHECK_FALSE(edit.are_neighbours(a, b));
    edit.swap_edge(h);
    edit.check();
    CHECK(edit.are_neighbours(a, b));
    CHECK_FALSE(edit.are_neighbours(c, d));
  }
}

TEST_CASE("model vertices stay, and a tetrahedron is not folded up", "[remesh]") {
  const SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  const EditMesh edit(mesh, seamless_model(mesh));
  for (HalfEdge h = 0; h < edit.half_edge_count(); ++h) {
    CHECK_FALSE(edit.can_collapse(h, edit.origin(h)));
    CHECK_FALSE(edit.can_collapse(h, edit.target(h)));
  }
  const SurfaceMesh smooth = make_icosphere(1, 1);
  EditMesh round(smooth, seamless_model(smooth));
  for (std::size_t k = 0; k < 100; ++k) {
    for (HalfEdge h = 0; h < round.half_edge_count(); ++h) {
      if (round.has(h) && round.can_collapse(h, round.origin(h))) round.collapse_edge(h, round.origin(h));
    }
  }
  round.check();
  CHECK(count(round).vertices == 4);
  CHECK(count(round).triangles == 4);
}

TEST_CASE("thousands of random changes leave a mesh that is sound, of solids, sheets and walls", "[remesh]") {
  for (std::size_t seed = 1; seed <= scaled_count(40, 1000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(3);
    SurfaceMesh mesh = evaluate_boolean(Operation::Partition, pointers_to(solids)).mesh;
    if (random.once_in(3)) mesh.triangles.resize(mesh.triangles.size() * 2 / 3);
    mesh.walls.resize(mesh.walls.empty() ? 0 : mesh.triangles.size());
    EditMesh edit(mesh, seamless_model(mesh));
    edit.check();
    change_at_random(edit, random, 150);
  }
}
