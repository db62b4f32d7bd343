// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 4: a boundary representation with several meshes, before and after, under the same numbers; a model of several of them.
#include <algorithm>
#include <set>

#include "mortise/boolean/imprint.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/imprint_checks.h"
#include "support/models.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A mesh and what it lies on.
struct MeshOnModel {
  SurfaceMesh mesh;
  Classification on;
};

/// Every triangle in four; what is in the middle of an edge lies on what the edge lies on.
MeshOnModel halved(const SurfaceMesh& mesh, const Classification& on) {
  const MeshTopology topology = build_topology(mesh);
  const auto middle_of = [&](std::size_t e) { return VertexId(mesh.points.size() + e); };
  MeshOnModel result{mesh, on};
  result.mesh.triangles.clear();
  result.on.face_of_triangle.clear();
  result.on.entity_of_vertex.resize(mesh.points.size() + topology.edges.size());
  for (const auto& [a, b] : topology.edges) result.mesh.points.push_back(0.5 * (mesh.points[a.index()] + mesh.points[b.index()]));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    const auto middle = [&](std::size_t k) { return middle_of(topology.edge_of[3 * t + k].index()); };
    for (const Triangle& part : {Triangle{c[0], middle(0), middle(2)}, Triangle{c[1], middle(1), middle(0)},
                                 Triangle{c[2], middle(2), middle(1)}, Triangle{middle(0), middle(1), middle(2)}}) {
      result.mesh.triangles.push_back(part);
      result.on.face_of_triangle.push_back(on.face_of_triangle[t]);
    }
    for (std::size_t k = 0; k < 3; ++k)
      result.on.entity_of_vertex[middle(k).index()] = {EntityDimension::Face, on.face_of_triangle[t].value};
  }
  result.on.path = {};
  for (std::uint32_t e = 0; e < on.path.size(); ++e) {
    const auto path = on.path.of(ModelEdgeId(e));
    std::vector<VertexId>& finer = result.on.path.items;
    finer.push_back(path[0]);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), sorted_ends(path[i], path[i + 1]));
      const VertexId middle = middle_of(static_cast<std::size_t>(found - topology.edges.begin()));
      result.on.entity_of_vertex[middle.index()] = {EntityDimension::Edge, e};
      finer.insert(finer.end(), {middle, path[i + 1]});
    }
    static_cast<void>(result.on.path.close());
  }
  return result;
}

}  // namespace

TEST_CASE("Fig. 4: a mesh before and one after are on the same entities, under the same numbers", "[paper][brep]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), moved(make_cylinder(0.75, 2, 24), {1, 1, 1})});
  const MeshOnModel finer = halved(m.boolean.mesh, m.model.classification), finest = halved(finer.mesh, finer.on);
  for (const MeshOnModel* after : {&finer, &finest}) {
    const ClassifiedBrep model{m.model.brep, after->on};
    CHECK(find_faults(after->mesh, model) == std::vector<std::string>());
    const ModelView view = view_of(after->mesh, model);
    for (const EntityDimension d : {EntityDimension::Vertex, EntityDimension::Edge, EntityDimension::Face, EntityDimension::Region}) {
      for (std::uint32_t i = d == EntityDimension::Region ? 1 : 0; i < entity_count(m.model.brep, d); ++i) {
        const ModelEntity entity{d, i};
        INFO(entity_name(entity));
        CHECK(measure(view, entity) == Approx(measure(m.result, entity)).epsilon(1e-12));
        const std::size_t times = after == &finer ? 4 : 16;
        if (d == EntityDimension::Face)
          CHECK(view.triangles_of_face.of(ModelFaceId(i)).size() == times * m.result.triangles_of_face.of(ModelFaceId(i)).size());
      }
    }
  }
}

TEST_CASE("Fig. 4: the mesh after has the model the mesh before has", "[paper][brep]") {
  const ResultModel m(Operation::Union, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  const MeshOnModel finer = halved(m.boolean.mesh, m.model.classification);
  const ClassifiedBrep rebuilt = build_brep(finer.mesh);
  CHECK(rebuilt.brep.vertex_count == m.model.brep.vertex_count);
  CHECK(rebuilt.brep.edges.size() == m.model.brep.edges.size());
  CHECK(rebuilt.brep.faces.size() == m.model.brep.faces.size());
  for (std::uint32_t v = 0; v < rebuilt.brep.vertex_count; ++v) {
    CHECK(rebuilt.classification.mesh_vertex[ModelVertexId(v)] == finer.on.mesh_vertex[ModelVertexId(v)]);
  }
  CHECK(rebuilt.classification.face_of_triangle == finer.on.face_of_triangle);
}

TEST_CASE("Fig. 4: mesh edges on model edges alone can be asked for", "[paper][brep]") {
  const ResultModel m(Operation::Union, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  std::set<std::array<VertexId, 2>> on_edges;
  for (std::uint32_t e = 0; e < m.model.brep.edges.size(); ++e) {
    for (const auto& edge : mesh_on(m.result, {EntityDimension::Edge, e}, Extent::Closure).edges) CHECK(on_edges.insert(edge).second);
  }
  CHECK(on_edges.size() == 30);
  CHECK(mesh_on(m.result, {EntityDimension::Face, 0}, Extent::Interior).vertices.empty());
}

TEST_CASE("Fig. 4: representations of one model share the edges of their contact", "[paper][brep]") {
  const std::vector<SurfaceMesh> solids{moved(make_cylinder(1, 4, 24), {0, 0, -2}),
                                        transform(moved(make_cylinder(0.6, 4, 24), {0, 0, -2}), rotation(Axis::X, 90))};
  const ImprintResult imprinted = imprint(pointers_to(solids));
  const std::vector<std::array<std::uint32_t, 2>> shared = shared_edges(imprinted);
  REQUIRE(!shared.empty());
  std::vector<std::set<std::set<std::uint32_t>>> contact_edges;
  for (const ImprintedOperand& operand : imprinted.operands) {
    BrepRules rules;
    rules.seams = Seams::None;
    const auto local = [&](std::uint32_t id) {
      return VertexId(static_cast<std::size_t>(std::lower_bound(operand.vertex_ids.begin(), operand.vertex_ids.end(), id) -
                                               operand.vertex_ids.begin()));
    };
    for (const auto& [a, b] : shared) rules.features.user_edges.push_back({local(a), local(b)});
    const ClassifiedBrep model = build_brep(operand.mesh, rules);
    CHECK(find_faults(operand.mesh, model) == std::vector<std::string>());
    CHECK(model.brep.faces.size() == 5);  // caps, and the side in three
    std::set<std::uint32_t> on_contact;
    for (const auto& [a, b] : shared) on_contact.insert({a, b});
    contact_edges.emplace_back();
    for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
      std::set<std::uint32_t> ids;
      for (const VertexId v : model.classification.path.of(ModelEdgeId(e))) ids.insert(operand.vertex_ids[v.index()]);
      if (on_contact.count(*ids.begin()) != 0) contact_edges.back().insert(ids);
    }
  }
  CHECK(contact_edges[0].size() == 2);
  CHECK(contact_edges[0] == contact_edges[1]);
}
