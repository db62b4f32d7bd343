// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Questions to models whose answers are known.
#include "mortise/brep/model_queries.h"

#include <cmath>
#include <set>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr EntityDimension vertex = EntityDimension::Vertex, edge = EntityDimension::Edge, face = EntityDimension::Face,
                          region = EntityDimension::Region;

std::size_t count_on(const ModelView& view, EntityDimension dimension, Extent extent) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < entity_count(view.model.brep, dimension); ++i)
    count += mesh_on(view, {dimension, i}, extent).vertices.size();
  return count;
}

}  // namespace

TEST_CASE("neighbours one dimension up and down, of a cube", "[brep]") {
  const Brep brep = build_brep(box({0, 0, 0}, {1, 2, 3})).brep;
  for (std::uint32_t v = 0; v < 8; ++v) CHECK(entities_above(brep, {vertex, v}).size() == 3);
  for (std::uint32_t e = 0; e < 12; ++e) {
    CHECK(entities_above(brep, {edge, e}).size() == 2);
    CHECK(entities_below(brep, {edge, e}).size() == 2);
    for (const ModelEntity& v : entities_below(brep, {edge, e})) {
      const std::vector<ModelEntity> edges = entities_above(brep, v);
      CHECK(std::find(edges.begin(), edges.end(), ModelEntity{edge, e}) != edges.end());
    }
  }
  for (std::uint32_t f = 0; f < 6; ++f) {
    CHECK(entities_below(brep, {face, f}).size() == 4);
    CHECK(entities_above(brep, {face, f}) == std::vector<ModelEntity>{{region, 0}, {region, 1}});
  }
  CHECK(entities_below(brep, {region, 1}).size() == 6);
  CHECK(entities_below(brep, {vertex, 0}).empty());
  CHECK(entities_above(brep, {region, 1}).empty());
}

TEST_CASE("measures and boxes of the entities of a box with a cavity and a sheet in it", "[brep]") {
  const SurfaceMesh solid =
      joined({box({0, 0, 0}, {4, 4, 4}), inside_out(box({1, 1, 1}, {2, 2, 2})), moved(make_grid_sheet(1, 1, 2, 2), {2.5, 2.5, 3})});
  const ClassifiedBrep model = build_brep(solid);
  const ModelView view = view_of(solid, model);
  REQUIRE(model.brep.region_count == 3);
  CHECK(std::isinf(measure(view, {region, 0})));
  CHECK(measure(view, {region, 1}) == 63);
  CHECK(measure(view, {region, 2}) == 1);
  double area = 0, length = 0;
  for (std::uint32_t f = 0; f < model.brep.faces.size(); ++f) area += measure(view, {face, f});
  for (std::uint32_t e = 0; e < model.brep.edges.size(); ++e) length += measure(view, {edge, e});
  CHECK(area == 6 * 16 + 6 + 1);
  CHECK(length == 12 * 4 + 12 + 4);
  CHECK(measure(view, {vertex, 0}) == 0);
  CHECK(bounding_box(view, {region, 2}).lo == Vec3d{1, 1, 1});
  CHECK(bounding_box(view, {region, 1}).hi == Vec3d{4, 4, 4});
}

TEST_CASE("a cavity is a void, unless another solid fills it", "[brep]") {
  const SurfaceMesh hollow = joined({box({0, 0, 0}, {4, 4, 4}), inside_out(box({1, 1, 1}, {2, 2, 2}))}),
                    filling = box({1, 1, 1}, {2, 2, 2});
  const auto voids_of = [](const SurfaceMesh& mesh) { return find_voids(mesh, build_brep(mesh)); };
  CHECK(voids_of(hollow) == std::vector<std::uint8_t>{0, 0, 1});
  CHECK(voids_of(evaluate_boolean(Operation::Partition, pointers_to(std::vector<SurfaceMesh>{hollow, filling})).mesh) ==
        std::vector<std::uint8_t>{0, 0, 0});
}

