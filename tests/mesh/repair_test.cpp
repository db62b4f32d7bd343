// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every step of a repair by itself: what it mends, what it leaves, what it says.
#include "mortise/mesh/repair.h"

#include <algorithm>

#include "mortise/mesh/inspect.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/weld.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

constexpr RepairSteps drop_degenerate{.drop_degenerate = true};
constexpr RepairSteps drop_duplicates{.drop_duplicates = true};
constexpr RepairSteps cancel_opposites{.cancel_opposites = true};
constexpr RepairSteps orient{.orient = true};
constexpr RepairSteps flip_inside_out{.flip_inside_out = true};
constexpr RepairSteps fill_planar_holes{.fill_planar_holes = true};

std::vector<std::uint32_t> numbers(const std::vector<FaceId>& faces) {
  std::vector<std::uint32_t> ids;
  for (const FaceId f : faces) ids.push_back(f.value);
  return ids;
}

/// The only note.
RepairNote note_of(const RepairedMesh& repaired) {
  REQUIRE(repaired.done.size() == 1);
  return repaired.done.front();
}

SurfaceMesh unit_box() { return test::box({0, 0, 0}, {1, 1, 1}); }

SurfaceMesh with_faces_turned(SurfaceMesh mesh, const std::vector<std::size_t>& faces) {
  for (const std::size_t f : faces) std::swap(mesh.triangles[f][1], mesh.triangles[f][2]);
  return mesh;
}

/// A box whose edge on the x axis has a further vertex at a half for one of its two faces, and a face without area to close that.
SurfaceMesh box_with_sliver() {
  SurfaceMesh mesh = unit_box();
  const VertexId low(0), high(1), middle(mesh.points.size());
  mesh.points.push_back({0.5, 0, 0});
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle t = mesh.triangles[f];
      if (t[k] != low || t[(k + 1) % 3] != high) continue;
      mesh.triangles[f] = {low, middle, t[(k + 2) % 3]};
      mesh.triangles.push_back({middle, high, t[(k + 2) % 3]});
      mesh.triangles.push_back({low, high, middle});
      return mesh;
    }
  }
  return mesh;
}

/// A flat ring of quads between two squares in z = 0, facing up, each quad two faces.
SurfaceMesh flat_ring() {
  SurfaceMesh mesh;
  for (const double r : {3.0, 1.0}) {
    for (const auto& [x, y] : {std::pair{-r, -r}, std::pair{r, -r}, std::pair{r, r}, std::pair{-r, r}}) mesh.points.push_back({x, y, 0});
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    mesh.triangles.push_back({VertexId(i), VertexId(j), VertexId(4 + j)});
    mesh.triangles.push_back({VertexId(i), VertexId(4 + j), VertexId(4 + i)});
  }
  return mesh;
}

}  // namespace

TEST_CASE("Nothing is done that was not asked for", "[mesh][repair]") {
  SurfaceMesh mesh = box_with_sliver();
  mesh.triangles.push_back(mesh.triangles[0]);
  const RepairedMesh same = repair(mesh, {});
  CHECK(test::has_same_bits(same.mesh, mesh));
  CHECK(same.done.empty());
  CHECK(same.source_face.back() == 14);
  CHECK(repair({}, {true, true, true, true, true, true}).done.empty());
}

TEST_CASE("Vertices are welded, and those without faces left out", "[mesh][repair]") {
  const RepairedMesh repaired =
      repair(test::make_mesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {{1, 2, 3}, {4, 5, 3}}), {});
  CHECK(repaired.mesh.points.size() == 4);
  CHECK(repaired.source_vertex == std::vector<VertexId>{VertexId(1), VertexId(2), VertexId(3), VertexId(5)});
}

TEST_CASE("A face without area that closes the surface gives its middle corner to its neighbour", "[mesh][repair]") {
  const SurfaceMesh mesh = box_with_sliver();
  REQUIRE(test::is_balanced(mesh));
  const RepairedMesh repaired = repair(mesh, drop_degenerate);
  CHECK(test::is_balanced(repaired.mesh));
  CHECK(repaired.mesh.triangles.size() == 14);
  CHECK(test::exactly_summed_volume(repaired.mesh) == 1);
  const MeshReport report = inspect(repaired.mesh);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.self_intersections == 0);
  CHECK(note_of(repaired).count == 1);
  CHECK(numbers(note_of(repaired).faces) == std::vector<std::uint32_t>{13});
}

