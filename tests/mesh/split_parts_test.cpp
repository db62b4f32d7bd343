// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Parts by components and by regions: what stays together, what comes apart, where faces and vertices come from.
#include "mortise/mesh/split_parts.h"

#include "mortise/mesh/measures.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

std::vector<double> volumes_of(const std::vector<MeshPart>& parts) {
  std::vector<double> volumes;
  for (const MeshPart& part : parts) volumes.push_back(enclosed_volume(part.mesh));
  return volumes;
}

/// Do the faces of all parts lie where their sources lie, and is each source there once?
bool is_partition(const SurfaceMesh& mesh, const std::vector<MeshPart>& parts) {
  std::vector<int> times(mesh.triangles.size(), 0);
  for (const MeshPart& part : parts) {
    for (std::size_t f = 0; f < part.mesh.triangles.size(); ++f) {
      ++times[part.source_face[f].index()];
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId v = part.mesh.triangles[f][i];
        const Vec3d& p = part.mesh.points[v.index()];
        if (p != mesh.points[mesh.triangles[part.source_face[f].index()][i].index()]) return false;
        if (p != mesh.points[part.source_vertex[v.index()].index()]) return false;
      }
    }
  }
  return times == std::vector<int>(mesh.triangles.size(), 1);
}

SurfaceMesh boxes_at(const Vec3d& first, const Vec3d& second) {
  return weld(test::joined({test::box(first, first + Vec3d{1, 1, 1}), test::box(second, second + Vec3d{1, 1, 1})})).mesh;
}

}  // namespace

TEST_CASE("A mesh of nothing has no parts", "[mesh][split]") {
  CHECK(split_parts({}, SplitBy::Components).empty());
  CHECK(split_parts({}, SplitBy::Regions).empty());
}

TEST_CASE("Components come in the order of their lowest faces and know their sources", "[mesh][split]") {
  const SurfaceMesh mesh = test::joined({test::box({5, 0, 0}, {7, 1, 1}), test::octahedron({0, 0, 0}, 1), test::box({0, 5, 0}, {1, 6, 3})});
  const std::vector<MeshPart> parts = split_parts(mesh, SplitBy::Components);
  CHECK(volumes_of(parts) == std::vector<double>{2, 4.0 / 3, 3});
  CHECK(is_partition(mesh, parts));
  CHECK(parts[1].source_face.front() == FaceId(12));
  CHECK(parts[1].mesh.points.size() == 6);
}

TEST_CASE("Bodies that meet in a vertex are two components, bodies that meet along an edge one", "[mesh][split]") {
  CHECK(split_parts(boxes_at({0, 0, 0}, {1, 1, 1}), SplitBy::Components).size() == 2);
  CHECK(split_parts(boxes_at({0, 0, 0}, {1, 1, 0}), SplitBy::Components).size() == 1);
}

TEST_CASE("Bodies that meet in a vertex or along an edge are two regions", "[mesh][split]") {
  for (const Vec3d& second : {Vec3d{1, 1, 1}, Vec3d{1, 1, 0}, Vec3d{0, -1, 1}}) {
    const SurfaceMesh mesh = boxes_at({0, 0, 0}, second);
    const std::vector<MeshPart> parts = split_parts(mesh, SplitBy::Regions);
    CHECK(volumes_of(parts) == std::vector<double>{1, 1});
    CHECK(is_partition(mesh, parts));
  }
}

TEST_CASE("A region has its cavities, a component has not", "[mesh][split]") {
  const SurfaceMesh mesh =
      test::joined({test::inside_out(test::box({1, 1, 1}, {4, 4, 4})), test::box({0, 0, 0}, {5, 5, 5}), test::box({2, 2, 2}, {3, 3, 3})});
  CHECK(volumes_of(split_parts(mesh, SplitBy::Regions)) == std::vector<double>{125 - 27, 1});
  CHECK(volumes_of(split_parts(mesh, SplitBy::Components)) == std::vector<double>{-27, 125, 1});
}

TEST_CASE("Faces without shared vertices are welded, and sources are those of the soup", "[mesh][split]") {
  const SurfaceMesh boxes = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({3, 0, 0}, {4, 1, 1})});
  SurfaceMesh soup;
  for (const Triangle& t : boxes.triangles) {
    for (const VertexId v : t) soup.points.push_back(boxes.points[v.index()]);
    const std::size_t n = soup.points.size();
    soup.triangles.push_back({VertexId(n - 3), VertexId(n - 2), VertexId(n - 1)});
  }
  const std::vector<MeshPart> parts = split_parts(soup, SplitBy::Regions);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].mesh.points.size() == 8);
  CHECK(is_partition(soup, parts));
}

TEST_CASE("Labels keep their numbers and names in every part", "[mesh][split]") {
  SurfaceMesh mesh = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({3, 0, 0}, {4, 1, 1})});
  mesh.label_names = {"left", "right"};
  mesh.face_labels.assign(24, 0);
  for (std::size_t f = 12; f < 24; ++f) mesh.face_labels[f] = 1;
  const std::vector<MeshPart> parts = split_parts(mesh, SplitBy::Components);
  CHECK(parts[1].mesh.face_labels == std::vector<std::uint32_t>(12, 1));
  CHECK(parts[1].mesh.label_names == mesh.label_names);
}

TEST_CASE("Regions of what bounds nothing are refused by name, components are not", "[mesh][split]") {
  SurfaceMesh open = test::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  CHECK(split_parts(open, SplitBy::Components).size() == 1);
  const auto not_closed = test::error_of([&] { (void)split_parts(open, SplitBy::Regions); });
  REQUIRE(not_closed);
  CHECK(not_closed->code == ErrorCode::NotClosed);
  CHECK(not_closed->ids.size() == 6);

  SurfaceMesh twisted = test::box({0, 0, 0}, {1, 1, 1});
  std::swap(twisted.triangles[3][0], twisted.triangles[3][1]);
  const auto not_oriented = test::error_of([&] { (void)split_parts(twisted, SplitBy::Regions); });
  REQUIRE(not_oriented);
  CHECK(not_oriented->code == ErrorCode::NotOriented);
  CHECK(not_oriented->ids.size() == 6);

  const SurfaceMesh inside_out = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::inside_out(test::box({3, 0, 0}, {4, 1, 1}))});
  const auto turned = test::error_of([&] { (void)split_parts(inside_out, SplitBy::Regions); });
  REQUIRE(turned);
  CHECK(turned->code == ErrorCode::InsideOut);
  CHECK(turned->ids == std::vector<std::uint32_t>{12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23});
}

TEST_CASE("Real files come apart into the parts they are known to have", "[mesh][split]") {
  if (test::is_data_missing()) return;
  CHECK(split_parts(test::read_data("nasty/gc_platonic_shelf.obj"), SplitBy::Regions).size() == 5);
  CHECK(split_parts(test::read_data("terrain/buildings_clean.obj"), SplitBy::Regions).size() == 17);
  CHECK(split_parts(test::read_data("nasty/of_stirrer6_plates.obj"), SplitBy::Components).size() == 6);
  CHECK(split_parts(test::read_data("nasty/synthetic/cubes_touch_edge.off"), SplitBy::Regions).size() == 2);
  CHECK(volumes_of(split_parts(test::read_data("nasty/synthetic/cube_cavity.off"), SplitBy::Regions)) == std::vector<double>{7});
}

}  // namespace mortise
