// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex and corner data through operations on one mesh.
#include "mortise/mesh/corner_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mortise/mesh/corners_to_vertices.h"
#include "mortise/mesh/extrude_to.h"
#include "mortise/mesh/group_by_label.h"
#include "mortise/mesh/repair.h"
#include "mortise/mesh/round_to_float32.h"
#include "mortise/mesh/select_faces.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/split_parts.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/transform.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data_checks.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Values = std::vector<double>;

/// Two triangles over a square, one at each side of its diagonal.
SurfaceMesh square() { return make_mesh({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}}); }

/// A value per corner: 0, 1, 2 ...
SurfaceMesh with_numbered_corners(SurfaceMesh mesh) {
  DataChannel channel{"number", 1, DataKind::Value, {}};
  for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) channel.values.push_back(static_cast<double>(c));
  mesh.corner_data.push_back(std::move(channel));
  return mesh;
}

SurfaceMesh with_vertex_channel(SurfaceMesh mesh, DataKind kind, const Vec3d& v) {
  DataChannel channel{"v", 3, kind, {}};
  for (std::size_t i = 0; i < mesh.points.size(); ++i) channel.values.insert(channel.values.end(), {v.x, v.y, v.z});
  mesh.vertex_data.push_back(std::move(channel));
  return mesh;
}

Vec3d first_of(const std::vector<DataChannel>& data) { return {data[0].values[0], data[0].values[1], data[0].values[2]}; }

Vec3d moved_normal(const Vec3d& normal, const AffineMap& map) {
  return first_of(transform(with_vertex_channel(square(), DataKind::Normal, normal), map).vertex_data);
}

/// What validate() says of a mesh with these data.
std::string message_of(const std::vector<DataChannel>& vertex_data, const std::vector<DataChannel>& corner_data = {}) {
  SurfaceMesh mesh = square();
  mesh.vertex_data = vertex_data;
  mesh.corner_data = corner_data;
  const auto error = error_of([&] { validate(mesh); });
  return error ? error->message : "";
}

}  // namespace

TEST_CASE("channels that do not fit the mesh are refused by name", "[data]") {
  const Values four(4, 1), six(6, 1), twelve(12, 1);
  CHECK(message_of({{"heat", 1, DataKind::Value, four}}, {{"age", 1, DataKind::Value, six}}) == "");
  CHECK(message_of({{"heat", 1, DataKind::Value, {1, no_value, 3, 4}}}) == "");
  CHECK(message_of({{"", 1, DataKind::Value, four}}) == "a data channel has no name");
  CHECK(message_of({{"heat", 0, DataKind::Value, {}}}) == "channel 'heat' has no components");
  CHECK(message_of({{"heat", 1, DataKind::Value, six}}) == "channel 'heat' has 6 values for 4 vertices of 1 components");
  CHECK(message_of({{"heat", 4, DataKind::Value, six}}) == "channel 'heat' has 6 values for 4 vertices of 4 components");
  CHECK(message_of({}, {{"age", 2, DataKind::Value, six}}) == "channel 'age' has 6 values for 6 corners of 2 components");
  CHECK(message_of({{"n", 1, DataKind::Normal, four}}) == "channel 'n' holds vectors or normals: they have 3 components");
  CHECK(message_of({{"n", 3, DataKind::Vector, twelve}}) == "");
  CHECK(message_of({{"heat", 1, DataKind::Value, {1, 2, std::numeric_limits<double>::infinity(), 4}}}) ==
        "channel 'heat' has an infinite value: NaN is the one for none");
  CHECK(message_of({{"heat", 1, DataKind::Value, four}}, {{"heat", 1, DataKind::Value, six}}) == "two data channels have the name 'heat'");
}

TEST_CASE("welding keeps what vertices at one position had for each corner", "[data]") {
  SurfaceMesh soup = soup_of(square());
  soup.vertex_data.push_back({"number", 1, DataKind::Value, {0, 1, 2, 3, 4, 5}});
  const SurfaceMesh welded = weld(soup).mesh;
  CHECK(welded.points.size() == 4);
  CHECK(welded.vertex_data.empty());
  CHECK(welded.corner_data[0].values == Values{0, 1, 2, 3, 4, 5});
}