TEST_CASE("Faces without area next to each other go one after the other", "[mesh][repair]") {
  // a strip of slivers along the x axis between a face above and faces below
  const SurfaceMesh mesh = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -3, 0}},
                                           {{0, 4, 5}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {1, 0, 6}, {2, 1, 6}, {3, 2, 6}, {4, 3, 6}});
  const RepairedMesh repaired = repair(mesh, drop_degenerate);
  const MeshReport report = inspect(repaired.mesh);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.triangles == 8);
  CHECK(report.boundary_edges == 4);
  CHECK(report.area == 12);
  CHECK(note_of(repaired).count == 3);
}

TEST_CASE("A fan of faces without area costs no more than its faces", "[mesh][repair]") {
  constexpr std::size_t n = 20'000;
  SurfaceMesh fan;
  fan.points.push_back({0, 1, 0});
  for (std::size_t i = 0; i <= n; ++i) fan.points.push_back({static_cast<double>(i), 0, 0});
  for (std::size_t i = 1; i < n; ++i) fan.triangles.push_back({VertexId(1), VertexId(1 + i), VertexId(2 + i)});
  fan.triangles.push_back({VertexId(1), VertexId(1 + n), VertexId(0)});
  const RepairedMesh repaired = repair(fan, drop_degenerate);
  CHECK(note_of(repaired).count == n - 1);
  CHECK(repaired.mesh.triangles.size() == n);
  CHECK(surface_area(repaired.mesh) == n / 2.0);
  CHECK(std::all_of(repaired.source_face.begin(), repaired.source_face.end(), [](std::uint32_t f) { return f == n - 1; }));
}

TEST_CASE("Faces without area folded onto each other vanish", "[mesh][repair]") {
  // four points on a line, two faces along it that share their longest side, closed by two more
  const SurfaceMesh fold = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 3}, {3, 2, 0}, {0, 2, 1}, {1, 2, 3}});
  const RepairedMesh repaired = repair(fold, drop_degenerate);
  CHECK(repaired.mesh.triangles.empty());
  CHECK(note_of(repaired).count == 4);
}

TEST_CASE("A face without area that hangs on an edge or repeats a vertex just goes", "[mesh][repair]") {
  SurfaceMesh mesh = unit_box();
  mesh.points.push_back({0.5, 0, 0});
  mesh.triangles.push_back({VertexId(0), VertexId(8), VertexId(1)});
  mesh.triangles.push_back({VertexId(2), VertexId(2), VertexId(3)});
  mesh.triangles.push_back({VertexId(5), VertexId(5), VertexId(5)});
  const RepairedMesh repaired = repair(mesh, drop_degenerate);
  CHECK(test::has_same_bits(repaired.mesh, unit_box()));
  CHECK(numbers(note_of(repaired).faces) == std::vector<std::uint32_t>{12, 13, 14});
}

TEST_CASE("Duplicates run the same way, opposites cancel in pairs", "[mesh][repair]") {
  SurfaceMesh mesh = unit_box();
  mesh.triangles.push_back({mesh.triangles[3][1], mesh.triangles[3][2], mesh.triangles[3][0]});
  mesh.triangles.push_back({mesh.triangles[3][0], mesh.triangles[3][2], mesh.triangles[3][1]});
  const RepairedMesh once = repair(mesh, drop_duplicates);
  CHECK(once.mesh.triangles.size() == 13);
  CHECK(numbers(note_of(once).faces) == std::vector<std::uint32_t>{12});
  const RepairedMesh cancelled = repair(mesh, cancel_opposites);
  CHECK(cancelled.mesh.triangles.size() == 12);
  CHECK(test::is_balanced(cancelled.mesh));
  CHECK(numbers(note_of(cancelled).faces) == std::vector<std::uint32_t>{3, 13});
}

TEST_CASE("The fewer faces turn to the more", "[mesh][repair]") {
  const RepairedMesh repaired = repair(with_faces_turned(unit_box(), {0, 3, 7}), orient);
  CHECK(test::has_same_bits(repaired.mesh, unit_box()));
  CHECK(numbers(note_of(repaired).faces) == std::vector<std::uint32_t>{0, 3, 7});
  const RepairedMesh others = repair(with_faces_turned(unit_box(), {0, 1, 2, 3, 4, 5, 6, 7, 8}), orient);
  CHECK(numbers(note_of(others).faces) == std::vector<std::uint32_t>{9, 10, 11});
  CHECK(test::exactly_summed_volume(others.mesh) == -1);
}

