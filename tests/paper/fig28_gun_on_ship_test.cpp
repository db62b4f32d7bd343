// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 28: a gun set into the deck of a ship that is an open shell, attributes on both, remeshed in layers round the cut only; and the
// sixteen sets of faces the tags of the paper can keep.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "mortise/base/trig.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/brep/attributes.h"
#include "mortise/brep/result_features.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "mortise/size/graph_sources.h"
#include "support/catch.h"
#include "support/models.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr std::uint32_t stations = 100, round_bilge = 30, across_deck = 24;
constexpr double half_length = 6, draught = 1.2;

/// Half the breadth: 1.7 amidships, 0.3 at both ends.
double half_breadth(double x) { return 0.3 + 1.4 * (1 - x * x / (half_length * half_length)); }

/// Skin and deck of a hull in z <= 0 from end to end; its ends are open.
SurfaceMesh open_hull() {
  SurfaceMesh ship;
  const std::size_t ring = round_bilge + across_deck;
  for (std::uint32_t i = 0; i <= stations; ++i) {
    const double x = half_length * (2.0 * i / stations - 1), b = half_breadth(x);
    for (std::uint32_t j = 0; j < round_bilge; ++j) {
      const double angle = 180.0 * j / round_bilge;
      ship.points.push_back({x, b * trig::cos_deg(angle), j == 0 ? 0 : -draught * trig::sin_deg(angle)});
    }
    for (std::uint32_t j = 0; j < across_deck; ++j) ship.points.push_back({x, b * (2.0 * j / across_deck - 1), 0});
  }
  for (std::size_t i = 0; i < stations; ++i) {
    for (std::size_t j = 0; j < ring; ++j) {
      const VertexId a(i * ring + j), b((i + 1) * ring + j), c((i + 1) * ring + (j + 1) % ring), d(i * ring + (j + 1) % ring);
      ship.triangles.push_back({a, b, c});
      ship.triangles.push_back({a, c, d});
    }
  }
  return ship;
}

/// The same with both ends closed.
SurfaceMesh closed_hull() {
  SurfaceMesh ship = open_hull();
  const std::size_t ring = round_bilge + across_deck, last = stations * ring;
  const VertexId aft(ship.points.size()), fore(ship.points.size() + 1);
  ship.points.push_back({-half_length, 0, -draught / 3});
  ship.points.push_back({half_length, 0, -draught / 3});
  for (std::size_t j = 0; j < ring; ++j) {
    const std::size_t next = (j + 1) % ring;
    ship.triangles.push_back({aft, VertexId(j), VertexId(next)});
    ship.triangles.push_back({fore, VertexId(last + next), VertexId(last + j)});
  }
  return ship;
}

constexpr Vec3d place{0.25, 0.125, -0.15};  // of the gun: its base reaches through the deck
constexpr double radius_of_base = 0.6, largest_size = 0.12;

/// Of small triangles.
SurfaceMesh gun_in_deck() {
  const ModelScene coarse = scene_of(gun());
  return moved(remesh(coarse.mesh, coarse.model, coarse.normals, SizingProxy({}, {.global = 0.05})).mesh, place);
}

bool is_deck(const SurfaceMesh& mesh, FaceId t) {
  const Triangle& corners = mesh.triangles[t.index()];
  return std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return mesh.points[v.index()].z == 0; });
}

/// "deck" and "skin" on the faces of the ship, "gun" on all faces of the gun.
std::array<std::vector<Attribute>, 2> attributes_of(const ResultModel& m) {
  std::array<std::vector<Attribute>, 2> given;
  const Brep& ship = m.operand_models[0].brep;
  for (std::uint32_t f = 0; f < ship.faces.size(); ++f) {
    const bool on_deck = is_deck(m.meshes[0], m.operands[0].triangles_of_face.of(ModelFaceId(f))[0]);
    given[0].push_back({on_deck ? "deck" : "skin", AttributeKind::BoundaryCondition, "1", {{EntityDimension::Face, f}}, {}});
  }
  Attribute gun{"gun", AttributeKind::Load, "2", {}, {}};
  for (std::uint32_t f = 0; f < m.operand_models[1].brep.faces.size(); ++f) gun.targets.push_back({EntityDimension::Face, f});
  given[1] = {gun};
  return given;
}

