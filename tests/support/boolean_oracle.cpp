// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rational geometry by brute force: windings, volumes, and the points that triangles make.
#include "support/boolean_oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace mortise::oracle {
namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Tetrahedron = std::array<RationalPoint, 4>;
template <class Number>
using Vector = std::array<Number, 3>;

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

template <class Number>
Vector<Number> cross_product(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Number dot_product(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Number determinant(const Vector<Number>& a, const Vector<Number>& b, const Vector<Number>& c) {
  return dot_product(cross_product(a, b), c);
}

/// A double as an odd or zero integer times a power of two.
std::pair<long long, int> odd_mantissa(double value) {
  int exponent = 0;
  auto mantissa = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  while (mantissa != 0 && mantissa % 2 == 0) mantissa /= 2, ++exponent;
  return {mantissa, exponent};
}

/// The largest e such that every coordinate used is a whole multiple of 2^e.
int grid_exponent(const SurfaceMesh& mesh) {
  int exponent = 1024;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = mesh.points[v.index()][i];
        if (x != 0) exponent = std::min(exponent, odd_mantissa(x).second);
      }
    }
  }
  return exponent;
}

Vector<Integer> on_grid(const Vec3d& p, int exponent) {
  Vector<Integer> whole;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [mantissa, own_exponent] = odd_mantissa(p[i]);
    if (mantissa != 0) whole[i] = Integer(mantissa) << static_cast<unsigned>(own_exponent - exponent);
  }
  return whole;
}

Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

bool is_zero(const RationalPoint& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

RationalPoint between(const RationalPoint& a, const RationalPoint& b, const Rational& t) {
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
  return p;
}

/// normal . p = offset
struct Plane {
  RationalPoint normal;
  Rational offset;

  [[nodiscard]] Rational height(const RationalPoint& p) const { return dot_product(normal, p) - offset; }
};

/// A triangle with its plane; corners in doubles serve for box tests only.
struct Facet {
  Corners corners;
  std::array<RationalPoint, 3> points;
  Plane plane;
  std::size_t operand = 0;
};

Facet make_facet(const Corners& corners, std::size_t operand) {
  Facet facet{corners, {exact(corners[0]), exact(corners[1]), exact(corners[2])}, {}, operand};
  facet.plane.normal = cross_product(minus(facet.points[1], facet.points[0]), minus(facet.points[2], facet.points[0]));
  facet.plane.offset = dot_product(facet.plane.normal, facet.points[0]);
  return facet;
}

bool corners_meet(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::max({a[0][i], a[1][i], a[2][i]}) < std::min({b[0][i], b[1][i], b[2][i]})) return false;
    if (std::max({b[0][i], b[1][i], b[2][i]}) < std::min({a[0][i], a[1][i], a[2][i]})) return false;
  }
  return true;
}

/// Is a point of the facet's plane in the closed facet?
bool contains(const Facet& facet, const RationalPoint& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint& from = facet.points[i];
    const RationalPoint side = cross_product(minus(facet.points[(i + 1) % 3], from), minus(p, from));
    if (dot_product(side, facet.plane.normal) < 0) return false;
  }
  return true;
}

bool is_in_segment(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  return dot_product(minus(a, p), minus(b, p)) <= 0;
}

std::optional<RationalPoint> line_through_plane(const RationalPoint& a, const RationalPoint& b, const Plane& plane) {
  const Rational height_a = plane.height(a);
  const Rational slope = height_a - plane.height(b);
  if (slope.is_zero()) return std::nullopt;
  return between(a, b, height_a / slope);
}

/// Where two lines cross; nothing when they are parallel or pass one another.
std::optional<RationalPoint> crossing_of_lines(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                                               const RationalPoint& d) {
  const RationalPoint along = minus(b, a);
  const RationalPoint normal = cross_product(along, minus(d, c));
  if (is_zero(normal) || !dot_product(normal, minus(c, a)).is_zero()) return std::nullopt;
  const RationalPoint across = cross_product(minus(c, a), minus(d, c));
  return between(a, b, dot_product(across, normal) / dot_product(normal, normal));
}

