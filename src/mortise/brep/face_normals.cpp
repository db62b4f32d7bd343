// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cross products of edges scaled to length about 1.
#include "mortise/brep/face_normals.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mortise/base/error.h"

namespace mortise {
namespace {

constexpr double least_height = 1e-6;  // of the longest edge
constexpr std::size_t most_slivers_in_a_row = 16;

double largest_part(const Vec3d& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

Vec3d corner(const SurfaceMesh& mesh, std::size_t f, std::size_t k) { return mesh.points[mesh.triangles[f][k].index()]; }

// Zero for a sliver.
Vec3d normal_of(const SurfaceMesh& mesh, std::size_t f) {
  const Vec3d a = corner(mesh, f, 0), b = corner(mesh, f, 1), c = corner(mesh, f, 2);
  Vec3d u = b - a, v = c - a, w = c - b;
  double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
  const bool is_ordinary = longest > 1e-60 && longest < 1e60;  // else products leave the range of doubles
  if (!is_ordinary) {
    const double scale = 1 / std::max({largest_part(u), largest_part(v), largest_part(w)});
    u = scale * u, v = scale * v, w = scale * w;
    longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
  }
  const Vec3d normal = cross(u, v);
  const double square = dot(normal, normal);  // of the height times the longest edge
  if (!(square >= least_height * least_height * longest * longest)) return {0, 0, 0};
  return (1 / std::sqrt(square)) * normal;
}

HalfEdge longest_half_edge(const SurfaceMesh& mesh, std::size_t f) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d along = corner(mesh, f, (k + 1) % 3) - corner(mesh, f, k);
    const double length = dot(along, along);
    if (length > most) {
      most = length;
      longest = k;
    }
  }
  return static_cast<HalfEdge>(3 * f + longest);
}

// From sliver to sliver over longest edges, to a triangle that has a normal.
Vec3d normal_across(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<Vec3d>& normals, std::size_t f) {
  bool is_turned = false;
  for (std::size_t step = 0; step < most_slivers_in_a_row; ++step) {
    const HalfEdge h = longest_half_edge(mesh, f);
    const MeshEdgeId e = topology.edge_of[h];
    if (!e.is_valid() || topology.uses_of(e).size() != 2) return {0, 0, 0};
    const auto uses = topology.uses_of(e);
    const HalfEdge other = uses[0] == h ? uses[1] : uses[0];
    is_turned = is_turned != (origin_of(mesh, h) == origin_of(mesh, other));
    f = face_of(other).index();
    const Vec3d& normal = normals[f];
    if (dot(normal, normal) > 0) return is_turned ? -1.0 * normal : normal;
  }
  return {0, 0, 0};
}

}  // namespace

FaceNormals measure_normals(const SurfaceMesh& mesh, const MeshTopology& topology) {
  FaceNormals result;
  result.normals.resize(mesh.triangles.size());
  std::vector<std::size_t> slivers;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    result.normals[f] = normal_of(mesh, f);
    if (dot(result.normals[f], result.normals[f]) == 0) slivers.push_back(f);
  }
  std::vector<Vec3d> taken;
  for (const std::size_t f : slivers) taken.push_back(normal_across(mesh, topology, result.normals, f));
  for (std::size_t i = 0; i < slivers.size(); ++i) result.normals[slivers[i]] = taken[i];
  return result;
}

FaceNormals source_normals(const Provenance& provenance, const std::vector<FaceNormals>& operand_normals) {
  std::vector<std::uint32_t> first_plane{0};
  for (const FaceNormals& operand : operand_normals) {
    first_plane.push_back(first_plane.back() + static_cast<std::uint32_t>(operand.normals.size()));
  }
  FaceNormals result;
  for (std::size_t t = 0; t < provenance.source_face.size(); ++t) {
    const std::uint32_t k = provenance.source_operand[t], f = provenance.source_face[t];
    if (k >= operand_normals.size() || f >= operand_normals[k].normals.size())
      throw Error(ErrorCode::InvalidArgument, "source_normals",
                  "facet " + std::to_string(t) + " comes from a triangle that no operand has");
    const Vec3d& normal = operand_normals[k].normals[f];
    result.normals.push_back(provenance.flipped[t] != 0 ? -1.0 * normal : normal);
    result.planes.push_back(first_plane[k] + f);
  }
  return result;
}

}  // namespace mortise
