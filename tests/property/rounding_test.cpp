// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Scenes built to break rounding. Every result is certified and free of crossings by the oracle, or uncertified with crossings
// where it says; how many needed which step of repair is printed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "mortise/base/trig.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"
#include "support/random_source.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr Operation operations[] = {Operation::Union, Operation::Intersect, Operation::Subtract, Operation::SymmetricDifference};

AffineMap random_turn(RandomSource& random) {
  const double x = random.between(0, 360), y = random.between(0, 360), z = random.between(0, 360);
  return compose(compose(rotation(Axis::X, x), rotation(Axis::Y, y)), rotation(Axis::Z, z));
}

/// Does a face that the certificate names have no area by the oracle, or cross another, or have an edge with more than one other face,
/// where the order of faces may have changed?
bool is_reason_true(const BooleanResult& result) {
  const SurfaceMesh& mesh = result.mesh;
  const std::vector<std::uint32_t>& failed = result.report.certificate.failed_faces;
  const auto is_failed = [&](std::uint32_t f) { return std::binary_search(failed.begin(), failed.end(), f); };
  const std::vector<std::uint32_t> flat = oracle::faces_without_area(mesh);
  if (std::any_of(flat.begin(), flat.end(), is_failed)) return true;
  for (const auto& pair : oracle::self_crossings(mesh)) {
    if (is_failed(pair.face_a) || is_failed(pair.face_b)) return true;
  }
  const MeshTopology topology = build_topology(mesh);
  for (const MeshEdgeId e : find_non_manifold_edges(topology)) {
    for (const HalfEdge h : topology.uses_of(e)) {
      if (is_failed(face_of(h).value)) return true;
    }
  }
  return false;
}

/// An operand and two of its faces, the lower one first.
using FacePair = std::array<std::size_t, 3>;

FacePair sources_of(const BooleanResult& result, const oracle::MeetingPair& pair) {
  const Provenance& p = result.provenance;
  if (p.source_operand[pair.face_a] != p.source_operand[pair.face_b]) return {};
  const std::size_t f = p.source_face[pair.face_a], g = p.source_face[pair.face_b];
  return {p.source_operand[pair.face_a], std::min(f, g), std::max(f, g)};
}

/// Counts results by what they needed.
struct Tally {
  std::size_t results = 0, plain = 0, merged = 0, swapped = 0, snapped = 0, moved = 0, uncertified = 0;
  double largest_repair = 0;

  /// @param brought  crossing faces of one operand: a certificate is relative to them
  void add(const BooleanResult& result, const std::set<FacePair>& brought = {}) {
    const Certificate& certificate = result.report.certificate;
    ++results;
    CHECK(is_balanced(result.mesh));
    if (certificate.status == CertificateStatus::Uncertified) {
      ++uncertified;
      REQUIRE(!certificate.failed_faces.empty());
      CHECK(is_reason_true(result));
      return;
    }
    CHECK(certificate.failed_faces.empty());
    for (const auto& pair : oracle::self_crossings(result.mesh)) CHECK(brought.count(sources_of(result, pair)) == 1);
    plain += certificate.merge_rounds + certificate.swap_rounds + certificate.snap_rounds == 0 ? 1 : 0;
    merged += certificate.merge_rounds > 0 ? 1 : 0;
    swapped += certificate.swap_rounds > 0 ? 1 : 0;
    snapped += certificate.snap_rounds > 0 ? 1 : 0;
    moved += certificate.moved_input_vertices.empty() ? 0 : 1;
    largest_repair = std::max(largest_repair, certificate.repair_displacement);
    CHECK(certificate.repair_displacement <= certificate.largest_displacement);
  }

  void print(const char* family) const {
    std::printf(
        "rounding, %-32s %4zu results: %4zu as rounded, %4zu merged, %3zu swapped, %3zu snapped (%zu moved input), "
        "%3zu uncertified, repairs moved by %.3g at most\n",
        family, results, plain, merged, swapped, snapped, moved, uncertified, largest_repair);
  }
};

void evaluate_all(const std::vector<SurfaceMesh>& operands, Tally& tally, const std::set<FacePair>& brought = {}) {
  for (const Operation operation : operations) {
    INFO(operation_name(operation));
    const BooleanResult result = evaluate(operation, operands);
    tally.add(result, brought);
    if (result.report.certificate.snap_rounds > 0) CHECK(faults_of_provenance(pointers_to(operands), result, Repairs::Allowed) == "");
  }
}

SurfaceMesh round_shape(RandomSource& random) {
  switch (random.below(4)) {
    case 0:
      return make_icosphere(1, 1);
    case 1:
      return make_torus(1, 0.375, 12, 8);
    case 2:
      return make_cylinder(0.75, 1.5, 9);
    default:
      return box({-0.5, -0.75, -1}, {0.5, 0.75, 1});
  }
}

SurfaceMesh turned_shape(RandomSource& random) {
  const AffineMap pose = random_turn(random);
  return transform(round_shape(random), pose);
}

