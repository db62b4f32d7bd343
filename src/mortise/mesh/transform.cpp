// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Affine maps of meshes, always in the same order of operations.
#include "mortise/mesh/transform.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"
#include "mortise/exact/predicates.h"
#include "mortise/mesh/face_marks.h"

namespace mortise {
namespace {

bool is_finite(const Vec3d& p) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::fabs(p.x) <= largest && std::fabs(p.y) <= largest && std::fabs(p.z) <= largest;
}

double sum_of_products(const Vec3d& row, const Vec3d& p) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (row[i] != 0) sum = sum == 0 ? row[i] * p[i] : sum + row[i] * p[i];
  }
  return sum;
}

Vec3d product(const std::array<Vec3d, 3>& rows, const Vec3d& p) {
  return {sum_of_products(rows[0], p), sum_of_products(rows[1], p), sum_of_products(rows[2], p)};
}

Vec3d column(const std::array<Vec3d, 3>& rows, std::size_t i) { return {rows[0][i], rows[1][i], rows[2][i]}; }

/// Sign of the determinant, exactly.
Sign handedness(const AffineMap& map) { return orient3d(Vec3d{}, column(map.linear, 0), column(map.linear, 1), column(map.linear, 2)); }

void check_invertible(const AffineMap& map) {
  const bool finite = is_finite(map.linear[0]) && is_finite(map.linear[1]) && is_finite(map.linear[2]) && is_finite(map.offset);
  if (!finite) throw Error(ErrorCode::InvalidArgument, "transform", "the map has an entry that is not a finite number");
  if (handedness(map) == Sign::Zero) throw Error(ErrorCode::InvalidArgument, "transform", "the map flattens the mesh: it has no inverse");
}

}  // namespace

AffineMap scaling(const Vec3d& factors) { return {{{{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}}}, {}}; }

AffineMap rotation(Axis axis, double degrees) {
  const std::size_t from = (static_cast<std::size_t>(axis) + 1) % 3;
  const std::size_t to = (from + 1) % 3;
  const double cosine = trig::cos_deg(degrees);
  const double sine = trig::sin_deg(degrees);
  AffineMap map;
  map.linear[from][from] = cosine;
  map.linear[from][to] = -sine;
  map.linear[to][from] = sine;
  map.linear[to][to] = cosine;
  return map;
}

AffineMap translation(const Vec3d& offset) {
  AffineMap map;
  map.offset = offset;
  return map;
}

AffineMap mirroring(Axis axis) {
  AffineMap map;
  const auto i = static_cast<std::size_t>(axis);
  map.linear[i][i] = -1;
  return map;
}

AffineMap compose(const AffineMap& first, const AffineMap& second) {
  AffineMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) map.linear[i][j] = sum_of_products(second.linear[i], column(first.linear, j));
  }
  map.offset = product(second.linear, first.offset) + second.offset;
  return map;
}

Vec3d apply(const AffineMap& map, const Vec3d& p) {
  Vec3d image = product(map.linear, p);
  for (std::size_t i = 0; i < 3; ++i) {
    if (map.offset[i] != 0) image[i] += map.offset[i];
  }
  return image;
}

SurfaceMesh transform(const SurfaceMesh& mesh, const AffineMap& map) {
  check_invertible(map);
  SurfaceMesh image = mesh;
  std::vector<std::uint32_t> too_large;
  for (std::size_t v = 0; v < image.points.size(); ++v) {
    image.points[v] = apply(map, mesh.points[v]);
    if (!is_finite(image.points[v])) too_large.push_back(static_cast<std::uint32_t>(v));
  }
  if (!too_large.empty()) {
    throw Error(ErrorCode::OutOfRange, "transform", "the image of a vertex does not fit a double")
        .with_ids(IdKind::Vertices, std::move(too_large));
  }
  if (handedness(map) == Sign::Negative) {
    for (std::size_t f = 0; f < image.triangles.size(); ++f) turn_over(FaceId(f), image);
  }
  return image;
}

}  // namespace mortise
