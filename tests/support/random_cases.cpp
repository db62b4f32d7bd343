// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operands of the random campaign, family by family.
#include "support/random_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/base/trig.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/random_solids.h"

namespace mortise::test {
namespace {

using Solids = std::vector<SurfaceMesh>;

constexpr Axis axes[] = {Axis::X, Axis::Y, Axis::Z};

std::uint32_t count_of(std::size_t n) { return static_cast<std::uint32_t>(n); }

AffineMap random_rotation(RandomSource& random) {
  const double y = random.between(0, 360), x = random.between(0, 360), z = random.between(0, 360);
  return compose(compose(rotation(Axis::X, x), rotation(Axis::Y, y)), rotation(Axis::Z, z));
}

SurfaceMesh posed(const SurfaceMesh& mesh, RandomSource& random, double reach) {
  const Vec3d offset = random.point(-reach, reach);
  return transform(mesh, compose(random_rotation(random), translation(offset)));
}

/// A closed surface about the origin, of size 1 or so, with about `faces` faces or fewer.
SurfaceMesh random_round_shape(RandomSource& random, std::size_t faces) {
  const double side = std::sqrt(static_cast<double>(faces) / 2);
  const auto along = [&](double share) { return count_of(std::max<std::size_t>(3, static_cast<std::size_t>(share * side))); };
  switch (random.below(5)) {
    case 0:
      return make_sphere(random.between(0.5, 1), along(1.2), along(0.8));
    case 1:
      return make_icosphere(random.between(0.5, 1), faces < 80 ? 0 : faces < 320 ? 1 : faces < 1280 ? 2 : 3);
    case 2: {
      const double minor_radius = random.between(0.1, 0.5);
      return make_torus(random.between(0.6, 1), minor_radius, along(1.4), along(0.7));
    }
    case 3:
      return moved(make_cylinder(random.between(0.2, 0.8), 1, count_of(std::max<std::size_t>(3, faces / 4))), {0, 0, -0.5});
    default:
      return moved(make_cone(random.between(0.2, 0.8), 1, count_of(std::max<std::size_t>(3, faces / 2))), {0, 0, -0.5});
  }
}

// ---- grid

Solids grid_case(RandomSolids& random) {
  const std::size_t kind = random.below(12);
  if (kind == 0) return random.next(4);
  Solids solids;
  for (std::size_t count = kind < 3 ? 3 : 2; count > 0; --count) solids.push_back(random.next_of_all_kinds());
  return solids;
}

// ---- near-coincident copies

/// Every coordinate of every point, in turn.
template <class Map>
SurfaceMesh with_coordinates(SurfaceMesh mesh, const Map& map) {
  for (Vec3d& p : mesh.points) {
    for (std::size_t i = 0; i < 3; ++i) p[i] = map(p[i]);
  }
  return mesh;
}

double one_ulp_aside(double x, RandomSource& random) {
  const double infinity = std::numeric_limits<double>::infinity();
  return random.once_in(3) ? x : std::nextafter(x, random.once_in(2) ? infinity : -infinity);
}

SurfaceMesh nearly_copied(const SurfaceMesh& mesh, RandomSource& random) {
  const double tiny = random.octaves(-53, -10);
  switch (random.below(5)) {
    case 0:
      return moved(mesh, tiny * random.direction());
    case 1:
      return with_coordinates(mesh, [&](double x) { return x + tiny * random.between(-1, 1); });
    case 2:
      return transform(mesh, rotation(axes[random.below(3)], trig::to_degrees(tiny)));
    case 3:
      return scaled(mesh, random.once_in(2) ? 1 + tiny : 1 - tiny);
    default:
      return with_coordinates(mesh, [&](double x) { return one_ulp_aside(x, random); });
  }
}

SurfaceMesh shape_to_copy(RandomSolids& random) {
  if (random.once_in(2)) return random_round_shape(random, random.size(8, 300));
  return scaled(random.next(), 0.25);
}

Solids copies_case(RandomSolids& random) {
  SurfaceMesh original = shape_to_copy(random);
  if (random.once_in(2)) original = posed(original, random, 1);
  Solids solids{original, nearly_copied(original, random)};
  if (random.once_in(6)) solids.push_back(nearly_copied(solids[random.below(2)], random));
  return solids;
}

// ---- needles, plates, slivers

SurfaceMesh box_about_origin(const Vec3d& size) { return box(-0.5 * size, 0.5 * size); }

/// One to three of its sizes are 1, the others `thin`; about the origin.
SurfaceMesh random_thin_shape(RandomSource& random, double thin) {
  switch (random.below(6)) {
    case 0:
      return box_about_origin({1, thin, thin});
    case 1:
      return box_about_origin({1, 1, thin});
    case 2:
      return moved(make_cone(thin, 1, count_of(3 + random.below(9))), {0, 0, -0.5});
    case 3:
      return moved(make_cylinder(thin, 1, count_of(3 + random.below(9))), {0, 0, -0.5});
    case 4:
      return tetrahedron({-0.5, -0.5, 0}, {0.5, -0.5, thin}, {0.5, 0.5, 0}, {-0.5, 0.5, thin});
    default: {
      const AffineMap flat = scaling({1, random.once_in(2) ? 1 : thin, thin});
      return transform(make_icosphere(0.5, count_of(random.below(2))), flat);
    }
  }
}

/// A needle, and others through it, beside it, or along it and turned by no more than its thickness.
Solids needles_case(RandomSource& random) {
  const double thin = random.octaves(-27, -10);
  const SurfaceMesh first = random_thin_shape(random, thin);
  const AffineMap pose = random.once_in(3) ? AffineMap{} : random_rotation(random);
  Solids solids{transform(first, pose)};
  for (std::size_t count = 1 + (random.once_in(4) ? 1 : 0); count > 0; --count) {
    const std::size_t kind = random.below(4);
    if (kind == 0) solids.push_back(posed(random_round_shape(random, 100), random, 0.5));
    if (kind == 1) solids.push_back(posed(random_thin_shape(random, random.octaves(-27, -10)), random, 0.2));
    if (kind == 2) solids.push_back(transform(moved(with_axes_turned(first), {0.25, 0, 0}), pose));
    if (kind == 3) {
      const double degrees = trig::to_degrees(thin * random.between(-2, 2));
      const AffineMap turn = rotation(axes[random.below(3)], degrees);
      solids.push_back(transform(transform(first, compose(turn, translation((thin / 2) * random.direction()))), pose));
    }
  }
  return solids;
}

// ---- fans

/// A ring round the z axis above the origin, the origin and a point above: two fans on one ring.
SurfaceMesh random_fan(RandomSource& random, std::size_t sides) {
  std::vector<Vec3d> points{{0, 0, 0}, {0, 0, 2}};
  const bool is_flat = random.once_in(3);
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 360 * static_cast<double>(i) / static_cast<double>(sides);
    points.push_back({trig::cos_deg(angle), trig::sin_deg(angle), is_flat ? 1 : random.between(0.5, 1.5)});
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t here = 2 + i, next = 2 + (i + 1) % sides;
    triangles.push_back({0, next, here});
    triangles.push_back({1, here, next});
  }
  return make_mesh(points, triangles);
}

/// The fan whose ring is every `step`-th point of another's, twice as far from the apex: edges of both lie on one another.
SurfaceMesh fan_along_edges(const SurfaceMesh& fan, std::size_t step) {
  std::vector<Vec3d> points{{0, 0, 0}, {0, 0, 5}};
  for (std::size_t i = 2; i < fan.points.size(); i += step) points.push_back(2.0 * fan.points[i]);
  const std::size_t sides = points.size() - 2;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t here = 2 + i, next = 2 + (i + 1) % sides;
    triangles.push_back({0, next, here});
    triangles.push_back({1, here, next});
  }
  return make_mesh(points, triangles);
}

