// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The absolute level: what an operand brought along counts too.
#include <algorithm>

#include "mortise/boolean/certify_or_repair.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/random_solids.h"
#include "support/self_crossing_oracle.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

Certificate certificate_of(CertificateLevel level, const std::vector<SurfaceMesh>& operands) {
  BooleanOptions options;
  options.certify = level;
  return evaluate_boolean(Operation::Union, pointers_to(operands), options).report.certificate;
}

}  // namespace

TEST_CASE("a crossing that an operand has far from the others is in the way of an absolute certificate alone") {
  // A torus pushed through itself in one place: connected, so that the call does not look for it.
  SurfaceMesh torus = make_torus(3, 1, 24, 12);
  for (Vec3d& p : torus.points) {
    if (p.x > 3.9) p.x -= 3;
  }
  const std::size_t crossings = oracle::self_crossings(torus).size();
  REQUIRE(crossings > 0);
  const std::vector<SurfaceMesh> scene{torus, box({-4.5, -0.5, -0.5}, {-3.5, 0.5, 2})};
  const Certificate relative = certificate_of(CertificateLevel::Relative, scene);
  CHECK(relative.level == CertificateLevel::Relative);
  CHECK(relative.status == CertificateStatus::Certified);
  const Certificate absolute = certificate_of(CertificateLevel::Absolute, scene);
  CHECK(absolute.level == CertificateLevel::Absolute);
  CHECK(absolute.status == CertificateStatus::Uncertified);
  CHECK(std::is_sorted(absolute.failed_faces.begin(), absolute.failed_faces.end()));
  CHECK(absolute.failed_faces.size() > 1);
}

TEST_CASE("an absolute certificate agrees with the oracle") {
  std::size_t certified = 0;
  for (std::size_t seed = 1; seed <= scaled_count(60, 1000); ++seed) {
    INFO("seed " << seed);
    std::vector<SurfaceMesh> solids = RandomSolids(seed).next(2);
    if (seed % 3 == 0) solids.push_back(joined({moved(solids[0], {20, 0, 0}), moved(solids[1], {20, 0, 0})}));
    BooleanOptions options;
    options.certify = CertificateLevel::Absolute;
    const BooleanResult result = evaluate_boolean(Operation::Union, pointers_to(solids), options);
    const bool is_free = oracle::self_crossings(result.mesh).empty();
    CHECK((result.report.certificate.status == CertificateStatus::Certified) == is_free);
    certified += is_free ? 1 : 0;
  }
  CHECK(certified > 0);
}