TEST_CASE("faces taken out of a mesh bring their data", "[data]") {
  SurfaceMesh mesh = with_numbered_corners(square());
  mesh.vertex_data.push_back({"heat", 2, DataKind::Value, {0, 1, 10, 11, 20, 21, 30, 31}});
  const MeshPart part = select_faces(mesh, std::array{FaceId(1U)});
  CHECK(part.mesh.corner_data[0].values == Values{3, 4, 5});
  CHECK(part.mesh.vertex_data[0].values == Values{0, 1, 20, 21, 30, 31});
  CHECK(select_faces(mesh, {}).mesh.corner_data.size() == 1);
}

TEST_CASE("parts of a mesh keep their data", "[data]") {
  const std::vector<MeshPart> parts =
      split_parts(with_chart(joined({box({0, 0, 0}, {1, 1, 1}), box({3, 0, 0}, {5, 2, 2})})), SplitBy::Regions);
  REQUIRE(parts.size() == 2);
  for (const MeshPart& part : parts) CHECK(deviation_from_chart(part.mesh, 1) == 0);
}

TEST_CASE("copies of vertices keep their data", "[data]") {
  const SurfaceMesh touching = weld(joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})})).mesh;
  const SurfaceMesh charted = with_numbered_corners(with_chart(touching));
  const SplitPinches split = split_pinches(charted, build_topology(charted));
  CHECK(split.mesh.points.size() == 16);
  CHECK(split.mesh.corner_data[0].values == charted.corner_data[0].values);
  CHECK(split.mesh.vertex_data[0].values.size() == 32);
  SurfaceMesh by_corners = split.mesh;
  by_corners.corner_data = all_as_corner_data(split.mesh);
  by_corners.vertex_data.clear();
  CHECK(deviation_from_chart(by_corners, 1) == 0);
}

TEST_CASE("vectors move with the mesh, normals stay at right angles and keep their length, values stay", "[data]") {
  const AffineMap stretch = scaling({2, 1, 4});
  const SurfaceMesh vectors = transform(with_vertex_channel(square(), DataKind::Vector, {1, 2, 3}), stretch);
  CHECK(first_of(vectors.vertex_data) == Vec3d{2, 2, 12});
  const SurfaceMesh values = transform(with_vertex_channel(square(), DataKind::Value, {1, 2, 3}), stretch);
  CHECK(first_of(values.vertex_data) == Vec3d{1, 2, 3});
  // At right angles to (1, -1, 0), which becomes (2, -1, 0).
  const Vec3d n = moved_normal({3, 3, 0}, stretch);
  CHECK(std::abs(dot(n, Vec3d{2, -1, 0})) < 1e-15);
  CHECK(std::abs(dot(n, n) - 18) < 1e-14);
  CHECK(n.x > 0);
}

TEST_CASE("exact maps move normals exactly", "[data]") {
  const Vec3d n{0.1, 0.2, 0.7};
  CHECK(moved_normal(n, translation({1, 2, 3})) == n);
  CHECK(moved_normal(n, scaling({0.3, 0.3, 0.3})) == n);
  CHECK(moved_normal(n, rotation(Axis::Z, 90)) == Vec3d{-0.2, 0.1, 0.7});
  CHECK(moved_normal(n, mirroring(Axis::X)) == Vec3d{-0.1, 0.2, 0.7});
  CHECK(moved_normal(n, scaling({-1, -1, -1})) == Vec3d{-0.1, -0.2, -0.7});
  CHECK(moved_normal(n, compose(scaling({0x1p600, 0x1p600, 0x1p600}), rotation(Axis::X, 270))) == Vec3d{0.1, 0.7, -0.2});
  CHECK(moved_normal({0, 0, 0}, rotation(Axis::Z, 30)) == Vec3d{0, 0, 0});
}

