// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 29: a body, a wing through it with a thin trailing edge, and an engine under the wing: one solid in any order of the operands, and
// the trailing edge stays when it is remeshed.
#include <algorithm>
#include <array>
#include <cmath>

#include "mortise/brep/validate_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "mortise/size/small_features.h"
#include "support/boolean_checks.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A body of revolution along x, pointed at both ends.
SurfaceMesh spindle(double length, double radius, std::uint32_t along, std::uint32_t around) {
  std::vector<Vec2d> profile;
  for (std::uint32_t k = 0; k <= along; ++k) {
    const double t = 2.0 * k / along - 1, x = t * (1.5 - 0.5 * t * t);
    profile.push_back({k == 0 || k == along ? 0 : radius * std::sqrt(1 - x * x), length / 2 * x});
  }
  return transform(revolve(profile, around), rotation(Axis::Y, 90));
}

/// Half the thickness of a symmetric aerofoil of chord 1, 12 % thick, closed at the trailing edge.
double half_thickness(double x) { return 0.6 * (0.2969 * std::sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x)))); }

/// Of the lower side from the trailing edge to the nose, then back above; `blunt` is added to the thickness at the trailing edge.
std::vector<Vec2d> aerofoil(std::uint32_t steps, double blunt) {
  std::vector<Vec2d> outline;
  const auto add = [&](std::uint32_t k, double side) {
    const double t = static_cast<double>(k) / steps, x = t * t * (3 - 2 * t);
    outline.push_back({1.6 * x, side * 1.6 * (half_thickness(x) + blunt * x / 2)});
  };
  for (std::uint32_t k = blunt > 0 ? steps : steps - 1; k > 0; --k) add(k, -1);
  for (std::uint32_t k = 0; k < steps; ++k) add(k, 1);
  blunt > 0 ? add(steps, 1) : outline.push_back({1.6, 0});
  return outline;
}

/// From y = -4 to 4, swept back.
SurfaceMesh wing(double blunt) {
  SurfaceMesh mesh = extrude(aerofoil(20, blunt), 8);
  for (Vec3d& p : mesh.points) p = {p.x - 0.8 + 0.25 * (p.z - 4), 4 - p.z, p.y + 0.1};
  return mesh;
}

SurfaceMesh engine() { return moved(spindle(1.8, 0.3, 14, 20), {0.1, -2.2, -0.15}); }

std::vector<SurfaceMesh> aeroplane(double blunt) { return {spindle(8, 0.7, 24, 28), wing(blunt), engine()}; }

/// Of model edges along x = 0.8 - y / 4 at the height of the wing.
double length_of_trailing_edges(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  const auto is_there = [&](VertexId v) {
    const Vec3d& p = mesh.points[v.index()];
    return std::fabs(p.x + 0.25 * p.y - 0.8) < 1e-12 && std::fabs(p.z - 0.1) < 0.01;
  };
  double sum = 0;
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    if (!std::all_of(path.begin(), path.end(), is_there)) continue;
    const Vec3d &from = mesh.points[path.front().index()], &to = mesh.points[path.back().index()];
    if (std::fabs(to.y - from.y) < 1e-9) continue;  // across the blunt one, at a tip
    for (std::size_t k = 1; k < path.size(); ++k) sum += length(mesh.points[path[k].index()] - mesh.points[path[k - 1].index()]);
  }
  return sum;
}

}  // namespace

TEST_CASE("Fig. 29: body, wing and engine are the same solid in all six orders", "[paper]") {
  const std::vector<SurfaceMesh> parts = aeroplane(0);
  std::array<std::size_t, 3> order{0, 1, 2};
  const ModelScene first = scene_of(Operation::Union, parts);
  const double volume = exact_volume(first.mesh), area = surface_area(first.mesh);
  CHECK(volume < exact_volume(parts[0]) + exact_volume(parts[1]) + exact_volume(parts[2]) - 0.1);
  int orders = 0;
  do {
    const ModelScene scene = scene_of(Operation::Union, {parts[order[0]], parts[order[1]], parts[order[2]]});
    CHECK(scene.mesh.triangles.size() == first.mesh.triangles.size());
    CHECK(scene.model.brep.faces.size() == first.model.brep.faces.size());
    CHECK(exact_volume(scene.mesh) == Approx(volume).epsilon(1e-12));
    CHECK(surface_area(scene.mesh) == Approx(area).epsilon(1e-12));
    CHECK(is_balanced(scene.mesh));
    CHECK(euler_characteristic(scene.mesh) == 2);
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  CHECK(orders == 6);
}

TEST_CASE("Fig. 29: remeshed, the trailing edge is where it was and the solid is watertight", "[paper][remesh]") {
  const double sharp = 0, blunt = 0.01;  // a sixth of the size thick
  for (const double trailing : {sharp, blunt}) {
    INFO("thickness of the trailing edge " << trailing);
    const ModelScene scene = scene_of(Operation::Union, aeroplane(trailing));
    const SizingProxy sizes({}, {.global = 0.1});
    const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
    const ClassifiedBrep after = model_after(scene, result);
    CHECK(find_faults(result.mesh, after).empty());
    CHECK(is_balanced(result.mesh));
    CHECK(euler_characteristic(result.mesh) == 2);
    CHECK(count_crossings(result.mesh) == 0);
    CHECK(result.kept.empty());
    CHECK(std::fabs(enclosed_volume(result.mesh) / enclosed_volume(scene.mesh) - 1) < 0.01);

    CHECK(deviation_after(scene, result, sizes).curves_to_reference.in_sizes < 1e-3);
    const double length_before = length_of_trailing_edges(scene.mesh, scene.model);
    CHECK(length_before > (trailing == sharp ? 1 : 2) * 6);
    CHECK(length_of_trailing_edges(result.mesh, after) == Approx(length_before).epsilon(1e-12));

    const QualityReport q = measure_quality(result.mesh, after, sizes);
    CHECK(q.folds == 0);
    CHECK(q.free.least_angle_deg > 34);
    CHECK(static_cast<double>(q.free.count) > 0.9 * static_cast<double>(q.all.count));
    CHECK(q.all.below_30 < (trailing == sharp ? 20U : 200U));  // the tips of the wing; the strip between two trailing edges
  }
}

TEST_CASE("Fig. 29: with sizes for small features the strip between two trailing edges has good triangles too", "[paper][remesh]") {
  const ModelScene scene = scene_of(Operation::Union, aeroplane(0.01));
  const SizingProxy coarse({}, {.global = 0.1});
  const SizingProxy sizes = coarse.with(find_small_features(scene.mesh, scene.model, coarse).sources);
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes);
  const ClassifiedBrep after = model_after(scene, result);
  CHECK(find_faults(result.mesh, after).empty());
  CHECK(euler_characteristic(result.mesh) == 2);
  CHECK(length_of_trailing_edges(result.mesh, after) == Approx(length_of_trailing_edges(scene.mesh, scene.model)).epsilon(1e-12));
  const QualityReport q = measure_quality(result.mesh, after, sizes);
  CHECK(q.folds == 0);
  CHECK(q.all.least_angle_deg > 32);
}
