// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mortise/mesh/measures.h"
#include "mortise/remesh/model_edge_chains.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/triangle_shape.h"

namespace mortise {
namespace {

constexpr int sweeps = 3;                                   // of moves per round
constexpr double splits_allowed = 4;                        // over the count foretold, per round
constexpr double good_enough = 0.75;                        // a mean ratio, about 26 degrees
constexpr double triangles_per_square = 2.309401076758503;  // 4 / sqrt(3): equilateral ones of edge 1 on area 1

// Small against the size there, or in so many pieces that it does not matter.
double count_on(const Vec3d& a, const Vec3d& b, const Vec3d& c, const SizingProxy& sizes) {
  const Vec3d area = area_vector(a, b, c);
  const double h = sizes.size_at(1.0 / 3 * (a + b + c));
  return triangles_per_square * std::sqrt(dot(area, area)) / 2 / (h * h);
}

// Over four parts of each of four, where sizes may vary on the triangle.
double count_on(const Triangle& t, const std::vector<Vec3d>& points, const SizingProxy& sizes) {
  constexpr int parts = 4;
  const Vec3d &a = points[t[0].index()], u = 1.0 / parts * (points[t[1].index()] - a), v = 1.0 / parts * (points[t[2].index()] - a);
  if (sizes.slope() == 0) return count_on(a, points[t[1].index()], points[t[2].index()], sizes);
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      const Vec3d p = a + static_cast<double>(i) * u + static_cast<double>(j) * v;
      sum += count_on(p, p + u, p + v, sizes);
      if (i + j + 1 < parts) sum += count_on(p + u, p + u + v, p + v, sizes);
    }
  }
  return sum;
}

void check_rules(const SurfaceMesh& mesh, const ClassifiedBrep& model, const RemeshRules& rules) {
  if (!rules.zone.empty() && rules.zone.size() != mesh.triangles.size())
    throw Error(ErrorCode::InvalidArgument, "remesh", "the zone has " + std::to_string(rules.zone.size()) + " marks, not one per triangle");
  const bool is_fine = rules.shortest > 0 && rules.longest > rules.shortest && rules.longest < 1e3 && rules.worst_angle_deg >= 0 &&
                       rules.worst_angle_deg < 60;
  if (!is_fine) throw Error(ErrorCode::InvalidArgument, "remesh", "rules need 0 < shortest < longest < 1000 and 0 <= worst_angle_deg < 60");
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    if (model.brep.edges[ModelEdgeId(e)].is_seam)
      throw Error(ErrorCode::InvalidArgument, "remesh", "edge " + std::to_string(e) + " is a seam: make the model without seams");
  }
}

// Or refuses.
double foretell_count(const SurfaceMesh& mesh, const SizingProxy& sizes, const RemeshRules& rules) {
  double count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool stays = !rules.zone.empty() && rules.zone[t] == 0;
    count += stays ? 1 : count_on(mesh.triangles[t], mesh.points, sizes);
  }
  if (count <= rules.most_triangles) return count;
  throw Error(ErrorCode::ResultTooLarge, "remesh",
              "the sizes ask for about " + std::to_string(static_cast<std::uint64_t>(std::min(count, 1e18))) + " triangles, more than " +
                  std::to_string(static_cast<std::uint64_t>(rules.most_triangles)));
}

void change_mesh(WorkingMesh& w, const RemeshRules& rules, double foretold) {
  const double most_new = splits_allowed * foretold + 1000;
  const double all = rules.rounds + rules.last_rounds + 1;
  for (std::uint32_t round = 0; round < rules.rounds; ++round) {
    report_progress(rules.progress, "remesh", round / all);
    swap_edges(w);
    resample_model_edges(w);
    collapse_short_edges(w, rules.shortest, rules.longest);
    swap_edges(w);
    split_long_edges(w, rules.longest, most_new);
    collapse_short_edges(w, rules.shortest, rules.longest);
    swap_edges(w);
    for (int k = 0; k < sweeps; ++k) smooth_vertices(w, good_enough);
    swap_edges(w);
    settle_on_reference(w);
  }
  for (std::uint32_t round = 0; round < rules.last_rounds; ++round) {
    report_progress(rules.progress, "remesh", (rules.rounds + round) / all);
    improve_worst_triangles(w, rules.worst_angle_deg, rules.longest);
    if (round + 2 < rules.last_rounds) smooth_vertices(w, 0);
  }
  settle_on_reference(w);
}