TEST_CASE("a turned normal has its length", "[data]") {
  const Vec3d n = moved_normal({0.6, 0.64, 0.48}, compose(rotation(Axis::X, 33), rotation(Axis::Y, 71)));
  CHECK(std::abs(dot(n, n) - 1) < 1e-15);
  CHECK(std::isnan(moved_normal({0, no_value, 1}, rotation(Axis::Z, 30)).x));
}

TEST_CASE("a vector whose image does not fit is an error that names the channel", "[data]") {
  const SurfaceMesh mesh = with_vertex_channel(square(), DataKind::Vector, {1e300, 0, 0});
  const auto error = error_of([&] { (void)transform(mesh, scaling({1e10, 1, 1})); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::OutOfRange);
  CHECK(error->message == "the image of a vector of channel 'v' does not fit a double");
}

TEST_CASE("a mirrored mesh keeps its data with its corners, and its normals outside", "[data]") {
  SurfaceMesh mesh = with_numbered_corners(with_vertex_channel(square(), DataKind::Normal, {0, 0, 1}));
  mesh = transform(mesh, mirroring(Axis::Z));
  CHECK(mesh.triangles[0] == Triangle{VertexId(0U), VertexId(2U), VertexId(1U)});
  CHECK(mesh.corner_data[0].values == Values{0, 2, 1, 3, 5, 4});
  CHECK(first_of(mesh.vertex_data) == Vec3d{0, 0, -1});
}

TEST_CASE("faces that are turned over turn their normals", "[data]") {
  SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh = with_numbered_corners(with_vertex_channel(inside_out(mesh), DataKind::Normal, {0, 3, -0.0}));
  const SurfaceMesh mended = repair(mesh, {.flip_inside_out = true}).mesh;
  REQUIRE(mended.corner_data.size() == 2);
  CHECK(first_of(mended.corner_data) == Vec3d{0, -3, 0});
  CHECK_FALSE(std::signbit(mended.corner_data[0].values[0]));
  CHECK(Values(mended.corner_data[1].values.begin(), mended.corner_data[1].values.begin() + 3) == Values{0, 2, 1});
}

TEST_CASE("a neighbour that takes up the corner of a face without area has a value there", "[data]") {
  // p q w is cut at m, which lies on p q at a quarter; the face p m q has no area.
  SurfaceMesh mesh = make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
  mesh.vertex_data.push_back({"heat", 1, DataKind::Value, {10, 20, 50, 999}});
  const SurfaceMesh mended = repair(mesh, {.drop_degenerate = true}).mesh;
  REQUIRE(mended.triangles.size() == 2);
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& p = mended.points[mended.triangles[t][i].index()];
      CHECK(mended.corner_data[0].values[3 * t + i] == 10 + 2.5 * p.x + 10 * p.y);
    }
  }
}

TEST_CASE("fillings of holes have no values", "[data]") {
  SurfaceMesh open = with_chart(box({0, 0, 0}, {1, 1, 1}));
  open.triangles.resize(10);
  const RepairedMesh mended = repair(open, {.fill_planar_holes = true});
  REQUIRE(mended.mesh.triangles.size() == 12);
  const Values& uv = mended.mesh.corner_data[0].values;
  for (std::size_t i = 0; i < uv.size(); ++i) CHECK(std::isnan(uv[i]) == (mended.source_face[i / 6] == RepairedMesh::none));
}

TEST_CASE("the solid of a sheet has the data of the sheet on it", "[data]") {
  const SurfaceMesh sheet = with_chart(make_grid_sheet(2, 2, 2, 2));
  for (const double z : {-1.0, 1.0}) {
    const SurfaceMesh solid = extrude_to(sheet, z);
    const Values& uv = solid.corner_data[0].values;
    REQUIRE(uv.size() == 6 * solid.triangles.size());
    for (std::size_t i = 0; i < uv.size(); ++i) CHECK(std::isnan(uv[i]) == (i / 6 >= sheet.triangles.size()));
    SurfaceMesh top = solid;
    top.triangles.resize(sheet.triangles.size());
    CHECK(deviation_from_chart(top, 1) == 0);
  }
}

