// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Overlays: connected by shared area, through any number of faces, and not by equal planes.
#include "mortise/arrange/overlay_coplanar.h"

#include <algorithm>

#include "mortise/exact/predicates.h"
#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// One triangle of the plane z = 0, as an operand.
SurfaceMesh tile(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return make_mesh({a, b, c}, {{0, 1, 2}}); }

/// A right triangle with legs of 2 at (x, y, 0).
SurfaceMesh right_triangle(double x, double y) { return tile({x, y, 0}, {x + 2, y, 0}, {x, y + 2, 0}); }

std::vector<std::vector<std::uint32_t>> groups_of(const Overlays& overlays) {
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::size_t i = 0; i < overlays.size(); ++i) {
    std::vector<std::uint32_t> group;
    for (const SourceId f : overlays.faces_of(OverlayId(i))) group.push_back(f.value);
    groups.push_back(group);
  }
  return groups;
}

using Groups = std::vector<std::vector<std::uint32_t>>;

void check_consistent(const Arrangement& scene) {
  const Overlays& o = scene.overlays;
  CHECK(o.first_slot.size() == o.size() + 1);
  CHECK(o.axis.size() == o.size());
  std::vector<std::uint8_t> is_touched(scene.faces.corners.size(), 0);
  for (const Contact& c : scene.contacts.contacts) is_touched[c.face_a.index()] = is_touched[c.face_b.index()] = 1;
  for (const StrayPoint& s : scene.contacts.stray_points) is_touched[s.face.index()] = 1;
  for (std::size_t f = 0; f < is_touched.size(); ++f) {
    const SlotId slot = o.slot_of_face[SourceId(f)];
    CHECK(slot.is_valid() == (is_touched[f] != 0));
    if (slot.is_valid()) CHECK(o.face[slot] == SourceId(f));
  }
  for (std::size_t i = 0; i < o.size(); ++i) {
    const auto faces = o.faces_of(OverlayId(i));
    REQUIRE(!faces.empty());
    CHECK(std::is_sorted(faces.begin(), faces.end()));
    CHECK(o.plane[OverlayId(i)] == scene.faces.corners[faces.front()]);
    for (const SourceId f : faces) {
      CHECK(o.of_face(f) == OverlayId(i));
      CHECK(o.overlay_of_slot[o.slot_of_face[f]] == OverlayId(i));
      const auto at = [&](std::size_t c) { return scene.faces.corner_position(f, c); };
      CHECK(orient2d(at(0), at(1), at(2), o.axis[OverlayId(i)]) != Sign::Zero);
      for (const PointId p : scene.faces.corners[f]) CHECK(scene.faces.points.side_of_plane(o.plane[OverlayId(i)], p) == Sign::Zero);
    }
  }
}

}  // namespace

TEST_CASE("overlays of the small scenes hold each face in contact once, over one plane and one axis") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    check_consistent(Arrangement(scene.operands));
  }
}

TEST_CASE("overlap joins faces through other faces") {
  // 0 overlaps 1, 1 overlaps 2, 2 overlaps 3; 0 and 3 are far apart.
  const Arrangement scene({right_triangle(0, 0), right_triangle(1, 0), right_triangle(2, 0), right_triangle(3, 0)});
  CHECK(groups_of(scene.overlays) == Groups{{0, 1, 2, 3}});
  check_consistent(scene);
}

TEST_CASE("a bridge that comes last joins what was apart") {
  const Arrangement scene({right_triangle(0, 0), right_triangle(3, 0), right_triangle(1.5, 0)});
  CHECK(groups_of(scene.overlays) == Groups{{0, 1, 2}});
}

TEST_CASE("equal planes without common area stay apart") {
  // Both are in z = 0 and both are cut by a wall; they are far from each other.
  const SurfaceMesh wall = make_mesh({{-9, 0.5, -9}, {30, 0.5, -9}, {0, 0.5, 30}}, {{0, 1, 2}});
  const Arrangement scene({right_triangle(0, 0), right_triangle(10, 0), wall});
  CHECK(groups_of(scene.overlays) == Groups{{0}, {1}, {2}});
}

TEST_CASE("faces of one plane that touch in a corner or along an edge stay apart") {
  CHECK(groups_of(Arrangement({right_triangle(0, 0), right_triangle(2, 0)}).overlays) == Groups{{0}, {1}});
  const SurfaceMesh below = tile({0, 0, 0}, {2, -2, 0}, {2, 0, 0});
  CHECK(groups_of(Arrangement({right_triangle(0, 0), below}).overlays) == Groups{{0}, {1}});
  const SurfaceMesh half_below = tile({1, 0, 0}, {2, -2, 0}, {3, 0, 0});
  CHECK(groups_of(Arrangement({right_triangle(0, 0), half_below}).overlays) == Groups{{0}, {1}});
}

TEST_CASE("one ulp of common area makes one overlay") {
  const SurfaceMesh below = tile({0, 0x1p-1074, 0}, {2, -2, 0}, {2, 0x1p-1074, 0});
  CHECK(groups_of(Arrangement({right_triangle(0, 0), below}).overlays) == Groups{{0, 1}});
}

TEST_CASE("faces that look the other way overlap too") {
  const SurfaceMesh down = tile({0.25, 0.25, 0}, {0.25, 0.75, 0}, {0.75, 0.25, 0});
  const Arrangement scene({down, right_triangle(0, 0)});
  CHECK(groups_of(scene.overlays) == Groups{{0, 1}});
  check_consistent(scene);
}

TEST_CASE("faces of one operand are overlaid as those of several") {
  const SurfaceMesh folded = make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, 2, 0}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(groups_of(Arrangement({folded}).overlays) == Groups{{0, 1}});
}

TEST_CASE("a face touched by a stray point only has an overlay of its own") {
  const SurfaceMesh mesh =
      make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {9, 9, 9}, {8, 9, 9}, {9, 8, 9}}, {{4, 5, 6}, {0, 1, 2}, {0, 3, 1}});
  const Arrangement scene({mesh});
  CHECK(groups_of(scene.overlays) == Groups{{1}});
  check_consistent(scene);
}

TEST_CASE("no contact, no overlay") {
  const Arrangement scene({right_triangle(0, 0), right_triangle(9, 9)});
  CHECK(scene.overlays.size() == 0);
  CHECK(scene.overlays.first_slot.values() == std::vector<std::uint32_t>{0});
}

TEST_CASE("overlays are the same for every order of operands") {
  const std::vector<SurfaceMesh> tiles{right_triangle(0, 0),  right_triangle(5, 0),
                                       right_triangle(1, 0),  right_triangle(6, 0),
                                       right_triangle(20, 0), make_mesh({{-9, 0.5, -9}, {50, 0.5, -9}, {0, 0.5, 30}}, {{0, 1, 2}})};
  CHECK(groups_of(Arrangement(tiles).overlays) == Groups{{0, 2}, {1, 3}, {4}, {5}});
  CHECK(groups_of(Arrangement({tiles.rbegin(), tiles.rend()}).overlays) == Groups{{0}, {1}, {2, 4}, {3, 5}});
}
