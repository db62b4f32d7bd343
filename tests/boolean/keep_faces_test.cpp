// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// All sets of tags against a filter of the arrangement by windings of the oracle.
#include "mortise/boolean/keep_faces.h"

#include <algorithm>
#include <set>

#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/arrangement.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"
#include "support/winding_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Corner = std::array<double, 3>;
using Corners = std::array<Corner, 3>;

/// The corners from the smallest on, in their order.
Corners turned(Corners c) {
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

std::multiset<Corners> triangles_of(const SurfaceMesh& mesh) {
  std::multiset<Corners> triangles;
  for (const Triangle& t : mesh.triangles) {
    Corners c;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& p = mesh.points[t[i].index()];
      c[i] = {p.x, p.y, p.z};
    }
    triangles.insert(turned(c));
  }
  return triangles;
}

/// The tag of every facet, by its definition.
class TaggedFacets {
 public:
  TaggedFacets(const std::vector<SurfaceMesh>& solids, const std::vector<std::size_t>& self)
      : scene_(solids, self), windings_(windings_beside_facets(scene_)) {}

  [[nodiscard]] std::multiset<Corners> filtered(KeepMask mask) const {
    std::multiset<Corners> triangles;
    for (std::size_t i = 0; i < scene_.facets.size(); ++i) {
      if (windings_[i].front == windings_[i].back || (mask & tag_of(FacetId(i))) == 0) continue;
      Corners c;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& p = scene_.faces.points.nearest(scene_.facets.corners[FacetId(i)][k]);
        c[k] = {p.x, p.y, p.z};
      }
      triangles.insert(turned(c));
    }
    return triangles;
  }

 private:
  [[nodiscard]] unsigned tag_of(FacetId f) const {
    const auto sources = scene_.facets.sources_of(f);
    const std::size_t own = scene_.faces.operand[sources.front().face].index();
    bool has_same = false, has_opposite = false, is_inside = false;
    for (const FacetSource& s : sources) {
      if (scene_.faces.operand[s.face].index() == own) continue;
      (s.is_opposite ? has_opposite : has_same) = true;
    }
    if (has_same) return static_cast<unsigned>(KeepTag::OnSame);
    if (has_opposite) return static_cast<unsigned>(KeepTag::OnOpposite);
    for (std::size_t k = 0; k < scene_.operands.size(); ++k) is_inside = is_inside || (k != own && windings_[f.index()].front[k] > 0);
    if (own == 0) return static_cast<unsigned>(is_inside ? KeepTag::FirstInside : KeepTag::FirstOutside);
    return static_cast<unsigned>(is_inside ? KeepTag::OtherInside : KeepTag::OtherOutside);
  }

  Arrangement scene_;
  std::vector<WindingsBeside> windings_;
};

/// @param self  operands that cross themselves
void check_all_masks(const std::vector<SurfaceMesh>& solids, bool needs_all_tags, const std::vector<std::size_t>& self = {}) {
  const TaggedFacets tagged(solids, self);
  for (unsigned mask = 0; mask < 64; ++mask) {
    INFO("mask " << mask);
    const BooleanResult kept = keep_faces(static_cast<KeepMask>(mask), pointers_to(solids));
    CHECK(triangles_of(kept.mesh) == tagged.filtered(static_cast<KeepMask>(mask)));
    CHECK(kept.report.certificate.status == CertificateStatus::Certified);
    // A point made by an operand with itself may be left with faces that do not determine it.
    if (self.empty()) CHECK(faults_of_provenance(pointers_to(solids), kept, Repairs::None) == "");
    CHECK(kept.provenance.covering.size() == kept.mesh.triangles.size());
    const bool is_single = mask != 0 && (mask & (mask - 1)) == 0;
    if (needs_all_tags && is_single) CHECK(!kept.mesh.triangles.empty());
  }
}

const SurfaceMesh block = box({0, 0, 0}, {4, 4, 4});

/// Parts that overlap the block with a face flush in its top, stand on it, and touch it in a corner and across an edge.
const SurfaceMesh parts_round_block = joined({box({2, 2, 2}, {6, 6, 4}), box({0.5, 0.5, 4}, {1.5, 1.5, 5}), box({-1, -1, -1}, {0, 0, 0}),
                                              tetrahedron({-1, 2, 3}, {1, 2, 5}, {-3, 1, 6}, {-3, 3, 6})});

}  // namespace

TEST_CASE("every set of tags gives the facets that a filter of the arrangement gives", "[keep_faces]") {
  check_all_masks({block, parts_round_block}, true);
  check_all_masks({parts_round_block, block}, true);
}

TEST_CASE("every set of tags gives the facets of the filter for random solids too", "[keep_faces]") {
  for (std::size_t seed = 1; seed <= scaled_count(10, 200); ++seed) {
    INFO("seed " << seed);
    check_all_masks(RandomSolids(seed).next(2 + seed % 2), false);
  }
}

