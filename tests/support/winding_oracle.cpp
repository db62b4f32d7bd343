// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rays from the middle of a facet, in integers: all positions times a common denominator.
#include "support/winding_oracle.h"

#include <optional>
#include <stdexcept>
#include <string>

#include "support/exact_points.h"

namespace mortise::test {
namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Vector = std::array<Integer, 3>;

Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Integer dot_product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Integer common_multiple(const Integer& a, const Integer& b) { return a / gcd(a, b) * b; }

/// The point times `scale`, a multiple of its denominators.
Vector whole(const oracle::RationalPoint& p, const Integer& scale) {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = Integer(numerator(p[i])) * (scale / Integer(denominator(p[i])));
  return result;
}

Integer common_denominator(const oracle::RationalPoint& p, Integer denominators) {
  for (const oracle::Rational& x : p) denominators = common_multiple(denominators, Integer(denominator(x)));
  return denominators;
}

struct WholeFace {
  std::size_t operand;
  std::array<Vector, 3> corners;
};

class Rays {
 public:
  explicit Rays(const Arrangement& scene) : scene_(scene), at_(exact_points(scene)) {
    for (std::size_t f = 0; f < scene.faces.corners.size(); ++f) {
      for (const PointId p : scene.faces.corners[SourceId(f)]) grid_ = common_denominator(at_[p.index()], grid_);
    }
    for (std::size_t f = 0; f < scene.faces.corners.size(); ++f) {
      const SourceId id(f);
      if (scene.faces.shape[id] != FaceShape::Proper) continue;
      const PlanePoints& c = scene.faces.corners[id];
      const auto corner = [&](std::size_t i) { return whole(at_[c[i].index()], grid_); };
      faces_.push_back({scene.faces.operand[id].index(), {corner(0), corner(1), corner(2)}});
    }
  }

  [[nodiscard]] WindingsBeside beside(FacetId f) const {
    const PlanePoints& c = scene_.facets.corners[f];
    const oracle::RationalPoint &a = at_[c[0].index()], &b = at_[c[1].index()], &d = at_[c[2].index()];
    oracle::RationalPoint middle, normal;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      middle[i] = (a[i] + b[i] + d[i]) / 3;
      normal[i] = (b[j] - a[j]) * (d[k] - a[k]) - (b[k] - a[k]) * (d[j] - a[j]);
    }
    for (int attempt = 1; attempt < 1000; ++attempt) {
      const auto windings = shoot(middle, whole(normal, common_denominator(normal, 1)), attempt);
      if (windings) return *windings;
    }
    throw std::logic_error("the middle of facet " + std::to_string(f.index()) + " lies on an edge");
  }

 private:
  /// Windings by a ray that leaves the middle in front of the facet; nothing when it meets an edge.
  [[nodiscard]] std::optional<WindingsBeside> shoot(const oracle::RationalPoint& middle, const Vector& normal, int attempt) const {
    Vector ray{Integer(1009), Integer(31 * attempt + 7), Integer(attempt * attempt - 500)};
    const Integer forward = dot_product(ray, normal);
    if (forward.is_zero()) return std::nullopt;
    if (forward < 0) ray = {-ray[0], -ray[1], -ray[2]};
    const Integer scale = common_denominator(middle, 1);
    const Vector from = whole(middle, scale * grid_);
    WindingsBeside result{std::vector<int>(scene_.operands.size(), 0), {}};
    std::vector<int> step(scene_.operands.size(), 0);
    for (const WholeFace& face : faces_) {
      std::array<Vector, 3> v;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t x = 0; x < 3; ++x) v[i][x] = face.corners[i][x] * scale - from[x];
      }
      std::array<int, 3> side{};
      for (std::size_t i = 0; i < 3; ++i) side[i] = dot_product(ray, cross_product(v[i], v[(i + 1) % 3])).sign();
      if (side[0] * side[1] < 0 || side[1] * side[2] < 0 || side[2] * side[0] < 0) continue;
      if (side[0] == 0 || side[1] == 0 || side[2] == 0) return std::nullopt;
      const int distance = dot_product(v[0], cross_product(v[1], v[2])).sign() * side[0];
      if (distance > 0) result.front[face.operand] += side[0];
      if (distance == 0) step[face.operand] += side[0];
    }
    result.back = result.front;
    for (std::size_t k = 0; k < step.size(); ++k) result.back[k] += step[k];
    return result;
  }

  const Arrangement& scene_;
  std::vector<oracle::RationalPoint> at_;
  Integer grid_ = 1;
  std::vector<WholeFace> faces_;
};

}  // namespace

std::vector<WindingsBeside> windings_beside_facets(const Arrangement& scene) {
  const Rays rays(scene);
  std::vector<WindingsBeside> result;
  for (std::size_t i = 0; i < scene.facets.size(); ++i) result.push_back(rays.beside(FacetId(i)));
  return result;
}

}  // namespace mortise::test