std::optional<RationalPoint> common_point(const Plane& p, const Plane& q, const Plane& r) {
  const Rational det = determinant(p.normal, q.normal, r.normal);
  if (det.is_zero()) return std::nullopt;
  const RationalPoint qr = cross_product(q.normal, r.normal);
  const RationalPoint rp = cross_product(r.normal, p.normal);
  const RationalPoint pq = cross_product(p.normal, q.normal);
  RationalPoint point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = (p.offset * qr[i] + q.offset * rp[i] + r.offset * pq[i]) / det;
  return point;
}

// ---- windings ----

/// +1 or -1 when the ray passes through the inside of the facet from behind or from the front, 0 when it misses the closed
/// facet; nothing when it touches its border or runs in its plane.
std::optional<int> ray_crossing(const RationalPoint& origin, const RationalPoint& direction, const Facet& facet) {
  std::array<int, 3> side{};
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint a = minus(facet.points[i], origin), b = minus(facet.points[(i + 1) % 3], origin);
    side[i] = determinant(direction, a, b).sign();
  }
  const bool outside = *std::min_element(side.begin(), side.end()) < 0 && *std::max_element(side.begin(), side.end()) > 0;
  if (outside) return 0;
  const int slope = dot_product(direction, facet.plane.normal).sign();
  if (slope == 0) return facet.plane.height(origin).is_zero() ? std::nullopt : std::optional<int>(0);
  if (side[0] == 0 || side[1] == 0 || side[2] == 0) return std::nullopt;
  return facet.plane.height(origin).sign() * slope < 0 ? slope : 0;
}

std::optional<int> winding_along(const std::vector<Facet>& facets, const RationalPoint& origin, const RationalPoint& direction) {
  int winding = 0;
  for (const Facet& facet : facets) {
    const std::optional<int> crossing = ray_crossing(origin, direction, facet);
    if (!crossing) return std::nullopt;
    winding += *crossing;
  }
  return winding;
}

std::vector<Facet> facets_of(const SurfaceMesh& mesh, std::size_t operand) {
  std::vector<Facet> facets;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    Facet facet = make_facet(corners_of(mesh, f), operand);
    if (!is_zero(facet.plane.normal)) facets.push_back(std::move(facet));
  }
  return facets;
}

// ---- volumes ----

Rational six_volume(const Tetrahedron& t) { return determinant(minus(t[1], t[0]), minus(t[2], t[0]), minus(t[3], t[0])); }

/// Tetrahedra that add up, with their orientation as sign, to the solid.
std::vector<Tetrahedron> signed_tetrahedra(const SurfaceMesh& mesh) {
  std::vector<Tetrahedron> result;
  if (mesh.triangles.empty()) return result;
  const RationalPoint apex = exact(mesh.points[mesh.triangles[0][0].index()]);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Corners c = corners_of(mesh, f);
    const Tetrahedron t{apex, exact(c[0]), exact(c[1]), exact(c[2])};
    if (!six_volume(t).is_zero()) result.push_back(t);
  }
  return result;
}

/// Replaces a tetrahedron by the part of it on the side where heights are not negative.
void clip_one(const Tetrahedron& t, const std::array<Rational, 4>& height, std::vector<Tetrahedron>& result) {
  std::vector<std::size_t> in, out;
  for (std::size_t i = 0; i < 4; ++i) (height[i] >= 0 ? in : out).push_back(i);
  const auto cut = [&](std::size_t i, std::size_t o) { return between(t[i], t[o], height[i] / (height[i] - height[o])); };
  const auto add_prism = [&](const std::array<RationalPoint, 3>& a, const std::array<RationalPoint, 3>& b) {
    result.push_back({a[0], a[1], a[2], b[0]});
    result.push_back({a[1], a[2], b[0], b[1]});
    result.push_back({a[2], b[0], b[1], b[2]});
  };
  if (out.empty()) result.push_back(t);
  if (in.size() == 1) result.push_back({t[in[0]], cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2])});
  if (in.size() == 2) {
    add_prism({t[in[0]], cut(in[0], out[0]), cut(in[0], out[1])}, {t[in[1]], cut(in[1], out[0]), cut(in[1], out[1])});
  }
  if (in.size() == 3) add_prism({t[in[0]], t[in[1]], t[in[2]]}, {cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0])});
}

