// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 18: a frustum and a sphere with attributes, through every operation and policy, whatever the numbering. What is expected is summed
// from the sources of facets and closed formulas; the models have no part in it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "mortise/base/trig.h"
#include "mortise/base/union_find.h"
#include "mortise/boolean/imprint.h"
#include "mortise/brep/attributes.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/models.h"
#include "support/random_source.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr EntityDimension face = EntityDimension::Face, region = EntityDimension::Region;
constexpr unsigned frustum_bit = 1, sphere_bit = 2;

/// Radius 2 at z = -1, 1 at z = 1.
SurfaceMesh frustum() {
  const std::vector<Vec2d> profile{{0, -1}, {2, -1}, {1, 1}, {0, 1}};
  return revolve(profile, 48);
}
SurfaceMesh sphere() { return moved(make_icosphere(1.4, 3), {1, 0.25, 0.5}); }

// A regular polygon of 48 corners and radius 1, and what is made of it.
const double polygon_area = 24 * trig::sin_deg(7.5), half_side = trig::sin_deg(3.75), apothem = trig::cos_deg(3.75);
const double frustum_volume = 2.0 / 3 * (4 + 2 + 1) * polygon_area;
const double sphere_volume = enclosed_volume(sphere()), sphere_area = surface_area(sphere());

/// Areas and volumes of what the attributes are on, before any operation; "rim" is a length.
const std::map<std::string, double> whole{
    {"load", polygon_area},    {"base", 4 * polygon_area}, {"steel", 48 * 3 * half_side* std::sqrt(4 + apothem * apothem)},
    {"pressure", sphere_area}, {"rim", 96 * half_side},    {"iron", frustum_volume},
    {"oil", sphere_volume}};

const std::vector<std::string> face_names{"load", "base", "steel", "pressure"};

/// The attribute on a triangle of an operand, told by where it lies.
std::string name_on(const SurfaceMesh& mesh, std::uint32_t t, bool is_sphere) {
  if (is_sphere) return "pressure";
  const Triangle& c = mesh.triangles[t];
  const auto lies_at = [&](double z) { return std::all_of(c.begin(), c.end(), [&](VertexId v) { return mesh.points[v.index()].z == z; }); };
  return lies_at(1) ? "load" : lies_at(-1) ? "base" : "steel";
}

/// An operation, and the solids that contain each region of its result.
struct Call {
  std::string name;
  bool is_reversed;  ///< the sphere comes first
  std::function<BooleanResult(const OperandList&)> evaluate;
  std::vector<unsigned> regions;
};

std::vector<Call> all_calls() {
  const auto of = [](Operation operation) { return [operation](const OperandList& list) { return evaluate_boolean(operation, list); }; };
  const auto imprinted = [](const OperandList& list) { return imprint(list).whole; };
  return {{"union", false, of(Operation::Union), {3}},
          {"union, sphere first", true, of(Operation::Union), {3}},
          {"intersection", false, of(Operation::Intersect), {3}},
          {"intersection, sphere first", true, of(Operation::Intersect), {3}},
          {"frustum less sphere", false, of(Operation::Subtract), {1}},
          {"sphere less frustum", true, of(Operation::Subtract), {2}},
          {"symmetric difference", false, of(Operation::SymmetricDifference), {1, 2}},
          {"partition", false, of(Operation::Partition), {1, 2, 3}},
          {"partition, sphere first", true, of(Operation::Partition), {1, 2, 3}},
          {"imprint", false, imprinted, {1, 2, 3}}};
}

/// The same mesh, its vertices and triangles in another order.
SurfaceMesh renumbered(const SurfaceMesh& mesh, RandomSource& random) {
  const auto shuffled = [&](std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    random.shuffle(order);
    return order;
  };
  const std::vector<std::size_t> vertex_place = shuffled(mesh.points.size()), triangle_place = shuffled(mesh.triangles.size());
  SurfaceMesh result = mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) result.points[vertex_place[v]] = mesh.points[v];
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) result.triangles[triangle_place[t]][k] = VertexId(vertex_place[mesh.triangles[t][k].index()]);
  }
  return result;
}

