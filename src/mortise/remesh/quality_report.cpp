// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/quality_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "mortise/base/error.h"
#include "mortise/brep/model_queries.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct ShapeOfTriangle {
  double least_angle = 0, greatest_angle = 0, radius_ratio = 0, edge_ratio = 0, area = 0;
  Vec3d normal;  // of any length
};

struct LengthOfEdge {
  double plain = 0, in_sizes = 0;
};

/// What marks are made from, once for all sets of triangles and edges.
struct Measured {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  MeshTopology topology;
  std::vector<ShapeOfTriangle> shapes;  // per triangle
  std::vector<LengthOfEdge> lengths;    // per edge
};

using Marks = std::vector<std::uint8_t>;

ShapeOfTriangle shape_of(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
  const std::array<double, 3> angles = triangle_angles_deg(a, b, c);
  const double ab = length(b - a), bc = length(c - b), ca = length(a - c), area = triangle_area(a, b, c);
  ShapeOfTriangle shape;
  shape.least_angle = *std::min_element(angles.begin(), angles.end());
  shape.greatest_angle = *std::max_element(angles.begin(), angles.end());
  const double shortest = std::min({ab, bc, ca}), longest = std::max({ab, bc, ca});
  shape.edge_ratio = shortest > 0 ? longest / shortest : infinity;
  shape.radius_ratio = shortest > 0 ? 4 * (2 * area / ab / bc) * (2 * area / ca / (ab + bc + ca)) : 0;
  shape.area = area;
  shape.normal = cross(b - a, c - a);
  return shape;
}

Measured measure(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizing, const std::vector<double>& sizes) {
  Measured m{mesh, model, build_topology(mesh), {}, {}};
  for (const Triangle& t : mesh.triangles) m.shapes.push_back(shape_of(mesh, t));
  for (const auto& [from, to] : m.topology.edges) {
    const Vec3d &a = mesh.points[from.index()], &b = mesh.points[to.index()];
    const double plain = length(b - a), at_middle = sizing.size_at(0.5 * (a + b));
    m.lengths.push_back({plain, plain * (1 / sizes[from.index()] + 4 / at_middle + 1 / sizes[to.index()]) / 6});
  }
  return m;
}

void add_angles(TriangleMarks& marks, std::vector<double>& smallest) {
  std::sort(smallest.begin(), smallest.end());
  const auto after = [&](double part) { return smallest[static_cast<std::size_t>(part * static_cast<double>(smallest.size()))]; };
  marks.least_angle_deg = smallest.front();
  marks.permille_angle_deg = after(0.001);
  marks.percent_angle_deg = after(0.01);
  marks.median_angle_deg = after(0.5);
  marks.below_30 = static_cast<std::size_t>(std::lower_bound(smallest.begin(), smallest.end(), 30.0) - smallest.begin());
}

double ratio_of(double a, double b) { return std::min(a, b) > 0 ? std::max(a, b) / std::min(a, b) : infinity; }

// Over pairs of triangles of the set that share an edge.
double greatest_growth(const Measured& m, const Marks& is_in) {
  double greatest = 0;
  for (std::size_t e = 0; e < m.topology.edges.size(); ++e) {
    double least = infinity, most = 0;
    for (const HalfEdge h : m.topology.uses_of(MeshEdgeId(e))) {
      if (is_in[h / 3] == 0) continue;
      least = std::min(least, m.shapes[h / 3].area);
      most = std::max(most, m.shapes[h / 3].area);
    }
    if (least < infinity) greatest = std::max(greatest, std::sqrt(ratio_of(most, least)));
  }
  return greatest;
}

TriangleMarks marks_of_triangles(const Measured& m, const Marks& is_in) {
  TriangleMarks marks;
  std::vector<double> smallest;
  marks.least_radius_ratio = 1;
  for (std::size_t t = 0; t < m.shapes.size(); ++t) {
    if (is_in[t] == 0) continue;
    const ShapeOfTriangle& shape = m.shapes[t];
    smallest.push_back(shape.least_angle);
    marks.greatest_angle_deg = std::max(marks.greatest_angle_deg, shape.greatest_angle);
    marks.above_115 += shape.greatest_angle > 115 ? 1 : 0;
    marks.least_radius_ratio = std::min(marks.least_radius_ratio, shape.radius_ratio);
    marks.mean_radius_ratio += shape.radius_ratio;
    marks.greatest_edge_ratio = std::max(marks.greatest_edge_ratio, shape.edge_ratio);
    marks.mean_edge_ratio += shape.edge_ratio;
  }
  if (smallest.empty()) return {};
  marks.count = smallest.size();
  marks.mean_radius_ratio /= static_cast<double>(marks.count);
  marks.mean_edge_ratio /= static_cast<double>(marks.count);
  marks.greatest_growth = greatest_growth(m, is_in);
  add_angles(marks, smallest);
  return marks;
}