std::vector<Tetrahedron> clip(const std::vector<Tetrahedron>& pieces, const Plane& plane) {
  std::vector<Tetrahedron> clipped;
  for (const Tetrahedron& t : pieces) {
    clip_one(t, {plane.height(t[0]), plane.height(t[1]), plane.height(t[2]), plane.height(t[3])}, clipped);
  }
  std::erase_if(clipped, [](const Tetrahedron& t) { return six_volume(t).is_zero(); });
  return clipped;
}

/// The parts of the pieces inside a tetrahedron of either orientation.
std::vector<Tetrahedron> clip_by_tetrahedron(std::vector<Tetrahedron> pieces, const Tetrahedron& by) {
  for (std::size_t i = 0; i < 4 && !pieces.empty(); ++i) {
    const RationalPoint &a = by[(i + 1) % 4], &b = by[(i + 2) % 4], &c = by[(i + 3) % 4];
    Plane plane{cross_product(minus(b, a), minus(c, a)), 0};
    plane.offset = dot_product(plane.normal, a);
    if (plane.height(by[i]) < 0) {
      for (Rational& n : plane.normal) n = -n;
      plane.offset = -plane.offset;
    }
    pieces = clip(pieces, plane);
  }
  return pieces;
}

Rational common_six_volume(const std::vector<Tetrahedron>& pieces, std::span<const SurfaceMesh* const> rest) {
  if (rest.empty()) {
    Rational sum = 0;
    for (const Tetrahedron& t : pieces) sum += abs(six_volume(t));
    return sum;
  }
  Rational sum = 0;
  for (const Tetrahedron& by : signed_tetrahedra(*rest[0])) {
    const std::vector<Tetrahedron> inside = clip_by_tetrahedron(pieces, by);
    if (!inside.empty()) sum += six_volume(by).sign() * common_six_volume(inside, rest.subspan(1));
  }
  return sum;
}

/// Sum over the subsets of at least one operand, odd ones positive, `always` being in every subset.
Rational included_volume(std::span<const SurfaceMesh* const> operands, const SurfaceMesh* always) {
  Rational sum = 0;
  for (std::size_t subset = 1; subset < (std::size_t{1} << operands.size()); ++subset) {
    std::vector<const SurfaceMesh*> chosen;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(operands[i]);
    }
    const bool odd = chosen.size() % 2 == 1;
    if (always != nullptr) chosen.insert(chosen.begin(), always);
    sum += odd ? common_volume(chosen) : -common_volume(chosen);
  }
  return sum;
}

/// Volume inside an odd number of operands: sum of (-2)^(n - 1) times the common volume, over all choices of n operands.
Rational odd_volume(std::span<const SurfaceMesh* const> operands) {
  Rational sum = 0;
  for (std::size_t subset = 1; subset < (std::size_t{1} << operands.size()); ++subset) {
    std::vector<const SurfaceMesh*> chosen;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(operands[i]);
    }
    int factor = 1;
    for (std::size_t i = 1; i < chosen.size(); ++i) factor *= -2;
    sum += factor * common_volume(chosen);
  }
  return sum;
}

// ---- made points ----

