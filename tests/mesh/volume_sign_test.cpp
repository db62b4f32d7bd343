// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The sign of enclosed volumes, where doubles cannot tell it too.
#include "mortise/mesh/volume_sign.h"

#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

namespace mortise {

TEST_CASE("The sign of a volume says which way a closed surface runs", "[mesh][volume_sign]") {
  CHECK(enclosed_volume_sign(test::box({5, 5, 5}, {6, 6, 6})) == Sign::Positive);
  CHECK(enclosed_volume_sign(test::inside_out(test::box({5, 5, 5}, {6, 6, 6}))) == Sign::Negative);
  CHECK(enclosed_volume_sign(test::scaled(test::octahedron({0, 0, 0}, 1), 1e-200)) == Sign::Positive);
  CHECK(enclosed_volume_sign(test::scaled(test::octahedron({0, 0, 0}, 1), 1e200)) == Sign::Positive);
  CHECK(enclosed_volume_sign({}) == Sign::Zero);
}

TEST_CASE("The sign of a volume far below the rounding of its terms is exact", "[mesh][volume_sign]") {
  const double far = 0x1p60;
  const SurfaceMesh thin = test::make_mesh({{far, far, far}, {-far, 0, far}, {0, far, -far}, {far, far, far - 256}},
                                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  const Sign sign = enclosed_volume_sign(thin);
  CHECK(sign != Sign::Zero);
  CHECK(enclosed_volume_sign(test::inside_out(thin)) == -sign);
  CHECK((test::exactly_summed_volume(thin) > 0) == (sign == Sign::Positive));
  CHECK(enclosed_volume_sign(
            test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.3, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})) == Sign::Zero);
}

}  // namespace mortise
