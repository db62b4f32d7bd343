// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Self-crossings: every way two triangles can meet, random ones against the oracle, and known counts of real files.
#include "mortise/mesh/find_self_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using Faces = std::vector<std::array<std::size_t, 3>>;

constexpr FaceId first{std::size_t{0}};
constexpr FaceId second{std::size_t{1}};

/// How the two faces meet: the same for both orders and for faces turned and turned over.
PairMeeting meeting_of(const std::vector<Vec3d>& points, const Faces& faces) {
  SurfaceMesh mesh = test::make_mesh(points, faces);
  const PairMeeting meeting = classify_meeting(mesh, first, second);
  for (int turn = 0; turn < 6; ++turn) {
    REQUIRE(classify_meeting(mesh, first, second) == meeting);
    REQUIRE(classify_meeting(mesh, second, first) == meeting);
    std::rotate(mesh.triangles[0].begin(), mesh.triangles[0].begin() + 1, mesh.triangles[0].end());
    if (turn == 2) std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    if (turn % 2 == 1) std::rotate(mesh.triangles[1].begin(), mesh.triangles[1].begin() + 1, mesh.triangles[1].end());
    if (turn == 3) std::swap(mesh.triangles[1][1], mesh.triangles[1][2]);
  }
  return meeting;
}

/// A triangle in z = 0 against a second one, no vertex shared.
PairMeeting apart_from_base(const Vec3d& p, const Vec3d& q, const Vec3d& r) {
  return meeting_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, q, r}, {{0, 1, 2}, {3, 4, 5}});
}

/// The same, sharing vertex 0 = (0, 0, 0).
PairMeeting at_corner_of_base(const Vec3d& q, const Vec3d& r) {
  return meeting_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, q, r}, {{0, 1, 2}, {0, 3, 4}});
}

/// The same, sharing the edge from (0, 0, 0) to (4, 0, 0).
PairMeeting at_edge_of_base(const Vec3d& r) { return meeting_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, r}, {{0, 1, 2}, {1, 0, 3}}); }

std::vector<oracle::MeetingPair> plain(const std::vector<SelfCrossing>& pairs) {
  std::vector<oracle::MeetingPair> plain_pairs;
  for (const SelfCrossing& pair : pairs) plain_pairs.push_back({pair.a.value, pair.b.value, static_cast<oracle::Meeting>(pair.kind)});
  return plain_pairs;
}

/// Triangles over few points on a small grid: shared corners and edges, coincidences and flat faces abound.
SurfaceMesh random_mesh(std::mt19937& random, std::size_t points, std::uint32_t grid, double scale) {
  SurfaceMesh mesh;
  const auto coordinate = [&] { return scale * static_cast<double>(random() % grid); };
  for (std::size_t i = 0; i < points; ++i) mesh.points.push_back({coordinate(), coordinate(), coordinate()});
  for (int f = 0; f < 12; ++f)
    mesh.triangles.push_back({VertexId(random() % points), VertexId(random() % points), VertexId(random() % points)});
  return mesh;
}

}  // namespace

static_assert(static_cast<int>(PairMeeting::Crossing) == static_cast<int>(oracle::Meeting::Crossing));
static_assert(static_cast<int>(PairMeeting::CoplanarOverlap) == static_cast<int>(oracle::Meeting::Overlap));
static_assert(static_cast<int>(PairMeeting::Touching) == static_cast<int>(oracle::Meeting::Touching));

TEST_CASE("Triangles in different planes without a shared vertex", "[mesh][self_crossings]") {
  CHECK(apart_from_base({1, 1, -1}, {1, 1, 1}, {2, 1, 1}) == PairMeeting::Crossing);
  CHECK(apart_from_base({1, 1, 0}, {-9, 1, 1}, {9, 1, -1}) == PairMeeting::Crossing);   // a corner in the plane, the inside across
  CHECK(apart_from_base({-9, 1, -1}, {9, 1, -1}, {1, 1, 9}) == PairMeeting::Crossing);  // the base pierces it from edge to edge
  CHECK(apart_from_base({1, 1, 0}, {1, 1, 1}, {2, 1, 1}) == PairMeeting::Touching);     // a corner stands on the inside
  CHECK(apart_from_base({1, 1, 0}, {2, 1, 0}, {2, 1, 1}) == PairMeeting::Touching);     // an edge stands on the inside
  CHECK(apart_from_base({4, 0, 0}, {5, 0, 1}, {5, 1, 1}) == PairMeeting::Touching);     // equal corners that are not shared
  CHECK(apart_from_base({2, -1, -1}, {2, 1, 1}, {2, -9, 9}) == PairMeeting::Touching);  // an edge crosses an edge
  CHECK(apart_from_base({2, 0, 0}, {2, -1, 1}, {2, -1, -1}) == PairMeeting::Touching);  // a corner on an edge, straddling
  CHECK(apart_from_base({1, 0, 0}, {2, 0, 0}, {1, -1, 1}) == PairMeeting::Touching);    // an edge along an edge
  CHECK(apart_from_base({1, 1, 1}, {2, 1, 1}, {1, 2, 2}) == PairMeeting::Apart);
  CHECK(apart_from_base({5, 5, -1}, {5, 5, 1}, {6, 5, 1}) == PairMeeting::Apart);  // crosses the plane elsewhere
  CHECK(apart_from_base({5, 0, 0}, {6, 0, 0}, {6, 0, 1}) == PairMeeting::Apart);   // on the line of an edge, beyond it
}