/// All operations on operands drawn from seeds.
template <class Draw>
Tally evaluate_family(const char* name, const Draw& draw) {
  Tally tally;
  for (std::size_t seed = 1; seed <= scaled_count(60, 2000); ++seed) {
    INFO(name << ", seed " << seed);
    RandomSource random(seed);
    evaluate_all(draw(random), tally);
  }
  tally.print(name);
  CHECK(tally.uncertified == 0);
  return tally;
}

/// Every coordinate moved up or down by one unit in the last place, or not.
SurfaceMesh one_ulp_off(SurfaceMesh mesh, RandomSource& random) {
  for (Vec3d& p : mesh.points) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double limit = random.once_in(2) ? 100 : -100;
      if (!random.once_in(3)) p[i] = std::nextafter(p[i], limit);
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("copies turned by 1e-9 to 1e-16 are certified", "[rounding]") {
  const Tally tally = evaluate_family("copies turned a little", [](RandomSource& random) {
    const SurfaceMesh shape = turned_shape(random);
    const double radians = std::pow(10.0, -9 - static_cast<int>(random.below(8)));
    return std::vector<SurfaceMesh>{shape, transform(shape, rotation(Axis::Z, trig::to_degrees(radians)))};
  });
  CHECK(tally.plain + tally.merged > tally.results / 2);
}

TEST_CASE("shells one unit in the last place apart are certified", "[rounding]") {
  const Tally tally = evaluate_family("shells 1 ulp apart", [](RandomSource& random) {
    const SurfaceMesh shape = turned_shape(random);
    const double outwards = 1 + std::ldexp(1.0, -52 + static_cast<int>(random.below(3)));
    const bool is_random = random.once_in(2);
    return std::vector<SurfaceMesh>{shape,
                                    is_random ? one_ulp_off(shape, random) : transform(shape, scaling({outwards, outwards, outwards}))};
  });
  CHECK(tally.plain + tally.merged > tally.results / 2);
}

TEST_CASE("many planes through nearly one point are certified, or uncertified with a true reason", "[rounding]") {
  Tally tally;
  for (std::size_t seed = 1; seed <= scaled_count(6, 60); ++seed) {
    INFO("seed " << seed);
    RandomSource random(seed);
    // A corner of every box lies within a few units in the last place of one point.
    std::vector<SurfaceMesh> boxes;
    const Vec3d point{0.1, 0.2, 0.3};
    for (std::size_t i = 0; i < 10 + 6 * seed; ++i) {
      const AffineMap turn = random_turn(random);
      const SurfaceMesh turned = transform(box({0, 0, 0}, random.point(1, 2)), turn);
      boxes.push_back(one_ulp_off(moved(turned, point), random));
    }
    for (const Operation operation : {Operation::Union, Operation::Subtract}) tally.add(evaluate(operation, boxes));
  }
  tally.print("planes through nearly one point");
}

TEST_CASE("chains of 50 operations in random poses stay certified, and move no input vertex", "[rounding]") {
  Tally tally;
  for (std::size_t seed = 1; seed <= scaled_count(3, 100); ++seed) {
    RandomSource random(seed);
    SurfaceMesh body = transform(box({-1, -1, -1}, {1, 1, 1}), random_turn(random));
    for (int step = 0; step < 50; ++step) {
      INFO("seed " << seed << ", step " << step);
      const Vec3d at = 1.2 * random.direction();
      const SurfaceMesh tool = moved(scaled(turned_shape(random), 0.4), at);
      const BooleanResult next = evaluate(random.once_in(2) ? Operation::Union : Operation::Subtract, {body, tool});
      tally.add(next);
      CHECK(next.report.self_contacts.empty());
      body = next.mesh;
    }
  }
  tally.print("chains of 50");
  CHECK(tally.uncertified + tally.moved == 0);
}

TEST_CASE("ordinary scenes need no repair", "[rounding]") {
  const Tally tally = evaluate_family("ordinary scenes", [](RandomSource& random) {
    const SurfaceMesh first = turned_shape(random), second = turned_shape(random);
    return std::vector<SurfaceMesh>{first, moved(second, random.point(-0.5, 0.5))};
  });
  CHECK(tally.plain == tally.results);
}

TEST_CASE("two meshes of slivers in the last places are certified, or uncertified with a true reason", "[rounding][scenario]") {
  if (is_data_missing()) return;
  Tally tally;
  const std::vector<SurfaceMesh> twins{read_data("nasty/manifold_Generic_Twin_7863_left.obj"),
                                       read_data("nasty/manifold_Generic_Twin_7863_right.obj")};
  std::set<FacePair> brought;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const auto& pair : oracle::self_crossings(twins[k])) brought.insert({k, pair.face_a, pair.face_b});
  }
  REQUIRE(!brought.empty());
  evaluate_all(twins, tally, brought);
  tally.print("Generic_Twin");
}
