// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rounds of merging and swapping, each followed by a certificate.
#include "mortise/boolean/certify_or_repair.h"

#include <algorithm>

#include "mortise/boolean/merge_close_vertices.h"
#include "mortise/boolean/swap_slivers.h"
#include "mortise/mesh/find_self_crossings.h"

namespace mortise {

namespace {

// Coordinates that do not tell apart what the operands are made of leave nothing to mend.
RoundedResult give_up(MergedMesh merged) {
  RoundedResult result;
  Certificate& certificate = result.certified.certificate;
  certificate.status = CertificateStatus::Uncertified;
  for (std::uint32_t t = 0; t < merged.mesh.triangles.size(); ++t) certificate.failed_faces.push_back(t);
  certificate.largest_displacement = merged.rounding_displacement;
  result.merged = std::move(merged);
  result.is_given_up = true;
  return result;
}

}  // namespace

RoundedResult certify_or_repair(const OperandFaces& faces, const Facets& facets, MergedMesh merged, Coordinates coordinates,
                                int most_rounds, const ProgressCallback& progress) {
  const RepairReach reach = repair_reach(coordinates);
  const std::size_t vertices = merged.mesh.points.size();
  if (merge_equal_vertices(faces, facets, coordinates, merged) > vertices / 4) return give_up(std::move(merged));
  CertifiedMesh certified = certify(faces, facets, merged, progress);
  for (int round = 0; round < most_rounds && !certified.failed.empty(); ++round) {
    const std::uint32_t merges = certified.certificate.merge_rounds, swaps = certified.certificate.swap_rounds;
    const bool is_merged = merge_close_vertices(faces, facets, certified.failed, reach, merged);
    if (!is_merged && !swap_slivers(FacetOrder(faces, facets), certified.failed, reach, merged)) break;
    certified = certify(faces, facets, merged, progress);
    certified.certificate.repair_displacement = merged.repair_displacement;
    certified.certificate.merge_rounds = merges + (is_merged ? 1 : 0);
    certified.certificate.swap_rounds = swaps + (is_merged ? 0 : 1);
  }
  return {std::move(merged), std::move(certified), false};
}

Certificate certify_all_pairs(const SurfaceMesh& mesh, Certificate relative) {
  Certificate certificate = std::move(relative);
  certificate.level = CertificateLevel::Absolute;
  certificate.triangles_tested = mesh.triangles.size();
  std::vector<std::uint32_t>& failed = certificate.failed_faces;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (is_degenerate(mesh, FaceId(f))) failed.push_back(f);
  }
  for (const SelfCrossing& pair : find_self_crossings(mesh)) {
    failed.push_back(pair.a.value);
    failed.push_back(pair.b.value);
  }
  std::sort(failed.begin(), failed.end());
  failed.erase(std::unique(failed.begin(), failed.end()), failed.end());
  if (!failed.empty()) certificate.status = CertificateStatus::Uncertified;
  return certificate;
}

}  // namespace mortise
