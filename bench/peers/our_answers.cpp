// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Calls Mortise, and measures its results.
#include "our_answers.h"

#include <algorithm>
#include <cmath>

#include "measure_cost.h"
#include "mortise/mortise.h"

namespace mortise::peers {
namespace {

double distance(const Vec3d& p, const Vec3d& q) { return std::sqrt(dot(p - q, p - q)); }

double perimeters_of(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
    sum += distance(a, b) + distance(b, c) + distance(c, a);
  }
  return sum;
}

Shape shape_of(const SurfaceMesh& mesh) {
  const SplitPinches split = split_pinches(mesh, build_topology(mesh));
  const MeshTopology topology = build_topology(split.mesh);
  Shape shape;
  shape.volume = enclosed_volume(mesh);
  shape.area = surface_area(mesh);
  shape.perimeters = perimeters_of(mesh);
  shape.euler = static_cast<std::int64_t>(split.mesh.points.size()) - static_cast<std::int64_t>(topology.edges.size()) +
                static_cast<std::int64_t>(split.mesh.triangles.size());
  shape.shells = split.shells.count;
  shape.boundary_edges = find_boundary_edges(topology).size();
  return shape;
}

std::string fault_of(const SurfaceMesh& mesh) {
  const SelfCrossingCounts counts = count_self_crossings(mesh);
  if (counts.degenerate_faces != 0) return "has faces without area";
  return counts.crossing + counts.coplanar_overlap + counts.touching != 0 ? "crosses itself" : "";
}

}  // namespace

Answers our_answers(const SurfaceMesh& a, const SurfaceMesh& b, Depth depth) {
  Answers answers;
  std::array<BooleanResult, 4> results;
  try {
    answers.union_cost = measure_cost([&] { results[United] = unite(a, b); });
    answers.four_cost = measure_cost([&] { results = {unite(a, b), intersect(a, b), subtract(a, b), subtract(b, a)}; });
  } catch (const Error& error) {
    answers.refusal = error.what();
    return answers;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    answers.shapes[i] = shape_of(results[i].mesh);
    answers.shapes[i]->is_uncertified = results[i].report.certificate.status == CertificateStatus::Uncertified;
    if (depth == Depth::FiguresAndFaults) answers.shapes[i]->fault = fault_of(results[i].mesh);
    answers.displacement = std::max(answers.displacement, results[i].report.certificate.largest_displacement);
  }
  return answers;
}

}  // namespace mortise::peers
