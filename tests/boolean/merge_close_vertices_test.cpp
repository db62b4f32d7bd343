// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Merging of close vertices: which of two stays, what goes with them, and that the result stays balanced.
#include "mortise/boolean/merge_close_vertices.h"

#include <algorithm>
#include <set>

#include "boolean/evaluation.h"
#include "boolean/merged_meshes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/grid_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double reach = 0x1p-46;

/// The unit box with edge 0 - 1 split at these places, one after the other: vertices 8, 9, ...
SurfaceMesh split_box(const std::vector<double>& places) {
  SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  VertexId from(0);
  for (const double x : places) {
    const VertexId v(mesh.points.size()), to(1);
    mesh.points.push_back({x, 0, 0});
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
      const Triangle c = mesh.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = c[i], b = c[(i + 1) % 3], apex = c[(i + 2) % 3];
        if (!(a == from && b == to) && !(a == to && b == from)) continue;
        mesh.triangles[t] = {a, v, apex};
        mesh.triangles.push_back({v, b, apex});
      }
    }
    from = v;
  }
  return mesh;
}

std::vector<FailedPair> all_failed(const SurfaceMesh& mesh) {
  std::vector<FailedPair> failed;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) failed.push_back({FaceId(t), FaceId(t)});
  return failed;
}

/// A split box as a result with the box's corners as input vertices.
struct Repair {
  explicit Repair(const SurfaceMesh& mesh, std::size_t inputs = 8)
      : faces(points_only(inputs, mesh.points.size())),
        merged(merged_of(mesh, inputs, faces)),
        facets(facets_of(merged)),
        failed(all_failed(mesh)) {}

  bool run(double how_far = reach) { return merge_close_vertices(faces, facets, failed, {reach, how_far}, merged); }

  OperandFaces faces;
  MergedMesh merged;
  Facets facets;
  std::vector<FailedPair> failed;
};

}  // namespace

TEST_CASE("a made vertex next to an input vertex becomes it, and the triangles between go") {
  Repair repair(split_box({1 - 0x1p-50}));
  REQUIRE(repair.merged.mesh.triangles.size() == 14);
  REQUIRE(repair.run());
  CHECK(fault_of(repair.merged) == "");
  CHECK(repair.merged.mesh.triangles.size() == 12);
  CHECK(repair.merged.mesh.points == box({0, 0, 0}, {1, 1, 1}).points);
  CHECK(repair.merged.repair_displacement == 0x1p-50);
  CHECK(std::count(repair.merged.is_repaired.begin(), repair.merged.is_repaired.end(), 1) == 2);
}

TEST_CASE("made vertices on the same doubles become one without any failure, input vertices are left alone") {
  Repair repair(split_box({0.25, 0.25, 0}));
  merge_equal_vertices(repair.faces, repair.facets, Coordinates::Float64, repair.merged);
  CHECK(fault_of(repair.merged) == "");
  CHECK(repair.merged.mesh.points.size() == 10);  // the one at 0 and the corner are not both made
  CHECK(repair.merged.mesh.triangles.size() == 16);
  CHECK(repair.merged.repair_displacement == 0);
}

TEST_CASE("where no made vertices are on the same doubles, nothing is repaired") {
  Repair repair(split_box({0.25, 0.5}));
  merge_equal_vertices(repair.faces, repair.facets, Coordinates::Float64, repair.merged);
  CHECK(repair.merged.mesh.points.size() == 10);
  CHECK(repair.merged.facets_before_repair.empty());
}

TEST_CASE("two made vertices become the first of them") {
  Repair repair(split_box({0.5, 0.5 + 0x1p-50}));
  REQUIRE(repair.run());
  CHECK(fault_of(repair.merged) == "");
  REQUIRE(repair.merged.mesh.points.size() == 9);
  CHECK(repair.merged.mesh.points[8] == Vec3d{0.5, 0, 0});
  CHECK(repair.merged.repair_displacement == 0x1p-50);
}

TEST_CASE("a row of close vertices ends at the input vertex, and the displacement is that of the farthest") {
  Repair repair(split_box({1 - 3 * 0x1p-50, 1 - 2 * 0x1p-50, 1 - 0x1p-50}));
  REQUIRE(repair.run());
  CHECK(fault_of(repair.merged) == "");
  CHECK(repair.merged.mesh.triangles.size() == 12);
  CHECK(repair.merged.mesh.points.size() == 8);
  CHECK(repair.merged.repair_displacement == 3 * 0x1p-50);
}

TEST_CASE("which of some triangles on the same corners remains does not depend on their numbers") {
  const VertexId a(0U), b(1U);
  std::vector<Triangle> layers{{a, b, VertexId(2U)}, {a, b, VertexId(3U)}, {b, a, VertexId(4U)}};
  std::set<PlanePoints> remaining;
  std::sort(layers.begin(), layers.end());
  do {
    SurfaceMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0x1p-50}, {0, 1, 0x1p-49}};
    mesh.triangles = layers;
    Repair repair(mesh, 2);
    repair.failed = {{FaceId(0U), FaceId(1U)}, {FaceId(1U), FaceId(2U)}};
    REQUIRE(repair.run());
    REQUIRE(repair.merged.mesh.triangles.size() == 1);
    remaining.insert(repair.facets.corners[repair.merged.facet_of_triangle[0].facet]);
  } while (std::next_permutation(layers.begin(), layers.end()));
  CHECK(remaining.size() == 1);
}