TEST_CASE("every entity of a mesh is inside one entity of its model", "[brep]") {
  for (std::size_t seed = 1; seed <= 10; ++seed) {
    const std::vector<SurfaceMesh> solids = RandomSolids(seed).next(2);
    const SurfaceMesh mesh = evaluate_boolean(Operation::Partition, pointers_to(solids)).mesh;
    const ClassifiedBrep model = build_brep(mesh);
    const ModelView view = view_of(mesh, model);
    CHECK(count_on(view, vertex, Extent::Interior) + count_on(view, edge, Extent::Interior) + count_on(view, face, Extent::Interior) ==
          mesh.points.size());
    CHECK(count_on(view, region, Extent::Interior) == 0);
    std::multiset<std::array<VertexId, 2>> edges;
    std::size_t triangles = 0;
    for (const EntityDimension dimension : {edge, face}) {
      for (std::uint32_t i = 0; i < entity_count(model.brep, dimension); ++i) {
        const MeshEntities on = mesh_on(view, {dimension, i}, Extent::Interior);
        edges.insert(on.edges.begin(), on.edges.end());
        triangles += on.triangles.size();
      }
    }
    const MeshTopology topology = build_topology(mesh);
    CHECK(edges == std::multiset<std::array<VertexId, 2>>(topology.edges.begin(), topology.edges.end()));
    CHECK(triangles == mesh.triangles.size());
  }
}

TEST_CASE("the closure of an entity has its boundary", "[brep]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  const ClassifiedBrep model = build_brep(cube);
  const ModelView view = view_of(cube, model);
  const MeshEntities inside = mesh_on(view, {face, 0}, Extent::Interior), closed = mesh_on(view, {face, 0}, Extent::Closure);
  CHECK(inside.vertices.empty());
  CHECK(inside.edges.size() == 1);
  CHECK(inside.triangles.size() == 2);
  CHECK(closed.vertices.size() == 4);
  CHECK(closed.edges.size() == 5);
  const MeshEntities solid = mesh_on(view, {region, 1}, Extent::Closure);
  CHECK(solid.vertices.size() == 8);
  CHECK(solid.edges.size() == 18);
  CHECK(solid.triangles.size() == 12);
}

TEST_CASE("closest points on vertices, edges, faces and regions", "[brep]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  const ClassifiedBrep model = build_brep(cube);
  const ModelView view = view_of(cube, model);
  const Vec3d above{0.25, 0.5, 3};
  CHECK(closest_point(view, {region, 1}, above).point == Vec3d{0.25, 0.5, 1});
  CHECK(closest_point(view, {region, 1}, above).distance == 2);
  CHECK(closest_point(view, {region, 1}, {2, 2, 2}).point == Vec3d{1, 1, 1});
  for (std::uint32_t f = 0; f < 6; ++f) {
    const ClosestPoint closest = closest_point(view, {face, f}, above);
    const Vec3d normal = normal_near(view, ModelFaceId(f), above);
    CHECK(dot(normal, normal) == 1);
    if (normal.z == 1) CHECK(closest.distance == 2);
    if (normal.x == -1) CHECK(closest.point == Vec3d{0, 0.5, 1});
  }
  for (std::uint32_t e = 0; e < 12; ++e) {
    const ClosestPoint closest = closest_point(view, {edge, e}, {0.5, 0.5, 0.5});
    CHECK(closest.distance == Approx(std::sqrt(0.5)));
  }
  for (std::uint32_t v = 0; v < 8; ++v) CHECK(closest_point(view, {vertex, v}, {0.5, 0.5, 0.5}).distance == Approx(std::sqrt(0.75)));
}

TEST_CASE("entities that a model does not have are refused by name", "[brep]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  const ClassifiedBrep model = build_brep(cube);
  const auto error = error_of([&] { (void)measure(view_of(cube, model), {face, 6}); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
  CHECK(error->message == "the model has no face 6");
  CHECK(error_of([&] { (void)entities_above(model.brep, {edge, 12}); })->code == ErrorCode::InvalidArgument);
}