/// The two solids, in another numbering for every round but the first.
std::vector<SurfaceMesh> numbered_solids(std::size_t round, bool is_reversed) {
  std::vector<SurfaceMesh> solids{frustum(), sphere()};
  RandomSource random(round);
  for (SurfaceMesh& mesh : solids) mesh = round == 0 ? mesh : renumbered(mesh, random);
  if (is_reversed) std::swap(solids[0], solids[1]);
  return solids;
}

/// One as it is made, the others random.
std::size_t numberings() { return std::max<std::size_t>(2, scaled_count(4, 40)); }

/// Calls check(call, result) for every operation and numbering.
template <class Check>
void for_each_result(const Check& check) {
  for (std::size_t round = 0; round < numberings(); ++round) {
    for (const Call& call : all_calls()) {
      INFO(call.name << ", numbering " << round);
      check(call, ResultModel(call.evaluate, numbered_solids(round, call.is_reversed)));
    }
  }
}

// ---- What is expected

/// Names of the sources of every facet.
std::vector<std::set<std::string>> names_of_facets(const Call& call, const ResultModel& m) {
  std::vector<std::set<std::string>> names(m.boolean.mesh.triangles.size());
  for (std::size_t t = 0; t < names.size(); ++t) {
    for_each_source(m.boolean.provenance, FaceId(t), [&](const FacetOrigin& s) {
      names[t].insert(name_on(m.meshes[s.operand], s.face, (s.operand == 1) != call.is_reversed));
    });
  }
  return names;
}

double area_of(const SurfaceMesh& mesh, std::size_t t) {
  const Triangle& c = mesh.triangles[t];
  return triangle_area(mesh.points[c[0].index()], mesh.points[c[1].index()], mesh.points[c[2].index()]);
}

/// Areas of the parts of an attribute that hang together through edges of two facets.
std::vector<double> areas_of_parts(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<std::set<std::string>>& names,
                                   const std::string& name) {
  UnionFind parts(mesh.triangles.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() == 2 && names[uses[0] / 3].count(name) != 0 && names[uses[1] / 3].count(name) != 0)
      parts.join(uses[0] / 3, uses[1] / 3);
  }
  std::map<std::uint32_t, double> areas;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (names[t].count(name) != 0) areas[parts.find(t)] += area_of(mesh, t);
  }
  std::vector<double> list;
  for (const auto& [part, area] : areas) list.push_back(area);
  return list;
}

/// The length of the edges between top and side of the frustum.
double rim_length(const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<std::set<std::string>>& names) {
  double sum = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    bool has_load = false, has_steel = false;
    for (const HalfEdge h : topology.uses_of(MeshEdgeId(e))) {
      has_load = has_load || names[h / 3].count("load") != 0;
      has_steel = has_steel || names[h / 3].count("steel") != 0;
    }
    const auto& [a, b] = topology.edges[e];
    if (has_load && has_steel) sum += length(mesh.points[b.index()] - mesh.points[a.index()]);
  }
  return sum;
}

/// The volume of the space that just these solids contain; of both, the space that any contains when it is one region.
double volume_of_region(const Call& call, unsigned solids) {
  static const double common = enclosed_volume(intersect(frustum(), sphere()).mesh);
  if (solids == frustum_bit) return frustum_volume - common;
  if (solids == sphere_bit) return sphere_volume - common;
  return call.name.substr(0, 5) == "union" ? frustum_volume + sphere_volume - common : common;
}

/// Measures of the parts of every attribute in a result; none for one that is gone.
using Parts = std::map<std::string, std::vector<double>>;

