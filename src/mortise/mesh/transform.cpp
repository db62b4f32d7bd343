// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Affine maps of meshes, always in the same order of operations.
#include "mortise/mesh/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/corner_data.h"
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

bool has_no_value(const Vec3d& v) { return is_no_value(v.x) || is_no_value(v.y) || is_no_value(v.z); }

/// Length by components of growing size: the same for a vector with axes exchanged.
double length_of_sorted(const Vec3d& v) {
  std::array<double, 3> sizes{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
  std::sort(sizes.begin(), sizes.end());
  return length({sizes[0], sizes[1], sizes[2]});
}

/// Turns normals: the inverse transposed linear part of a map, up to a positive factor.
class NormalMap {
 public:
  explicit NormalMap(const AffineMap& map) {
    double largest = 0;
    for (const Vec3d& row : map.linear) largest = std::max({largest, std::fabs(row.x), std::fabs(row.y), std::fabs(row.z)});
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    std::array<Vec3d, 3> linear = map.linear;
    for (Vec3d& row : linear) row = {std::ldexp(row.x, -exponent), std::ldexp(row.y, -exponent), std::ldexp(row.z, -exponent)};
    const double side = handedness(map) == Sign::Negative ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) rows_[i] = side * cross(linear[(i + 1) % 3], linear[(i + 2) % 3]);
    const double factor = rows_[0].x;
    is_trivial_ = factor > 0 && rows_ == std::array<Vec3d, 3>{{{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}}};
  }

  [[nodiscard]] Vec3d image(const Vec3d& normal) const {
    if (is_trivial_) return normal;
    const Vec3d turned = product(rows_, normal);
    const double size = length_of_sorted(turned), wanted = length_of_sorted(normal);
    return size > 0 ? (wanted / size) * turned : normal;
  }

 private:
  std::array<Vec3d, 3> rows_;
  bool is_trivial_ = false;
};

template <class Image>
void replace_vectors(DataChannel& channel, const Image& image) {
  std::vector<double>& x = channel.values;
  for (std::size_t i = 0; i + 2 < x.size(); i += 3) {
    const Vec3d before{x[i], x[i + 1], x[i + 2]};
    const Vec3d after = has_no_value(before) ? Vec3d{no_value, no_value, no_value} : image(before);
    if (!has_no_value(before) && !is_finite(after)) {
      throw Error(ErrorCode::OutOfRange, "transform", "the image of a vector of channel '" + channel.name + "' does not fit a double");
    }
    for (std::size_t k = 0; k < 3; ++k) x[i + k] = after[k];
  }
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
  transform_data(map, image);
  if (handedness(map) == Sign::Negative) {
    for (std::size_t f = 0; f < image.triangles.size(); ++f) reverse_corners(FaceId(f), image);
  }
  return image;
}

void transform_data(const AffineMap& map, SurfaceMesh& mesh) {
  if (mesh.vertex_data.empty() && mesh.corner_data.empty()) return;
  const NormalMap normals(map);
  for (std::vector<DataChannel>* channels : {&mesh.vertex_data, &mesh.corner_data}) {
    for (DataChannel& c : *channels) {
      if (c.kind == DataKind::Normal) replace_vectors(c, [&](const Vec3d& v) { return normals.image(v); });
      if (c.kind == DataKind::Vector) replace_vectors(c, [&](const Vec3d& v) { return product(map.linear, v); });
    }
  }
}

}  // namespace mortise
