// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "support/remesh_scenes.h"

#include <algorithm>
#include <cmath>

#include "mortise/base/bits.h"
#include "mortise/base/trig.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/self_crossing_oracle.h"

namespace mortise::test {
namespace {

using Corner = std::array<std::uint64_t, 3>;
using Corners = std::array<Corner, 3>;

Corner bits_of(const Vec3d& p) { return {cast_bits<std::uint64_t>(p.x), cast_bits<std::uint64_t>(p.y), cast_bits<std::uint64_t>(p.z)}; }

/// The bits of the coordinates, from the lowest corner on, in their order.
Corners corners_of(const SurfaceMesh& mesh, const Triangle& t) {
  Corners corners{};
  for (std::size_t k = 0; k < 3; ++k) corners[k] = bits_of(mesh.points[t[k].index()]);
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

double equilateral_edge(const SurfaceMesh& mesh, FaceId t) {
  const auto [a, b, c] = mesh.triangles[t.index()];
  return std::sqrt(4 / std::sqrt(3.0) * triangle_area(mesh.points[a.index()], mesh.points[b.index()], mesh.points[c.index()]));
}

}  // namespace

BrepRules without_seams(double edge_angle_deg) {
  BrepRules rules;
  rules.seams = Seams::None;
  rules.edge_angle_deg = edge_angle_deg;
  return rules;
}

ModelScene scene_of(SurfaceMesh mesh, FaceNormals normals, const BrepRules& rules) {
  ClassifiedBrep model = build_brep(mesh, rules, normals);
  return {std::move(mesh), std::move(normals), std::move(model)};
}

ModelScene scene_of(const SurfaceMesh& mesh, const BrepRules& rules) {
  return scene_of(mesh, measure_normals(mesh, build_topology(mesh)), rules);
}

ModelScene scene_of(const BooleanResult& result, const std::vector<SurfaceMesh>& operands, const BrepRules& rules) {
  std::vector<FaceNormals> normals;
  for (const SurfaceMesh& operand : operands) normals.push_back(measure_normals(operand, build_topology(operand)));
  return scene_of(result.mesh, source_normals(result.provenance, normals), rules);
}

ModelScene scene_of(Operation operation, const std::vector<SurfaceMesh>& operands, const BrepRules& rules) {
  return scene_of(evaluate(operation, operands), operands, rules);
}

std::vector<SurfaceMesh> crossing_cylinders(std::uint32_t around) {
  std::vector<SurfaceMesh> both{make_cylinder(1, 4, around), make_cylinder(0.6, 4, around)};
  for (Vec3d& p : both[1].points) p = {p.z - 2, p.x + 0.02, p.y + 2.013};
  return both;
}

std::vector<SurfaceMesh> ball_ring_and_corner_sheet() {
  constexpr double y = corner_of_sheet, z = corner_of_sheet;
  const Vec3d left{-1.6, y, z}, right{1.6, y, z};
  const SurfaceMesh sheet = make_mesh({left, right, {1.6, 2.05, z}, {-1.6, 2.05, z}, {1.6, y, -1.6}, {-1.6, y, -1.6}},
                                      {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}});
  return {make_icosphere(1, 3), moved(make_torus(1, 0.4, 48, 24), ring_centre), sheet};
}

SurfaceMesh gun() {
  const SurfaceMesh base = make_cylinder(0.6, 0.5, 24), house = box({-0.5, -0.4, 0.375}, {0.5, 0.4, 1});
  const SurfaceMesh barrel = transform(transform(make_cylinder(0.1, 2, 12), rotation(Axis::Y, 90)), translation({0.25, 0.03125, 0.6875}));
  return evaluate(Operation::Union, {base, house, barrel}).mesh;
}

std::vector<SurfaceMesh> plate_and_drills() {
  std::vector<SurfaceMesh> solids{box({0, 0, 0}, {4, 3, 1})};
  for (const Drilling& d : drillings) solids.push_back(moved(make_cylinder(d.radius, 2, sides_of_drill), d.centre - Vec3d{0, 0, 0.5}));
  return solids;
}

std::vector<SizeSource> sources_at_rims(double growth) {
  std::vector<SizeSource> sources;
  for (const Drilling& d : drillings) {
    const auto corner = [&](std::uint32_t k, double z) {
      const double angle = 360.0 * k / sides_of_drill;
      return d.centre + Vec3d{d.radius * trig::cos_deg(angle), d.radius * trig::sin_deg(angle), z};
    };
    for (std::uint32_t k = 0; k < sides_of_drill; ++k) {
      for (const double z : {0.0, 1.0}) {
        const Vec3d a = corner(k, z), b = corner(k + 1, z);
        sources.push_back(segment_source(a, b, std::sqrt(dot(b - a, b - a)), growth));
      }
    }
  }
  return sources;
}

ClassifiedBrep model_after(const ModelScene& scene, const RemeshResult& result) { return {scene.model.brep, result.classification}; }

Deviation deviation_after(const ModelScene& scene, const RemeshResult& result, const SizingProxy& sizes) {
  return measure_deviation(result.mesh, model_after(scene, result), scene.mesh, scene.model, sizes, Matching::Entities);
}

std::vector<double> growths_of(const SurfaceMesh& mesh) {
  const MeshTopology topology = build_topology(mesh);
  std::vector<double> growths;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const HalfEdge> uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() != 2) continue;
    const double one = equilateral_edge(mesh, face_of(uses[0])), other = equilateral_edge(mesh, face_of(uses[1]));
    growths.push_back(std::max(one / other, other / one));
  }
  std::sort(growths.begin(), growths.end());
  return growths;
}

SurfaceMesh part_of(const RemeshResult& result, ModelFaceId face) {
  SurfaceMesh part;
  part.points = result.mesh.points;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    if (result.classification.face_of_triangle[t] == face) part.triangles.push_back(result.mesh.triangles[t]);
  }
  return part;
}

std::size_t count_lost(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& marks, const SurfaceMesh& other) {
  std::vector<Corners> there;
  for (const Triangle& t : other.triangles) there.push_back(corners_of(other, t));
  std::sort(there.begin(), there.end());
  std::size_t lost = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (marks[t] == 0) lost += std::binary_search(there.begin(), there.end(), corners_of(mesh, mesh.triangles[t])) ? 0 : 1;
  }
  return lost;
}

SurfaceMesh part_away_from(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& marks, const SurfaceMesh& other) {
  std::vector<Corner> there;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (marks[t] != 0) continue;
    for (const VertexId v : mesh.triangles[t]) there.push_back(bits_of(mesh.points[v.index()]));
  }
  std::sort(there.begin(), there.end());
  SurfaceMesh part;
  part.points = other.points;
  for (const Triangle& t : other.triangles) {
    const bool is_away = std::none_of(
        t.begin(), t.end(), [&](VertexId v) { return std::binary_search(there.begin(), there.end(), bits_of(other.points[v.index()])); });
    if (is_away) part.triangles.push_back(t);
  }
  return part;
}

std::size_t count_crossings(const SurfaceMesh& mesh) {
  const std::vector<oracle::MeetingPair> pairs = oracle::self_crossings(mesh);
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [](const oracle::MeetingPair& p) {
    return p.meeting == oracle::Meeting::Crossing || p.meeting == oracle::Meeting::Overlap;
  }));
}

}  // namespace mortise::test