Parts parts_of(const Call& call, const ResultModel& m) {
  const MeshTopology topology = build_topology(m.boolean.mesh);
  const std::vector<std::set<std::string>> names = names_of_facets(call, m);
  Parts parts;
  for (const std::string& name : face_names) parts[name] = areas_of_parts(m.boolean.mesh, topology, names, name);
  for (const unsigned solids : call.regions) {
    if ((solids & frustum_bit) != 0) parts["iron"].push_back(volume_of_region(call, solids));
    if ((solids & sphere_bit) != 0) parts["oil"].push_back(volume_of_region(call, solids));
  }
  return parts;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// ---- What is found

/// The face of an operand that all triangles with a name are on.
std::uint32_t face_named(const Call& call, const ResultModel& m, std::size_t k, const std::string& name) {
  std::set<std::uint32_t> faces;
  for (std::uint32_t t = 0; t < m.meshes[k].triangles.size(); ++t) {
    if (name_on(m.meshes[k], t, (k == 1) != call.is_reversed) == name)
      faces.insert(m.operand_models[k].classification.face_of_triangle[t].value);
  }
  REQUIRE(faces.size() == 1);
  return *faces.begin();
}

Attribute attribute(const std::string& name, const ModelEntity& target, const AttributePolicy& policy, const std::string& value = "1") {
  return {name, AttributeKind::User, value, {target}, policy};
}

/// Attributes of both operands, by position.
using Given = std::array<std::vector<Attribute>, 2>;

Given attributes_of(const Call& call, const ResultModel& m, const AttributePolicy& policy) {
  const std::size_t f = call.is_reversed ? 1 : 0, s = 1 - f;
  Given given;
  for (const char* name : {"load", "base", "steel"}) given[f].push_back(attribute(name, {face, face_named(call, m, f, name)}, policy));
  given[f].push_back(attribute("iron", {region, 1}, policy));
  given[s] = {attribute("pressure", {face, face_named(call, m, s, "pressure")}, policy), attribute("oil", {region, 1}, policy)};
  return given;
}

std::vector<Attribute> transferred(const ResultModel& m, const Given& given) {
  const std::vector<OperandAttributes> operands{{given[0], &m.operand_models[0].brep}, {given[1], &m.operand_models[1].brep}};
  return transfer_attributes(m.lineage, operands);
}

using Measures = std::map<std::string, double>;

Measures measures_of(const ResultModel& m, const Given& given) {
  Measures found;
  for (const AttributeMeasure& a : measure_attributes(m.result, transferred(m, given))) found[a.name] = a.length + a.area + a.volume;
  return found;
}

/// None lost, none invented, and every one as large as it should be.
void check_same(const Measures& found, const Measures& expected) {
  std::vector<std::string> found_names, expected_names;
  for (const auto& [name, measure] : found) found_names.push_back(name);
  for (const auto& [name, measure] : expected) expected_names.push_back(name);
  CHECK(found_names == expected_names);
  for (const auto& [name, measure] : expected) {
    INFO(name);
    if (found.count(name) != 0) CHECK(found.at(name) == Approx(measure).epsilon(1e-12));
  }
}

}  // namespace

TEST_CASE("Fig. 18: every attribute covers what is left of its parent, whatever the operation and the numbering", "[paper][attributes]") {
  std::map<std::string, Measures> of_call;
  for_each_result([&](const Call& call, const ResultModel& m) {
    const Measures found = measures_of(m, attributes_of(call, m, {}));
    Measures expected;
    for (const auto& [name, parts] : parts_of(call, m)) {
      if (!parts.empty()) expected[name] = sum_of(parts);
    }
    check_same(found, expected);
    of_call[call.name] = found;
  });
  for (const std::string& name : face_names) {
    INFO(name);
    const auto area = [&](const char* call) { return of_call.at(call).count(name) != 0 ? of_call.at(call).at(name) : 0; };
    const bool is_of_frustum = name != "pressure";
    CHECK(area("union") + area("intersection") == Approx(whole.at(name)).epsilon(1e-12));
    CHECK(area("frustum less sphere") == Approx(area(is_of_frustum ? "union" : "intersection")).epsilon(1e-12));
    CHECK(area("sphere less frustum") == Approx(area(is_of_frustum ? "intersection" : "union")).epsilon(1e-12));
    for (const char* call : {"symmetric difference", "partition", "imprint"}) CHECK(area(call) == Approx(whole.at(name)).epsilon(1e-12));
  }
  for (const char* name : {"iron", "oil"}) CHECK(of_call.at("partition").at(name) == Approx(whole.at(name)).epsilon(1e-12));
}

