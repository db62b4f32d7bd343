// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a list of self pairs leaves out touches nowhere; what it keeps is little.
#include "mortise/arrange/self_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boolean/evaluation.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_maps.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SelfPairs pairs_of(const SurfaceMesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  std::vector<std::uint32_t> lowest;
  for (const VertexId v : welded.new_vertex) lowest.push_back(welded.old_vertex[v.index()].value);
  return find_self_pairs(mesh, lowest);
}

/// Pairs that touch beyond what they share, found by the search that knows nothing.
std::vector<std::array<std::uint32_t, 2>> touching_pairs(const SurfaceMesh& mesh) {
  const OperandFaces faces = gather({mesh}, {0});
  const Contacts contacts = find_contacts(faces, std::uint64_t{1} << 31, {});
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const Contact& c : contacts.contacts) pairs.push_back({c.face_a.value, c.face_b.value});
  return pairs;
}

/// A touching pair of an image that the list does not have; empty when it has all. Images that round too much count as fine.
std::string missing_pair(const SelfPairs& known, const SurfaceMesh& mesh, const AffineMap& map) {
  if (!(rounding_seen_in_mesh(map, bounding_box(mesh)) <= known.slack)) return "";
  for (const auto& pair : touching_pairs(transform(mesh, map))) {
    if (!std::binary_search(known.pairs.begin(), known.pairs.end(), pair)) {
      return std::to_string(pair[0]) + " and " + std::to_string(pair[1]);
    }
  }
  return "";
}

/// Two faces on a common edge with almost no angle between them, and others that almost touch.
SurfaceMesh almost_folded(double angle) {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.25, 0.75, angle}, {0.5, 0.5, 2 * angle}, {3, 3, 2 * angle}, {3, 2, 1}},
                   {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}});
}

}  // namespace

TEST_CASE("no pair of faces of a moved mesh touches that is not in the list") {
  RandomSolids solids(17);
  RandomMaps maps(18);
  std::size_t listed = 0;
  for (std::size_t i = 0; i < scaled_count(300, 5000); ++i) {
    const SurfaceMesh mesh = i % 3 == 0 ? joined(solids.next(2)) : solids.next_of_all_kinds();
    const SelfPairs known = pairs_of(mesh);
    REQUIRE(known.is_known);
    listed += known.pairs.size();
    INFO("mesh " << i);
    for (int k = 0; k < 8; ++k) CHECK(missing_pair(known, mesh, maps.next(3)) == "");
  }
  CHECK(listed > 0);
}

TEST_CASE("faces that only rounding brings together are in the list") {
  for (int exponent = -60; exponent <= -1; ++exponent) {
    const SurfaceMesh mesh = almost_folded(std::ldexp(1.0, exponent));
    const SelfPairs known = pairs_of(mesh);
    INFO("angle 2^" << exponent);
    if (exponent < -38) CHECK(known.pairs.size() == 3);
    if (exponent > -20) CHECK(known.pairs.empty());
    RandomMaps maps(19);
    for (int k = 0; k < 40; ++k) CHECK(missing_pair(known, mesh, maps.next(2)) == "");
  }
}

TEST_CASE("clean meshes have next to no pairs") {
  CHECK(pairs_of(make_icosphere(1, 4)).pairs.empty());
  CHECK(pairs_of(make_torus(2, 0.5, 64, 32)).pairs.empty());
  CHECK(pairs_of(make_grid_sheet(1, 1, 40, 30)).pairs.empty());
  CHECK(pairs_of(soup_of(box({0, 0, 0}, {1, 2, 3}))).pairs.empty());
}

TEST_CASE("more than a few pairs per face are not kept, nor those of coordinates too large or small to multiply") {
  std::vector<SurfaceMesh> copies(12, box({0, 0, 0}, {1, 1, 1}));
  CHECK(!pairs_of(joined(copies)).is_known);
  CHECK(!pairs_of(scaled(box({0, 0, 0}, {1, 1, 1}), 0x1p300)).is_known);
  CHECK(!pairs_of(scaled(box({0, 0, 0}, {1, 1, 1}), 0x1p-300)).is_known);
  CHECK(!pairs_of({}).is_known);
}

TEST_CASE("the rounding of a map is bounded by what it does") {
  RandomMaps maps(20);
  const Box3 box{{-3, -2, -1}, {1, 2, 3}};
  CHECK(rounding_seen_in_mesh(translation({1e6, 0, 0}), box) > 1e-10);
  CHECK(rounding_seen_in_mesh(rotation(Axis::X, 30), box) < 1e-13);
  CHECK(std::isinf(rounding_seen_in_mesh(scaling({1, 1, 1e-200}), box)));
  CHECK(std::isinf(rounding_seen_in_mesh(scaling({1e200, 1e200, 1e200}), box)) == false);
  for (int i = 0; i < 200; ++i) {
    const AffineMap map = maps.next(4);
    const double bound = rounding_seen_in_mesh(map, box);
    for (int k = 0; k < 20; ++k) {
      const Vec3d p = maps.point(-1, 1);
      const Vec3d near = apply(map, p);
      long double largest_row = 0;  // the error of a coordinate, divided by the largest stretch of the map
      long double error = 0;
      for (std::size_t r = 0; r < 3; ++r) {
        long double sum = map.offset[r], row = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          sum += static_cast<long double>(map.linear[r][c]) * p[c];
          row += std::fabs(map.linear[r][c]);
        }
        error = std::max(error, std::fabs(sum - near[r]));
        largest_row = std::max(largest_row, row);
      }
      CHECK(static_cast<double>(error / largest_row) <= bound);
    }
  }
}
