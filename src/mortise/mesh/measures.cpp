// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lengths, areas, volumes and angles: scaled by powers of two, summed in double-double about the centre of the box.
#include "mortise/mesh/measures.h"

#include <algorithm>
#include <cmath>

#include "mortise/base/bits.h"
#include "mortise/base/trig.h"
#include "mortise/exact/big_float.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/formulas.h"

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
  const auto biased = static_cast<int>(cast_bits<std::uint64_t>(size) >> 52);
  if (biased > 0 && biased < 0x7ff) return biased - 1022;
  int exponent = 0;
  std::frexp(size, &exponent);
  return exponent;
}

/// x * 2^exponent as ldexp gives it, and quickly for all but extreme exponents.
double shifted(double x, int exponent) {
  if (exponent < -1000 || exponent > 1000) return std::ldexp(x, exponent);
  return x * cast_bits<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

Vec3d scale(const Vec3d& p, int exponent) { return {shifted(p.x, exponent), shifted(p.y, exponent), shifted(p.z, exponent)}; }

Vec3dd scale(const Vec3dd& p, int exponent) {
  Vec3dd scaled;
  for (std::size_t i = 0; i < 3; ++i) scaled[i] = {shifted(p[i].hi, exponent), shifted(p[i].lo, exponent), 0};
  return scaled;
}

double length_of(const Vec3dd& p) {
  const int exponent = exponent_of(largest_size(p));
  const Vec3dd scaled = scale(p, -exponent);
  return shifted(std::sqrt(dot_of_rounded(scaled, scaled)), exponent);
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

/// An angle of 0 to 180 degrees by its direction: cosine and sine times any length.
struct Angle {
  double cosine = 1, sine = 0;

  [[nodiscard]] bool operator<(const Angle& other) const {
    const double turn = cosine * other.sine - sine * other.cosine;
    return turn > 0 || (turn == 0 && cosine > 0 && other.cosine < 0);
  }
  [[nodiscard]] double degrees() const { return trig::to_degrees(trig::atan2(sine, cosine)); }
};

std::array<Angle, 3> angles_of(const TriangleShape& shape) {
  const Vec3dd bc = difference(shape.ac, shape.ab);
  const std::array<double, 3> cosines{dot_of_rounded(shape.ab, shape.ac), -dot_of_rounded(shape.ab, bc), dot_of_rounded(shape.ac, bc)};
  std::array<Angle, 3> angles;
  for (std::size_t i = 0; i < 3; ++i) {
    if (cosines[i] != 0 || shape.twice_area != 0) angles[i] = {cosines[i], shape.twice_area};
  }
  return angles;
}

/// Of the tetrahedra from the centre to all faces, coordinates scaled: what cancels in double-double.
double exact_six_volumes(const SurfaceMesh& mesh, const std::array<int, 3>& exponents, const Vec3d& centre) {
  const auto scaled = [&](VertexId v) {
    const Vec3d& p = mesh.points[v.index()];
    return Vec3d{shifted(p.x, -exponents[0]), shifted(p.y, -exponents[1]), shifted(p.z, -exponents[2])};
  };
  BigFloat sum;
  for (const Triangle& t : mesh.triangles) sum = sum + orient3d_value<BigFloat>(scaled(t[0]), scaled(t[2]), scaled(t[1]), centre);
  const auto [value, exponent] = sum.leading();
  return std::ldexp(value, exponent);
}

}  // namespace

double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const TriangleShape shape = shape_of(a, b, c);
  return std::ldexp(shape.twice_area, 2 * shape.exponent - 1);
}

std::array<double, 3> triangle_angles_deg(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const std::array<Angle, 3> angles = angles_of(shape_of(a, b, c));
  return {angles[0].degrees(), angles[1].degrees(), angles[2].degrees()};
}

Box3 bounding_box(const SurfaceMesh& mesh) {
  Box3 box;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) box.extend(mesh.points[v.index()]);
  }
  return box;
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
    for (std::size_t i = 0; i < 3; ++i) scaled[i] = DoubleDouble::difference(shifted(p[i], -exponents[i]), centre[i]);
    return scaled;
  };
  DoubleDouble six_volumes;
  for (const Triangle& t : mesh.triangles) {
    const Vec3dd a = from_centre(mesh.points[t[0].index()]);
    const Vec3dd b = from_centre(mesh.points[t[1].index()]);
    const Vec3dd c = from_centre(mesh.points[t[2].index()]);
    six_volumes = six_volumes + dot(a, cross(b, c));
  }
  const int exponent = exponents[0] + exponents[1] + exponents[2];
  if (!certain_sign(six_volumes)) return std::ldexp(exact_six_volumes(mesh, exponents, centre) / 6, exponent);
  return std::ldexp((six_volumes / DoubleDouble{6, 0, 0}).hi, exponent);
}

FaceMeasures measure_faces(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const Box3 box = bounding_box(mesh);
  const int exponent = exponent_of(std::max(largest_size(box.lo), largest_size(box.hi)));
  DoubleDouble twice_area;
  Angle smallest{-1, 0}, largest{1, 0};
  for (const Triangle& t : mesh.triangles) {
    const TriangleShape shape = shape_of(mesh, t);
    twice_area = twice_area + DoubleDouble{shifted(shape.twice_area, 2 * (shape.exponent - exponent)), 0, 0};
    for (const Angle& angle : angles_of(shape)) {
      smallest = std::min(smallest, angle);
      largest = std::max(largest, angle);
    }
  }
  return {std::ldexp(twice_area.hi, 2 * exponent - 1), {smallest.degrees(), largest.degrees()}};
}

}  // namespace mortise
