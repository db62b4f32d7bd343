// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Imprints: every operand as it was but for its edges, common numbers, nothing lost, nothing twice.
#include "mortise/boolean/imprint.h"

#include <algorithm>

#include "mortise/boolean/keep_faces.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/imprint_checks.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"
#include "support/scene_list.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

ImprintResult imprint_of(const std::vector<SurfaceMesh>& operands) { return imprint(pointers_to(operands)); }

bool is_certified(const ImprintResult& result) { return result.whole.report.certificate.status == CertificateStatus::Certified; }

bool are_clean(const std::vector<SurfaceMesh>& solids) {
  return std::all_of(solids.begin(), solids.end(), [](const SurfaceMesh& m) { return oracle::self_crossings(m).empty(); });
}

void check_exactly(const std::vector<SurfaceMesh>& solids) {
  const auto operands = pointers_to(solids);
  const ImprintResult result = imprint_of(solids);
  CHECK(faults_of_numbering(operands, result) == "");
  CHECK(faults_of_split(operands, result) == "");
  CHECK(is_certified(result));
  for (const ImprintedOperand& operand : result.operands) CHECK(is_balanced(operand.mesh));
  if (are_clean(solids)) CHECK(oracle::self_crossings(result.whole.mesh).empty());
  CHECK(counts_of(imprint_of(imprinted_meshes(result))) == counts_of(result));
}

/// The same in the other order of operands.
void check_order(const std::vector<SurfaceMesh>& solids) {
  const ImprintResult forward = imprint_of(solids), backward = imprint_of({solids.rbegin(), solids.rend()});
  CHECK(sorted_points(forward.whole.mesh) == sorted_points(backward.whole.mesh));
  CHECK(forward.whole.mesh.triangles.size() == backward.whole.mesh.triangles.size());
  CHECK(forward.whole.graph.edges.size() == backward.whole.graph.edges.size());
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const SurfaceMesh &one = forward.operands[k].mesh, &other = backward.operands[solids.size() - 1 - k].mesh;
    CHECK(sorted_points(one) == sorted_points(other));
    CHECK(one.triangles.size() == other.triangles.size());
  }
}

double area_of(const SurfaceMesh& mesh) { return shape_of(mesh).area; }

}  // namespace

TEST_CASE("operands of the small scenes come back whole, split along their contacts", "[imprint]") {
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    check_exactly(scene.operands);
    check_order(scene.operands);
  }
}

TEST_CASE("random solids come back whole, split along their contacts", "[imprint]") {
  for (std::size_t seed = 1; seed <= scaled_count(200, 4000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(seed % 5 == 0 ? 4 : 2);
    check_exactly(solids);
    check_order(solids);
  }
}

TEST_CASE("random solids with cavities and several parts come back whole", "[imprint]") {
  for (std::size_t seed = 1; seed <= scaled_count(60, 1000); ++seed) {
    INFO("seed " << seed);
    RandomSolids random(seed);
    check_exactly({random.next_of_all_kinds(), random.next_of_all_kinds()});
  }
}

TEST_CASE("boxes that touch share vertices, edges and the facets of the common face", "[imprint]") {
  const ImprintResult result = imprint(box({0, 0, 0}, {1, 1, 1}), box_other_diagonals({1, 0, 0}, {2, 1, 1}));
  const ImprintedOperand &a = result.operands[0], &b = result.operands[1];
  std::vector<std::uint32_t> common;
  std::set_intersection(a.vertex_ids.begin(), a.vertex_ids.end(), b.vertex_ids.begin(), b.vertex_ids.end(), std::back_inserter(common));
  double area = 0;
  for (std::size_t t = 0; t < a.facet_ids.size(); ++t) {
    const auto at = std::find(b.facet_ids.begin(), b.facet_ids.end(), a.facet_ids[t]);
    CHECK((at != b.facet_ids.end()) == (a.category[t] == FacetCategory::OnOpposite));
    if (at == b.facet_ids.end()) continue;
    CHECK(b.category[static_cast<std::size_t>(at - b.facet_ids.begin())] == FacetCategory::OnOpposite);
    SurfaceMesh facet = a.mesh;
    facet.triangles = {a.mesh.triangles[t]};
    area += area_of(facet);
  }
  CHECK(area == 1);
  CHECK(common.size() == 5);  // four corners and the place where the diagonals cross
  CHECK(shared_edges(result).size() == 8);
  CHECK(result.whole.mesh.triangles.size() + 4 == a.facet_ids.size() + b.facet_ids.size());
}

TEST_CASE("a face that coincides with faces along and against it has the category each operand sees", "[imprint]") {
  // Two boxes on the same bottom, a plinth under both.
  const std::vector<SurfaceMesh> solids{box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 2}), box({0, 0, -1}, {1, 1, 0})};
  const ImprintResult result = imprint_of(solids);
  CHECK(faults_of_split(pointers_to(solids), result) == "");
  const auto area = [&](std::size_t k, FacetCategory category) {
    SurfaceMesh part = result.operands[k].mesh;
    part.triangles.clear();
    for (std::size_t t = 0; t < result.operands[k].category.size(); ++t) {
      if (result.operands[k].category[t] == category) part.triangles.push_back(result.operands[k].mesh.triangles[t]);
    }
    return area_of(part);
  };
  CHECK((area(0, FacetCategory::OnSame) == 5 && area(0, FacetCategory::Inside) == 1));  // the bottom runs like that of the second
  CHECK((area(1, FacetCategory::OnSame) == 5 && area(1, FacetCategory::Outside) == 5));
  CHECK((area(2, FacetCategory::OnOpposite) == 1 && area(2, FacetCategory::Outside) == 5));
}