TEST_CASE("input vertices never move, however close") {
  Repair repair(split_box({1 - 0x1p-50}), 9);
  CHECK_FALSE(repair.run());
  CHECK(repair.merged.mesh.triangles.size() == 14);
  CHECK(repair.merged.repair_displacement == 0);
  // A made vertex between two input vertices joins one of them, not both to each other.
  const SurfaceMesh mesh = split_box({1 - 2 * 0x1p-50, 1 - 0x1p-50});
  Repair between(mesh, 9);
  REQUIRE(between.run());
  CHECK(fault_of(between.merged) == "");
  CHECK(between.merged.mesh.points.size() == 9);
  for (std::size_t v = 0; v < 9; ++v) CHECK(between.merged.mesh.points[v] == mesh.points[v]);
}

TEST_CASE("vertices beyond reach, and of triangles that did not fail, are left alone") {
  const SurfaceMesh mesh = split_box({1 - 0x1p-45});
  Repair far(mesh);
  CHECK_FALSE(far.run());
  CHECK(has_same_bits(far.merged.mesh, mesh));
  CHECK(far.run(0x1p-45));
  Repair elsewhere(split_box({1 - 0x1p-50}));
  // Triangles 2 and 3 are the top of the box.
  elsewhere.failed = {{FaceId(2), FaceId(3)}};
  CHECK_FALSE(elsewhere.run());
  elsewhere.failed.clear();
  CHECK_FALSE(elsewhere.run());
}

TEST_CASE("vertices of two triangles that failed together are compared as well") {
  // Two boxes apart: one made vertex each, next to the other.
  SurfaceMesh mesh = joined({box({0, 0, 0}, {1, 1, 1}), tetrahedron({1 + 0x1p-50, 1, 1}, {2, 1, 1}, {2, 2, 1}, {2, 1, 2})});
  std::size_t tip = 0, of_tip = 0, of_corner = 0;
  for (std::size_t v = 8; v < mesh.points.size(); ++v) tip = mesh.points[v].x < 1.5 ? v : tip;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const VertexId v : mesh.triangles[t]) {
      if (v.index() == tip) of_tip = t;
      if (v.index() == 7) of_corner = t;
    }
  }
  Repair repair(mesh);
  repair.failed = {{FaceId(of_corner), FaceId(of_tip)}};
  REQUIRE(repair.run());
  CHECK(fault_of(repair.merged) == "");
  CHECK(repair.merged.mesh.points.size() == 11);
  CHECK(repair.merged.mesh.triangles.size() == 16);
}

TEST_CASE("opposite triangles on the same corners cancel: a shell flattened to nothing is gone") {
  SurfaceMesh mesh = octahedron({0, 0, 0}, 1);
  mesh.points[4] = {0, 0, 0x1p-50};
  mesh.points[5] = {0, 0, -0x1p-50};
  Repair repair(joined({mesh, box({5, 5, 5}, {6, 6, 6})}), 0);
  repair.failed = {{FaceId(0), FaceId(4)}};  // one face at either tip
  REQUIRE(repair.run());
  CHECK(fault_of(repair.merged) == "");
  CHECK(repair.merged.mesh.triangles.size() == 12);
  CHECK(repair.merged.mesh.points.size() == 8);
  CHECK(repair.merged.provenance.source_face.front() == 8);  // what is left knows where it comes from
}

TEST_CASE("labels and sources stay with their triangles") {
  Repair repair(split_box({1 - 0x1p-50}));
  MergedMesh& merged = repair.merged;
  merged.mesh.label_names = {"even", "odd"};
  for (std::size_t t = 0; t < 14; ++t) {
    merged.mesh.face_labels.push_back(t % 2);
    merged.provenance.other_source_begin[t + 1] = static_cast<std::uint32_t>(t + 1);
    merged.provenance.other_source_operand.push_back(1);
    merged.provenance.other_source_face.push_back(static_cast<std::uint32_t>(100 + t));
    merged.provenance.other_source_flipped.push_back(static_cast<std::uint8_t>(t));
  }
  REQUIRE(repair.run());
  CHECK(fault_of(merged) == "");
  for (std::size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
    const std::uint32_t source = merged.provenance.source_face[t];
    CHECK(merged.mesh.face_labels[t] == source % 2);
    CHECK(merged.provenance.other_source_face[merged.provenance.other_source_begin[t]] == 100 + source);
    CHECK(merged.provenance.other_source_flipped[merged.provenance.other_source_begin[t]] == source);
    CHECK(merged.facet_of_triangle[t].facet == FacetId(source));
  }
}

TEST_CASE("results of random solids stay balanced whatever is merged, and no input vertex moves") {
  constexpr std::uint32_t seed = 40;
  INFO("seed " << seed);
  GridSolids random(seed);
  std::size_t merges = 0;
  for (std::size_t i = 0, n = scaled_count(150, 10000); i < n; ++i) {
    INFO("case " << i);
    const auto operation = static_cast<Operation>(random.below(3));
    MergedScene scene(operation, {random.solid(4), random.solid(4)});
    MergedMesh& merged = scene.merged;
    std::vector<FailedPair> failed;
    for (std::size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
      if (random.below(2) == 0)
        failed.push_back({FaceId(t), FaceId(static_cast<std::size_t>(random.below(static_cast<int>(merged.mesh.triangles.size()))))});
    }
    const std::size_t before = merged.mesh.points.size();
    const double how_far = 0.5 + random.below(3);
    if (!merge_close_vertices(scene.faces, scene.facets, failed, {reach, how_far}, merged)) continue;
    ++merges;
    CHECK(fault_of(merged) == "");
    CHECK(merged.mesh.points.size() < before);
    CHECK(merged.repair_displacement > 0);
    // No vertex moved: those that are left are where their points are.
    for (std::size_t v = 0; v < merged.mesh.points.size(); ++v)
      CHECK(merged.mesh.points[v] == scene.faces.points.nearest(merged.point_of_vertex[v]));
  }
  CHECK(merges > scaled_count(150, 10000) / 4);
}
