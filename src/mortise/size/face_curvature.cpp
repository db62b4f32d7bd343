// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/face_curvature.h"

#include <algorithm>
#include <cmath>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"
#include "mortise/base/union_find.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

constexpr double thinnest = 1e-6;    // height by longest edge
constexpr double same_plane = 1e-6;  // angle between normals

Vec3d unit(const Vec3d& v) {
  const double size = length(v);
  return size > 0 ? Vec3d{v.x / size, v.y / size, v.z / size} : Vec3d{};
}

bool are_in_one_plane(const FaceNormals& normals, FaceId f, FaceId g) {
  if (!normals.planes.empty() && normals.planes[f.index()] == normals.planes[g.index()]) return true;
  const Vec3d &m = normals.normals[f.index()], &n = normals.normals[g.index()];
  const Vec3d turn = cross(m, n);
  return dot(m, n) > 0 && dot(turn, turn) < same_plane * same_plane;
}

// Over a piece of one plane: the gradient [uu uv; vu vv] of the normal, times the area.
struct GradientSum {
  double uu = 0, uv = 0, vu = 0, vv = 0;
  double area = 0;
  double longest = 0;  // edge, squared
};

// Of the symmetric part of the mean gradient.
double largest_curvature(const GradientSum& sum) {
  if (!(sum.area > thinnest * sum.longest)) return 0;
  const double mean = (sum.uu + sum.vv) / 2, half = (sum.uu - sum.vv) / 2, mixed = (sum.uv + sum.vu) / 2;
  return (std::fabs(mean) + std::sqrt(half * half + mixed * mixed)) / sum.area;
}

// Two axes at right angles to a normal.
std::array<Vec3d, 2> axes_across(const Vec3d& normal) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::fabs(normal[k]) < std::fabs(normal[least])) least = k;
  }
  Vec3d axis{};
  axis[least] = 1;
  const Vec3d u = unit(cross(axis, normal));
  return {u, cross(normal, u)};
}

// Corner 3 f + k of triangle f stands for the vertex there as the triangles see it that are joined to f round it.
class Bending {
 public:
  Bending(const ModelView& view, const FaceNormals& normals)
      : mesh_(view.mesh), normals_(normals), corners_(3 * mesh_.triangles.size()), pieces_(mesh_.triangles.size()) {
    const MeshTopology topology = build_topology(mesh_);
    const std::vector<std::uint8_t> is_crease = mark_model_edges(topology, view.model);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const auto uses = topology.uses_of(MeshEdgeId(e));
      if (is_crease[e] == 0 && uses.size() == 2) join_across(uses[0], uses[1]);
    }
  }

  [[nodiscard]] std::vector<double> measure() {
    average_normals();
    std::vector<GradientSum> sums(mesh_.triangles.size());
    for (std::uint32_t f = 0; f < sums.size(); ++f) add_gradient(f, sums[pieces_.find(f)]);
    std::vector<double> curvatures;
    for (std::uint32_t f = 0; f < sums.size(); ++f) {
      const std::uint32_t piece = pieces_.find(f);
      curvatures.push_back(piece == f ? largest_curvature(sums[f]) : curvatures[piece]);
    }
    return curvatures;
  }

 private:
  void join_across(HalfEdge g, HalfEdge h) {
    const bool is_opposite = origin_of(mesh_, g) != origin_of(mesh_, h);
    corners_.join(g, is_opposite ? next_in_face(h) : h);
    corners_.join(next_in_face(g), is_opposite ? h : next_in_face(h));
    if (are_in_one_plane(normals_, face_of(g), face_of(h))) pieces_.join(face_of(g).value, face_of(h).value);
  }

  [[nodiscard]] Vec3d point(std::uint32_t corner) const { return mesh_.points[origin_of(mesh_, corner).index()]; }

  // Or without a normal.
  [[nodiscard]] bool is_thin(std::uint32_t f) const {
    const Vec3d u = point(3 * f + 1) - point(3 * f), v = point(3 * f + 2) - point(3 * f), w = v - u;
    const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
    const Vec3d& normal = normals_.normals[f];
    return !(length(cross(u, v)) > thinnest * longest) || !(dot(normal, normal) > 0);
  }

  void average_normals() {
    averages_.assign(3 * mesh_.triangles.size(), {});
    for (std::uint32_t c = 0; c < averages_.size(); ++c) {
      if (is_thin(c / 3)) continue;
      const Vec3d u = point(next_in_face(c)) - point(c), v = point(next_in_face(next_in_face(c))) - point(c);
      Vec3d& sum = averages_[corners_.find(c)];
      sum = sum + trig::atan2(length(cross(u, v)), dot(u, v)) * normals_.normals[c / 3];
    }
    for (Vec3d& normal : averages_) normal = unit(normal);
  }

  // Bounded however thin the triangle is. Each corner counts along the edge across it, turned by a right angle.
  void add_gradient(std::uint32_t f, GradientSum& sum) {
    const auto [u, v] = axes_across(normals_.normals[pieces_.find(f)]);
    for (std::uint32_t c = 3 * f; c < 3 * f + 3; ++c) {
      const Vec3d& normal = averages_[corners_.find(c)];
      const Vec3d from = point(next_in_face(c)), across = point(next_in_face(next_in_face(c))) - from, back = point(c) - from;
      const double eu = dot(across, u), ev = dot(across, v), nu = dot(normal, u), nv = dot(normal, v);
      sum.uu -= nu * ev / 2, sum.uv += nu * eu / 2, sum.vu -= nv * ev / 2, sum.vv += nv * eu / 2;
      sum.area += (eu * dot(back, v) - ev * dot(back, u)) / 6;
      sum.longest = std::max(sum.longest, dot(across, across));
    }
  }

  const SurfaceMesh& mesh_;
  const FaceNormals& normals_;
  UnionFind corners_;  // half-edges at their origins
  UnionFind pieces_;   // triangles of one plane
  std::vector<Vec3d> averages_;
};

}  // namespace

std::vector<double> measure_curvatures(const ModelView& view, const FaceNormals& normals) {
  const std::size_t count = view.mesh.triangles.size();
  if (normals.normals.size() != count || (!normals.planes.empty() && normals.planes.size() != count))
    throw Error(ErrorCode::InvalidArgument, "sizing", "there is not one normal per triangle");
  return Bending(view, normals).measure();
}

}  // namespace mortise