TEST_CASE("an operand nothing touches comes back bit by bit", "[imprint]") {
  SurfaceMesh ball = make_icosphere(1, 3);
  ball.label_names = {"north", "south"};
  for (const Triangle& t : ball.triangles) ball.face_labels.push_back(ball.points[t[0].index()].z > 0 ? 0 : 1);
  const ImprintResult result = imprint_of({box({5, 5, 5}, {6, 6, 6}), ball, box({5.5, 5.5, 5.5}, {7, 7, 7})});
  const ImprintedOperand& same = result.operands[1];
  CHECK(has_same_bits(same.mesh, ball));
  CHECK(same.mesh.face_labels == ball.face_labels);
  CHECK(same.mesh.label_names == ball.label_names);
  for (std::uint32_t v = 0; v < ball.points.size(); ++v) CHECK(same.source_vertex[v] == v);
  for (std::uint32_t f = 0; f < ball.triangles.size(); ++f) CHECK(same.source_face[f] == f);
}

TEST_CASE("an operand that overlaps itself comes back with all its faces", "[imprint]") {
  const SurfaceMesh nested = joined({box({0, 0, 0}, {4, 4, 4}), box({2, 2, 2}, {6, 6, 6})});
  const SurfaceMesh twice = joined({box({0, 0, 0}, {2, 2, 2}), box({0, 0, 0}, {2, 2, 2})});
  SurfaceMesh finned = box({0, 0, 0}, {1, 1, 1});
  finned.points.push_back({1, 0.5, 1.5});
  finned.triangles.push_back({VertexId(5), VertexId(7), VertexId(8)});
  finned.triangles.push_back({VertexId(7), VertexId(5), VertexId(8)});
  const SurfaceMesh cutter = box({0.5, 0.25, 0.5}, {3, 0.75, 3});
  for (const SurfaceMesh& mesh : {nested, twice, finned}) {
    const std::vector<SurfaceMesh> solids{mesh, cutter};
    const ImprintResult result = imprint_of(solids);
    CHECK(faults_of_numbering(pointers_to(solids), result) == "");
    CHECK(faults_of_provenance(pointers_to(solids), result.whole, Repairs::None) == "");
    CHECK(is_balanced(result.operands[0].mesh));
    CHECK(exact_volume(result.operands[0].mesh) == exact_volume(mesh));
    CHECK(area_of(result.operands[0].mesh) == Approx(area_of(mesh)).epsilon(1e-14));
    CHECK(counts_of(imprint_of(imprinted_meshes(result))) == counts_of(result));
  }
}

