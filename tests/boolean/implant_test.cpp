// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Components in a host: what goes, what stays, what both sides share (paper Fig. 16, 28).
#include "mortise/boolean/implant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/partition_checks.h"
#include "support/random_solids.h"
#include "support/remesh_scenes.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Edge = std::array<std::uint32_t, 2>;
using PlainTriangle = std::array<std::array<double, 3>, 3>;

BooleanResult implant_of(const std::vector<SurfaceMesh>& operands, ImplantContact contact = ImplantContact::Keep) {
  return implant(pointers_to(operands), contact);
}

bool has_source_in(const Provenance& p, std::size_t f, std::uint32_t operand) {
  for (std::uint32_t i = p.other_source_begin[f]; i < p.other_source_begin[f + 1]; ++i) {
    if (p.other_source_operand[i] == operand) return true;
  }
  return p.source_operand[f] == operand;
}

std::vector<std::uint32_t> behind(const BooleanResult& r, std::size_t f) { return r.provenance.covering_sets[r.provenance.covering[f]]; }
std::vector<std::uint32_t> in_front(const BooleanResult& r, std::size_t f) {
  return r.provenance.covering_sets[r.provenance.covering_front[f]];
}

/// Edges with an odd number of the facets of an operand.
std::set<Edge> border_of(const BooleanResult& result, std::uint32_t operand, bool alone) {
  std::set<Edge> odd;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (!has_source_in(result.provenance, f, operand)) continue;
    if (alone && result.provenance.other_source_begin[f] != result.provenance.other_source_begin[f + 1]) continue;
    const Triangle& t = result.mesh.triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = t[i].value, v = t[(i + 1) % 3].value;
      const Edge e{std::min(u, v), std::max(u, v)};
      if (!odd.insert(e).second) odd.erase(e);
    }
  }
  return odd;
}

PlainTriangle plain(const SurfaceMesh& mesh, const Triangle& t) {
  PlainTriangle corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& p = mesh.points[t[i].index()];
    corners[i] = {p.x, p.y, p.z};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::set<PlainTriangle> plain_triangles(const SurfaceMesh& mesh) {
  std::set<PlainTriangle> all;
  for (const Triangle& t : mesh.triangles) all.insert(plain(mesh, t));
  return all;
}

/// Host faces whose box does not meet that of the component come back with the same bits; returns how many there are.
std::size_t check_untouched(const SurfaceMesh& host, const SurfaceMesh& component, const BooleanResult& result) {
  Box3 reach;
  for (const Vec3d& p : component.points) reach.extend(p);
  const std::set<PlainTriangle> found = plain_triangles(result.mesh);
  std::size_t far = 0, lost = 0;
  for (const Triangle& t : host.triangles) {
    Box3 box;
    for (const VertexId v : t) box.extend(host.points[v.index()]);
    if (boxes_meet(box, reach)) continue;
    ++far;
    lost += found.count(plain(host, t)) == 0 ? 1 : 0;
  }
  CHECK(lost == 0);
  return far;
}

/// The border of what is left of the host lies on the component edge for edge, and host faces alone end nowhere else.
void check_loop(const BooleanResult& result) {
  const std::set<Edge> loop = border_of(result, 0, true);
  std::set<Edge> of_component;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (!has_source_in(result.provenance, f, 1)) continue;
    const Triangle& t = result.mesh.triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      of_component.insert({std::min(t[i].value, t[(i + 1) % 3].value), std::max(t[i].value, t[(i + 1) % 3].value)});
    }
  }
  CHECK(loop.size() >= 3);
  CHECK(std::includes(of_component.begin(), of_component.end(), loop.begin(), loop.end()));
  CHECK(border_of(result, 1, false).empty());
}

double volume_of_operand(const BooleanResult& result, std::uint32_t operand) {
  double sum = 0;
  for (const ResultRegion& r : find_result_regions(result).regions) {
    if (r.operands == std::vector<std::uint32_t>{operand}) sum += r.volume;
  }
  return sum;
}

