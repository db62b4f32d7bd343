// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lengths, areas, volumes and angles: scaled by powers of two, summed in double-double about the centre of the box.
#include "mortise/mesh/measures.h"

#include <algorithm>
#include <cmath>

#include "mortise/base/trig.h"
#include "mortise/exact/double_double.h"

namespace mortise {
namespace {

using Vec3dd = std::array<DoubleDouble, 3>;

Vec3dd difference(const Vec3d& a, const Vec3d& b) {
  return {DoubleDouble::difference(a.x, b.x), DoubleDouble::difference(a.y, b.y), DoubleDouble::difference(a.z, b.z)};
}

Vec3dd difference(const Vec3dd& a, const Vec3dd& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vec3dd cross(const Vec3dd& a, const Vec3dd& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

DoubleDouble dot(const Vec3dd& a, const Vec3dd& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

double dot_of_rounded(const Vec3dd& a, const Vec3dd& b) { return (a[0].hi * b[0].hi + a[1].hi * b[1].hi) + a[2].hi * b[2].hi; }

double largest_size(const Vec3d& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

double largest_size(const Vec3dd& p) { return std::max({std::fabs(p[0].hi), std::fabs(p[1].hi), std::fabs(p[2].hi)}); }

/// The e with size / 2^e in [1/2, 1); 0 for zero.
int exponent_of(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return exponent;
}

Vec3d scale(const Vec3d& p, int exponent) { return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)}; }

Vec3dd scale(const Vec3dd& p, int exponent) {
  Vec3dd scaled;
  for (std::size_t i = 0; i < 3; ++i) scaled[i] = {std::ldexp(p[i].hi, exponent), std::ldexp(p[i].lo, exponent), 0};
  return scaled;
}

double length_of(const Vec3dd& p) {
  const int exponent = exponent_of(largest_size(p));
  const Vec3dd scaled = scale(p, -exponent);
  return std::ldexp(std::sqrt(dot_of_rounded(scaled, scaled)), exponent);
}

/// The shape of a triangle, its longest side about 1.
struct TriangleShape {
  Vec3dd ab, ac;
  double twice_area = 0;
  int exponent = 0;  ///< lengths times 2^exponent are the true ones
};

TriangleShape shape_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  TriangleShape shape;
  const int outer = exponent_of(std::max({largest_size(a), largest_size(b), largest_size(c)}));
  const Vec3d origin = scale(a, -outer);
  const Vec3dd ab = difference(scale(b, -outer), origin);
  const Vec3dd ac = difference(scale(c, -outer), origin);
  const int inner = exponent_of(std::max(largest_size(ab), largest_size(ac)));
  shape.ab = scale(ab, -inner);
  shape.ac = scale(ac, -inner);
  shape.twice_area = length_of(cross(shape.ab, shape.ac));
  shape.exponent = outer + inner;
  return shape;
}

TriangleShape shape_of(const SurfaceMesh& mesh, const Triangle& t) {
  return shape_of(mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()]);
}

std::array<double, 3> angles_of(const TriangleShape& shape) {
  const Vec3dd bc = difference(shape.ac, shape.ab);
  const double at_a = dot_of_rounded(shape.ab, shape.ac);
  const double at_b = -dot_of_rounded(shape.ab, bc);
  const double at_c = dot_of_rounded(shape.ac, bc);
  std::array<double, 3> angles{};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    const double cosine = i == 0 ? at_a : i == 1 ? at_b : at_c;
    angles[i] = cosine == 0 && shape.twice_area == 0 ? 0 : trig::to_degrees(trig::atan2(shape.twice_area, cosine));
  }
  return angles;
}

}  // namespace

double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const TriangleShape shape = shape_of(a, b, c);
  return std::ldexp(shape.twice_area, 2 * shape.exponent - 1);
}

std::array<double, 3> triangle_angles_deg(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return angles_of(shape_of(a, b, c)); }

Box3 bounding_box(const SurfaceMesh& mesh) {
  Box3 box;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) box.extend(mesh.points[v.index()]);
  }
  return box;
}

double surface_area(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Box3 box = bounding_box(mesh);
  const int exponent = exponent_of(std::max(largest_size(box.lo), largest_size(box.hi)));
  DoubleDouble twice_area;
  for (const Triangle& t : mesh.triangles) {
    const TriangleShape shape = shape_of(mesh, t);
    twice_area = twice_area + DoubleDouble{std::ldexp(shape.twice_area, 2 * (shape.exponent - exponent)), 0, 0};
  }
  return std::ldexp(twice_area.hi, 2 * exponent - 1);
}

double enclosed_volume(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Box3 box = bounding_box(mesh);
  std::array<int, 3> exponents{};
  Vec3d centre;
  for (std::size_t i = 0; i < 3; ++i) {
    exponents[i] = exponent_of(std::max(std::fabs(box.lo[i]), std::fabs(box.hi[i])));
    centre[i] = 0.5 * (std::ldexp(box.lo[i], -exponents[i]) + std::ldexp(box.hi[i], -exponents[i]));
  }
  const auto from_centre = [&](const Vec3d& p) {
    Vec3dd scaled;
    for (std::size_t i = 0; i < 3; ++i) scaled[i] = DoubleDouble::difference(std::ldexp(p[i], -exponents[i]), centre[i]);
    return scaled;
  };
  DoubleDouble six_volumes;
  for (const Triangle& t : mesh.triangles) {
    const Vec3dd a = from_centre(mesh.points[t[0].index()]);
    const Vec3dd b = from_centre(mesh.points[t[1].index()]);
    const Vec3dd c = from_centre(mesh.points[t[2].index()]);
    six_volumes = six_volumes + dot(a, cross(b, c));
  }
  return std::ldexp((six_volumes / DoubleDouble{6, 0, 0}).hi, exponents[0] + exponents[1] + exponents[2]);
}

AngleRange angle_range(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  AngleRange range{180, 0};
  for (const Triangle& t : mesh.triangles) {
    for (const double angle : angles_of(shape_of(mesh, t))) {
      range.min_deg = std::min(range.min_deg, angle);
      range.max_deg = std::max(range.max_deg, angle);
    }
  }
  return range;
}

}  // namespace mortise