TEST_CASE("faces kept by tags are those of the imprint with these categories", "[imprint]") {
  const std::vector<SurfaceMesh> solids{box({0, 0, 0}, {4, 4, 4}), joined({box({2, 2, 2}, {6, 6, 4}), box({4, 0, 0}, {5, 1, 1})})};
  const ImprintResult result = imprint_of(solids);
  for (unsigned mask = 0; mask < 64; ++mask) {
    std::size_t expected = 0;
    for (std::size_t f = 0; f < result.whole.mesh.triangles.size(); ++f) {
      const auto category = static_cast<unsigned>(result.whole.provenance.category[f]);
      const bool is_first = result.whole.provenance.source_operand[f] == 0;
      const unsigned place = category >= 2 ? category + 2 : category + (is_first ? 0 : 2);
      expected += mask >> place & 1U;
    }
    CHECK(keep_faces(static_cast<KeepMask>(mask), pointers_to(solids)).mesh.triangles.size() == expected);
  }
}

TEST_CASE("turned copies of a solid that rounding folds stay closed, each by itself, after the repair", "[imprint]") {
  std::size_t repaired = 0;  // and certified: not every scene as close as this can be repaired
  for (int i = 1; i <= 40; ++i) {
    INFO("copy " << i);
    const SurfaceMesh ring = make_torus(2, 0.5, 12, 8);
    const SurfaceMesh other = transform(ring, rotation(Axis::Z, 30.0 * i));
    const std::vector<SurfaceMesh> solids{ring, transform(other, translation({0, 0, i % 4 == 0 ? 0 : 0x1p-52 * i}))};
    const ImprintResult result = imprint_of(solids);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(is_balanced(result.operands[k].mesh));
      CHECK(exact_volume(result.operands[k].mesh) == Approx(exact_volume(solids[k])).epsilon(1e-13));
      CHECK(area_of(result.operands[k].mesh) == Approx(area_of(solids[k])).epsilon(1e-12));
    }
    if (!is_certified(result)) continue;
    CHECK(faults_of_numbering(pointers_to(solids), result) == "");
    repaired += result.whole.report.certificate.repair_displacement > 0 ? 1 : 0;
    CHECK(oracle::self_crossings(result.whole.mesh).empty());
    CHECK(counts_of(imprint_of(imprinted_meshes(result))) == counts_of(result));
  }
  CHECK(repaired >= 25);
}

TEST_CASE("an imprint is refused like a boolean, and can be cancelled", "[imprint]") {
  const SurfaceMesh cube = box({0, 0, 0}, {1, 1, 1});
  CHECK(error_of([] { (void)imprint_of({}); })->code == ErrorCode::InvalidArgument);
  CHECK(error_of([&] { (void)imprint_of({cube, inside_out(cube)}); })->code == ErrorCode::InsideOut);
  BooleanOptions options;
  options.progress = [](std::string_view, double) { return false; };
  CHECK(error_of([&] { (void)imprint(cube, cube, options); })->code == ErrorCode::Cancelled);
}

TEST_CASE("real meshes come back whole, split along their contacts", "[imprint][scenario]") {
  if (is_data_missing()) return;
  for (const ListedScene& scene : listed_scenes()) {
    if (!scene.needs_data || !scene.has_figures) continue;
    INFO(scene.name);
    std::vector<SurfaceMesh> solids;
    std::size_t triangles = 0;
    for (const std::string& text : scene.operands) solids.push_back(load_operand(text));
    for (const SurfaceMesh& m : solids) triangles += m.triangles.size();
    if (is_reduced_run() && triangles > 20000) continue;
    const ImprintResult result = imprint_of(solids);
    CHECK(is_certified(result));
    CHECK(faults_of_numbering(pointers_to(solids), result) == "");
    for (std::size_t k = 0; k < solids.size(); ++k) {
      INFO("operand " << k);
      CHECK(is_balanced(result.operands[k].mesh));
      const double area = area_of(solids[k]), slack = identity_tolerance(0, area, result.whole.report, largest_coordinate(solids[k]));
      CHECK(std::abs(exact_volume(result.operands[k].mesh) - exact_volume(solids[k])) <= slack);
      CHECK(area_of(result.operands[k].mesh) == Approx(area).epsilon(1e-9));
    }
    CHECK(counts_of(imprint_of(imprinted_meshes(result))) == counts_of(result));
    if (triangles < 100000) check_order(solids);
  }
}