/// A hull 12 long with a flat deck at z = 1.5 of many faces.
SurfaceMesh hull() {
  SurfaceMesh ship = make_icosphere(1, 4);
  for (Vec3d& p : ship.points) p = {6 * p.x, 1.5 * p.y, 3 * p.z};
  SurfaceMesh body = evaluate(Operation::Intersect, {ship, box({-7, -7, -7}, {7, 7, 1.5})}).mesh;
  return evaluate(Operation::Union, {body, box({-2, -1, -1}, {2, 1, 1.5})}).mesh;
}

}  // namespace

TEST_CASE("a gun on deck: the deck under it is the contact face, the loop is shared, all else is as it was", "[implant]") {
  const SurfaceMesh ship = hull(), part = transform(gun(), translation({0.25, 0.125, 1.5}));
  const BooleanResult result = implant_of({ship, part});
  CHECK(faults_of_partition(result) == "");
  CHECK(faults_of_provenance(pointers_to(std::vector{ship, part}), result, Repairs::None) == "");
  CHECK(oracle::self_crossings(result.mesh).empty());
  check_loop(result);
  CHECK(check_untouched(ship, part, result) > 1000);
  CHECK(volume_of_operand(result, 0) == Approx(exact_volume(ship)).epsilon(1e-13));
  CHECK(volume_of_operand(result, 1) == Approx(exact_volume(part)).epsilon(1e-13));
  double contact = 0;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (in_front(result, f).empty()) continue;
    CHECK(result.provenance.category[f] == FacetCategory::OnOpposite);
    CHECK((behind(result, f) == std::vector<std::uint32_t>{1} && in_front(result, f) == std::vector<std::uint32_t>{0}));
    CHECK((has_source_in(result.provenance, f, 0) && has_source_in(result.provenance, f, 1)));
    SurfaceMesh facet = result.mesh;
    facet.triangles = {result.mesh.triangles[f]};
    contact += shape_of(facet).area;
  }
  CHECK(contact == Approx(0.5 * 24 * std::sin(2 * 3.14159265358979323846 / 24) * 0.36).epsilon(1e-12));
}

TEST_CASE("without contact faces the gun and the ship are one body", "[implant]") {
  const SurfaceMesh ship = hull(), part = transform(gun(), translation({0.25, 0.125, 1.5}));
  const BooleanResult result = implant_of({ship, part}, ImplantContact::Drop);
  const BooleanResult united = evaluate(Operation::Union, {ship, part});
  CHECK(has_same_bits(result.mesh, united.mesh));
  CHECK(is_balanced(result.mesh));
  CHECK(find_result_regions(result).regions.size() == 1);
  CHECK(check_untouched(ship, part, result) > 1000);
}

TEST_CASE("a component that reaches into the host stays entire, and the host ends at it", "[implant]") {
  const SurfaceMesh ship = hull(), part = transform(gun(), translation({0.25, 0.125, 1.25}));
  const BooleanResult result = implant_of({ship, part});
  CHECK(faults_of_partition(result) == "");
  check_loop(result);
  CHECK(check_untouched(ship, part, result) > 1000);
  CHECK(volume_of_operand(result, 1) == Approx(exact_volume(part)).epsilon(1e-13));
  CHECK(volume_of_operand(result, 0) == Approx(exact_volume(evaluate(Operation::Subtract, {ship, part}).mesh)).epsilon(1e-13));
  SurfaceMesh of_part = result.mesh;
  of_part.triangles.clear();
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (has_source_in(result.provenance, f, 1)) of_part.triangles.push_back(result.mesh.triangles[f]);
    CHECK_FALSE((result.provenance.source_operand[f] == 0 && result.provenance.category[f] == FacetCategory::Inside));
  }
  CHECK(is_balanced(of_part));  // all run outwards of the component
  CHECK(exact_volume(of_part) == Approx(exact_volume(part)).epsilon(1e-13));
  CHECK(shape_of(of_part).area == Approx(shape_of(part).area).epsilon(1e-13));
}

TEST_CASE("the small scenes: the last operand keeps its volume, the others what it leaves them", "[implant]") {
  for (const Scene& scene : small_scenes()) {
    if (scene.operands.size() < 2 || scene.operands.size() > 4) continue;
    INFO(scene.name);
    const auto operands = pointers_to(scene.operands);
    const BooleanResult result = implant(operands);
    CHECK(faults_of_partition(result) == "");
    CHECK(faults_of_provenance(operands, result, Repairs::None) == "");
    std::map<std::vector<std::uint32_t>, oracle::Rational> expected;
    for (const auto& [covering, volume] : expected_volumes(operands)) expected[{covering.back()}] += volume;
    CHECK(exact_volumes(operands, result) == expected);
  }
}