/// A tetrahedron with the apex and an edge of the fan, and more, as one of its edges.
SurfaceMesh tetrahedron_on_edge(const SurfaceMesh& fan, RandomSource& random) {
  const Vec3d along = 2.0 * fan.points[2 + random.below(fan.points.size() - 2)];
  const Vec3d last = 2.0 * random.direction();
  return tetrahedron({0, 0, 0}, along, 2.0 * random.direction(), last);
}

/// A tetrahedron with an edge through the apex.
SurfaceMesh tetrahedron_through_apex(RandomSource& random) {
  const Vec3d along = random.direction();
  const Vec3d last = 2.0 * random.direction();
  return tetrahedron(along, -1.0 * along, 2.0 * random.direction(), last);
}

SurfaceMesh box_at_apex(RandomSource& random) {
  Vec3d lo{-1, -1, -1}, hi{1, 1, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    if (const std::size_t side = random.below(3); side == 0)
      lo[i] = 0;
    else if (side == 1)
      hi[i] = 0;
  }
  return box(lo, hi);
}

SurfaceMesh partner_of_fan(const SurfaceMesh& fan, RandomSource& random) {
  const std::size_t sides = fan.points.size() - 2;
  // Fans that share an apex have that many pairs of faces: their product is bounded.
  const std::size_t others = random.size(3, std::max<std::size_t>(4, std::min<std::size_t>(1000, 20000 / sides)));
  switch (random.below(7)) {
    case 0: {
      const AffineMap pose = random_rotation(random);
      return transform(random_fan(random, others), pose);
    }
    case 1:
      return sides <= 150 ? scaled(fan, random.once_in(2) ? 2 : 0.5) : tetrahedron_on_edge(fan, random);
    case 2:
      return fan_along_edges(fan, std::max<std::size_t>(1, std::min(sides / 3, sides / std::min(sides, others))));
    case 3:
      return tetrahedron_on_edge(fan, random);
    case 4:
      return tetrahedron_through_apex(random);
    case 5:
      return box_at_apex(random);
    default:
      return posed(random_fan(random, others), random, 0.5);
  }
}