TEST_CASE("A one-sided surface is reported and left, what lies beside it is oriented", "[mesh][repair]") {
  // a strip of five triangles round with a half turn: the smallest Moebius strip
  SurfaceMesh mesh =
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  mesh = test::joined({mesh, with_faces_turned(test::box({5, 0, 0}, {6, 1, 1}), {2})});
  const RepairedMesh repaired = repair(mesh, orient);
  REQUIRE(repaired.done.size() == 2);
  CHECK(numbers(repaired.done[0].faces) == std::vector<std::uint32_t>{7});
  CHECK(repaired.done[1].outcome == RepairOutcome::NotOrientable);
  CHECK(repaired.done[1].count == 1);
  CHECK(numbers(repaired.done[1].faces) == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
  CHECK(std::equal(mesh.triangles.begin(), mesh.triangles.begin() + 5, repaired.mesh.triangles.begin()));
}

TEST_CASE("Inside-out bodies turn with all that lies in them, cavities stay", "[mesh][repair]") {
  const SurfaceMesh body = test::box({0, 0, 0}, {9, 9, 9});
  const SurfaceMesh cavity = test::inside_out(test::box({1, 1, 1}, {8, 8, 8}));
  const SurfaceMesh island = test::box({2, 2, 2}, {3, 3, 3});
  const auto volume_after = [](const std::vector<SurfaceMesh>& parts) {
    return test::exactly_summed_volume(repair(test::joined(parts), flip_inside_out).mesh);
  };
  const double volume = 729 - 343 + 1;
  CHECK(repair(test::joined({body, cavity, island}), flip_inside_out).done.empty());
  CHECK(volume_after({test::inside_out(body), test::inside_out(cavity), test::inside_out(island)}) == volume);
  CHECK(volume_after({body, cavity, test::inside_out(island)}) == volume);
  CHECK(volume_after({test::inside_out(island), cavity, body, test::inside_out(test::moved(body, {20, 0, 0}))}) == volume + 729);
  CHECK(volume_after({test::inside_out(body), test::inside_out(cavity), island}) == volume);
  CHECK(volume_after({test::inside_out(body), cavity}) == 729 + 343);
}

TEST_CASE("A planar hole is filled, facing out, with the label of a neighbour", "[mesh][repair]") {
  SurfaceMesh mesh = make_cylinder(1, 2, 16);
  // a concave hole: faces off the bottom and nothing else
  const auto is_bottom = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh.points[v.index()].z == 0; });
  };
  const double volume = enclosed_volume(mesh);
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), is_bottom), mesh.triangles.end());
  mesh.label_names = {"wall"};
  mesh.face_labels.assign(mesh.triangles.size(), 0);
  const RepairedMesh repaired = repair(mesh, fill_planar_holes);
  CHECK(test::is_balanced(repaired.mesh));
  CHECK(enclosed_volume(repaired.mesh) == Approx(volume).epsilon(1e-14));
  CHECK(repaired.mesh.triangles.size() == mesh.triangles.size() + 14);
  CHECK(repaired.mesh.face_labels.size() == repaired.mesh.triangles.size());
  CHECK(repaired.source_face.back() == RepairedMesh::none);
  CHECK(note_of(repaired).outcome == RepairOutcome::Done);
  CHECK(note_of(repaired).count == 1);
  CHECK(note_of(repaired).faces.size() == 16);
}

TEST_CASE("Two holes that touch in a vertex are filled as two", "[mesh][repair]") {
  // a plate with nine cells on top, two diagonal ones open
  SurfaceMesh sheet = make_grid_sheet(3, 3, 3, 3);
  sheet.triangles.erase(sheet.triangles.begin() + 8, sheet.triangles.begin() + 10);  // the middle cell
  sheet.triangles.erase(sheet.triangles.begin(), sheet.triangles.begin() + 2);       // a corner cell
  const RepairedMesh repaired = repair(test::joined({sheet, SurfaceMesh()}), fill_planar_holes);
  REQUIRE(repaired.done.size() == 2);
  CHECK(repaired.done[0].outcome == RepairOutcome::Done);
  CHECK(repaired.done[0].count == 1);
  CHECK(surface_area(repaired.mesh) == 8);
  CHECK(repaired.done[1].outcome == RepairOutcome::WouldOverlap);
}

TEST_CASE("Round a flat sheet nothing is filled, the hole in it is", "[mesh][repair]") {
  const RepairedMesh repaired = repair(flat_ring(), fill_planar_holes);
  CHECK(surface_area(repaired.mesh) == 36);
  CHECK(repaired.mesh.triangles.size() == 10);
  REQUIRE(repaired.done.size() == 2);
  CHECK(repaired.done[0].outcome == RepairOutcome::Done);
  CHECK(repaired.done[1].outcome == RepairOutcome::WouldOverlap);
  CHECK(inspect(repaired.mesh).self_intersections == 0);
}

