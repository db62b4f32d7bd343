// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Calls CGAL, and measures its results with its own functions.
#include "cgal_answers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <cstdlib>

#include "measure_cost.h"

namespace mortise::peers {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polygon = std::array<std::size_t, 3>;

std::vector<Polygon> polygons_of(const SurfaceMesh& mesh) {
  std::vector<Polygon> polygons;
  for (const Triangle& t : mesh.triangles) polygons.push_back({t[0].index(), t[1].index(), t[2].index()});
  return polygons;
}

std::vector<Kernel::Point_3> points_of(const SurfaceMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3d& p : mesh.points) points.emplace_back(p.x, p.y, p.z);
  return points;
}

CgalMesh cgal_mesh(const SurfaceMesh& mesh) {
  CgalMesh result;
  pmp::polygon_soup_to_polygon_mesh(points_of(mesh), polygons_of(mesh), result);
  return result;
}

bool has_degenerate_face(const CgalMesh& mesh) {
  for (const auto face : mesh.faces()) {
    if (pmp::is_degenerate_triangle_face(face, mesh)) return true;
  }
  return false;
}

double largest_coordinate(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const Vec3d& p : mesh.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return largest;
}

double perimeters_of(const CgalMesh& mesh) {
  double sum = 0;
  for (const auto halfedge : mesh.halfedges()) sum += pmp::edge_length(halfedge, mesh);
  return sum;
}

Shape shape_of(const CgalMesh& mesh) {
  Shape shape;
  shape.boundary_edges = static_cast<std::uint64_t>(
      std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](const auto edge) { return mesh.is_border(edge); }));
  if (shape.boundary_edges == 0) shape.volume = pmp::volume(mesh);
  shape.area = pmp::area(mesh);
  shape.perimeters = perimeters_of(mesh);
  shape.euler = static_cast<std::int64_t>(mesh.number_of_vertices()) - static_cast<std::int64_t>(mesh.number_of_edges()) +
                static_cast<std::int64_t>(mesh.number_of_faces());
  std::vector<std::size_t> shell_of(mesh.num_faces());
  shape.shells =
      static_cast<std::int64_t>(pmp::connected_components(mesh, CGAL::make_property_map(shell_of), pmp::parameters::default_values()));
  return shape;
}

std::string fault_of(const CgalMesh& mesh) {
  if (has_degenerate_face(mesh)) return "has faces without area";
  return pmp::does_self_intersect(mesh) ? "crosses itself" : "";
}

using Outputs = std::array<boost::optional<CgalMesh*>, 4>;

/// Which of the asked ones were answered; the operands are cut, so each call takes its own.
std::array<bool, 4> evaluate(const SurfaceMesh& a, const SurfaceMesh& b, const Outputs& outputs, Cost& cost) {
  CgalMesh mesh_a = cgal_mesh(a), mesh_b = cgal_mesh(b);
  std::array<bool, 4> answered{};
  cost = measure_cost([&] {
    answered = pmp::corefine_and_compute_boolean_operations(mesh_a, mesh_b, outputs, pmp::parameters::throw_on_self_intersection(true));
  });
  return answered;
}

/// The union of each run of neighbours.
std::vector<CgalMesh> unite_runs(std::vector<CgalMesh> meshes, std::size_t run) {
  std::vector<CgalMesh> united;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (i % run == 0) {
      united.push_back(std::move(meshes[i]));
      continue;
    }
    CgalMesh both;
    if (!pmp::corefine_and_compute_union(united.back(), meshes[i], both)) {
      std::fprintf(stderr, "CGAL cannot make the union manifold\n");
      std::exit(1);
    }
    united.back() = std::move(both);
  }
  return united;
}

}  // namespace

std::string why_unfit_for_cgal(const SurfaceMesh& mesh) {
  if (!pmp::is_polygon_soup_a_polygon_mesh(polygons_of(mesh))) return "not manifold and oriented";
  const CgalMesh m = cgal_mesh(mesh);
  if (!CGAL::is_closed(m)) return "open";
  if (has_degenerate_face(m)) return "faces without area";
  if (pmp::does_self_intersect(m)) return "crosses itself";
  if (!pmp::does_bound_a_volume(m)) return "bounds no volume";
  return "";
}

CostOfUnion cgal_union(std::span<const SurfaceMesh> operands, std::span<const std::size_t> runs) {
  std::vector<CgalMesh> meshes;
  for (const SurfaceMesh& mesh : operands) meshes.push_back(cgal_mesh(mesh));
  CostOfUnion result;
  result.cost = measure_cost([&] {
    for (const std::size_t run : runs) meshes = unite_runs(std::move(meshes), run);
  });
  result.volume = pmp::volume(meshes.front());
  return result;
}

Answers cgal_answers(const SurfaceMesh& a, const SurfaceMesh& b, Depth depth) {
  CGAL::Lazy_exact_nt<CGAL::Exact_predicates_exact_constructions_kernel::FT>::set_relative_precision_of_to_double(cgal_precision);
  Answers answers;
  answers.displacement = 2 * cgal_precision * std::max(largest_coordinate(a), largest_coordinate(b));
  try {
    std::array<CgalMesh, 4> results;
    evaluate(a, b, {&results[United]}, answers.union_cost);
    results[United].clear();
    const std::array<bool, 4> answered =
        evaluate(a, b, {&results[United], &results[Common], &results[ALessB], &results[BLessA]}, answers.four_cost);
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!answered[i]) continue;
      pmp::duplicate_non_manifold_vertices(results[i]);
      answers.shapes[i] = shape_of(results[i]);
      if (depth == Depth::FiguresAndFaults) answers.shapes[i]->fault = fault_of(results[i]);
    }
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    answers.refusal = "an operand crosses itself near the cut";
  }
  return answers;
}

}  // namespace mortise::peers
