// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One mesh of the kept facets: its vertices, sense, labels and where everything comes from.
#include "mortise/boolean/merge.h"

#include <algorithm>
#include <cmath>

#include "boolean/evaluation.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

SurfaceMesh labelled(SurfaceMesh mesh, const std::vector<std::string>& names, std::uint32_t modulus) {
  mesh.label_names = names;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) mesh.face_labels.push_back(f % modulus);
  return mesh;
}

/// The name of the label of each triangle.
std::vector<std::string> names_of_faces(const MergedMesh& merged) {
  std::vector<std::string> names;
  for (const std::uint32_t label : merged.mesh.face_labels) names.push_back(merged.mesh.label_names.at(label));
  return names;
}

}  // namespace

TEST_CASE("a result names its sources: operand, face and whether it runs against it") {
  const MergedScene scene(Operation::Subtract, {unit, box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75})});
  const Provenance& p = scene.merged.provenance;
  REQUIRE(scene.merged.mesh.triangles.size() == 24);
  for (std::size_t t = 0; t < 24; ++t) {
    const bool is_cavity = t >= 12;
    CHECK(p.source_operand[t] == (is_cavity ? 1 : 0));
    CHECK(p.source_face[t] == t % 12);
    CHECK(p.flipped[t] == (is_cavity ? 1 : 0));
    CHECK(p.category[t] == (is_cavity ? FacetCategory::Inside : FacetCategory::Outside));
  }
  CHECK(p.other_source_begin == std::vector<std::uint32_t>(25, 0));
  CHECK(is_balanced(scene.merged.mesh));
  CHECK(exactly_summed_volume(scene.merged.mesh) == 0.875);
}

TEST_CASE("a facet of coincident faces names all of them, the lowest operand first") {
  const MergedScene scene(Operation::Union, {unit, unit, inside_out(inside_out(unit))});
  const Provenance& p = scene.merged.provenance;
  REQUIRE(scene.merged.mesh.triangles.size() == 12);
  for (std::uint32_t t = 0; t < 12; ++t) {
    CHECK(p.source_operand[t] == 0);
    CHECK(p.other_source_begin[t] == 2 * t);
    CHECK((p.other_source_operand[2 * t] == 1 && p.other_source_operand[2 * t + 1] == 2));
    CHECK((p.other_source_face[2 * t] == t && p.other_source_face[2 * t + 1] == t));
  }
  CHECK(p.other_source_begin.back() == 24);
}

TEST_CASE("what covers the space behind a facet is stored once per set") {
  const MergedScene scene(Operation::Union, {unit, moved(unit, {0.5, 0, 0}), moved(unit, {9, 0, 0})});
  const Provenance& p = scene.merged.provenance;
  auto sets = p.covering_sets;
  std::sort(sets.begin(), sets.end());
  CHECK(sets == std::vector<std::vector<std::uint32_t>>{{0}, {0, 1}, {1}, {2}});
  REQUIRE(p.covering.size() == scene.merged.mesh.triangles.size());
  for (std::size_t t = 0; t < p.covering.size(); ++t) {
    const auto& set = p.covering_sets.at(p.covering[t]);
    CHECK(std::find(set.begin(), set.end(), p.source_operand[t]) != set.end());
  }
}

TEST_CASE("vertices are the points in use, input points first, each with its source") {
  const MergedScene scene(Operation::Union, {unit, moved(unit, {0.5, 0.5, 0.5})});
  const MergedMesh& merged = scene.merged;
  CHECK(std::is_sorted(merged.point_of_vertex.begin(), merged.point_of_vertex.end()));
  CHECK(merged.mesh.points.size() == 7 + 7 + 6);
  for (std::size_t v = 0; v < merged.mesh.points.size(); ++v) {
    const PointId p = merged.point_of_vertex[v];
    CHECK(merged.mesh.points[v] == scene.faces.points.nearest(p));
    const std::uint32_t k = merged.provenance.vertex_operand[v], source = merged.provenance.vertex_source[v];
    CHECK((k == Provenance::none) == !scene.faces.points.is_input(p));
    CHECK((source == Provenance::none) == (k == Provenance::none));
    if (k != Provenance::none) CHECK(scene.operands[k].points[source] == merged.mesh.points[v]);
  }
}

TEST_CASE("a vertex of several operands, or several times in one, is the lowest of them") {
  SurfaceMesh soup;
  for (const Triangle& t : unit.triangles) {
    for (const VertexId v : t) soup.points.push_back(unit.points[v.index()]);
    const std::size_t n = soup.points.size();
    soup.triangles.push_back({VertexId(n - 3), VertexId(n - 2), VertexId(n - 1)});
  }
  const MergedScene scene(Operation::Union, {soup, unit});
  const Provenance& p = scene.merged.provenance;
  REQUIRE(scene.merged.mesh.points.size() == 8);
  for (std::size_t v = 0; v < 8; ++v) {
    CHECK(p.vertex_operand[v] == 0);
    const auto first = std::find(soup.points.begin(), soup.points.end(), scene.merged.mesh.points[v]);
    CHECK(p.vertex_source[v] == static_cast<std::uint32_t>(first - soup.points.begin()));
  }
}

