// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operands that are no solids are refused with their code, their number and the places as the caller numbered them.
#include "mortise/boolean/refuse_operands.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "boolean/evaluation.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

std::optional<Error> refusal(const std::vector<SurfaceMesh>& operands, const std::vector<std::size_t>& self = {}) {
  const Evaluation scene(operands, self);
  return error_of([&] { refuse_operands(pointers_to(scene.operands), scene.faces, scene.categories); });
}

SurfaceMesh without_face(SurfaceMesh mesh, std::size_t f) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(f));
  return mesh;
}

SurfaceMesh with_flipped_face(SurfaceMesh mesh, std::size_t f) {
  std::swap(mesh.triangles[f][1], mesh.triangles[f][2]);
  return mesh;
}

using Pair = std::array<std::uint32_t, 2>;

/// The vertex pairs of an error, without their direction.
std::set<Pair> pairs_of(const Error& error) {
  std::set<Pair> pairs;
  for (std::size_t i = 0; i + 1 < error.ids.size(); i += 2) {
    pairs.insert({std::min(error.ids[i], error.ids[i + 1]), std::max(error.ids[i], error.ids[i + 1])});
  }
  return pairs;
}

std::set<Pair> edges_of_face(const Triangle& t) {
  std::set<Pair> edges;
  for (std::size_t i = 0; i < 3; ++i) edges.insert({std::min(t[i], t[(i + 1) % 3]).value, std::max(t[i], t[(i + 1) % 3]).value});
  return edges;
}

void check_not_closed(const std::optional<Error>& error, int operand, const std::set<Pair>& pairs) {
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotClosed);
  CHECK(error->operand == operand);
  CHECK(error->id_kind == IdKind::VertexPairs);
  CHECK(pairs_of(*error) == pairs);
  CHECK(error->ids.size() == 2 * pairs.size());
}

}  // namespace

TEST_CASE("solids are let through") {
  CHECK_FALSE(refusal({unit}));
  CHECK_FALSE(refusal({unit, moved(unit, {0.5, 0.5, 0.5}), unit}));
  CHECK_FALSE(refusal({joined({box({0, 0, 0}, {9, 9, 9}), inside_out(box({1, 1, 1}, {8, 8, 8}))}), unit}));
  CHECK_FALSE(refusal({soup_of(unit), SurfaceMesh{}}));
  CHECK_FALSE(refusal({joined({unit, moved(unit, {1, 1, 0})})}));
}

TEST_CASE("an open edge is named by the vertices of the operand it is in") {
  check_not_closed(refusal({without_face(unit, 4)}), 0, edges_of_face(unit.triangles[4]));
  check_not_closed(refusal({unit, moved(unit, {0.5, 0.5, 0.5}), without_face(moved(unit, {5, 0, 0}), 7)}), 2,
                   edges_of_face(unit.triangles[7]));
  const auto error = refusal({without_face(unit, 4)});
  CHECK(error->message.find("operand 0") != std::string::npos);
  CHECK(error->message.find("3 open edges") != std::string::npos);
}

TEST_CASE("an open edge is named also where others cut it in pieces") {
  // The second box passes through the hole of the first, so that its open edges are split.
  const SurfaceMesh open = without_face(unit, 2);  // one half of z = 1
  check_not_closed(refusal({open, box({0.25, 0.25, 0.5}, {0.75, 0.75, 2})}), 0, edges_of_face(unit.triangles[2]));
}

TEST_CASE("in a soup an open edge is named by the vertices of the face it belongs to") {
  const SurfaceMesh soup = without_face(soup_of(unit), 0);
  const auto error = refusal({soup});
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotClosed);
  REQUIRE(error->ids.size() == 6);
  for (std::size_t i = 0; i < 6; i += 2) CHECK(error->ids[i] / 3 == error->ids[i + 1] / 3);  // two corners of one face
}

TEST_CASE("the lowest operand that is no solid is named, whatever the others are") {
  const auto error = refusal({unit, with_flipped_face(moved(unit, {5, 0, 0}), 3), without_face(moved(unit, {9, 0, 0}), 0)});
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotOriented);
  CHECK(error->operand == 1);
  check_not_closed(refusal({without_face(unit, 0), inside_out(moved(unit, {5, 0, 0}))}, {1}), 0, edges_of_face(unit.triangles[0]));
}

TEST_CASE("faces that run the same way along an edge are named by that edge") {
  const auto error = refusal({unit, with_flipped_face(moved(unit, {5, 0, 0}), 3)});
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotOriented);
  CHECK(error->operand == 1);
  CHECK(error->id_kind == IdKind::VertexPairs);
  CHECK(pairs_of(*error) == edges_of_face(unit.triangles[3]));
  CHECK(error->message.find("3 edges") != std::string::npos);
}

TEST_CASE("an operand that is open and badly oriented is open") {
  SurfaceMesh both = with_flipped_face(without_face(unit, 0), 6);
  const auto error = refusal({both});
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotClosed);
  const std::set<Pair> open = edges_of_face(unit.triangles[0]);
  for (const Pair& p : pairs_of(*error)) CHECK(open.count(p) == 1);
}

TEST_CASE("an operand oriented inwards is named with its faces") {
  const auto error = refusal({unit, inside_out(moved(unit, {5, 0, 0}))}, {1});
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InsideOut);
  CHECK(error->operand == 1);
  CHECK(error->id_kind == IdKind::Faces);
  std::vector<std::uint32_t> all(12);
  std::iota(all.begin(), all.end(), 0U);
  CHECK(error->ids == all);
}

TEST_CASE("an edge split on one side only is closed") {
  SurfaceMesh split = unit;  // the bottom's second face (0, 3, 1) becomes two, over the middle of edge 0 - 1
  split.points.push_back({0.5, 0, 0});
  split.triangles[1] = {VertexId(0), VertexId(3), VertexId(8)};
  split.triangles.push_back({VertexId(8), VertexId(3), VertexId(1)});
  CHECK_FALSE(refusal({split}));
}

TEST_CASE("edges that are badly oriented after splitting only are named by the given edges they lie on") {
  // The top runs the wrong way, and each of its four edges is split on the other side only: no edge has two faces as given.
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2},
                 {2, 2, 2}, {0, 2, 2}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2}, {0, 1, 2}};
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) { mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)}); };
  add(0, 2, 1);
  add(0, 3, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4, middle = 8 + i;
    add(i, j, middle);
    add(j, 4 + j, middle);
    add(i, middle, 4 + i);
  }
  SurfaceMesh fine = mesh;
  fine.triangles.push_back({VertexId(4), VertexId(5), VertexId(6)});
  fine.triangles.push_back({VertexId(4), VertexId(6), VertexId(7)});
  CHECK_FALSE(refusal({fine}));
  add(4, 6, 5);
  add(4, 7, 6);
  const auto error = refusal({mesh});
  REQUIRE(error);
  CHECK(error->code == ErrorCode::NotOriented);
  // The long edge of the top and the two short ones of the side, four times.
  CHECK(pairs_of(*error).size() == 12);
  CHECK(error->message.find("12 edges") != std::string::npos);
  for (const std::uint32_t v : error->ids) CHECK(v >= 4);
}
