// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Draws files and poses.
#include "pairs.h"

#include <algorithm>
#include <cmath>

#include "mortise/mortise.h"
#include "support/data.h"
#include "support/random_source.h"

namespace mortise::peers {
namespace {

using test::RandomSource;

constexpr std::size_t free_pairs = 320, aligned_pairs = 60, turned_pairs = 20, same_pairs = 10, large_pairs = 4, needle_pairs = 2;

Vec3d centre_of(const Box3& box) { return 0.5 * (box.lo + box.hi); }

double longest_side(const Box3& box) {
  const Vec3d sides = box.hi - box.lo;
  return std::max({sides.x, sides.y, sides.z});
}

/// The rotation of a unit quaternion.
AffineMap rotation_by(const std::array<double, 4>& q) {
  const auto [w, x, y, z] = q;
  AffineMap map;
  map.linear = {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                 {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                 {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
  return map;
}

/// All rotations alike.
AffineMap random_rotation(RandomSource& random) {
  for (;;) {
    std::array<double, 4> q;
    for (double& component : q) component = random.between(-1, 1);
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (length < 0.1 || length > 1) continue;
    for (double& component : q) component /= length;
    return rotation_by(q);
  }
}

AffineMap uniform_scaling(double factor) { return scaling({factor, factor, factor}); }

SurfaceMesh turned_at_random(const SurfaceMesh& mesh, RandomSource& random) {
  const Box3 box = bounding_box(mesh);
  const AffineMap centred = translation(-1.0 * centre_of(box));
  const AffineMap sized = compose(centred, uniform_scaling(random.between(0.6, 1.6) / longest_side(box)));
  return transform(mesh, compose(sized, random_rotation(random)));
}

SurfaceMesh sized_by_power_of_two(const SurfaceMesh& mesh) {
  const int exponent = std::ilogb(longest_side(bounding_box(mesh)));
  return transform(mesh, uniform_scaling(std::ldexp(1.0, -exponent)));
}

/// One of: low on low side, low on high, high on low, high on high, centre on centre, a quarter of the box further.
double aligning_offset(double lo_a, double hi_a, double lo_b, double hi_b, RandomSource& random) {
  switch (random.below(6)) {
    case 0:
      return lo_a - lo_b;
    case 1:
      return hi_a - lo_b;
    case 2:
      return lo_a - hi_b;
    case 3:
      return hi_a - hi_b;
    case 4:
      return 0.5 * (lo_a + hi_a) - 0.5 * (lo_b + hi_b);
    default:
      return lo_a - lo_b + 0.25 * (hi_a - lo_a);
  }
}

PosedPair place_aligned(const SurfaceMesh& a, const SurfaceMesh& b, RandomSource& random) {
  const SurfaceMesh sized_a = sized_by_power_of_two(a), sized_b = sized_by_power_of_two(b);
  const Box3 box_a = bounding_box(sized_a), box_b = bounding_box(sized_b);
  Vec3d offset;
  for (std::size_t i = 0; i < 3; ++i) offset[i] = aligning_offset(box_a.lo[i], box_a.hi[i], box_b.lo[i], box_b.hi[i], random);
  return {sized_a, transform(sized_b, translation(offset))};
}

PosedPair place_turned(const SurfaceMesh& mesh, RandomSource& random) {
  const SurfaceMesh sized = sized_by_power_of_two(mesh);
  const SurfaceMesh centred = transform(sized, translation(-1.0 * centre_of(bounding_box(sized))));
  const auto axis = static_cast<Axis>(random.below(3));
  return {centred, transform(centred, rotation(axis, 90.0 * static_cast<double>(1 + random.below(3))))};
}

PosedPair place_freely(const SurfaceMesh& a, const SurfaceMesh& b, RandomSource& random) {
  const SurfaceMesh turned_a = turned_at_random(a, random), turned_b = turned_at_random(b, random);
  return {turned_a, transform(turned_b, translation(random.point(-0.3, 0.3)))};
}

}  // namespace

const char* pose_name(Pose pose) {
  constexpr std::array<const char*, 4> names{"free", "aligned", "turned", "same"};
  return names[static_cast<std::size_t>(pose)];
}

const Files& files() {
  static const Files names{{"aircraft/cape_arrow_reference.obj",
                            "aircraft/cape_bullet.obj",
                            "aircraft/cape_engine.obj",
                            "aircraft/cape_fin1.obj",
                            "aircraft/cape_fin2.obj",
                            "aircraft/cape_fin3.obj",
                            "aircraft/cape_fin4.obj",
                            "aircraft/ceasiom_fuselage_closed.off",
                            "aircraft/ceasiom_wing_swept.stl",
                            "aircraft/ceasiom_wing_winglet.stl",
                            "cad/cht_bottomAir.stl",
                            "cad/cht_heater.stl",
                            "cad/cht_leftSolid.stl",
                            "cad/cht_rightSolid.stl",
                            "cad/cht_topAir.stl",
                            "cad/duct.off",
                            "cad/fandisk.off",
                            "cad/fandisk_quads.off",
                            "cad/flange.stl",
                            "cad/furnace_heater.obj",
                            "cad/furnace_shield.obj",
                            "cad/mixer_shaft.obj",
                            "cad/mixer_stirrer.obj",
                            "cad/mixer_zone.obj",
                            "cad/pipe.obj",
                            "cad/porous_block.off",
                            "cad/px4_omniquad_arm.stl",
                            "cad/px4_omniquad_base.stl",
                            "cad/thingi10k_472042_boiler.stl",
                            "cad/thingi10k_520644_number2.stl",
                            "cad/thingi10k_65004_case.stl",
                            "cad/wecsim_base.stl",
                            "cad/wecsim_flap.stl",
                            "nasty/gc_platonic_shelf.obj",
                            "nasty/manifold_Havocglass8_left.obj",
                            "nasty/manifold_Havocglass8_right.obj",
                            "nasty/manifold_Offset3.obj",
                            "nasty/manifold_Offset4.obj",
                            "nasty/synthetic/cube_cavity.off",
                            "nasty/synthetic/cube_diag_a.off",
                            "nasty/synthetic/cube_diag_b.off",
                            "nasty/synthetic/needle_box.off",
                            "nasty/synthetic/plate_1e-7.off",
                            "nasty/synthetic/prism_concave_polygons.off",
                            "nasty/synthetic/quad_nonplanar_cube.off",
                            "nasty/synthetic/spike_vertex_on_face.off",
                            "nasty/synthetic/tet_edge_on_face.off",
                            "primitives/fig05_cylinder_a.off",
                            "primitives/fig05_cylinder_b.off",
                            "primitives/fig25_torus.off",
                            "primitives/fig26_sphere.off",
                            "primitives/fig26_torus.off",
                            "primitives/fig27_box_coarse.off",
                            "primitives/fig27_box_fine.off",
                            "primitives/fig27_box_quads.off",
                            "primitives/fig27_cylinder_1.off",
                            "primitives/fig27_cylinder_2.off",
                            "primitives/fig27_cylinder_3.off",
                            "primitives/gch_sphere1.obj",
                            "primitives/gch_sphere1_minus_sphere2.obj",
                            "primitives/gch_sphere2.obj",
                            "primitives/stl_box_ascii.stl",
                            "primitives/stl_box_binary.stl",
                            "scans/blub.obj",
                            "scans/bob_small.ply",
                            "scans/bunny_adaptive.off",
                            "scans/cactus10k.obj",
                            "scans/spot.obj",
                            "ship/stack_funnel.obj",
                            "terrain/buildings_clean.obj"},
                           {"car/drivaer_front_wheels.ply", "car/drivaer_rear_wheels.ply", "scans/armadillo100k.ply", "ship/dtc_hull.ply"},
                           {"nasty/synthetic/comb_x_40.off", "nasty/synthetic/comb_y_40.off"}};
  return names;
}

std::vector<Pair> make_pairs(std::uint64_t seed) {
  RandomSource random(seed);
  const auto any = [&random](const std::vector<std::string>& names) { return names[random.below(names.size())]; };
  std::vector<Pair> pairs;
  const auto add = [&](Pose pose, const std::string& file_a, const std::string& file_b) {
    pairs.push_back({pose, file_a, file_b, seed * 1'000'000 + pairs.size()});
  };
  const auto add_single = [&](Pose pose, const std::string& file) { add(pose, file, file); };
  const auto& [moderate, large, needles] = files();
  for (std::size_t i = 0; i < free_pairs; ++i) add(Pose::Free, any(moderate), any(moderate));
  for (std::size_t i = 0; i < aligned_pairs / 2; ++i) add(Pose::Aligned, any(moderate), any(moderate));
  for (std::size_t i = 0; i < aligned_pairs / 2; ++i) add_single(Pose::Aligned, any(moderate));
  for (std::size_t i = 0; i < turned_pairs; ++i) add_single(Pose::Turned, any(moderate));
  for (std::size_t i = 0; i < same_pairs; ++i) add_single(Pose::Same, any(moderate));
  for (std::size_t i = 0; i < large_pairs; ++i) add(Pose::Free, large[i % large.size()], any(moderate));
  for (std::size_t i = 0; i < needle_pairs; ++i) add(Pose::Free, needles[i % needles.size()], any(moderate));
  return pairs;
}

SurfaceMesh load(const std::string& file) { return weld(test::read_data(file)).mesh; }

PosedPair place(const Pair& pair, const SurfaceMesh& a, const SurfaceMesh& b) {
  RandomSource random(pair.seed);
  switch (pair.pose) {
    case Pose::Free:
      return place_freely(a, b, random);
    case Pose::Aligned:
      return place_aligned(a, b, random);
    case Pose::Turned:
      return place_turned(a, random);
    case Pose::Same:
      break;
  }
  const SurfaceMesh turned = turned_at_random(a, random);
  return {turned, turned};
}

}  // namespace mortise::peers
