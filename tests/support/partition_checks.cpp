// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Partitions region by region.
#include "support/partition_checks.h"

#include <array>
#include <set>

#include "support/boolean_checks.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"

namespace mortise::test {
namespace {

/// The facets of a region with the vertices of the result.
SurfaceMesh facets_round(const BooleanResult& result, const ResultRegions& regions, std::uint32_t region) {
  SurfaceMesh mesh;
  mesh.points = result.mesh.points;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const Triangle& t = result.mesh.triangles[f];
    if (regions.region_of_facet[f] == region) mesh.triangles.push_back(t);
    if (regions.region_in_front[f] == region) mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  return mesh;
}

std::vector<std::uint32_t> chosen_operands(std::size_t choice, std::size_t count) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t k = 0; k < count; ++k) {
    if ((choice >> k & 1U) != 0) chosen.push_back(k);
  }
  return chosen;
}

}  // namespace

std::string faults_of_partition(const BooleanResult& result) {
  std::string faults;
  const auto check = [&](bool is_right, const std::string& fault) {
    if (!is_right) faults += fault + "\n";
  };
  const Provenance& p = result.provenance;
  const std::size_t count = result.mesh.triangles.size();
  const ResultRegions regions = find_result_regions(result);
  check(p.covering.size() == count && p.covering_front.size() == count, "arrays differ in size");
  check(result.report.certificate.status == CertificateStatus::Certified, "not certified");
  check(regions.is_closed, "regions are not closed");
  for (std::size_t f = 0; f < count && faults.empty(); ++f) {
    const std::string at = " at facet " + std::to_string(f);
    const std::uint32_t behind = regions.region_of_facet[f], front = regions.region_in_front[f];
    check(behind != front, "one region on both sides" + at);
    check(behind != ResultRegions::none, "nothing behind" + at);
    check(p.covering_sets[p.covering[f]] != p.covering_sets[p.covering_front[f]], "the same operands on both sides" + at);
    if (behind != ResultRegions::none)
      check(regions.regions[behind].operands == p.covering_sets[p.covering[f]], "other operands behind" + at);
    const bool is_void = front == ResultRegions::none;
    check(p.covering_sets[p.covering_front[f]] == (is_void ? std::vector<std::uint32_t>{} : regions.regions[front].operands),
          "other operands in front" + at);
  }
  for (std::uint32_t r = 0; r < regions.regions.size(); ++r) {
    check(is_balanced(region_mesh(result, regions, r)), "region " + std::to_string(r) + " is open");
    check(regions.regions[r].volume > 0, "region " + std::to_string(r) + " has no volume");
    check(!regions.regions[r].operands.empty(), "region " + std::to_string(r) + " belongs to nobody");
  }
  return faults;
}

std::map<std::vector<std::uint32_t>, oracle::Rational> exact_volumes(std::span<const SurfaceMesh* const> operands,
                                                                     const BooleanResult& result) {
  const ResultRegions regions = find_result_regions(result);
  const std::vector<oracle::RationalPoint> positions = exact_positions(operands, result);
  std::map<std::vector<std::uint32_t>, oracle::Rational> volumes;
  for (std::uint32_t r = 0; r < regions.regions.size(); ++r) {
    volumes[regions.regions[r].operands] += oracle::volume(facets_round(result, regions, r), positions);
  }
  return volumes;
}

std::map<std::vector<std::uint32_t>, oracle::Rational> expected_volumes(std::span<const SurfaceMesh* const> operands) {
  const std::size_t choices = std::size_t{1} << operands.size();
  std::vector<oracle::Rational> volume(choices, 0);  // first: in all the chosen
  for (std::size_t choice = 1; choice < choices; ++choice) {
    std::vector<const SurfaceMesh*> chosen;
    for (const std::uint32_t k : chosen_operands(choice, operands.size())) chosen.push_back(operands[k]);
    volume[choice] = oracle::common_volume(chosen);
  }
  for (std::size_t k = 0; k < operands.size(); ++k) {  // then: in all the chosen and none of the others up to k
    for (std::size_t choice = 1; choice < choices; ++choice) {
      if ((choice >> k & 1U) == 0) volume[choice] -= volume[choice | std::size_t{1} << k];
    }
  }
  std::map<std::vector<std::uint32_t>, oracle::Rational> result;
  for (std::size_t choice = 1; choice < choices; ++choice) {
    if (volume[choice] != 0) result[chosen_operands(choice, operands.size())] = volume[choice];
  }
  return result;
}

std::int64_t euler_with_regions(const BooleanResult& result) {
  return euler_characteristic(result.mesh) - static_cast<std::int64_t>(find_result_regions(result).regions.size());
}

std::map<std::size_t, std::size_t> fan_sizes(const SurfaceMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, std::size_t> fan;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = t[i].value, v = t[(i + 1) % 3].value;
      ++fan[{std::min(u, v), std::max(u, v)}];
    }
  }
  std::map<std::size_t, std::size_t> sizes;
  for (const auto& [edge, size] : fan) ++sizes[size];
  return sizes;
}

}  // namespace mortise::test