void add_coplanar_crossings(const Facet& f, const Facet& g, std::vector<RationalPoint>& points) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const RationalPoint &a = f.points[i], &b = f.points[(i + 1) % 3], &c = g.points[j], &d = g.points[(j + 1) % 3];
      const std::optional<RationalPoint> p = crossing_of_lines(a, b, c, d);
      if (p && is_in_segment(a, b, *p) && is_in_segment(c, d, *p)) points.push_back(*p);
    }
  }
}

void add_edge_points(const Facet& edges, const Facet& face, std::vector<RationalPoint>& points) {
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint &a = edges.points[i], &b = edges.points[(i + 1) % 3];
    const std::optional<RationalPoint> p = line_through_plane(a, b, face.plane);
    if (p && is_in_segment(a, b, *p) && contains(face, *p)) points.push_back(*p);
  }
}

bool are_coplanar(const Facet& f, const Facet& g) {
  return std::all_of(g.points.begin(), g.points.end(), [&](const RationalPoint& p) { return f.plane.height(p).is_zero(); });
}

void add_pair_points(const Facet& f, const Facet& g, std::vector<RationalPoint>& points) {
  if (are_coplanar(f, g)) return add_coplanar_crossings(f, g, points);
  add_edge_points(f, g, points);
  add_edge_points(g, f, points);
}

bool less_rounded(const MadePoint& a, const MadePoint& b) {
  return std::array{a.rounded.x, a.rounded.y, a.rounded.z} < std::array{b.rounded.x, b.rounded.y, b.rounded.z};
}

std::vector<MadePoint> round_once(std::vector<RationalPoint> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<MadePoint> made;
  for (const RationalPoint& p : points) made.push_back({p, nearest_double(p)});
  std::stable_sort(made.begin(), made.end(), less_rounded);
  return made;
}

void add_triple_points(const std::vector<Facet>& facets, const std::vector<std::vector<std::size_t>>& meets,
                       std::vector<RationalPoint>& points) {
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t m = 0; m < meets[i].size(); ++m) {
      for (std::size_t n = m + 1; n < meets[i].size(); ++n) {
        const Facet &f = facets[i], &g = facets[meets[i][m]], &h = facets[meets[i][n]];
        if (!corners_meet(g.corners, h.corners)) continue;
        const std::optional<RationalPoint> p = common_point(f.plane, g.plane, h.plane);
        if (p && contains(f, *p) && contains(g, *p) && contains(h, *p)) points.push_back(*p);
      }
    }
  }
}

// ---- points from the faces around a vertex ----

std::vector<Facet> without_parallel(const std::vector<Facet>& facets) {
  std::vector<Facet> different;
  for (const Facet& facet : facets) {
    const auto parallel = [&](const Facet& other) { return is_zero(cross_product(facet.plane.normal, other.plane.normal)); };
    if (std::none_of(different.begin(), different.end(), parallel)) different.push_back(facet);
  }
  return different;
}

std::optional<RationalPoint> first_common_point(const std::vector<Facet>& planes) {
  for (std::size_t i = 2; i < planes.size(); ++i) {
    if (const auto p = common_point(planes[0].plane, planes[1].plane, planes[i].plane)) return p;
  }
  return std::nullopt;
}

std::vector<Facet> proper_facets(const std::vector<Corners>& faces) {
  std::vector<Facet> facets;
  for (const Corners& corners : faces) facets.push_back(make_facet(corners, 0));
  std::erase_if(facets, [](const Facet& facet) { return is_zero(facet.plane.normal); });
  return facets;
}

/// Corners in ascending order: the same for both faces of an edge.
using Edge = std::array<Vec3d, 2>;

bool passes_near(const Edge& edge, const Vec3d& vertex) {
  const Vec3d along = edge[1] - edge[0], to = vertex - edge[0];
  const Vec3d off = cross(along, to);
  const double length_squared = dot(along, along), limit = 1e-6 * length_squared;
  return dot(off, off) <= limit * limit && dot(to, along) >= -limit && dot(to, along) <= length_squared + limit;
}

