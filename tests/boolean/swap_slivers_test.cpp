// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Swaps of the longest edge of slivers: which are done, which are not, and what the two triangles know afterwards.
#include "mortise/boolean/swap_slivers.h"

#include <algorithm>
#include <cmath>

#include "boolean/evaluation.h"
#include "boolean/merged_meshes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/grid_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double height = 0x1p-50;

/// The unit box; vertex 8 lies `h` beside the middle of the diagonal 0 - 3 of its bottom. Triangle 1 is the sliver
/// (0, 3, 8), triangle 0 its neighbour (0, 2, 3).
SurfaceMesh box_with_sliver(double h) {
  SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.points.push_back({0.5 + h, 0.5 - h, 0});
  mesh.triangles[1] = {VertexId(0), VertexId(3), VertexId(8)};
  mesh.triangles.push_back({VertexId(3), VertexId(1), VertexId(8)});
  mesh.triangles.push_back({VertexId(1), VertexId(0), VertexId(8)});
  return mesh;
}

MergedMesh merged_box(double h) {
  const SurfaceMesh mesh = box_with_sliver(h);
  return merged_of(mesh, 8, points_only(8, 1));
}

bool has_triangle(const MergedMesh& merged, std::array<std::size_t, 3> corners) {
  return std::any_of(merged.mesh.triangles.begin(), merged.mesh.triangles.end(), [&](Triangle t) {
    for (int i = 0; i < 3; ++i) {
      if (t[0].index() == corners[0] && t[1].index() == corners[1] && t[2].index() == corners[2]) return true;
      std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    return false;
  });
}

const std::vector<FailedPair> the_sliver{{FaceId(1), FaceId(1)}};

bool swap_failed(std::span<const FailedPair> failed, const RepairReach& reach, MergedMesh& merged) {
  const OperandFaces enough_points = points_only(40, 8);
  const Facets facets = facets_of(merged);
  return swap_slivers(FacetOrder(enough_points, facets), failed, reach, merged);
}

}  // namespace

TEST_CASE("a sliver gives its longest edge another diagonal") {
  MergedMesh merged = merged_box(height / 2);
  REQUIRE(swap_failed(the_sliver, {0x1p-46, height}, merged));
  CHECK(fault_of(merged) == "");
  CHECK(merged.mesh.triangles.size() == 14);
  CHECK((has_triangle(merged, {8, 0, 2}) && has_triangle(merged, {2, 3, 8})));
  CHECK_FALSE(has_triangle(merged, {0, 3, 8}));
  CHECK(merged.mesh.points == box_with_sliver(height / 2).points);
}

TEST_CASE("the displacement is the height of the sliver") {
  MergedMesh merged = merged_box(height / 2);
  REQUIRE(swap_failed(the_sliver, {0x1p-46, height}, merged));
  const double exact = height / 2 * 1.4142135623730951;
  CHECK(std::abs(merged.repair_displacement - exact) < 0x1p-53);  // computed from coordinates of one half
}

TEST_CASE("both triangles belong to the face of the neighbour afterwards, with its label, sense and other sources") {
  for (const bool neighbour_has_more : {false, true}) {
    MergedMesh merged = merged_box(height / 2);
    Provenance& p = merged.provenance;
    merged.mesh.label_names = {"a", "b"};
    merged.mesh.face_labels.assign(14, 0);
    merged.mesh.face_labels[0] = 1;
    p.flipped[0] = 1;
    p.source_operand[0] = 7;
    p.category[0] = FacetCategory::OnSame;
    // Triangle 0 has two further sources or none, triangle 1 none or one, triangle 2 one.
    const std::vector<std::uint32_t> counts =
        neighbour_has_more ? std::vector<std::uint32_t>{2, 0, 1} : std::vector<std::uint32_t>{0, 1, 1};
    std::uint32_t sum = 0;
    for (std::size_t t = 0; t < 14; ++t) {
      for (std::uint32_t i = 0; t < 3 && i < counts[t]; ++i) {
        p.other_source_operand.push_back(static_cast<std::uint32_t>(t));
        p.other_source_face.push_back(10 * static_cast<std::uint32_t>(t) + i);
        p.other_source_flipped.push_back(static_cast<std::uint8_t>(t));
        ++sum;
      }
      p.other_source_begin[t + 1] = sum;
    }
    REQUIRE(swap_failed(the_sliver, {0x1p-46, height}, merged));
    CHECK(fault_of(merged) == "");
    const std::uint32_t expected = counts[0];
    for (const std::size_t t : {0U, 1U}) {
      CHECK(merged.mesh.face_labels[t] == 1);
      CHECK((p.source_operand[t] == 7 && p.source_face[t] == 0 && p.flipped[t] == 1));
      CHECK(merged.facet_of_triangle[t].facet == FacetId(0));
      CHECK(merged.is_repaired[t] == 1);
      CHECK(p.category[t] == FacetCategory::OnSame);
      REQUIRE(p.other_source_begin[t + 1] - p.other_source_begin[t] == expected);
      for (std::uint32_t i = 0; i < expected; ++i) CHECK(p.other_source_face[p.other_source_begin[t] + i] == i);
    }
    CHECK(p.other_source_face[p.other_source_begin[2]] == 20);
    CHECK(p.other_source_flipped[p.other_source_begin[2]] == 2);
    CHECK(p.other_source_flipped.size() == p.other_source_face.size());
    CHECK(merged.is_repaired[2] == 0);
  }
}