TEST_CASE("random solids: the last operand keeps its volume, the others what it leaves them", "[implant]") {
  for (std::size_t seed = 1; seed <= scaled_count(200, 4000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(seed % 4 == 0 ? 3 : 2);
    const auto operands = pointers_to(solids);
    const BooleanResult result = implant(operands);
    CHECK(faults_of_partition(result) == "");
    std::map<std::vector<std::uint32_t>, oracle::Rational> expected;
    for (const auto& [covering, volume] : expected_volumes(operands)) expected[{covering.back()}] += volume;
    CHECK(exact_volumes(operands, result) == expected);
  }
}

TEST_CASE("a component flush in a pocket of the deck has its top once, as skin of the component", "[implant]") {
  const SurfaceMesh deck = box({0, 0, 0}, {4, 4, 4}), hatch = box({1, 1, 3}, {2, 2, 4});
  const BooleanResult result = implant_of({deck, hatch});
  CHECK(faults_of_partition(result) == "");
  CHECK(volume_of_operand(result, 0) == 63);
  CHECK(volume_of_operand(result, 1) == 1);
  CHECK(shape_of(result.mesh).area == 96 + 5);
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    if (result.provenance.category[f] == FacetCategory::OnSame) CHECK(behind(result, f) == std::vector<std::uint32_t>{1});
  }
}

TEST_CASE("a component inside the host is a region in its place, one round the host leaves nothing of it", "[implant]") {
  const SurfaceMesh large = box({0, 0, 0}, {4, 4, 4}), small = box({1, 1, 1}, {2, 2, 2});
  const BooleanResult inside = implant_of({large, small});
  CHECK(volume_of_operand(inside, 0) == 63);
  CHECK(volume_of_operand(inside, 1) == 1);
  const BooleanResult swallowed = implant_of({small, large});
  CHECK(volume_of_operand(swallowed, 1) == 64);
  CHECK(swallowed.mesh.triangles.size() == 12);
}

TEST_CASE("an implant needs a component", "[implant]") {
  CHECK(error_of([] { (void)implant_of({box({0, 0, 0}, {1, 1, 1})}); })->code == ErrorCode::InvalidArgument);
  CHECK(error_of([] { (void)implant_of({}); })->code == ErrorCode::InvalidArgument);
}

TEST_CASE("a funnel on the deck of a ship: flush, sunk in, almost flush", "[implant][scenario]") {
  if (is_data_missing() || is_reduced_run()) return;
  const SurfaceMesh ship = read_data("ship/dtc_hull.ply");
  // s=0.015; the deck is at z=0.5723220109939575. Figures of SOURCES.md: what is left of the ship, and of the whole.
  const std::vector<std::array<std::string, 3>> cases{{"0.5723220109939575", "2.43630567736", "2.43715374729"},
                                                      {"0.50", "2.43610123028", "2.43694930021"},
                                                      {"0.572322", "2.43630567732", "2.43715374726"}};
  for (const auto& [height, left, all] : cases) {
    INFO("at " << height);
    const SurfaceMesh funnel = read_data("ship/stack_funnel.obj", "s=0.015 t=1.2,0," + height);
    const BooleanResult result = implant_of({ship, funnel});
    CHECK(result.report.certificate.status == CertificateStatus::Certified);
    CHECK(find_result_regions(result).is_closed);
    CHECK(find_result_regions(result).regions.size() == 2);
    CHECK(volume_of_operand(result, 0) == Approx(std::stod(left)).epsilon(1e-11));
    CHECK(volume_of_operand(result, 0) + volume_of_operand(result, 1) == Approx(std::stod(all)).epsilon(1e-11));
    CHECK(volume_of_operand(result, 1) == Approx(exact_volume(funnel)).epsilon(1e-12));
    check_loop(result);
    CHECK(check_untouched(ship, funnel, result) > 110000);
    CHECK(is_balanced(implant_of({ship, funnel}, ImplantContact::Drop).mesh));
  }
}