std::vector<Edge> edges_near(const std::vector<Facet>& facets, const Vec3d& vertex) {
  const auto less = [](const Vec3d& a, const Vec3d& b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; };
  std::vector<Edge> edges;
  for (const Facet& facet : facets) {
    for (std::size_t i = 0; i < 3; ++i) {
      Edge edge{facet.corners[i], facet.corners[(i + 1) % 3]};
      if (less(edge[1], edge[0])) std::swap(edge[0], edge[1]);
      if (passes_near(edge, vertex) && std::find(edges.begin(), edges.end(), edge) == edges.end()) edges.push_back(edge);
    }
  }
  return edges;
}

std::vector<RationalPoint> edge_candidates(const std::vector<Facet>& facets, const Vec3d& vertex) {
  const std::vector<Edge> edges = edges_near(facets, vertex);
  std::vector<RationalPoint> candidates;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const RationalPoint a = exact(edges[i][0]), b = exact(edges[i][1]);
    for (const Facet& facet : facets) {
      if (const auto p = line_through_plane(a, b, facet.plane)) candidates.push_back(*p);
    }
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (const auto p = crossing_of_lines(a, b, exact(edges[j][0]), exact(edges[j][1]))) candidates.push_back(*p);
    }
  }
  return candidates;
}

}  // namespace

Rational exact(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a rational of a number that is not finite");
  const auto [mantissa, exponent] = odd_mantissa(value);
  return mantissa == 0 ? Rational(0) : Rational(Integer(mantissa)) * power_of_two(exponent);
}

RationalPoint exact(const Vec3d& point) { return {exact(point.x), exact(point.y), exact(point.z)}; }

double nearest_double(const Rational& value) {
  if (value.is_zero()) return 0.0;
  const Integer top = abs(numerator(value)), bottom = denominator(value);
  // The quotient has 2^lowest as its last bit: 53 bits of it, fewer for subnormal numbers.
  const int size = static_cast<int>(msb(top)) - static_cast<int>(msb(bottom));
  const int lowest = std::max(size - 54, -1074);
  const Integer scaled_top = lowest < 0 ? Integer(top << static_cast<unsigned>(-lowest)) : top;
  const Integer scaled_bottom = lowest > 0 ? Integer(bottom << static_cast<unsigned>(lowest)) : bottom;
  Integer quotient, rest;
  divide_qr(scaled_top, scaled_bottom, quotient, rest);
  // One or two bits too many are dropped with everything below them.
  unsigned extra = quotient.is_zero() || msb(quotient) < 53 ? 0 : static_cast<unsigned>(msb(quotient)) - 52;
  const Integer kept = quotient >> extra;
  const Integer dropped = (quotient - (kept << extra)) * scaled_bottom + rest;
  const Integer twice = dropped * 2, unit = scaled_bottom << extra;
  const bool up = twice > unit || (twice == unit && bit_test(kept, 0));
  const double mantissa = static_cast<double>(static_cast<unsigned long long>(up ? kept + 1 : kept));
  const double magnitude = std::ldexp(mantissa, lowest + static_cast<int>(extra));
  return value < 0 ? -magnitude : magnitude;
}

Vec3d nearest_double(const RationalPoint& point) { return {nearest_double(point[0]), nearest_double(point[1]), nearest_double(point[2])}; }

int orient3d(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
  return determinant(minus(b, a), minus(c, a), minus(d, a)).sign();
}

Corners corners_of(const SurfaceMesh& mesh, std::size_t face) {
  const Triangle& t = mesh.triangles[face];
  return {mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()]};
}

std::optional<int> winding_number(const SurfaceMesh& mesh, const RationalPoint& point) {
  const std::vector<Facet> facets = facets_of(mesh, 0);
  for (const Facet& facet : facets) {
    if (facet.plane.height(point).is_zero() && contains(facet, point)) return std::nullopt;
  }
  for (int attempt = 1;; ++attempt) {
    const RationalPoint direction{Rational(1), Rational(attempt, 7 + attempt * attempt), Rational(attempt * attempt, 1001)};
    if (const std::optional<int> winding = winding_along(facets, point, direction)) return winding;
  }
}