TEST_CASE("a triangle higher than the reach of its place and than the least reach is no sliver") {
  const double high = 0x1p-46;  // the reach where coordinates are one half is half of that
  MergedMesh merged = merged_box(high);
  CHECK_FALSE(swap_failed(the_sliver, {0x1p-46, height}, merged));
  CHECK(has_same_bits(merged.mesh, box_with_sliver(high)));
  CHECK(merged.repair_displacement == 0);
  CHECK(swap_failed(the_sliver, {0x1p-46, 2 * high}, merged));
}

TEST_CASE("the reach of its place is enough for a sliver") {
  MergedMesh merged = merged_box(0x1p-48);
  CHECK(swap_failed(the_sliver, {0x1p-46, 0}, merged));
}

TEST_CASE("slivers next to a failed triangle are swapped, others are not") {
  MergedMesh near = merged_box(height / 2);
  CHECK(swap_failed(std::vector<FailedPair>{{FaceId(0), FaceId(0)}}, {0x1p-46, height}, near));  // the neighbour failed
  MergedMesh far = merged_box(height / 2);
  CHECK_FALSE(swap_failed(std::vector<FailedPair>{{FaceId(2), FaceId(3)}}, {0x1p-46, height}, far));  // the top did
  CHECK_FALSE(swap_failed({}, {0x1p-46, height}, far));
}

TEST_CASE("no swap makes an edge that is there already") {
  // A flat tetrahedron: the edge between its sliver's corner and the neighbour's exists.
  const SurfaceMesh flat = tetrahedron({0, 0, 0}, {2, 0, 0}, {1, height, 0}, {1, 1, height});
  const OperandFaces faces = points_only(4, 0);
  MergedMesh merged = merged_of(flat, 4, faces);
  std::vector<FailedPair> failed;
  for (std::size_t t = 0; t < 4; ++t) failed.push_back({FaceId(t), FaceId(t)});
  CHECK_FALSE(swap_failed(failed, {0x1p-46, height}, merged));
  CHECK(has_same_bits(merged.mesh, flat));
}

TEST_CASE("an edge of four triangles is not swapped") {
  // Two flat tents that share their longest edge, one above it and one below.
  const auto tent = [](double z) { return tetrahedron({0, 0, 0}, {2, 0, 0}, {1, height / 2, z * height / 4}, {1, 1, z}); };
  SurfaceMesh mesh = joined({tent(1), tent(-1)});
  // Weld the common edge.
  std::vector<VertexId> first(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    first[v] = VertexId(static_cast<std::size_t>(std::find(mesh.points.begin(), mesh.points.end(), mesh.points[v]) - mesh.points.begin()));
  }
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = first[v.index()];
  }
  const OperandFaces faces = points_only(mesh.points.size(), 0);
  MergedMesh merged = merged_of(mesh, mesh.points.size(), faces);
  std::vector<FailedPair> failed;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) failed.push_back({FaceId(t), FaceId(t)});
  (void)swap_failed(failed, {0x1p-46, height}, merged);
  CHECK(is_balanced(merged.mesh));
  std::size_t at_edge = 0;
  for (const Triangle& t : merged.mesh.triangles) {
    const auto has = [&](const Vec3d& p) {
      return std::any_of(t.begin(), t.end(), [&](VertexId v) { return merged.mesh.points[v.index()] == p; });
    };
    at_edge += has({0, 0, 0}) && has({2, 0, 0}) ? 1 : 0;
  }
  CHECK(at_edge == 4);
}