TEST_CASE("the sign of zero is that of the first vertex there") {
  SurfaceMesh minus = unit;
  for (Vec3d& p : minus.points) p.z = p.z == 0 ? -0.0 : p.z;
  const MergedScene first(Operation::Union, {minus, unit}), second(Operation::Union, {unit, minus});
  const auto negative_zeros = [](const SurfaceMesh& mesh) {
    return std::count_if(mesh.points.begin(), mesh.points.end(), [](const Vec3d& p) { return p.z == 0 && std::signbit(p.z); });
  };
  CHECK(negative_zeros(first.merged.mesh) == 4);
  CHECK(negative_zeros(second.merged.mesh) == 0);
}

TEST_CASE("facets flipped by a subtraction run the other way round") {
  const MergedScene scene(Operation::Subtract, {box({-1, -1, -1}, {2, 2, 2}), unit});
  const SurfaceMesh& mesh = scene.merged.mesh;
  for (std::size_t t = 12; t < 24; ++t) {
    const Triangle& source = unit.triangles[t - 12];
    for (std::size_t i = 0; i < 3; ++i) CHECK(mesh.points[mesh.triangles[t][i].index()] == unit.points[source[i == 0 ? 0 : 3 - i].index()]);
  }
}

TEST_CASE("labels of equal names are one, and every facet keeps the name of its source face") {
  const SurfaceMesh hull = labelled(unit, {"hull", "deck"}, 2), mast = labelled(moved(unit, {0.5, 0.5, 0.5}), {"deck", "mast", "flag"}, 3);
  const MergedScene scene(Operation::Union, {hull, mast});
  CHECK(scene.merged.mesh.label_names == std::vector<std::string>{"hull", "deck", "mast", "flag"});
  const std::vector<std::string> names = names_of_faces(scene.merged);
  REQUIRE(names.size() == scene.merged.mesh.triangles.size());
  const Provenance& p = scene.merged.provenance;
  for (std::size_t t = 0; t < names.size(); ++t) {
    const SurfaceMesh& operand = scene.operands[p.source_operand[t]];
    CHECK(names[t] == operand.label_names[operand.face_labels[p.source_face[t]]]);
  }
}

TEST_CASE("an operand without labels gets the empty name beside one with labels, and nothing otherwise") {
  const MergedScene mixed(Operation::Union, {unit, labelled(moved(unit, {5, 0, 0}), {"part"}, 1)});
  CHECK(mixed.merged.mesh.label_names == std::vector<std::string>{"", "part"});
  const std::vector<std::string> names = names_of_faces(mixed.merged);
  REQUIRE(names.size() == 24);
  for (std::size_t t = 0; t < 24; ++t) CHECK(names[t] == (t < 12 ? "" : "part"));
  const MergedScene plain(Operation::Union, {unit, moved(unit, {5, 0, 0})});
  CHECK((plain.merged.mesh.face_labels.empty() && plain.merged.mesh.label_names.empty()));
}

TEST_CASE("names given twice within an operand are one label") {
  const MergedScene scene(Operation::Union, {labelled(unit, {"side", "side"}, 2)});
  CHECK(scene.merged.mesh.label_names == std::vector<std::string>{"side"});
  CHECK(scene.merged.mesh.face_labels == std::vector<std::uint32_t>(12, 0));
}

TEST_CASE("nothing kept is an empty mesh with arrays of the right size") {
  const MergedScene scene(Operation::Intersect, {labelled(unit, {"a"}, 1), moved(unit, {5, 0, 0})});
  const MergedMesh& merged = scene.merged;
  CHECK((merged.mesh.points.empty() && merged.mesh.triangles.empty() && merged.mesh.face_labels.empty()));
  CHECK(merged.provenance.other_source_begin == std::vector<std::uint32_t>{0});
  CHECK((merged.provenance.vertex_operand.empty() && merged.provenance.covering_sets.empty()));
}

TEST_CASE("every result of the small scenes is balanced and knows its facets") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const MergedScene result(Operation::Union, scene.operands);
    const MergedMesh& merged = result.merged;
    CHECK(is_balanced(merged.mesh));
    CHECK(merged.facet_of_triangle.size() == merged.mesh.triangles.size());
    CHECK(std::count(merged.is_repaired.begin(), merged.is_repaired.end(), 0) == static_cast<std::ptrdiff_t>(merged.mesh.triangles.size()));
    CHECK(merged.repair_displacement == 0);
    for (std::size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
      const PlanePoints& c = result.facets.corners[merged.facet_of_triangle[t].facet];
      for (const VertexId v : merged.mesh.triangles[t]) CHECK(std::count(c.begin(), c.end(), merged.point_of_vertex[v.index()]) == 1);
    }
  }
}