TEST_CASE("a mesh rounded to float32 keeps its data in double", "[data]") {
  const SurfaceMesh ball = with_chart(make_icosphere(1, 2));
  const SurfaceMesh rounded = round_to_float32(ball);
  REQUIRE(rounded.triangles.size() == ball.triangles.size());
  CHECK(rounded.corner_data[0].values == all_as_corner_data(ball)[0].values);
  // m falls on the side p q of its neighbour in float32 only.
  SurfaceMesh flat = make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, -1e-60, 0}}, {{0, 1, 2}, {1, 0, 3}});
  flat.vertex_data.push_back({"heat", 1, DataKind::Value, {10, 20, 50, 999}});
  const SurfaceMesh cut = round_to_float32(flat);
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& p = cut.points[cut.triangles[t][i].index()];
      CHECK(cut.corner_data[0].values[3 * t + i] == 10 + 2.5 * p.x + 10 * p.y);
    }
  }
}

TEST_CASE("vertices are copied where corners have other values, and nowhere else", "[data]") {
  SurfaceMesh mesh = square();
  mesh.corner_data.push_back({"age", 1, DataKind::Value, {1, 2, 3, 1, 4, -0.0}});
  const MeshOfVertices result = corners_to_vertices(mesh, 0);
  // Vertex 0 has one value, vertex 2 has two; in the order of the vertices, then of the corners.
  CHECK(result.source_vertex == std::vector<VertexId>{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(2U), VertexId(3U)});
  CHECK(result.mesh.vertex_data[0].values == Values{1, 2, 3, 4, 0});
  CHECK_FALSE(std::signbit(result.mesh.vertex_data[0].values[4]));
  CHECK(result.mesh.triangles[1] == Triangle{VertexId(0U), VertexId(3U), VertexId(4U)});
  CHECK(corners_to_vertices(square(), 0).mesh.points.size() == 4);
}

TEST_CASE("missing values become what was asked for, missing normals those of the triangles", "[data]") {
  SurfaceMesh mesh = square();
  mesh.corner_data.push_back({"age", 1, DataKind::Value, {1, no_value, 3, 1, 3, no_value}});
  mesh.corner_data.push_back({"n", 3, DataKind::Normal, Values(18, no_value)});
  mesh.corner_data[1].values[0] = mesh.corner_data[1].values[1] = 0;
  mesh.corner_data[1].values[2] = 5;
  const MeshOfVertices result = corners_to_vertices(mesh, -7);
  CHECK(result.mesh.vertex_data[0].values == Values{1, 1, -7, 3, -7});
  CHECK(first_of({result.mesh.vertex_data[1]}) == Vec3d{0, 0, 5});
  CHECK(Values(result.mesh.vertex_data[1].values.begin() + 3, result.mesh.vertex_data[1].values.end()) ==
        Values{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
}

TEST_CASE("triangles are grouped by their labels, in their order", "[data]") {
  SurfaceMesh mesh = with_numbered_corners(make_grid_sheet(1, 1, 2, 1));
  mesh.face_labels = {2, 0, 2, 0};
  mesh.label_names = {"a", "b", "c"};
  const GroupedMesh grouped = group_by_label(mesh);
  CHECK(grouped.part.source_face == std::vector<FaceId>{FaceId(1U), FaceId(3U), FaceId(0U), FaceId(2U)});
  REQUIRE(grouped.groups.size() == 2);
  CHECK((grouped.groups[0].label == 0 && grouped.groups[0].first == 0 && grouped.groups[0].count == 2));
  CHECK((grouped.groups[1].label == 2 && grouped.groups[1].first == 2 && grouped.groups[1].count == 2));
  CHECK(grouped.part.mesh.corner_data[0].values == Values{3, 4, 5, 9, 10, 11, 0, 1, 2, 6, 7, 8});
  CHECK(group_by_label(square()).groups.size() == 1);
  CHECK(group_by_label({}).groups.empty());
}
