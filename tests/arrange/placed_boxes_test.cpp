// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Boxes that are moved hold the rounded images of their points, at every scale.
#include "mortise/arrange/placed_boxes.h"

#include <array>
#include <cmath>

#include "support/catch.h"
#include "support/random_maps.h"

using namespace mortise;
using namespace mortise::test;

namespace {

bool contains(const Box3& box, const Vec3d& p) {
  Box3 point;
  point.extend(p);
  return boxes_meet(box, point);
}

AffineMap scaled(AffineMap map, double factor) { return compose(map, scaling({factor, factor, factor})); }

}  // namespace

TEST_CASE("the image of a box holds the rounded images of its corners and of points in it") {
  RandomMaps random(41);
  constexpr std::array<double, 5> scales{1, 0x1p-400, 0x1p400, 0x1p-1050, 0x1p1022};
  for (int i = 0; i < 400; ++i) {
    const AffineMap map = scaled(random.next(i % 3 == 0 ? 1e9 : 2), scales[static_cast<std::size_t>(i) % scales.size()]);
    Box3 bounds;
    bounds.extend(random.point(-4, 4));
    bounds.extend(random.point(-4, 4));
    const Box3 image = PlacedBoxes(map, bounds).image_of(bounds);
    for (int k = 0; k < 16; ++k) {
      Vec3d p;
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = k < 8 ? ((k >> c & 1) != 0 ? bounds.hi[c] : bounds.lo[c]) : random.between(bounds.lo[c], bounds.hi[c]);
      CHECK(contains(image, apply(map, p)));
    }
  }
}

TEST_CASE("moved boxes are hardly larger than they must be") {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  const Box3 turned = PlacedBoxes(rotation(Axis::Z, 45), unit).image_of(unit);
  CHECK(turned.hi.y == Approx(std::sqrt(2.0)));
  CHECK(turned.lo.z == Approx(0).margin(1e-13));
}