TEST_CASE("Triangles in one plane without a shared vertex", "[mesh][self_crossings]") {
  CHECK(apart_from_base({1, 1, 0}, {2, 1, 0}, {1, 2, 0}) == PairMeeting::CoplanarOverlap);   // inside
  CHECK(apart_from_base({0, 0, 0}, {4, 0, 0}, {0, 4, 0}) == PairMeeting::CoplanarOverlap);   // equal positions
  CHECK(apart_from_base({2, 0, 0}, {2, 2, 0}, {0, 2, 0}) == PairMeeting::CoplanarOverlap);   // inscribed
  CHECK(apart_from_base({-1, 1, 0}, {9, 1, 0}, {4, 2, 0}) == PairMeeting::CoplanarOverlap);  // across
  CHECK(apart_from_base({0, 0, 0}, {4, 0, 0}, {0, -4, 0}) == PairMeeting::Touching);         // edge on equal edge
  CHECK(apart_from_base({1, 0, 0}, {2, -1, 0}, {1, -1, 0}) == PairMeeting::Touching);        // corner on edge
  CHECK(apart_from_base({4, 0, 0}, {5, 0, 0}, {5, 1, 0}) == PairMeeting::Touching);          // equal corners
  CHECK(apart_from_base({5, 0, 0}, {6, 0, 0}, {5, 1, 0}) == PairMeeting::Apart);
  CHECK(apart_from_base({3, 3, 0}, {4, 3, 0}, {3, 4, 0}) == PairMeeting::Apart);  // boxes overlap
}

TEST_CASE("Triangles that share one vertex", "[mesh][self_crossings]") {
  CHECK(at_corner_of_base({1, 1, 1}, {1, 2, 1}) == PairMeeting::Apart);
  CHECK(at_corner_of_base({-1, -1, 1}, {-1, -1, -1}) == PairMeeting::Apart);  // straddles, but away from the base
  CHECK(at_corner_of_base({1, 1, 1}, {1, 1, -1}) == PairMeeting::Crossing);   // ends inside
  CHECK(at_corner_of_base({9, 9, 1}, {9, 9, -1}) == PairMeeting::Crossing);   // runs through
  CHECK(at_corner_of_base({2, 2, 1}, {2, 2, -1}) == PairMeeting::Crossing);   // ends on the opposite edge
  CHECK(at_corner_of_base({1, 1, 0}, {1, 1, 1}) == PairMeeting::Touching);    // an edge lies inside
  CHECK(at_corner_of_base({2, 0, 1}, {2, 0, -1}) == PairMeeting::Touching);   // the inside runs along an edge
  CHECK(at_corner_of_base({2, 0, 0}, {2, 0, 1}) == PairMeeting::Touching);    // edges along each other
  CHECK(at_corner_of_base({-2, 0, 0}, {2, 0, 1}) == PairMeeting::Apart);      // on the same line, the other way
  CHECK(at_corner_of_base({1, 1, 0}, {1, 2, 0}) == PairMeeting::CoplanarOverlap);
  CHECK(at_corner_of_base({-1, 5, 0}, {5, -1, 0}) == PairMeeting::CoplanarOverlap);
  CHECK(at_corner_of_base({2, 0, 0}, {1, -1, 0}) == PairMeeting::Touching);  // edges along each other, in one plane
  CHECK(at_corner_of_base({9, 0, 0}, {1, -1, 0}) == PairMeeting::Touching);
  CHECK(at_corner_of_base({-1, 0, 0}, {-1, -1, 0}) == PairMeeting::Apart);
}

TEST_CASE("Triangles that share an edge or all vertices", "[mesh][self_crossings]") {
  CHECK(at_edge_of_base({0, -4, 0}) == PairMeeting::Apart);
  CHECK(at_edge_of_base({1, 1, 1}) == PairMeeting::Apart);
  CHECK(at_edge_of_base({1, 1, 0x1p-1074}) == PairMeeting::Apart);
  CHECK(at_edge_of_base({1, 1, 0}) == PairMeeting::CoplanarOverlap);
  CHECK(at_edge_of_base({9, 9, 0}) == PairMeeting::CoplanarOverlap);
  CHECK(meeting_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 1, 2}}) == PairMeeting::CoplanarOverlap);
  CHECK(meeting_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 1}}) == PairMeeting::CoplanarOverlap);
}