TEST_CASE("no triangle is swapped twice in one call") {
  // Two slivers over one neighbour: vertices beside two of its edges.
  SurfaceMesh mesh = box_with_sliver(height / 2);
  // (0, 2, 3) is the neighbour; the side y = 1 has its edge from 3 to 2, and gets a vertex beside that edge.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle c = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      if (c[0] == VertexId(3) && c[1] == VertexId(2)) {
        const VertexId tip(mesh.points.size());
        mesh.points.push_back({0.5, 1, height / 2});
        mesh.triangles[t] = {c[0], c[1], tip};
        mesh.triangles.push_back({c[1], c[2], tip});
        mesh.triangles.push_back({c[2], c[0], tip});
        break;
      }
      std::rotate(c.begin(), c.begin() + 1, c.end());
    }
  }
  REQUIRE(mesh.points.size() == 10);
  const OperandFaces faces = points_only(8, 2);
  MergedMesh merged = merged_of(mesh, 8, faces);
  std::vector<FailedPair> failed;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) failed.push_back({FaceId(t), FaceId(t)});
  REQUIRE(swap_failed(failed, {0x1p-46, height}, merged));
  CHECK(fault_of(merged) == "");
  CHECK(std::count(merged.is_repaired.begin(), merged.is_repaired.end(), 1) == 2);
  REQUIRE(swap_failed(failed, {0x1p-46, height}, merged));
  CHECK(fault_of(merged) == "");
}

TEST_CASE("results of random solids stay balanced whatever is swapped, and no vertex moves") {
  constexpr std::uint32_t seed = 41;
  INFO("seed " << seed);
  GridSolids random(seed);
  std::size_t swaps = 0;
  for (std::size_t i = 0, n = scaled_count(150, 10000); i < n; ++i) {
    INFO("case " << i);
    const auto operation = static_cast<Operation>(random.below(3));
    MergedScene scene(operation, {random.solid(4), random.solid(4)});
    const SurfaceMesh before = scene.merged.mesh;
    std::vector<FailedPair> failed;
    for (std::size_t t = 0; t < before.triangles.size(); ++t) {
      if (random.below(2) == 0) failed.push_back({FaceId(t), FaceId(t)});
    }
    if (!swap_failed(failed, {0x1p-46, 0.25 + random.below(3)}, scene.merged)) continue;
    ++swaps;
    CHECK(fault_of(scene.merged) == "");
    CHECK(scene.merged.mesh.points == before.points);
    CHECK(scene.merged.mesh.triangles.size() == before.triangles.size());
    CHECK(scene.merged.repair_displacement > 0);
  }
  CHECK(swaps > scaled_count(150, 10000) / 4);
}

namespace {

/// Three triangles at the edge 0 - 1, and the sliver (0, 1, 2) between them, which has vertex 2 just above it.
MergedMesh fan_with_sliver() {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, height / 2}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, -1}};
  const VertexId u(0U), v(1U), a(2U);
  mesh.triangles = {{u, v, a}, {v, u, VertexId(3U)}, {u, v, VertexId(4U)}, {v, u, VertexId(5U)}};
  MergedMesh merged = merged_of(mesh, 6, points_only(6, 0));
  merged.provenance.covering_front = {0, 0, 0, 0};
  merged.provenance.source_operand = {0, 1, 2, 1};
  merged.provenance.covering_sets = {{}};
  return merged;
}

}  // namespace

TEST_CASE("where inner faces are kept, every triangle at the edge of a sliver takes its corner in") {
  MergedMesh merged = fan_with_sliver();
  REQUIRE(swap_failed(std::vector<FailedPair>{{FaceId(0), FaceId(0)}}, {0x1p-46, height}, merged));
  CHECK(merged.mesh.triangles.size() == 6);
  for (const auto& corners : {std::array<std::size_t, 3>{2, 0, 3}, {3, 1, 2}, {0, 2, 4}, {2, 1, 4}, {2, 0, 5}, {5, 1, 2}}) {
    CHECK(has_triangle(merged, corners));
  }
  std::vector<std::uint32_t> operands = merged.provenance.source_operand;
  std::sort(operands.begin(), operands.end());
  CHECK(operands == std::vector<std::uint32_t>{1, 1, 1, 1, 2, 2});
  CHECK(merged.is_repaired == std::vector<std::uint8_t>(6, 1));
  CHECK(merged.provenance.other_source_begin == std::vector<std::uint32_t>(7, 0));
  CHECK(merged.facet_of_triangle.size() == 6);
}

TEST_CASE("of a boolean only edges of two triangles are swapped") {
  MergedMesh merged = fan_with_sliver();
  merged.provenance.covering_front.clear();
  CHECK_FALSE(swap_failed(std::vector<FailedPair>{{FaceId(0), FaceId(0)}}, {0x1p-46, height}, merged));
}