// The mesh without holes in its numbering.
RemeshResult compact(const WorkingMesh& w, const SurfaceMesh& given) {
  RemeshResult result;
  result.classification.mesh_vertex = IdVector<ModelVertexId, VertexId>(w.brep.vertex_count);
  std::vector<VertexId> new_vertex(w.mesh.vertex_count());
  for (std::size_t v = 0; v < w.mesh.vertex_count(); ++v) {
    const ModelEntity& entity = w.mesh.entity(VertexId(v));
    if (entity.dimension == EntityDimension::None) continue;
    new_vertex[v] = VertexId(result.mesh.points.size());
    result.mesh.points.push_back(w.mesh.points[v]);
    result.classification.entity_of_vertex.push_back(entity);
    if (entity.dimension == EntityDimension::Vertex) result.classification.mesh_vertex[ModelVertexId(entity.id)] = new_vertex[v];
  }
  result.mesh.label_names = given.label_names;
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
    if (!w.mesh.has(FaceId(t))) continue;
    const auto [a, b, c] = w.mesh.triangle(FaceId(t));
    const std::uint32_t source = w.mesh.references[t];
    result.mesh.triangles.push_back({new_vertex[a.index()], new_vertex[b.index()], new_vertex[c.index()]});
    result.classification.face_of_triangle.push_back(w.mesh.face(FaceId(t)));
    result.sources.emplace_back(source);
    if (!given.face_labels.empty()) result.mesh.face_labels.push_back(given.face_labels[source]);
    if (!given.walls.empty()) result.mesh.walls.push_back(given.walls[source]);
  }
  for (const std::vector<VertexId>& chain : trace_chains(w)) {
    for (const VertexId v : chain) result.classification.path.items.push_back(new_vertex[v.index()]);
    result.classification.path.close();
  }
  return result;
}

}  // namespace

std::vector<std::uint8_t> layers_round(const SurfaceMesh& mesh, const std::vector<std::array<VertexId, 2>>& edges, std::uint32_t layers) {
  std::vector<std::uint8_t> is_reached(mesh.points.size(), 0), zone(mesh.triangles.size(), 0);
  for (const std::array<VertexId, 2>& ends : edges) {
    for (const VertexId v : ends) {
      if (v.index() >= mesh.points.size())
        throw Error(ErrorCode::InvalidArgument, "layers_round",
                    "an edge ends at vertex " + std::to_string(v.value) + ", which is not there");
      is_reached[v.index()] = 1;
    }
  }
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    std::vector<VertexId> next;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      const bool touches = std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return is_reached[v.index()] != 0; });
      if (zone[t] != 0 || !touches) continue;
      zone[t] = 1;
      next.insert(next.end(), corners.begin(), corners.end());
    }
    for (const VertexId v : next) is_reached[v.index()] = 1;
  }
  return zone;
}

double predict_triangle_count(const SurfaceMesh& mesh, const SizingProxy& sizes) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += count_on(t, mesh.points, sizes);
  return sum;
}

RemeshResult remesh(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals, const SizingProxy& sizes,
                    const RemeshRules& rules) {
  check_rules(mesh, model, rules);
  const double foretold = foretell_count(mesh, sizes, rules);
  WorkingMesh working(mesh, model, normals, sizes, rules.zone);
  change_mesh(working, rules, foretold);
  return compact(working, mesh);
}

}  // namespace mortise