Rational volume(const SurfaceMesh& mesh) {
  // On a common grid of a power of two the sum is one of integers, without a common divisor to look for.
  const int exponent = grid_exponent(mesh);
  Integer sum = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Corners c = corners_of(mesh, f);
    sum += determinant(on_grid(c[0], exponent), on_grid(c[1], exponent), on_grid(c[2], exponent));
  }
  return Rational(sum) * power_of_two(3 * exponent) / 6;
}

Rational volume(const SurfaceMesh& mesh, const std::vector<RationalPoint>& positions) {
  Rational sum = 0;
  for (const Triangle& t : mesh.triangles) sum += determinant(positions[t[0].index()], positions[t[1].index()], positions[t[2].index()]);
  return sum / 6;
}

Rational common_volume(std::span<const SurfaceMesh* const> operands) {
  Rational sum = 0;
  for (const Tetrahedron& t : signed_tetrahedra(*operands[0])) sum += six_volume(t).sign() * common_six_volume({t}, operands.subspan(1));
  return sum / 6;
}

Rational boolean_volume(Operation operation, std::span<const SurfaceMesh* const> operands) {
  if (operands.size() > 6) throw std::invalid_argument("inclusion and exclusion of more than six operands");
  if (operation == Operation::Intersect) return common_volume(operands);
  if (operation == Operation::Union) return included_volume(operands, nullptr);
  if (operation == Operation::SymmetricDifference) return odd_volume(operands);
  return volume(*operands[0]) - included_volume(operands.subspan(1), operands[0]);
}

std::vector<MadePoint> made_points(std::span<const SurfaceMesh* const> operands, bool self) {
  std::vector<Facet> facets;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    for (Facet& facet : facets_of(*operands[k], k)) facets.push_back(std::move(facet));
  }
  std::vector<RationalPoint> points;
  std::vector<std::vector<std::size_t>> meets(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t j = i + 1; j < facets.size(); ++j) {
      if (!corners_meet(facets[i].corners, facets[j].corners)) continue;
      if (self || facets[i].operand != facets[j].operand) add_pair_points(facets[i], facets[j], points);
      meets[i].push_back(j);
    }
  }
  add_triple_points(facets, meets, points);
  return round_once(std::move(points));
}

std::vector<RationalPoint> points_determined_by(const Vec3d& vertex, const std::vector<Corners>& faces,
                                                const std::vector<Corners>& touching) {
  const std::vector<Facet> facets = proper_facets(faces);
  std::vector<RationalPoint> candidates;
  if (const auto p = first_common_point(without_parallel(facets))) {
    candidates = {*p};
  } else {
    std::vector<Corners> all = faces;
    all.insert(all.end(), touching.begin(), touching.end());
    candidates = edge_candidates(proper_facets(all), vertex);
  }
  std::erase_if(candidates, [&](const RationalPoint& p) {
    return std::any_of(facets.begin(), facets.end(), [&](const Facet& facet) { return !facet.plane.height(p).is_zero(); });
  });
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

std::vector<RationalPoint> points_determined_by_some(const Vec3d& vertex, const std::vector<Corners>& faces) {
  const std::vector<Facet> facets = proper_facets(faces);
  std::vector<RationalPoint> candidates = edge_candidates(facets, vertex);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t j = i + 1; j < facets.size(); ++j) {
      for (std::size_t k = j + 1; k < facets.size(); ++k) {
        if (const auto p = common_point(facets[i].plane, facets[j].plane, facets[k].plane)) candidates.push_back(*p);
      }
    }
  }
  std::erase_if(candidates, [&](const RationalPoint& p) { return nearest_double(p) != vertex; });
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

}  // namespace mortise::oracle