TEST_CASE("A face without area always meets beyond what is shared", "[mesh][self_crossings]") {
  const SurfaceMesh mesh = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {8, 8, 8}, {7, 7, 7}, {0, 0, 5}},
                                           {{0, 1, 2}, {3, 4, 5}, {3, 3, 4}, {0, 1, 6}});
  CHECK_FALSE(is_degenerate(mesh, FaceId(std::size_t{0})));
  CHECK(is_degenerate(mesh, FaceId(std::size_t{1})));
  CHECK(is_degenerate(mesh, FaceId(std::size_t{2})));
  CHECK(triangles_meet_beyond_shared(mesh, first, FaceId(std::size_t{1})));
  CHECK(triangles_meet_beyond_shared(mesh, FaceId(std::size_t{2}), first));
  CHECK_FALSE(triangles_meet_beyond_shared(mesh, first, FaceId(std::size_t{3})));
  CHECK(find_self_crossings(mesh).empty());
  CHECK(count_self_crossings(mesh).degenerate_faces == 2);
}

TEST_CASE("Closed shapes meet themselves nowhere, overlapping ones do, and counts agree with the list", "[mesh][self_crossings]") {
  CHECK(find_self_crossings(make_torus(3, 1, 24, 12)).empty());
  const SurfaceMesh boxes =
      test::joined({test::box({0, 0, 0}, {2, 2, 2}), test::box({1, 1, 1}, {3, 3, 3}), test::box({0, 0, 2}, {2, 2, 4})});
  const std::vector<SelfCrossing> pairs = find_self_crossings(boxes);
  CHECK(plain(pairs) == oracle::self_crossings(boxes));
  const SelfCrossingCounts counts = count_self_crossings(boxes);
  const auto count = [&](PairMeeting kind) {
    return static_cast<std::uint64_t>(
        std::count_if(pairs.begin(), pairs.end(), [&](const SelfCrossing& pair) { return pair.kind == kind; }));
  };
  CHECK(counts.crossing == count(PairMeeting::Crossing));
  CHECK(counts.coplanar_overlap == count(PairMeeting::CoplanarOverlap));
  CHECK(counts.touching == count(PairMeeting::Touching));
  CHECK(counts.crossing > 0);
  CHECK(counts.coplanar_overlap == 2);
}

TEST_CASE("Random triangles on small grids meet as the oracle says", "[mesh][self_crossings]") {
  const unsigned seed = 23;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  constexpr std::array<double, 4> scales{1, 0.1, 0x1p-1074, 0x1p1000};
  for (std::size_t round = 0; round < test::scaled_count(2000, 40000); ++round) {
    const std::uint32_t grid = 2 + static_cast<std::uint32_t>(random() % 5);
    const SurfaceMesh mesh = random_mesh(random, 5 + random() % 20, grid, scales[round % scales.size()]);
    INFO("round " << round);
    REQUIRE(plain(find_self_crossings(mesh)) == oracle::self_crossings(mesh));
  }
}

TEST_CASE("Random triangles of long mantissas, nearly degenerate, meet as the oracle says", "[mesh][self_crossings]") {
  const unsigned seed = 29;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (std::size_t round = 0; round < test::scaled_count(300, 6000); ++round) {
    SurfaceMesh mesh = random_mesh(random, 12, 3, 1.0 / 3);
    for (Vec3d& p : mesh.points) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (random() % 3 == 0) p[i] = std::nextafter(p[i], random() % 2 == 0 ? -1.0 : 1.0);
      }
    }
    INFO("round " << round);
    REQUIRE(plain(find_self_crossings(mesh)) == oracle::self_crossings(mesh));
  }
}

TEST_CASE("Real files have the known number of crossing pairs", "[mesh][self_crossings][data]") {
  if (!test::data_folder()) {
    WARN("skipped: there is no data folder (MORTISE_DATA)");
    return;
  }
  const std::vector<std::pair<std::string, std::uint64_t>> known{{"nasty/two_spheres.stl", 132},
                                                                 {"nasty/three_cubes.stl", 41},
                                                                 {"nasty/sphere_pair_overlap.obj", 147},
                                                                 {"nasty/manifold_Generic_Twin_7863_right.obj", 3},
                                                                 {"nasty/ceasiom_aircraft_soup.stl", 92},
                                                                 {"nasty/assimp_3DSMaxExport.STL", 356},
                                                                 {"aircraft/cape_bullet_box_overlap.obj", 62},
                                                                 {"scans/spot.obj", 0}};
  for (const auto& [file, crossings] : known) {
    INFO(file);
    const SurfaceMesh mesh = test::read_data(file);
    CHECK(count_self_crossings(mesh).crossing == crossings);
    CHECK(plain(find_self_crossings(mesh)) == oracle::self_crossings(mesh));
  }
}

}  // namespace mortise