TEST_CASE("Fig. 18: a split attribute is kept by the largest part, dropped, or named by its parts", "[paper][attributes]") {
  std::size_t splits = 0;
  for_each_result([&](const Call& call, const ResultModel& m) {
    AttributePolicy largest, drop, named;
    largest.on_split = OnSplit::Largest;
    drop.on_split = OnSplit::Drop;
    named.piece_name = "{name} {piece}";
    Measures of_largest, of_drop;
    const Measures found = measures_of(m, attributes_of(call, m, named));
    std::size_t count = 0;
    for (const auto& [name, parts] : parts_of(call, m)) {
      if (parts.empty()) continue;
      of_largest[name] = *std::max_element(parts.begin(), parts.end());
      if (parts.size() == 1) of_drop[name] = parts[0];
      std::vector<double> sorted = parts, pieces;
      for (std::size_t i = 1; i <= parts.size(); ++i) {
        const std::string piece = parts.size() == 1 ? name : name + " " + std::to_string(i);
        INFO(piece);
        REQUIRE(found.count(piece) == 1);
        pieces.push_back(found.at(piece));
      }
      std::sort(sorted.begin(), sorted.end());
      std::sort(pieces.begin(), pieces.end());
      for (std::size_t i = 0; i < sorted.size(); ++i) CHECK(pieces[i] == Approx(sorted[i]).epsilon(1e-12));
      count += parts.size();
      splits += parts.size() > 1 ? 1 : 0;
    }
    CHECK(found.size() == count);
    check_same(measures_of(m, attributes_of(call, m, largest)), of_largest);
    check_same(measures_of(m, attributes_of(call, m, drop)), of_drop);
  });
  // Side, top and sphere where all facets stay: four calls; both solids where regions stay apart: three.
  CHECK(splits == (3 * 4 + 2 * 3) * numberings());
}

TEST_CASE("Fig. 18: values that meet in a region are kept together, one of them, none, or refused", "[paper][attributes]") {
  for_each_result([](const Call& call, const ResultModel& m) {
    for (const OnMerge on_merge : {OnMerge::Union, OnMerge::First, OnMerge::Second, OnMerge::Error, OnMerge::Drop}) {
      AttributePolicy policy;
      policy.on_merge = on_merge;
      Given given;  // values are the bits of the solids
      for (std::size_t k = 0; k < 2; ++k) given[k] = {attribute("matter", {region, 1}, policy, (k == 1) == call.is_reversed ? "1" : "2")};
      const unsigned first = call.is_reversed ? sphere_bit : frustum_bit, second = 3 - first;
      Measures expected;
      for (const unsigned solids : call.regions) {
        const unsigned kept = solids != 3                   ? solids
                              : on_merge == OnMerge::Union  ? 3
                              : on_merge == OnMerge::First  ? first
                              : on_merge == OnMerge::Second ? second
                                                            : 0;
        for (const unsigned bit : {frustum_bit, sphere_bit}) {
          if ((kept & bit) != 0) expected[std::to_string(bit)] += volume_of_region(call, solids);
        }
      }
      const bool do_meet = std::count(call.regions.begin(), call.regions.end(), 3U) != 0;
      if (on_merge == OnMerge::Error && do_meet) {
        CHECK(error_of([&] { (void)transferred(m, given); })->code == ErrorCode::InvalidArgument);
        continue;
      }
      Measures found;
      for (const Attribute& a : transferred(m, given)) {
        CHECK(a.name == "matter");
        for (const ModelEntity& target : a.targets) found[a.value] += measure(m.result, target);
      }
      check_same(found, expected);
    }
  });
}

