// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Everything is measured along the axis nearest to the normal: heights over the other two are affine.
#include "mortise/mesh/half_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/mesh/require_plane.h"

namespace mortise {
namespace {

constexpr const char* stage = "make_half_space";

class HalfSpace {
 public:
  HalfSpace(const Plane& plane, const Box3& box) : plane_(plane), box_(box) {
    const Vec3d& n = plane.normal;
    up_ = std::fabs(n.x) >= std::fabs(n.y) ? 0 : 1;
    if (std::fabs(n.z) > std::fabs(n[up_])) up_ = 2;
    first_ = (up_ + 1) % 3;
    second_ = (up_ + 2) % 3;
    step_ = power_of_two_above(std::max({half_size(first_), half_size(second_), 0x1p-10 * std::fabs(box.lo[first_]),
                                         0x1p-10 * std::fabs(box.lo[second_]), 0x1p-10 * std::fabs(box.lo[up_])}));
  }

  // In the plane a triangle round the box as seen along the axis; at a quarter of the way to the apex its sides still are.
  [[nodiscard]] SurfaceMesh mesh() const {
    const double u = near_middle(first_), v = near_middle(second_);
    const double front = plane_.normal[up_] > 0 ? 1 : -1;
    SurfaceMesh result;
    for (const auto& [du, dv] : {std::pair{-16, -16}, std::pair{32, -16}, std::pair{-16, 32}})
      result.points.push_back(in_plane(u + du * step_, v + dv * step_));
    Vec3d apex = in_plane(u, v);
    apex[up_] -= front * 4 * std::max(step_, depth(front));
    result.points.push_back(apex);
    const bool is_front_up = front > 0;
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{1, 0, 3}, std::array{2, 1, 3}, std::array{0, 2, 3}}) {
      result.triangles.push_back({VertexId(static_cast<std::size_t>(a)), VertexId(static_cast<std::size_t>(is_front_up ? b : c)),
                                  VertexId(static_cast<std::size_t>(is_front_up ? c : b))});
    }
    return result;
  }

 private:
  static double power_of_two_above(double size) {
    int exponent = 0;
    std::frexp(size, &exponent);
    return size > 0 ? std::ldexp(1, exponent) : 1;
  }

  [[nodiscard]] double half_size(std::size_t axis) const { return 0.5 * box_.hi[axis] - 0.5 * box_.lo[axis]; }

  // A multiple of the step, so that heights over it are few bits long.
  [[nodiscard]] double near_middle(std::size_t axis) const {
    return std::floor((0.5 * box_.lo[axis] + 0.5 * box_.hi[axis]) / step_) * step_;
  }

  [[nodiscard]] Vec3d in_plane(double u, double v) const {
    Vec3d p;
    p[first_] = u;
    p[second_] = v;
    p[up_] = (plane_.offset - plane_.normal[first_] * u - plane_.normal[second_] * v) / plane_.normal[up_];
    return p;
  }

  // How far the box reaches behind the plane, along the axis.
  [[nodiscard]] double depth(double front) const {
    double deepest = 0;
    for (const double u : {box_.lo[first_], box_.hi[first_]}) {
      for (const double v : {box_.lo[second_], box_.hi[second_]}) {
        for (const double w : {box_.lo[up_], box_.hi[up_]}) deepest = std::max(deepest, front * (in_plane(u, v)[up_] - w));
      }
    }
    return deepest;
  }

  const Plane& plane_;
  const Box3& box_;
  std::size_t up_ = 0, first_ = 0, second_ = 0;
  double step_ = 1;
};

}  // namespace

SurfaceMesh make_half_space(const Plane& plane, const Box3& box) {
  require_plane(plane, stage);
  if (box.is_empty()) throw Error(ErrorCode::InvalidArgument, stage, "a half-space needs a mesh to cut");
  SurfaceMesh mesh = HalfSpace(plane, box).mesh();
  constexpr double largest = std::numeric_limits<double>::max();
  const bool fits = std::all_of(mesh.points.begin(), mesh.points.end(), [](const Vec3d& p) {
    return std::fabs(p.x) <= largest && std::fabs(p.y) <= largest && std::fabs(p.z) <= largest;
  });
  if (!fits) throw Error(ErrorCode::OutOfRange, stage, "the plane is too far from the meshes it cuts");
  return mesh;
}

}  // namespace mortise