std::map<std::string, double> areas_of(const SurfaceMesh& mesh, const ClassifiedBrep& model, const std::vector<Attribute>& attributes) {
  std::map<std::string, double> areas;
  for (const AttributeMeasure& a : measure_attributes(view_of(mesh, model), attributes)) areas[a.name] = a.area;
  return areas;
}

}  // namespace

TEST_CASE("Fig. 28: a gun set into the deck of an open shell keeps its attributes, and so do deck and skin, after remeshing round it too",
          "[paper][remesh][attributes]") {
  const ResultModel m([](const OperandList& list) { return implant(list); }, {open_hull(), gun_in_deck()}, without_seams());
  CHECK(m.boolean.graph.closed_loops == 1);
  const std::array<std::vector<Attribute>, 2> given = attributes_of(m);
  const std::vector<Attribute> attributes = transfer_attributes(
      m.lineage, std::vector<OperandAttributes>{{given[0], &m.operand_models[0].brep}, {given[1], &m.operand_models[1].brep}});

  const ModelScene scene = scene_of(m.boolean, m.meshes);
  const auto graph = find_graph_edges(scene.mesh, m.boolean.provenance);
  const SizingProxy sizes(sources_of_graph(scene.mesh.points, graph, 1.2), {.global = largest_size});
  RemeshRules rules;
  rules.zone = layers_round(scene.mesh, graph, 4);
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, rules);
  const ClassifiedBrep after = model_after(scene, result);
  CHECK(find_faults(result.mesh, after).empty());
  CHECK(count_crossings(result.mesh) == 0);
  CHECK(measure_quality(result.mesh, after, sizes).folds == 0);
  CHECK(deviation_after(scene, result, sizes).curves_to_reference.in_sizes < 1e-3);
  CHECK(find_boundary_edges(build_topology(result.mesh)).size() == 2 * (round_bilge + across_deck));

  CHECK(std::count(rules.zone.begin(), rules.zone.end(), std::uint8_t{0}) > 15000);
  CHECK(count_lost(scene.mesh, rules.zone, result.mesh) == 0);
  const SurfaceMesh changed = part_away_from(scene.mesh, rules.zone, result.mesh);
  CHECK(changed.triangles.size() > 5000);
  CHECK(measure_faces(changed).angles.min_deg > 30);
  CHECK(measure_faces(changed).angles.max_deg < 115);

  const std::map<std::string, double> before = areas_of(scene.mesh, scene.model, attributes),
                                      now = areas_of(result.mesh, after, attributes);
  REQUIRE(before.size() == 3);
  REQUIRE(now.size() == 3);
  CHECK(now.at("skin") == before.at("skin"));
  // The loop is as far off as an edge is from its arc; the base is cut along the loop, at its rim below and all round.
  const double pi = std::acos(-1.0), sagitta = 1.1 * largest_size * largest_size / (8 * radius_of_base);
  const double off_loop = 2 * pi * radius_of_base * sagitta;
  CHECK(std::fabs(now.at("deck") - before.at("deck")) < off_loop);
  CHECK(std::fabs(now.at("gun") - before.at("gun")) < off_loop + 2 * pi * 0.5 * sagitta);
}

TEST_CASE("Fig. 28: sets of tags keep sixteen different parts of ship and gun, one of them the implant", "[paper][keep_faces]") {
  const std::vector<SurfaceMesh> operands{closed_hull(), moved(gun(), place)};
  std::array<double, 16> areas{};
  for (unsigned mask = 0; mask < 16; ++mask)
    areas[mask] = surface_area(keep_faces(static_cast<KeepMask>(mask), pointers_to(operands)).mesh);
  for (unsigned mask = 0; mask < 16; ++mask) {
    double parts = 0;
    for (unsigned tag = 1; tag < 16; tag *= 2) parts += (mask & tag) != 0 ? areas[tag] : 0;
    CHECK(areas[mask] == Approx(parts).epsilon(1e-12));
  }
  CHECK(std::set<double>(areas.begin(), areas.end()).size() == 16);
  const KeepMask set_in = keep_mask(std::vector<std::string>{"10", "20", "21"});
  CHECK(areas[set_in] == Approx(surface_area(implant(pointers_to(operands)).mesh)).epsilon(1e-12));
}
