// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertices (after exact weld, unused ones included) and triangles of the real meshes, counted by another program.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mortise/base/error.h"

namespace mortise::test {

struct KnownMesh {
  std::string file;
  std::size_t vertices;
  std::size_t triangles;
};

inline const std::vector<KnownMesh> known_meshes = {
    {"primitives/fig05_cylinder_a.off", 2258, 4512},
    {"primitives/fig05_cylinder_b.off", 2054, 4104},
    {"primitives/fig25_torus.off", 864, 1728},
    {"primitives/fig26_corner_sheet.off", 693, 1280},
    {"primitives/fig26_sphere.off", 1026, 2048},
    {"primitives/fig26_torus.off", 1200, 2400},
    {"primitives/fig27_box_coarse.off", 8, 12},
    {"primitives/fig27_box_fine.off", 3458, 6912},
    {"primitives/fig27_box_quads.off", 386, 768},
    {"primitives/fig27_cylinder_1.off", 1034, 2064},
    {"primitives/fig27_cylinder_2.off", 1034, 2064},
    {"primitives/fig27_cylinder_3.off", 1034, 2064},
    {"primitives/gch_sphere1.obj", 1442, 2880},
    {"primitives/gch_sphere2.obj", 1442, 2880},
    {"primitives/gch_sphere1_minus_sphere2.obj", 1572, 3140},
    {"primitives/stl_box_ascii.stl", 8, 12},
    {"primitives/stl_box_binary.stl", 8, 12},
    {"ship/dtc_hull.ply", 58033, 116062},
    {"ship/wigley_hull.off", 6645, 12896},
    {"ship/stack_funnel.obj", 372, 740},
    {"aircraft/cape_bullet.obj", 2447, 4890},
    {"aircraft/cape_fin1.obj", 76, 148},
    {"aircraft/cape_fin2.obj", 76, 148},
    {"aircraft/cape_fin3.obj", 76, 148},
    {"aircraft/cape_fin4.obj", 76, 148},
    {"aircraft/cape_arrow_reference.obj", 4610, 9216},
    {"aircraft/cape_engine.obj", 3841, 7678},
    {"aircraft/cape_bullet_box_overlap.obj", 612, 1216},
    {"aircraft/ceasiom_fuselage_open_nose.stl", 319, 608},
    {"aircraft/ceasiom_fuselage_closed.off", 306, 608},
    {"aircraft/ceasiom_wing_swept.stl", 442, 880},
    {"aircraft/ceasiom_wing_winglet.stl", 442, 880},
    {"aircraft/naca0012_wing.obj", 7996, 15988},
    {"car/floor_sheet.off", 5661, 11000},
    {"car/floor_sheet_coarse_quads.off", 72, 110},
    {"car/drivaer_body.ply", 125446, 250962},
    {"car/drivaer_front_wheels.ply", 39066, 78164},
    {"car/drivaer_rear_wheels.ply", 43978, 87988},
    {"terrain/turbine_site_terrain.off", 10800, 21186},
    {"terrain/buildings_clean.obj", 880, 1692},
    {"cad/mixer_stirrer.obj", 1198, 2392},
    {"cad/mixer_zone.obj", 286, 568},
    {"cad/mixer_shaft.obj", 170, 336},
    {"cad/flange.stl", 3228, 6468},
    {"cad/duct.off", 5202, 10400},
    {"cad/porous_block.off", 2402, 4800},
    {"cad/cht_bottomAir.stl", 1044, 2088},
    {"cad/cht_topAir.stl", 922, 1840},
    {"cad/cht_leftSolid.stl", 308, 612},
    {"cad/cht_rightSolid.stl", 308, 612},
    {"cad/cht_heater.stl", 170, 336},
    {"cad/furnace_heater.obj", 702, 1404},
    {"cad/furnace_shield.obj", 806, 1612},
    {"cad/pipe.obj", 5635, 11266},
    {"cad/thingi10k_65004_case.stl", 731, 1466},
    {"cad/thingi10k_472042_boiler.stl", 1814, 3632},
    {"cad/thingi10k_520644_number2.stl", 3919, 7834},
    {"cad/px4_omniquad_base.stl", 2234, 4408},
    {"cad/px4_omniquad_arm.stl", 130, 256},
    {"cad/wecsim_flap.stl", 523, 1042},
    {"cad/wecsim_base.stl", 1338, 2672},
    {"cad/fandisk.off", 6475, 12946},
    {"cad/fandisk_quads.off", 766, 1528},
    {"scans/bunny_adaptive.off", 5884, 11764},
    {"scans/spot.obj", 2930, 5856},
    {"scans/blub.obj", 7106, 14208},
    {"scans/cactus10k.obj", 5000, 9996},
    {"scans/armadillo100k.ply", 49999, 99994},
    {"scans/bob_small.ply", 250, 500},
    {"nasty/of_buildings_degenerate.obj", 6142, 12264},
    {"nasty/manifold_Havocglass8_left.obj", 84, 164},
    {"nasty/manifold_Havocglass8_right.obj", 8, 12},
    {"nasty/manifold_Offset3.obj", 30, 56},
    {"nasty/manifold_Offset4.obj", 40, 76},
    {"nasty/manifold_Generic_Twin_7863_left.obj", 110, 212},
    {"nasty/manifold_Generic_Twin_7863_right.obj", 126, 244},
    {"nasty/manifold_openscad-nonmanifold-crash.obj", 658, 1442},
    {"nasty/gc_fan3.obj", 5, 3},
    {"nasty/gc_hourglass_ico.obj", 23, 40},
    {"nasty/gc_moebius.obj", 280, 448},
    {"nasty/gc_triple_vierbein.obj", 75, 108},
    {"nasty/gc_platonic_shelf.obj", 50, 80},
    {"nasty/gc_cat_head.obj", 131, 248},
    {"nasty/assimp_sphereWithHole.stl", 146, 285},
    {"nasty/assimp_Spider_binary.stl", 722, 1368},
    {"nasty/assimp_3DSMaxExport.STL", 1042, 2000},
    {"nasty/assimp_triangle_with_empty_solid.stl", 3, 1},
    {"nasty/assimp_regr01.obj", 1271, 2710},
    {"nasty/assimp_regr_3429812.obj", 4, 4},
    {"nasty/assimp_concave_polygon.obj", 64, 64},
    {"nasty/of_multiCollapse.stl", 11, 13},
    {"nasty/of_rotatingZone_bad_orientation.obj", 1984, 3964},
    {"nasty/of_heatedDuct.stl", 24, 44},
    {"nasty/of_cyclone.stl", 362, 670},
    {"nasty/of_mixer_sparger.stl", 560, 972},
    {"nasty/of_mixer_stirrer.stl", 689, 1196},
    {"nasty/of_mixer_baffles.stl", 18, 16},
    {"nasty/of_stirrer6_plates.obj", 24, 12},
    {"nasty/three_cubes.stl", 24, 36},
    {"nasty/two_spheres.stl", 804, 1600},
    {"nasty/thingi10k_40509_brainslug.stl", 7208, 14370},
    {"nasty/wecsim_base_cracks.stl", 12, 12},
    {"nasty/wecsim_float_cracks.stl", 264, 516},
    {"nasty/wecsim_plate_cracks.stl", 184, 356},
    {"nasty/ceasiom_aircraft_soup.stl", 320, 670},
    {"nasty/E_concave_polygon.obj", 12, 10},
    {"nasty/sphere_pair_overlap.obj", 1060, 2112},
};

/// Files that cannot be read, and where the trouble is.
struct KnownError {
  std::string file;
  ErrorCode code;
  std::uint32_t line;
};

inline const std::vector<KnownError> known_errors = {
    {"nasty/assimp_invalid.off", ErrorCode::ParseFailed, 6},          // a face of 0 corners
    {"nasty/assimp_malformed.obj", ErrorCode::BadIndex, 23},          // vertex 12 of 8
    {"nasty/assimp_malformed2.obj", ErrorCode::ParseFailed, 23},      // a face without corners
    {"nasty/assimp_number_formats.obj", ErrorCode::ParseFailed, 11},  // 3.1+e2
    {"nasty/synthetic/bad_index.off", ErrorCode::BadIndex, 23},       // vertex 99 of 8
    {"nasty/synthetic/inf_vertex.off", ErrorCode::NotFinite, 9},      // inf
    {"nasty/synthetic/nan_vertex.off", ErrorCode::NotFinite, 9},      // nan
};

}  // namespace mortise::test