TEST_CASE("faces that lie in their own operand only are outside the others", "[keep_faces]") {
  const SurfaceMesh crossed = joined({box({0, 0, 0}, {4, 4, 4}), box({2, 2, 2}, {6, 6, 6})});
  check_all_masks({crossed, box({1, 1, 1}, {3, 3, 9})}, false, {0});
  check_all_masks({box({1, 1, 1}, {3, 3, 9}), crossed}, false, {1});
  const std::vector<SurfaceMesh> apart{crossed, box({9, 9, 9}, {10, 10, 10})};
  CHECK(shape_of(keep_faces(keep_mask(std::vector<std::string>{"10"}), pointers_to(apart)).mesh).area == 2 * 6 * 16);
}

TEST_CASE("the tags of the paper give its operations, but for the direction of facets", "[keep_faces]") {
  const std::vector<SurfaceMesh> pair{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const auto kept = [&](const std::vector<std::string>& names) { return keep_faces(keep_mask(names), pointers_to(pair)).mesh; };
  CHECK(has_same_bits(kept({"10", "20"}), evaluate(Operation::Union, pair).mesh));
  CHECK(has_same_bits(kept({"11", "21"}), evaluate(Operation::Intersect, pair).mesh));
  CHECK(kept({"10", "21"}).triangles.size() == evaluate(Operation::Subtract, pair).mesh.triangles.size());
  CHECK_FALSE(is_balanced(kept({"10", "21"})));
  CHECK(kept({}).triangles.empty());
  CHECK(shape_of(kept({"10", "11", "20", "21"})).area == 48);
}

TEST_CASE("an open piece with made vertices only is certified, whichever way it looks", "[keep_faces]") {
  const SurfaceMesh large = box({-9, -8, -7}, {10, 11, 12});
  for (const Vec3d& centre : {Vec3d{10, 0.1, 0.2}, Vec3d{-9, 0.1, 0.2}, Vec3d{0.1, 11, 0.3}, Vec3d{0.1, 0.2, -7}}) {
    const AffineMap turn = compose(rotation(Axis::X, 31), rotation(Axis::Z, 17));
    const std::vector<SurfaceMesh> pair{transform(large, turn), transform(make_icosphere(1, 2), compose(translation(centre), turn))};
    const BooleanResult disc = keep_faces(keep_mask(std::vector<std::string>{"11"}), pointers_to(pair));
    CHECK(disc.report.certificate.status == CertificateStatus::Certified);
    REQUIRE(!disc.mesh.triangles.empty());
    CHECK(disc.report.certificate.triangles_tested >= disc.mesh.triangles.size());
    CHECK(euler_characteristic(disc.mesh) == 1);
  }
}

TEST_CASE("what different tags keep of a repaired result fits together, and is certified as a whole", "[keep_faces]") {
  std::size_t repaired = 0;
  for (std::size_t seed = 1; seed <= scaled_count(150, 3000); ++seed) {
    INFO("seed " << seed);
    const std::vector<SurfaceMesh> solids = slightly_off(RandomSolids(seed).next(2 + seed % 2));
    const auto all = keep_faces(63, pointers_to(solids));
    if (all.report.certificate.repair_displacement == 0) continue;
    const bool is_certified = all.report.certificate.status == CertificateStatus::Certified;
    if (is_certified) CHECK(oracle::self_crossings(all.mesh).empty());
    repaired += is_certified ? 1 : 0;
    std::multiset<Corners> pieces;
    std::size_t failed = 0;
    for (unsigned mask = 1; mask < 64; mask *= 2) {
      const BooleanResult piece = keep_faces(static_cast<KeepMask>(mask), pointers_to(solids));
      pieces.merge(triangles_of(piece.mesh));
      CHECK(piece.report.certificate.status == all.report.certificate.status);
      for (const std::uint32_t f : piece.report.certificate.failed_faces) CHECK(f < piece.mesh.triangles.size());
      failed += piece.report.certificate.failed_faces.size();
      CHECK(find_result_regions(piece).region_in_front.empty());
    }
    CHECK(pieces == triangles_of(all.mesh));
    CHECK(failed == all.report.certificate.failed_faces.size());
  }
  CHECK(repaired > scaled_count(150, 3000) / 10);
}

TEST_CASE("an open result has no regions, a closed one has", "[keep_faces]") {
  const std::vector<SurfaceMesh> pair{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const BooleanResult open = keep_faces(keep_mask(std::vector<std::string>{"10"}), pointers_to(pair));
  CHECK_FALSE(find_result_regions(open).is_closed);
  CHECK(find_result_regions(open).regions.empty());
  const BooleanResult closed = keep_faces(keep_mask(std::vector<std::string>{"11", "21"}), pointers_to(pair));
  CHECK(find_result_regions(closed).is_closed);
  REQUIRE(find_result_regions(closed).regions.size() == 1);
  CHECK(find_result_regions(closed).regions[0].volume == 1);
}

TEST_CASE("unknown tags and masks are refused", "[keep_faces]") {
  const auto error = error_of([] { (void)keep_mask(std::vector<std::string>{"12"}); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
  CHECK(error_of([] { (void)keep_faces(64, std::array{&block}); })->code == ErrorCode::InvalidArgument);
}