TEST_CASE("A hole round another hole of its plane stays open, and so does one that is not planar", "[mesh][repair]") {
  // the walls of a square pipe, without its two ends
  const SurfaceMesh outer = test::box({-3, -3, 0}, {3, 3, 1}), inner = test::inside_out(test::box({-1, -1, 0}, {1, 1, 1}));
  SurfaceMesh pipe = test::joined({outer, inner});
  const auto is_level = [&](const Triangle& t) {
    return pipe.points[t[0].index()].z == pipe.points[t[1].index()].z && pipe.points[t[1].index()].z == pipe.points[t[2].index()].z;
  };
  pipe.triangles.erase(std::remove_if(pipe.triangles.begin(), pipe.triangles.end(), is_level), pipe.triangles.end());
  const RepairedMesh nested = repair(pipe, fill_planar_holes);
  CHECK(note_of(nested).outcome == RepairOutcome::NotSimple);
  CHECK(note_of(nested).count == 4);
  CHECK(nested.mesh.triangles.size() == pipe.triangles.size());

  SurfaceMesh bent = test::octahedron({0, 0, 0}, 1);
  bent.points[0].z = 0.25;
  bent.triangles.resize(4);
  CHECK(note_of(repair(bent, fill_planar_holes)).outcome == RepairOutcome::NotPlanar);
}

TEST_CASE("Faults of real files are mended", "[mesh][repair]") {
  if (test::is_data_missing()) return;
  const auto after = [](const std::string& file, const RepairSteps& steps) { return repair(test::read_data("nasty/" + file), steps); };
  const auto volume_after = [&](const std::string& file, const RepairSteps& steps) {
    const RepairedMesh repaired = after("synthetic/" + file, steps);
    CHECK(test::is_balanced(repaired.mesh));
    return test::exactly_summed_volume(repaired.mesh);
  };
  CHECK(volume_after("cube_inward.off", flip_inside_out) == 1);
  CHECK(volume_after("cube_one_face_flipped.off", orient) == 1);
  CHECK(volume_after("cube_double_faces.off", drop_duplicates) == 1);
  CHECK(volume_after("cube_degenerate_tris.off", drop_degenerate) == 1);
  CHECK(volume_after("cube_open.off", fill_planar_holes) == 1);
  CHECK(volume_after("cube_zero_thickness_flap.off", cancel_opposites) == 1);
  CHECK(after("synthetic/cube_nested_same_orientation.off", flip_inside_out).done.empty());
  CHECK(volume_after("cube_cavity.off", flip_inside_out) == 7);

  for (const char* file : {"of_rotatingZone_bad_orientation.obj", "of_heatedDuct.stl"}) {
    const SurfaceMesh before = test::read_data(std::string("nasty/") + file);
    CHECK_FALSE(test::is_balanced(before));
    const RepairedMesh repaired = repair(before, {.orient = true, .flip_inside_out = true});
    CHECK(test::is_balanced(repaired.mesh));
    CHECK(enclosed_volume(repaired.mesh) > 0);
  }
  const RepairedMesh quad = after("assimp_regr_3429812.obj", drop_duplicates);
  CHECK(quad.mesh.triangles.size() == 2);
  CHECK(inspect(quad.mesh).non_manifold_edges == 0);
  CHECK(note_of(after("gc_moebius.obj", orient)).outcome == RepairOutcome::NotOrientable);
}

TEST_CASE("Every file of the data can be asked for every step", "[mesh][repair]") {
  if (test::is_data_missing()) return;
  for (const std::string file :
       {"of_buildings_degenerate.obj", "assimp_Spider_binary.stl", "thingi10k_40509_brainslug.stl", "of_cyclone.stl",
        "ceasiom_aircraft_soup.stl", "assimp_regr01.obj", "manifold_openscad-nonmanifold-crash.obj"}) {
    INFO(file);
    const SurfaceMesh before = test::read_data("nasty/" + file);
    const RepairedMesh repaired = repair(before, {true, true, true, true, true, true});
    const MeshReport report = inspect(repaired.mesh);
    CHECK(report.degenerate_faces == 0);
    CHECK(repaired.source_face.size() == repaired.mesh.triangles.size());
    if (test::is_balanced(before)) CHECK(test::is_balanced(repair(before, drop_degenerate).mesh));
  }
}

}  // namespace mortise
