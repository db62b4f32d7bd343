// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Calls CGAL, and finds the model on what it made.
#include "cgal_remesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <span>

#include "measure_cost.h"
#include "mortise/mortise.h"

namespace mortise::peers {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using CgalEdge = CgalMesh::Edge_index;
using CgalVertex = CgalMesh::Vertex_index;

constexpr unsigned int iterations = 3;

/// CGAL's mesh with our model on it.
struct Constrained {
  CgalMesh mesh;
  CgalMesh::Property_map<CgalEdge, bool> is_constrained;
  CgalMesh::Property_map<CgalVertex, bool> is_corner;
};

Constrained cgal_mesh(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  Constrained c;
  c.is_constrained = c.mesh.add_property_map<CgalEdge, bool>("e:constrained", false).first;
  c.is_corner = c.mesh.add_property_map<CgalVertex, bool>("v:corner", false).first;
  std::vector<CgalVertex> vertices;
  for (const Vec3d& p : mesh.points) vertices.push_back(c.mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& [i, j, k] : mesh.triangles) c.mesh.add_face(vertices[i.index()], vertices[j.index()], vertices[k.index()]);
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      c.is_constrained[c.mesh.edge(c.mesh.halfedge(vertices[path[k].index()], vertices[path[k + 1].index()]))] = true;
  }
  for (const VertexId v : model.classification.mesh_vertex) c.is_corner[vertices[v.index()]] = true;
  return c;
}

void remesh_by_cgal(Constrained& c, double size, ModelEdges edges) {
  if (edges == ModelEdges::Protected) {
    std::vector<CgalEdge> constrained;
    for (const CgalEdge e : c.mesh.edges()) {
      if (c.is_constrained[e]) constrained.push_back(e);
    }
    pmp::split_long_edges(constrained, size, c.mesh, CGAL::parameters::edge_is_constrained_map(c.is_constrained));
  }
  pmp::isotropic_remeshing(c.mesh.faces(), size, c.mesh,
                           CGAL::parameters::number_of_iterations(iterations)
                               .edge_is_constrained_map(c.is_constrained)
                               .vertex_is_constrained_map(c.is_corner)
                               .protect_constraints(edges == ModelEdges::Protected));
}

void take_out(Constrained& c, RemesherAnswer& answer) {
  BrepRules rules;
  rules.seams = Seams::None;
  rules.features.face_angle_deg = 180;
  c.mesh.collect_garbage();
  for (const CgalVertex v : c.mesh.vertices()) {
    const Kernel::Point_3& p = c.mesh.point(v);
    answer.mesh.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : c.mesh.faces()) {
    Triangle& t = answer.mesh.triangles.emplace_back();
    std::size_t k = 0;
    for (const CgalVertex v : c.mesh.vertices_around_face(c.mesh.halfedge(f))) t[k++] = VertexId(std::size_t{v});
  }
  for (const CgalEdge e : c.mesh.edges()) {
    if (c.is_constrained[e])
      rules.features.user_edges.push_back({VertexId(std::size_t{c.mesh.vertex(e, 0)}), VertexId(std::size_t{c.mesh.vertex(e, 1)})});
  }
  answer.model = build_brep(answer.mesh, rules);
}

}  // namespace

RemesherAnswer cgal_remesh(const SurfaceMesh& mesh, const ClassifiedBrep& model, double size, ModelEdges edges) {
  RemesherAnswer answer;
  const MeshTopology topology = build_topology(mesh);
  if (!find_non_manifold_edges(topology).empty() || !find_non_manifold_vertices(mesh, topology).empty()) {
    answer.refusal = "takes manifold meshes only";
    return answer;
  }
  Constrained c = cgal_mesh(mesh, model);
  try {
    const Cost cost = measure_cost([&] { remesh_by_cgal(c, size, edges); });
    answer.seconds = cost.milliseconds / 1000;
    answer.megabytes = cost.megabytes;
    take_out(c, answer);
  } catch (const std::exception& error) {
    answer.refusal = std::string("fails: ") + error.what();
  }
  return answer;
}

}  // namespace mortise::peers
