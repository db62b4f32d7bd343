// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizes on entities of models, numbers of edges, sizes at vertices and attributes, as sources.
#include "mortise/size/model_sources.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "mortise/base/error.h"
#include "mortise/brep/build_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/shapes.h"
#include "mortise/size/sizing_proxy.h"
#include "support/catch.h"
#include "support/random_source.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A mesh with its model. Stays where it is: the view refers to it.
struct Modelled {
  explicit Modelled(SurfaceMesh m) : mesh(std::move(m)), model(build_brep(mesh)), view(view_of(mesh, model)) {}
  Modelled(const Modelled&) = delete;
  Modelled& operator=(const Modelled&) = delete;

  SurfaceMesh mesh;
  ClassifiedBrep model;
  ModelView view;
};

bool all_are(const std::vector<SizeSource>& sources, std::size_t corner_count, double size) {
  for (const SizeSource& s : sources) {
    if (s.corner_count != corner_count || s.order != StrengthOrder::Constant || s.strengths[0] != size || s.growth != 1.25) return false;
  }
  return true;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::InvalidArgument);
    return error.message;
  }
  return "";
}

}  // namespace

TEST_CASE("a size on a vertex is a point, on an edge its segments, on a face its triangles, on a region those of its faces", "[size]") {
  const Modelled box(make_box({0, 0, 0}, {1, 1, 1}));
  const auto on = [&](EntityDimension dimension, std::uint32_t id) { return sources_on(box.view, {dimension, id}, 0.1, 1.25); };
  const std::vector<SizeSource> vertex = on(EntityDimension::Vertex, 3);
  CHECK((vertex.size() == 1 && all_are(vertex, 1, 0.1)));
  CHECK(vertex[0].corners[0] == box.mesh.points[box.model.classification.mesh_vertex[ModelVertexId(3)].index()]);
  const std::vector<SizeSource> edge = on(EntityDimension::Edge, 0), face = on(EntityDimension::Face, 0);
  CHECK((edge.size() == 1 && all_are(edge, 2, 0.1)));
  CHECK(length(edge[0].corners[1] - edge[0].corners[0]) == 1);
  CHECK((face.size() == 2 && all_are(face, 3, 0.1)));
  for (const std::uint32_t region : {0U, 1U}) {
    const std::vector<SizeSource> all = on(EntityDimension::Region, region);
    CHECK((all.size() == 12 && all_are(all, 3, 0.1)));
  }
  CHECK(message_of([&] { (void)on(EntityDimension::Face, 6); }) == "the model has no face 6");
}

TEST_CASE("a least number of edges is a size along every model edge but seams", "[size]") {
  // Two circles of 16 edges, and a seam of length 4.
  const Modelled cylinder(make_cylinder(1, 4, 16));
  const std::vector<SizeSource> sources = sources_for_edge_counts(cylinder.view, 32, 0, 1.25);
  REQUIRE(sources.size() == 32);
  for (const SizeSource& s : sources) {
    CHECK(s.corners[0].z == s.corners[1].z);
    CHECK(s.strengths[0] == Approx(16 * 2 * std::sin(std::numbers::pi / 16) / 32).epsilon(1e-14));
  }
  CHECK(all_are(sources_for_edge_counts(cylinder.view, 1000, 0.1, 1.25), 2, 0.1));
  const std::string refusal = "an edge has at least 1 element, of a smallest size that is finite and not negative";
  CHECK(message_of([&] { (void)sources_for_edge_counts(cylinder.view, 0, 0.1, 1.25); }) == refusal);
  CHECK(message_of([&] { (void)sources_for_edge_counts(cylinder.view, 4, -1, 1.25); }) == refusal);
}

TEST_CASE("sizes at vertices are linear on triangles", "[size]") {
  const SurfaceMesh sheet = make_grid_sheet(2, 2, 5, 4);
  std::vector<double> sizes;
  for (const Vec3d& p : sheet.points) sizes.push_back(0.5 + 0.1 * p.x + 0.2 * p.y);
  const SizingProxy proxy(sources_of_vertex_sizes(sheet, sizes, 1.25), {.global = 10});
  RandomSource random(1);
  for (int k = 0; k < 200; ++k) {
    const Vec3d p{random.between(0, 2), random.between(0, 2), 0};
    CHECK(proxy.size_at(p) == Approx(0.5 + 0.1 * p.x + 0.2 * p.y).epsilon(1e-14));
  }
  CHECK(proxy.size_at({0, 0, 3}) == Approx(0.5 + 3 * 0.25).epsilon(1e-14));
}

TEST_CASE("sizes at the vertices of thin triangles are linear from the ends of the longest edge to the third corner", "[size]") {
  SurfaceMesh thin;
  thin.points = {{0, 0, 0}, {4, 0, 0}, {1, 1e-9, 0}};
  thin.triangles = {{VertexId(2), VertexId(0), VertexId(1)}};
  const SizingProxy proxy(sources_of_vertex_sizes(thin, std::vector<double>{1, 1.3, 1.2}, 1.25), {.global = 10});
  CHECK(proxy.size_at({0, 0, 0}) == Approx(1));
  CHECK(proxy.size_at({0.5, 0, 0}) == Approx(1.1));
  CHECK(proxy.size_at({1, 0, 0}) == Approx(1.2));
  CHECK(proxy.size_at({3, 0, 4}) == Approx(1.2 + 0.1 * 2 / 3 + 4 * 0.25));
}

TEST_CASE("sizes at vertices that are missing or mean nothing are refused", "[size]") {
  const SurfaceMesh sheet = make_grid_sheet(1, 1, 1, 1);
  CHECK(message_of([&] {
          (void)sources_of_vertex_sizes(sheet, std::vector<double>{1, 1, 1}, 1.25);
        }) == "there are 3 sizes for 4 vertices");
  try {
    (void)sources_of_vertex_sizes(sheet, std::vector<double>{1, 1, 0, -1}, 1.25);
    FAIL("taken");
  } catch (const Error& error) {
    CHECK(error.message == "vertex 2 has a size that is not a positive number");
    CHECK(error.id_kind == IdKind::Vertices);
    CHECK(error.ids == std::vector<std::uint32_t>{2, 3});
  }
}

TEST_CASE("attributes of kind size are sources on their targets", "[size]") {
  const Modelled box(make_box({0, 0, 0}, {1, 1, 1}));
  const Attribute size{"fine", AttributeKind::Size, "5e-2", {{EntityDimension::Edge, 1}, {EntityDimension::Face, 2}}, {}};
  const Attribute other{"steel", AttributeKind::Material, "0.2", {{EntityDimension::Region, 1}}, {}};
  const std::vector<SizeSource> sources = sources_of_attributes(box.view, std::vector{other, size}, 1.25);
  REQUIRE(sources.size() == 3);
  CHECK(all_are({sources[0]}, 2, 0.05));
  CHECK(all_are({sources[1], sources[2]}, 3, 0.05));

  const auto refusal_of = [&](Attribute changed) {
    return message_of([&] { (void)sources_of_attributes(box.view, std::span(&changed, 1), 1.25); });
  };
  for (const char* value : {"null", "-1", "0", "\"0.1\"", "1e999", "{\"h\":1}"}) {
    Attribute bad = size;
    bad.value = value;
    CHECK(refusal_of(bad) == std::string("attribute 'fine' has the size ") + value + ", which is not a positive number");
  }
  Attribute away = size;
  away.targets = {{EntityDimension::Face, 6}};
  CHECK(refusal_of(away) == "attribute 'fine' is on face 6, which is not there");
}