// Along one model edge; a closed one goes on at its start.
double growth_along(const Measured& m, std::span<const VertexId> path, bool is_closed, const Marks& is_in) {
  double greatest = 0;
  std::vector<MeshEdgeId> pieces;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) pieces.push_back(find_edge(m.topology, path[k], path[k + 1]));
  for (std::size_t k = is_closed ? 0 : 1; k < pieces.size(); ++k) {
    const std::size_t one = pieces[k == 0 ? pieces.size() - 1 : k - 1].index(), other = pieces[k].index();
    if (is_in[one] != 0 && is_in[other] != 0) greatest = std::max(greatest, ratio_of(m.lengths[one].plain, m.lengths[other].plain));
  }
  return greatest;
}

LengthMarks marks_of_edges(const Measured& m, const Marks& is_in) {
  LengthMarks marks;
  marks.least = infinity;
  std::size_t in_band = 0;
  for (std::size_t e = 0; e < m.lengths.size(); ++e) {
    if (is_in[e] == 0) continue;
    const double length = m.lengths[e].in_sizes;
    ++marks.count;
    marks.least = std::min(marks.least, length);
    marks.greatest = std::max(marks.greatest, length);
    marks.mean += length;
    in_band += length >= length_limits[1] && length <= length_limits[6] ? 1 : 0;
    ++marks.bins[static_cast<std::size_t>(std::upper_bound(length_limits.begin(), length_limits.end(), length) - length_limits.begin())];
  }
  if (marks.count == 0) return {};
  marks.mean /= static_cast<double>(marks.count);
  marks.in_band = static_cast<double>(in_band) / static_cast<double>(marks.count);
  for (std::size_t e = 0; e < m.model.brep.edges.size(); ++e) {
    const ModelEdge& edge = m.model.brep.edges[ModelEdgeId(e)];
    const std::span<const VertexId> path = m.model.classification.path.of(ModelEdgeId(e));
    marks.greatest_growth = std::max(marks.greatest_growth, growth_along(m, path, edge.start == edge.end, is_in));
  }
  return marks;
}

Marks edges_of(const MeshTopology& topology, const Marks& triangles) {
  Marks is_in(topology.edges.size(), 0);
  for (HalfEdge h = 0; h < topology.edge_of.size(); ++h) {
    if (triangles[h / 3] != 0 && topology.edge_of[h].is_valid()) is_in[topology.edge_of[h].index()] = 1;
  }
  return is_in;
}

std::array<std::size_t, 13> count_valences(const Measured& m) {
  std::vector<std::size_t> valence(m.mesh.points.size(), 0);
  for (const std::array<VertexId, 2>& ends : m.topology.edges) {
    for (const VertexId v : ends) ++valence[v.index()];
  }
  std::array<std::size_t, 13> counts{};
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (m.model.classification.entity_of_vertex[v].dimension == EntityDimension::Face) ++counts[std::min(valence[v], counts.size() - 1)];
  }
  return counts;
}

std::size_t count_folds(const Measured& m) {
  const Marks is_on_model_edge = mark_model_edges(m.topology, m.model);
  std::size_t folds = 0;
  for (std::size_t e = 0; e < m.topology.edges.size(); ++e) {
    const std::span<const HalfEdge> uses = m.topology.uses_of(MeshEdgeId(e));
    if (is_on_model_edge[e] != 0 || uses.size() != 2) continue;
    folds += dot(m.shapes[uses[0] / 3].normal, m.shapes[uses[1] / 3].normal) < 0 ? 1 : 0;
  }
  return folds;
}

void check_model_of(const SurfaceMesh& mesh, const ClassifiedBrep& model, const std::vector<std::uint8_t>& frozen_edges) {
  const Classification& on = model.classification;
  const bool is_of_mesh = on.face_of_triangle.size() == mesh.triangles.size() && on.entity_of_vertex.size() == mesh.points.size() &&
                          on.path.size() == model.brep.edges.size();
  if (!is_of_mesh) throw Error(ErrorCode::InvalidArgument, "quality", "the model is not that of the mesh");
  if (!frozen_edges.empty() && frozen_edges.size() != model.brep.edges.size())
    throw Error(ErrorCode::InvalidArgument, "quality", "there is not one mark per model edge");
}

}  // namespace

QualityReport measure_quality(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizing,
                              const std::vector<std::uint8_t>& frozen_edges) {
  check_model_of(mesh, model, frozen_edges);
  const std::vector<double> sizes = sizing.sizes_at(mesh.points);
  const Measured m = measure(mesh, model, sizing, sizes);
  const FreeTriangles free = find_free_triangles(mesh, m.topology, model, sizes, frozen_edges);
  QualityReport report;
  report.all = marks_of_triangles(m, Marks(mesh.triangles.size(), 1));
  report.free = marks_of_triangles(m, free.is_free);
  report.edges = marks_of_edges(m, Marks(m.topology.edges.size(), 1));
  report.free_edges = marks_of_edges(m, edges_of(m.topology, free.is_free));
  report.obstacles = free.obstacles;
  report.valences = count_valences(m);
  report.folds = count_folds(m);
  return report;
}

}  // namespace mortise