TEST_CASE("Fig. 18: what is cut away goes with its attribute, or gives it to its neighbours", "[paper][attributes]") {
  const std::map<std::string, std::vector<std::string>> neighbours{{"load", {"steel"}}, {"base", {"steel"}}, {"steel", {"base", "load"}},
                                                                   {"pressure", {}},    {"iron", {}},        {"oil", {}}};
  std::size_t gone = 0;
  for_each_result([&](const Call& call, const ResultModel& m) {
    AttributePolicy policy;
    policy.on_delete = OnDelete::ToNeighbours;
    const Parts parts = parts_of(call, m);
    const auto size_of = [&](const std::string& name) { return parts.count(name) != 0 ? sum_of(parts.at(name)) : 0; };
    Measures expected;
    for (const auto& [name, beside] : neighbours) {
      double size = size_of(name);
      const bool is_gone = size == 0;
      for (const std::string& other : beside) size += is_gone ? size_of(other) : 0;
      if (size > 0) expected[name] = size;
      gone += is_gone ? 1 : 0;
    }
    check_same(measures_of(m, attributes_of(call, m, policy)), expected);
  });
  // The base in three calls, either solid in one.
  CHECK(gone == (3 + 2) * numberings());
}

TEST_CASE("Fig. 18: an attribute on a rim has the length that is left of it", "[paper][attributes]") {
  std::map<std::string, double> of_call;
  for_each_result([&](const Call& call, const ResultModel& m) {
    const std::size_t f = call.is_reversed ? 1 : 0;
    const std::uint32_t top = face_named(call, m, f, "load");
    Given given;
    for (const ModelEntity& e : entities_below(m.operand_models[f].brep, {face, top})) {
      if (!m.operand_models[f].brep.edges[ModelEdgeId(e.id)].is_seam) given[f].push_back(attribute("rim", e, {}));
    }
    REQUIRE(given[f].size() == 1);
    const double length = rim_length(m.boolean.mesh, build_topology(m.boolean.mesh), names_of_facets(call, m));
    check_same(measures_of(m, given), {{"rim", length}});
    of_call[call.name] = length;
  });
  CHECK(of_call.at("union") + of_call.at("intersection") == Approx(whole.at("rim")).epsilon(1e-12));
  CHECK(of_call.at("frustum less sphere") == Approx(of_call.at("union")).epsilon(1e-12));
  for (const char* call : {"symmetric difference", "partition", "imprint"})
    CHECK(of_call.at(call) == Approx(whole.at("rim")).epsilon(1e-12));
}

TEST_CASE("Fig. 18: an imprinted operand has all its attributes in full, by every policy", "[paper][attributes]") {
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<SurfaceMesh> solids = numbered_solids(1, false);
    const ImprintResult imprinted = imprint(pointers_to(solids));
    const auto as_result = [&](const OperandList&) {
      BooleanResult result;
      result.mesh = imprinted.operands[k].mesh;
      result.provenance.source_face = imprinted.operands[k].source_face;
      result.provenance.source_operand.assign(result.mesh.triangles.size(), 0);
      result.provenance.flipped.assign(result.mesh.triangles.size(), 0);
      return result;
    };
    const Call call{"imprint", k == 1, as_result, {k == 0 ? frustum_bit : sphere_bit}};
    const ResultModel m(as_result, {solids[k]});
    CHECK(m.boolean.mesh.triangles.size() > solids[k].triangles.size());
    for (const OnSplit on_split : {OnSplit::Copy, OnSplit::Largest, OnSplit::Drop}) {
      AttributePolicy policy;
      policy.on_split = on_split;
      std::vector<Attribute> given{attribute(k == 0 ? "iron" : "oil", {region, 1}, policy)};
      for (const std::string& name : face_names) {
        if ((name == "pressure") == (k == 1)) given.push_back(attribute(name, {face, face_named(call, m, 0, name)}, policy));
      }
      Measures expected;
      for (const Attribute& a : given) expected[a.name] = whole.at(a.name);
      const std::vector<OperandAttributes> operands{{given, &m.operand_models[0].brep}};
      Measures found;
      for (const AttributeMeasure& a : measure_attributes(m.result, transfer_attributes(m.lineage, operands)))
        found[a.name] = a.area + a.volume;
      check_same(found, expected);
    }
  }
}