Solids fans_case(RandomSource& random) {
  const SurfaceMesh fan = random_fan(random, random.size(3, 1000));
  Solids solids{fan, partner_of_fan(fan, random)};
  if (fan.points.size() < 100 && random.once_in(4)) solids.push_back(partner_of_fan(fan, random));
  return solids;
}

// ---- forests

/// Thin tetrahedra through z = 0, one in each cell of a square of `side` cells from -1 to 1.
SurfaceMesh random_forest(RandomSource& random, std::size_t side) {
  Solids trees;
  const double cell = 2 / static_cast<double>(side);
  for (std::size_t i = 0; i < side * side; ++i) {
    const Vec3d at{-1 + cell * static_cast<double>(i % side), -1 + cell * static_cast<double>(i / side), 0};
    const auto corner = [&](double z) {
      const double x = random.between(0, 1), y = random.between(0, 1);
      return at + Vec3d{x * cell, y * cell, z};
    };
    const Vec3d a = corner(-0.25), b = corner(-0.25), c = corner(-0.25), d = corner(random.between(0.1, 1));
    trees.push_back(tetrahedron(a, b, c, d));
  }
  return joined(trees);
}

/// Thin blades through z = 0, side by side along x.
SurfaceMesh random_comb(RandomSource& random, std::size_t blades) {
  Solids teeth;
  const double cell = 2 / static_cast<double>(blades);
  for (std::size_t i = 0; i < blades; ++i) {
    const double x = -1 + cell * static_cast<double>(i), left = x + cell * random.between(0.1, 0.4);
    const double right = x + cell * random.between(0.6, 0.9);
    const Vec3d hi{right, random.between(0.5, 1), random.between(0.1, 1)};
    teeth.push_back(box({left, -random.between(0.5, 1), -0.25}, hi));
  }
  return joined(teeth);
}

Solids forests_case(RandomSource& random) {
  const double tilt = random.once_in(2) ? 0 : random.between(-0.2, 0.2);
  SurfaceMesh ground = random.once_in(2) ? box({-2, -2, -2}, {2, 2, 0}) : tetrahedron({-8, -8, 0}, {8, -8, 0}, {0, 8, 0}, {0, 0, -8});
  for (Vec3d& p : ground.points) p.z += tilt * p.x;
  const std::size_t segments = random.size(30, 10000);
  const auto side_of = [](double squared) { return std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(squared))); };
  if (random.once_in(2)) return {ground, random_forest(random, side_of(static_cast<double>(segments) / 3))};
  // Two combs of n blades cross in 4 n n points of the ground.
  const std::size_t blades = side_of(static_cast<double>(segments) / 16);
  return {ground, random_comb(random, blades), quarter_turned(random_comb(random, blades))};
}

// ---- curved

Solids curved_case(RandomSource& random) {
  const auto faces = [&] { return random.size(16, random.once_in(20) ? 2000 : 400); };
  Solids solids;
  for (std::size_t count = random.once_in(6) ? 3 : 2; count > 0; --count) {
    solids.push_back(posed(random_round_shape(random, faces()), random, 0.5));
  }
  return solids;
}

// ---- all

Family random_family(RandomSource& random) {
  const std::size_t share = random.below(1000);
  if (share < 3) return Family::Forests;
  if (share < 450) return Family::Grid;
  if (share < 630) return Family::Copies;
  if (share < 770) return Family::Needles;
  return share < 850 ? Family::Fans : Family::Curved;
}

Solids solids_of(Family family, RandomSolids& random) {
  switch (family) {
    case Family::Grid:
      return grid_case(random);
    case Family::Copies:
      return copies_case(random);
    case Family::Needles:
      return needles_case(random);
    case Family::Fans:
      return fans_case(random);
    case Family::Forests:
      return forests_case(random);
    case Family::Curved:
      return curved_case(random);
  }
  return {};
}

/// Far away, where coordinates of the grid stay exact and others lose up to 20 bits.
Vec3d far_offset(RandomSource& random) {
  const double reach = random.octaves(0, 20);
  const Vec3d offset = random.point(-reach, reach);
  return {std::floor(offset.x), std::floor(offset.y), std::floor(offset.z)};
}

}  // namespace

std::string_view family_name(Family family) {
  constexpr std::string_view names[family_count] = {"grid", "copies", "needles", "fans", "forests", "curved"};
  return names[static_cast<std::size_t>(family)];
}

RandomCase make_random_case(std::uint64_t seed, std::uint64_t number) {
  RandomSolids random(seed * 0x9e3779b97f4a7c15ULL + number);
  RandomCase drawn;
  drawn.family = random_family(random);
  drawn.operands = solids_of(drawn.family, random);
  const bool can_move = drawn.family == Family::Grid || drawn.family == Family::Curved;
  const Vec3d offset = can_move && random.once_in(5) ? far_offset(random) : Vec3d{};
  const double scale = random.once_in(8) ? std::ldexp(1.0, static_cast<int>(random.below(601)) - 300) : 1;
  for (SurfaceMesh& mesh : drawn.operands) mesh = scaled(moved(std::move(mesh), offset), scale);
  return drawn;
}

}  // namespace mortise::test
